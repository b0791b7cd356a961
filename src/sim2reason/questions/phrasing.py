"""Phrases and sentences of questions: noun phrases at a moment, and periods and frequencies."""

import re
from dataclasses import dataclass, replace

import numpy as np

from sim2reason.base.draws import draw_index
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.bounces import GROUND
from sim2reason.questions.query import Noun, Query, Target
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Magnetic
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.quantities.subjects.bodies import Bodies, TurningBodies, center_path
from sim2reason.simulation.quantities.subjects.interactions import pair

QUOTA = {"what": 0.35, "find": 0.3, "how": 0.3, "determine": 0.12, "calculate": 0.08}
"""How often a verb asks, where it can; *how* can ask for little, and makes up for it there."""

_VERB = re.compile("|".join(QUOTA))
_OTHER = re.compile(r"\b(?:that|which|by) (?!which )\w")  # a clause with a subject of its own, or an agent


def draw_sentence(shapes: tuple[str, ...], rng: np.random.Generator) -> str:
    """Return a random one of equivalent sentences: first a verb, by fixed weights, then any sentence with that verb."""
    verbs = [match.group() if (match := _VERB.search(shape.lower())) else "what" for shape in shapes]
    return shapes[draw_index(rng, [QUOTA[verb] / verbs.count(verb) for verb in verbs])]


def sentence(shape: str) -> str:
    """Return a sentence with a capital letter."""
    return shape[0].upper() + shape[1:]


def question_sentences(target: Target, noun: Noun, when: str, again: str = "") -> tuple[str, ...]:
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
    positive, phrase = target.sense.positive, noun.phrase
    return (
        *(f"{question.removesuffix('?')}, {positive} being positive?" for question in how),
        f"taking {positive} as positive, find {phrase} {again}.",
        f"taking {positive} as positive, what is {phrase} {again}?",
        f"what is {phrase} {again}, {positive} being positive?",
        f"with {positive} as positive, determine {phrase} {again}.",
        f"find {phrase} {again}, counting {positive} as positive.",
        *((f"{when}, what is {phrase}, if {positive} counts as positive?",) if when[0].isalpha() else ()),
    )


def asking_then(query: Query, words: Words, noun: Noun) -> tuple[str, ...]:
    """Return all sentences that ask for a quantity, with every phrase for its moment."""
    assert query.target is not None
    assert query.moment is not None
    noun, whens = phrase_over_interval(query.moment, words, noun)
    shapes = (
        shape
        for when in whens
        for shape in question_sentences(query.target, noun, when, use_pronoun(query.moment, noun.phrase, when, words))
    )
    return tuple(dict.fromkeys(shapes))


def naming_then(query: Query, words: Words, noun: Noun) -> tuple[str, ...]:
    """Return noun phrases for a quantity with every phrase for its moment."""
    assert query.moment is not None
    if noun.timeless:
        return (noun.phrase,)
    noun, whens = phrase_over_interval(query.moment, words, noun)
    return tuple(f"{noun.phrase} {use_pronoun(query.moment, noun.phrase, when, words)}" for when in whens)


def stating_then(query: Query, words: Words, noun: Noun, value: str) -> tuple[str, ...]:
    """Return statements that a quantity has a value, with every phrase for its moment, those with verbs first."""
    assert query.moment is not None
    plain = tuple(f"{named} is {value}" for named in naming_then(query, words, noun))
    if noun.timeless:
        return plain
    noun, whens = phrase_over_interval(query.moment, words, noun)
    first = tuple(f"{when}, {noun.phrase} is {value}" for when in whens if when[0].isalpha())
    if not noun.states or noun.interval_phrase:
        return (*plain, *first)
    states = noun.states.replace("{value}", value)
    verbal = (f"{states} {use_pronoun(query.moment, states, when, words)}" for when in whens)
    early = (f"{when}, {states}" for when in whens if when[0].isalpha())
    return (*verbal, *early, *plain, *first)


def phrase_over_interval(moment: Moment, words: Words, noun: Noun) -> tuple[Noun, tuple[str, ...]]:
    """Return a noun with the phrases for its moment or, for a functional, for the interval up to the moment."""
    stretches = moment.stretches(words) if noun.interval_phrase else ()
    if stretches:
        return replace(noun, phrase=noun.interval_phrase), stretches
    return replace(noun, how="" if noun.interval_phrase else noun.how), moment.phrases(words)


