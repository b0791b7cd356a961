"""The sentences that ask for a noun phrase at a moment; the verbs are drawn by quota, not by chance alone."""

import re

import numpy as np

from sim2reason.questions.query import Query
from sim2reason.questions.targets import Noun, Target
from sim2reason.questions.words import Words

QUOTA = {"what": 0.35, "find": 0.3, "how": 0.6, "determine": 0.12, "calculate": 0.08}
"""How often a verb asks, where it can; *how* can ask for little, and makes up for it there."""

_VERB = re.compile("|".join(QUOTA))


def chosen(shapes: tuple[str, ...], rng: np.random.Generator) -> str:
    """One of several sentences that ask the same: its verb by quota, then any with that verb."""
    verbs = [found.group() if (found := _VERB.search(shape.lower())) else "what" for shape in shapes]
    weights = np.array([QUOTA[verb] / verbs.count(verb) for verb in verbs])
    return shapes[int(rng.choice(len(shapes), p=weights / weights.sum()))]


def sentence(shape: str) -> str:
    """A shape as it stands in a text: with a capital."""
    return shape[0].upper() + shape[1:]


def asking(target: Target, noun: Noun, when: str) -> tuple[str, ...]:
    """All ways to ask for a quantity, a magnitude or a component, at a moment."""
    if target.sense is None or target.sense.fixed:
        how = (noun.how.replace("{when}", when),) if noun.how else ()  # everyday English, where there is any
        return (*how, *_plain(noun.phrase, when))
    positive, said = target.sense.positive, noun.phrase
    return (
        f"taking {positive} as positive, find {said} {when}.",
        f"taking {positive} as positive, what is {said} {when}?",
        f"what is {said} {when}, {positive} being positive?",
        f"with {positive} as positive, determine {said} {when}.",
        f"find {said} {when}, counting {positive} as positive.",
        *((f"{when}, what is {said}, if {positive} counts as positive?",) if when[0].isalpha() else ()),
    )


def asking_then(query: Query, words: Words, noun: Noun) -> tuple[str, ...]:
    """All ways to ask for a quantity, in every phrase for its moment."""
    assert query.target is not None
    assert query.moment is not None
    return tuple(shape for when in query.moment.phrases(words) for shape in asking(query.target, noun, when))


def _plain(noun: str, when: str) -> tuple[str, ...]:
    return (
        f"what is {noun} {when}?",
        f"find {noun} {when}.",
        f"determine {noun} {when}.",
        f"calculate {noun} {when}.",
        *((f"{when}, what is {noun}?",) if when[0].isalpha() else ()),  # no sentence begins with a number
    )
