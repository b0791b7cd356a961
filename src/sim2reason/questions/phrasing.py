"""The sentences that ask for a noun phrase at a moment; the verbs are drawn by quota, not by chance alone."""

import re

import numpy as np

from sim2reason.questions import Query, Words
from sim2reason.questions.targets import GAIN, Target

FAST = "the speed of "
FAR = "the distance of "
FROM_START = " from its starting point"
QUOTA = {"what": 0.35, "find": 0.3, "how": 0.6, "determine": 0.12, "calculate": 0.08}
"""How often a verb asks, where it can; *how* can ask for little, and makes up for it there."""

_VERB = re.compile("|".join(QUOTA))


def chosen(shapes: tuple[str, ...], rng: np.random.Generator) -> str:
    """One of several sentences that ask the same: its verb by quota, then any with that verb."""
    verbs = [found.group() if (found := _VERB.search(shape.lower())) else "what" for shape in shapes]
    weights = np.array([QUOTA[verb] / verbs.count(verb) for verb in verbs])
    return shapes[int(rng.choice(len(shapes), p=weights / weights.sum()))]


def asking(target: Target, noun: str, when: str) -> tuple[str, ...]:
    """All ways to ask for a quantity, a magnitude or a component, at a moment."""
    sense = target.sense
    if sense is None or sense == GAIN or len(sense.axis) == 1:  # a gain, or an axis of the text, has a sign of its own
        return (*_special(noun, when), *_plain(noun, when))
    positive = sense.positive
    return (
        f"taking {positive} as positive, find {noun} {when}.",
        f"taking {positive} as positive, what is {noun} {when}?",
        f"what is {noun} {when}, {positive} being positive?",
        f"with {positive} as positive, determine {noun} {when}.",
        f"find {noun} {when}, counting {positive} as positive.",
        *((f"{when}, what is {noun}, if {positive} counts as positive?",) if when[0].isalpha() else ()),
    )


def asking_then(ask: Query, words: Words, noun: str) -> tuple[str, ...]:
    """All ways to ask for a quantity, in every phrase for its moment."""
    assert ask.target is not None
    phrases = ask.moment.phrases(words.mentions, released=words.released)
    return tuple(shape for when in phrases for shape in asking(ask.target, noun, when))


def _plain(noun: str, when: str) -> tuple[str, ...]:
    return (
        f"what is {noun} {when}?",
        f"find {noun} {when}.",
        f"determine {noun} {when}.",
        f"calculate {noun} {when}.",
        *((f"{when}, what is {noun}?",) if when[0].isalpha() else ()),  # no sentence begins with a number
    )


def _special(noun: str, when: str) -> tuple[str, ...]:
    """Where everyday English has a question word of its own."""
    if noun.startswith(FAST):
        body, _, ground = noun.removeprefix(FAST).partition(" relative to")
        return (f"how fast is {body} moving{' relative to' + ground if ground else ''} {when}?",)
    if noun.startswith(FAR) and FROM_START in noun:
        body, _, ground = noun.removeprefix(FAR).partition(FROM_START)
        return (f"how far is {body}{FROM_START}{ground} {when}?",)
    return ()
