"""Readers of main clauses that ask for what pulleys, axles, guides and hooks bear."""

import re
from collections.abc import Iterator

from sim2reason.questions.ordinary.hearing import Heard
from sim2reason.questions.ordinary.readers import Main
from sim2reason.questions.ordinary.value_readers import FORCES
from sim2reason.questions.ordinary.vocabulary import FIXED_END, LIGHT

ON_PULLEY, ON_AXLE = "force on a pulley", "force on the axle"


def _named(found: re.Match[str], heard: Heard) -> list[str]:
    return [heard.subject(found[key]) for key in "st" if found[key]]


def on_pulley(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the force of strings on a pulley, for each subject that is named: of a body that is none it has no value."""
    yield from (Main(ON_PULLEY, of) for of in _named(found, heard))


def on_axle(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield what the axle of a light pulley bears, or that of an arm; of the only one, if none is named."""
    for of in _named(found, heard) or [""]:
        yield Main(ON_PULLEY, of, ways=((of, LIGHT),))
        yield Main(ON_AXLE, of)


def on_hook(found: re.Match[str], heard: Heard) -> Iterator[Main]:
    """Yield the force in the string, rod or spring that is named, or else in the only one with a fixed end."""
    yield from (Main(force, heard.subject(found["s"]) or FIXED_END) for force in FORCES)
