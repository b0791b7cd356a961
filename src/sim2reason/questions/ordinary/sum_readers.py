"""Readers of main clauses that ask for energies, work, impulses and numbers of events over an interval."""

import re
from collections.abc import Iterator
from dataclasses import replace

from sim2reason.questions.ordinary.hearing import ALL, TokenizedSentence
from sim2reason.questions.ordinary.readers import CLAUSED, FREE, JUMP, STRETCH, Main, Reader, each, implied
from sim2reason.questions.ordinary.shape_readers import spring_work
from sim2reason.questions.ordinary.vocabulary import DRAWN, MUTUAL, ON, ONLY, OVER
from sim2reason.questions.ordinary.whens import AFTER, EVERYTHING, When

HEAT = "energy dissipated by friction"
_CLAUSE = re.compile(r" (?:when|until|till|before|by time|by moment|after|once|as soon as|while|in first|during) ")
EXTREMES = {"greatest compression": "most compressed", "greatest extension": "most stretched"}
"""By the name of a spring's greatest strain, the moment at which the spring has it, where a motion never recurs."""


def heat(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the energy dissipated by friction, up to a named moment or until nothing slips any more."""
    del found
    if "@" not in _CLAUSE.split(heard.text, maxsplit=1)[0]:
        yield Main(HEAT, EVERYTHING, needs=STRETCH)
    yield Main(HEAT, needs=STRETCH)
    yield Main("energy lost in a collision", needs=JUMP)
    yield Main("kinetic energy", needs=JUMP)
    for rank, when in enumerate(("stopped slipping", "stopped"), start=1):
        yield Main(HEAT, needs=FREE, ways=(("", OVER),), when=When(when, AFTER), rank=rank)


def heat_between(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the energy dissipated by friction between a body and its carrier, named in either order."""
    said = [heard.subject(found[key]) for key in "st"]
    for of, on in (said, said[::-1]):
        main = Main(HEAT, of, ways=((of, f"{ON}{on}"),))
        yield replace(main, needs=STRETCH)
        yield replace(main, needs=FREE, when=When(f"{of} stopped slipping", AFTER), rank=1)


def in_collision(*finds: str) -> Reader:
    """Return a reader for quantities of a named collision or, where none is named, of the motion's only collision."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        groups = found.groupdict()
        both = " & ".join(heard.subject(groups[key]) for key in "st" if groups.get(key))
        for find in finds:
            if " & " in both and not both.startswith(ALL):
                yield Main(find, needs=FREE, when=When(f"{both} collided", AFTER))
            yield Main(find, needs=STRETCH)
            yield Main(find, needs=FREE, ways=(("", ONLY),), when=When("collided", AFTER), rank=1)

    return read


def most(name: str) -> Reader:
    """Return a reader for a spring's greatest extension or compression, over the whole motion or up to that extreme."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        for of in each(heard, found["s"]):
            yield Main(name, of, needs=STRETCH)
            yield Main(name, of, needs=FREE, when=When(f"{of} {EXTREMES[name]}", AFTER), rank=1)

    return read


def of_hand_on(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the work of the hand, presuming that it pulls a named body."""
    for of in each(heard, found["s"]):
        yield Main("work of a hand", needs=STRETCH, ways=((of, DRAWN),))


def work_on(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the work of a string on the body that it pulls, or of a spring on the body at its free end."""
    yield from (Main("work of a tension", of, needs=STRETCH) for of in each(heard, found["s"]))
    yield from spring_work(found["t"], found["s"], heard)


def count_between(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the number of all collisions, if the sentence names all bodies together and there is no wall."""
    who = heard.subject(found["s"])
    if who.startswith(f"{ALL} "):
        yield from (replace(main, of="", ways=((who, ALL), ("", MUTUAL))) for main in count(found, heard))


def count(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the number of all collisions, or of those up to a moment."""
    yield from implied("number of collisions", "last collision")(found, heard)
    yield Main("number of collisions", needs=CLAUSED)
