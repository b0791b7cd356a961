"""Sentences that ask for a noun phrase at a moment, with verbs chosen by quota."""

import re
from dataclasses import replace

import numpy as np

from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.bounces import GROUND
from sim2reason.questions.query import Noun, Query, Target
from sim2reason.questions.words import Words

QUOTA = {"what": 0.35, "find": 0.3, "how": 0.3, "determine": 0.12, "calculate": 0.08}
"""How often a verb asks, where it can; *how* can ask for little, and makes up for it there."""

_VERB = re.compile("|".join(QUOTA))
_OTHER = re.compile(r"\b(?:that|which|by) (?!which )\w")  # a clause with a subject of its own, or an agent


def chosen(shapes: tuple[str, ...], rng: np.random.Generator) -> str:
    """Return a random one of equivalent sentences: first a verb, by fixed weights, then any sentence with that verb."""
    verbs = [found.group() if (found := _VERB.search(shape.lower())) else "what" for shape in shapes]
    weights = np.array([QUOTA[verb] / verbs.count(verb) for verb in verbs])
    return shapes[int(rng.choice(len(shapes), p=weights / weights.sum()))]


def sentence(shape: str) -> str:
    """Return a sentence with a capital letter."""
    return shape[0].upper() + shape[1:]


def asking(target: Target, noun: Noun, when: str, again: str = "") -> tuple[str, ...]:
    """Return all sentences that ask for a quantity, a magnitude or a component, at a moment.

    `again` is the phrase for the moment with a pronoun, for use after the noun phrase has named its subject.
    """
    if noun.timeless:
        return tuple(shape.replace(" {when}", "") for shape in _plain(noun.phrase, "{when}", "{when}"))
    again = again or when
    how = (noun.how.replace("{when}", again),) if noun.how else ()  # everyday English, where there is any
    if target.sense is None or target.sense.fixed:
        clauses = tuple(f"{verb} {noun.indirect} {again}." for verb in ("find", "determine")) if noun.indirect else ()
        return (*how, *clauses, *_plain(noun.phrase, when, again))
    positive, said = target.sense.positive, noun.phrase
    return (
        *(f"{question.removesuffix('?')}, {positive} being positive?" for question in how),
        f"taking {positive} as positive, find {said} {again}.",
        f"taking {positive} as positive, what is {said} {again}?",
        f"what is {said} {again}, {positive} being positive?",
        f"with {positive} as positive, determine {said} {again}.",
        f"find {said} {again}, counting {positive} as positive.",
        *((f"{when}, what is {said}, if {positive} counts as positive?",) if when[0].isalpha() else ()),
    )


def asking_then(query: Query, words: Words, noun: Noun) -> tuple[str, ...]:
    """Return all sentences that ask for a quantity, with every phrase for its moment."""
    assert query.target is not None
    assert query.moment is not None
    noun, whens = spanning(query.moment, words, noun)
    shapes = (
        shape
        for when in whens
        for shape in asking(query.target, noun, when, again(query.moment, noun.phrase, when, words))
    )
    return tuple(dict.fromkeys(shapes))


def naming_then(query: Query, words: Words, noun: Noun) -> tuple[str, ...]:
    """Return noun phrases for a quantity with every phrase for its moment."""
    assert query.moment is not None
    if noun.timeless:
        return (noun.phrase,)
    noun, whens = spanning(query.moment, words, noun)
    return tuple(f"{noun.phrase} {again(query.moment, noun.phrase, when, words)}" for when in whens)


def stating_then(query: Query, words: Words, noun: Noun, value: str) -> tuple[str, ...]:
    """Return statements that a quantity has a value, with every phrase for its moment, those with verbs first."""
    assert query.moment is not None
    plain = tuple(f"{named} is {value}" for named in naming_then(query, words, noun))
    if noun.timeless:
        return plain
    noun, whens = spanning(query.moment, words, noun)
    first = tuple(f"{when}, {noun.phrase} is {value}" for when in whens if when[0].isalpha())
    if not noun.states or noun.over:
        return (*plain, *first)
    states = noun.states.replace("{value}", value)
    verbal = (f"{states} {again(query.moment, states, when, words)}" for when in whens)
    early = (f"{when}, {states}" for when in whens if when[0].isalpha())
    return (*verbal, *early, *plain, *first)


def spanning(moment: Moment, words: Words, noun: Noun) -> tuple[Noun, tuple[str, ...]]:
    """Return a noun with the phrases for its moment or, for a functional, for the interval up to the moment."""
    stretches = moment.stretches(words) if noun.over else ()
    if stretches:
        return replace(noun, phrase=noun.over), stretches
    return replace(noun, how="" if noun.over else noun.how), moment.phrases(words)


def again(moment: Moment, noun: str, when: str, words: Words) -> str:
    """Return `when` with a pronoun for its subject, as in *when it stops*, if `noun` names the same subject.

    `noun` must name no other body or agent but the ground: after *the energy that the dashpot beside spring 2
    dissipates*, *it* would refer to the dashpot.
    """
    subject, pronoun = moment.subject(words), moment.pronoun
    part, of, whole = subject.rpartition(" of ")
    if moment.part and of and whole in noun and subject not in noun:  # the centre of what the phrase names
        pronoun = f"its {part.removeprefix('the ')}"
    elif not (subject and pronoun and subject in noun):
        return when
    others = any(said in noun and said not in subject for said in words.mentions.values() if said != GROUND)
    named = whole if subject not in noun else subject
    return when if others or _OTHER.search(noun.replace(named, "…")) else when.replace(subject, pronoun, 1)


def _plain(noun: str, when: str, again: str) -> tuple[str, ...]:
    return (
        f"what is {noun} {again}?",
        f"find {noun} {again}.",
        f"determine {noun} {again}.",
        f"calculate {noun} {again}.",
        *((f"{when}, what is {noun}?",) if when[0].isalpha() else ()),  # no sentence begins with a number
    )