def use_pronoun(moment: Moment, noun: str, when: str, words: Words) -> str:
    """Return `when` with a pronoun for its subject, as in *when it stops*, if `noun` names the same subject.

    `noun` must name no other body or agent but the ground: after *the energy that the dashpot beside spring 2
    dissipates*, *it* would refer to the dashpot.
    """
    subject, pronoun = moment.subject(words), moment.pronoun
    part, of, owner = subject.rpartition(" of ")
    if moment.part and of and owner in noun and subject not in noun:  # the centre of what the phrase names
        pronoun = f"its {part.removeprefix('the ')}"
    elif not (subject and pronoun and subject in noun):
        return when
    others = any(mention in noun and mention not in subject for mention in words.mentions.values() if mention != GROUND)
    named = owner if subject not in noun else subject
    return when if others or _OTHER.search(noun.replace(named, "…")) else when.replace(subject, pronoun, 1)


def _plain(noun: str, when: str, again: str) -> tuple[str, ...]:
    return (
        f"what is {noun} {again}?",
        f"find {noun} {again}.",
        f"determine {noun} {again}.",
        f"calculate {noun} {again}.",
        *((f"{when}, what is {noun}?",) if when[0].isalpha() else ()),  # no sentence begins with a number
    )


COUNTS = {2: "two", 3: "three"}
SPEEDS = {2: ("slower", "faster"), 3: ("slowest", "fastest")}
SIZES = {2: ("lower", "higher"), 3: ("lowest", "highest")}
PLURALS = {
    "period": "natural periods",
    "frequency": "natural frequencies",
    "angular frequency": "natural angular frequencies",
}
PER_SECOND = ", in oscillations per second"  # for natural frequencies, often mistaken for angular ones
LENGTHS = {2: ("longer", "shorter"), 3: ("longest", "shortest")}


@dataclass(frozen=True, slots=True)
class PeriodQuery(Query):
    """A query for the period of one body's motion, or of small oscillations of one, two or all bodies.

    `rank` counts modes of small oscillations by their frequency, from the slowest, of `modes` that there are. Of a
    `stable` equilibrium the text says so, since there may be others.
    """

    measure: str = "period"
    small: bool = False
    of: tuple[str, ...] = ()
    rank: int = 0
    modes: int = 1
    stable: bool = False

    @property
    def subject(self) -> str:
        """Return the name of the first body."""
        return next(iter(self.of), "")


def moving_body_phrases(words: Words) -> dict[str, str]:
    """Return the phrases of moving bodies and arms by name."""
    return {**words.subject_phrases(Bodies()), **words.subject_phrases(TurningBodies())}


def noun_of(query: PeriodQuery, words: Words) -> str:
    """Return a phrase such as *the period of small oscillations of the block about the position of equilibrium*."""
    if not query.small:
        return _noun_of_motion(query, words)
    about = f"about {_equilibrium_phrase(query)}"
    if query.modes > 1:
        speed = SPEEDS[query.modes][query.rank > 0]
        return f"the {query.measure} of the {speed} of the {COUNTS[query.modes]} normal modes of oscillation {about}"
    return f"the {query.measure} of small oscillations {_of(query, words)}"


def sentences(query: PeriodQuery, words: Words) -> tuple[str, ...]:
    """Return all sentences of the query, the most usual first."""
    if not query.small:
        others = _of_motion(query, words)
    else:
        others = _of_modes(query) if query.modes > 1 else _small_oscillation_sentences(query, words)
    return (*_plainly(noun_of(query, words)), *others)


def _equilibrium_phrase(query: PeriodQuery) -> str:
    return f"the position of {equilibrium_called(stable=query.stable)}"


def _of(query: PeriodQuery, words: Words) -> str:
    """Return the words for the bodies and the equilibrium of small oscillations with a single mode."""
    phrases = [moving_body_phrases(words)[name] for name in query.of]
    if len(phrases) > 1:
        return f"of {pair(*phrases)} relative to each other"
    return f"of {phrases[0]} about {_equilibrium_phrase(query)}" if phrases else f"about {_equilibrium_phrase(query)}"


def equilibrium_called(*, stable: bool) -> str:
    """Return the phrase for an equilibrium position."""
    return "stable equilibrium" if stable else "equilibrium"


def _noun_of_motion(query: PeriodQuery, words: Words) -> str:
    name, phrase = query.of[0], moving_body_phrases(words)[query.of[0]]
    if attracted_by(words.mechanism, name) in words.mentions:
        return f"the orbital {query.measure} of {phrase}"
    if _revolves(words.mechanism, name):
        return f"the {query.measure} of revolution of {phrase}"
    return f"the {query.measure} of the motion of {phrase}"


