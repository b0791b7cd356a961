"""Readers of main clauses about the centre of mass, amplitudes, springs, and motion relative to a carrier."""

import re
from collections.abc import Iterator
from dataclasses import replace

from sim2reason.questions.ordinary.hearing import ALL, TokenizedSentence
from sim2reason.questions.ordinary.readers import CLAUSED, FREE, LOSS, MOMENT, Main, Reader, each
from sim2reason.questions.ordinary.vocabulary import (
    BESIDE,
    BORNE,
    CENTERED,
    CENTRAL,
    DOWN,
    FARTHEST,
    FIXED_END,
    HELD,
    LIES,
    MOTIONS,
    ON,
    ONE_LINE,
    RESTS,
    SIDEWAYS,
    UP,
)
from sim2reason.questions.ordinary.whens import AFTER, AMPLITUDE, EVERYTHING, When, ways_of

_UPRIGHT = re.compile(rf"\b(?:{'|'.join(f'{MOTIONS[DOWN]} {MOTIONS[UP]}'.split())}|up|down)\b")
MASS_CENTER = "velocity of the centre of mass"


def mass_center(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the velocity of the centre of mass of all bodies, if the sentence names all together, or none."""
    who = heard.subject(found["s"])
    if not who or who == EVERYTHING or who.startswith(f"{ALL} "):
        yield Main(MASS_CENTER, ways=((who, ALL),) if who.startswith(f"{ALL} ") else ())


def amplitude(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the amplitude of an oscillation: in metres for a body on a line, as an angle for a swinging one."""
    for of in each(heard, found["s"]):
        yield Main(AMPLITUDE, of, needs=FREE)
        yield Main("greatest deflection", of, needs=FREE)


def own_axis(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the moment of inertia of a body about its own axis, or about its centre of mass if that is on the axis."""
    of = heard.subject(found["s"])
    yield Main("moment of inertia about the axis", of)
    yield Main("moment of inertia", of, ways=((of, CENTERED),))


def from_axis(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the distance of a body from an axis of coordinates, which is its other coordinate."""
    other = "y" if found["axis"] == "x" else "x"
    for of in each(heard, found["s"]):
        yield Main(f"{other} coordinate", of, needs=CLAUSED)


def on_line(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the coordinate of a body on the only line on which the body moves, if that line is an axis of the text."""
    yield from (Main("x coordinate", of, needs=CLAUSED, ways=((of, ONE_LINE),)) for of in each(heard, found["s"]))


SIDES = {"above": ("x", "+"), "below": ("x", "-"), "right": ("y", "+"), "left": ("y", "-")}


def beside_axis(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the distance of a body from an axis of coordinates on a named side, by default where it is farthest."""
    axis, sign = SIDES[found["side"]]
    other = "y" if axis == "x" else "x"
    if found["axis"] != axis:
        return
    for of in each(heard, found["s"]):
        beside = (of, f"{BESIDE}{sign}{other}")
        if found["most"]:
            turn = When(f"velocity of {of} along {other} = 0 m/s", ways=(beside, (of, f"{FARTHEST}{sign}{other}")))
            yield Main(f"{other} coordinate", of, needs=FREE, when=turn)
        else:
            yield Main(f"{other} coordinate", of, needs=CLAUSED, ways=(beside,))


def acceleration_on(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the acceleration of a body relative to the body that carries it."""
    of, on = heard.subject(found["s"]), heard.subject(found["t"])
    yield Main("acceleration relative to its carrier", of, needs=MOMENT, ways=((of, f"{ON}{on}"),))


def relatively(name: str) -> Reader:
    """Return a reader for a quantity of a body relative to the body that carries it."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        of, on = heard.subject(found["s"]), heard.subject(found["t"])
        ways = ((of, f"{ON}{on}"), *ways_of(found, of))
        yield Main(f"{name} relative to its carrier", of, needs=CLAUSED, ways=ways)
        if on and on != of and not ways_of(found, of) and not _UPRIGHT.search(heard.text):
            yield Main("relative speed", f"{of} & {on}", needs=CLAUSED, ways=((of, f"{BORNE}{on}"),))

    return read


def far_on(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the distance that a body slides on its carrier, up to a moment or until it stops slipping."""
    of, on = heard.subject(found["s"]), heard.subject(found["t"])
    along = ((of, LIES),) if re.search(r"\b(?:along|over|across)\b", heard.text) is not None else ()
    main = Main("displacement relative to its carrier", of, needs=CLAUSED, ways=((of, f"{ON}{on}"), *along))
    yield main
    yield replace(main, needs=FREE, when=When(f"{of} stopped slipping", AFTER))


def down(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the vertical velocity of a body that also moves sideways, presuming that it moves down."""
    for of in each(heard, found["s"]):
        yield Main("velocity", of, "vertical", needs=CLAUSED, ways=((of, "down"), (of, SIDEWAYS)))


def moving(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the time for which a body moves, until it comes to rest for good."""
    of = heard.subject(found["s"])
    yield Main("time", needs=FREE, when=When(f"{of} halted"))
    yield Main("time", needs=FREE, when=When(f"{of} stopped", ways=((of, RESTS),)), rank=1)


def work_of_spring(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the work of a spring, as the first subject, on a body, as the second one."""
    yield from spring_work(found["s"], found["t"], heard)


def spring_work(spring: str, on: str, heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the work of a spring with one fixed end on the body at the other: the energy that the spring loses."""
    of, other = heard.subject(spring), heard.subject(on)
    yield Main("spring energy", of, needs=LOSS, ways=((other or of, f"{HELD}{of}"),))


def far_end(turn: str = "") -> Reader:
    """Return a reader for the distance of a body from the fixed end of its spring, which is the spring's length.

    At a `turn`, its extreme length is the same each time if nothing but the spring acts.
    """

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        said = [heard.subject(found[key]) for key in "st" if found[key]]
        springs = [of for of in said if "spring" in of]
        bodies = [of for of in said if of not in springs]
        if len(bodies) == 1:
            of = springs[0] if springs else FIXED_END
            main = Main("spring length", of, ways=((bodies[0], f"{HELD}{of}"),))
            alone = (*main.ways, ("", CENTRAL))
            when = When(" ".join((*springs, turn)))
            yield replace(main, needs=FREE, ways=alone, when=when) if turn else main

    return read
