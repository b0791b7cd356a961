"""Readers of main clauses that ask for forces on pulleys, axles and hooks."""

import re
from collections.abc import Iterator

from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.readers import Main
from sim2reason.questions.ordinary.value_readers import FORCES
from sim2reason.questions.ordinary.vocabulary import FIXED_END, FREE_AXLE, LIGHT

ON_PULLEY, ON_AXLE, OF_AXLE = "force on a pulley", "force on the axle", "axle force"


def _named(found: re.Match[str], heard: TokenizedSentence) -> list[str]:
    return [heard.subject(found[key]) for key in "st" if found[key]]


def _beside_string(said: list[str]) -> list[str]:
    """Return the one of two subjects that is not a string; none if neither or both are strings."""
    others = [of for of in said if "string" not in of]
    return others if len(said) == 2 and len(others) == 1 else []


def on_pulley(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the force of a string on a pulley, whichever of the two is named first."""
    yield from (Main(ON_PULLEY, of) for of in _beside_string(_named(found, heard)))


def on_that_pulley(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the force on a pulley of the string that passes over it."""
    yield Main(ON_PULLEY, heard.subject(found["s"]))


def on_free_pulley(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the force of the only string on a pulley, presuming that no string is tied to the axle."""
    of = heard.subject(found["s"])
    yield Main(ON_PULLEY, of, ways=((of, FREE_AXLE),))


def on_axle(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the force on the axle of a light pulley or of an arm, by default of the only one in the scene."""
    said = _named(found, heard)
    for of in (_beside_string(said) if len(said) == 2 else said) or ([] if said else [""]):
        yield Main(ON_PULLEY, of, ways=((of, LIGHT),))
        yield Main(OF_AXLE, of)  # of the same size, with a worked solution
        yield Main(ON_AXLE, of)


def on_hook(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the force in a named string, rod or spring, or else in the only one with a fixed end."""
    yield from (Main(force, heard.subject(found["s"]) or FIXED_END) for force in FORCES)