def _of_motion(query: PeriodQuery, words: Words) -> tuple[str, ...]:
    mechanism, name, measure = words.mechanism, query.of[0], query.measure
    phrase, path = moving_body_phrases(words)[name], center_path(mechanism, name)
    center = attracted_by(mechanism, name)
    if center in words.mentions:
        return _of_orbit(measure, phrase, words.mentions[center])
    if _revolves(mechanism, name):
        return _of_revolution(measure, phrase)
    if not (path.straight or (words.released and path.swings)):
        again = (f"how long does it take until the motion of {phrase} repeats itself?",) if measure == "period" else ()
        return (f"with what {measure} does the motion of {phrase} repeat itself?", *again)
    does = "oscillate" if path.straight else "rock to and fro" if name in mechanism.contacts else "swing to and fro"
    first, _, rest = does.partition(" ")
    verb = f"{first}s {rest}".rstrip()
    takes = (f"how long does {phrase} take for one complete oscillation?",) if measure == "period" else ()
    return (
        f"with what {measure} does {phrase} {does}?",
        f"determine the {measure} with which {phrase} {verb}.",
        *takes,
    )


def _of_orbit(measure: str, phrase: str, center: str) -> tuple[str, ...]:
    return (
        f"with what {measure} does {phrase} go round {center}?",
        f"determine the {measure} of the motion of {phrase} about {center}.",
        f"what is the {measure} with which {phrase} goes round {center}?",
    )


def _of_revolution(measure: str, phrase: str) -> tuple[str, ...]:
    takes = (f"how long does one revolution of {phrase} take?",) if measure == "period" else ()
    return (f"with what {measure} does {phrase} go round its circle?", *takes)


def _revolves(mechanism: Mechanism, name: str) -> bool:
    """Return whether only a uniform magnetic field acts on a body in its plane, so that its path is a circle."""
    forces = [force for force in mechanism.forces if force.body == name]
    alone = len(forces) == 1 and forces[0].region is None and not (mechanism.lines or mechanism.attractions)
    law = forces[0].law if alone else None
    return isinstance(law, Magnetic) and law.profile.uniform and not center_path(mechanism, name).rises


def _plainly(noun: str) -> tuple[str, ...]:
    return (f"what is {noun}?", f"find {noun}.", f"determine {noun}.", f"calculate {noun}.")


def _small_oscillation_sentences(query: PeriodQuery, words: Words) -> tuple[str, ...]:
    phrases, measure, equilibrium = (
        [moving_body_phrases(words)[name] for name in query.of],
        query.measure,
        _equilibrium_phrase(query),
    )
    own = equilibrium.replace("the", "its", 1)
    if len(phrases) == 1:
        told = (
            f"disturbed slightly from {own}, with what {measure} does {phrases[0]} oscillate?",
            f"with what {measure} does {phrases[0]} oscillate if slightly disturbed from {own}?",
        )
    elif phrases:
        told = (
            f"with what {measure} do {pair(*phrases)} vibrate against each other when the amplitude is small?",
            f"with what {measure} would {pair(*phrases)} oscillate relative to each other after a slight disturbance?",
        )
    else:
        told = (
            f"if all is at rest in {equilibrium} and is slightly disturbed, what is the {measure} of the oscillations?",
            f"with what {measure} does everything oscillate if it is slightly disturbed from {equilibrium}?",
        )
    takes = (f"how long does one small oscillation {_of(query, words)} take?",) if measure == "period" else ()
    return (*told, *takes)


def _of_modes(query: PeriodQuery) -> tuple[str, ...]:
    """Return the sentences for one of several modes of oscillation, named by the order of their periods."""
    count, last, equilibrium = query.modes, query.rank > 0, _equilibrium_phrase(query)
    plural, unit = PLURALS[query.measure], PER_SECOND if query.measure == "frequency" else ""
    which = (LENGTHS if query.measure == "period" else SIZES)[count][last]
    return (
        f"oscillations about {equilibrium} have {COUNTS[count]} {plural}{unit}; what is the {which} of them?",
        f"of the {COUNTS[count]} {plural} of oscillations about {equilibrium}, find the {which}{unit}.",
    )


def attracted_by(mechanism: Mechanism, name: str) -> str:
    """Return the name of the fixed body that another one orbits; empty if there is none."""
    for pull in mechanism.attractions:
        for one, other in ((pull.a, pull.b), (pull.b, pull.a)):
            if one == name and not center_path(mechanism, other).ways:
                return other
    return ""
