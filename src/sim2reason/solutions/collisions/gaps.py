"""Distances between bodies on a line, or between a body and a wall, at t = 0, in the symbols of the text."""

from sim2reason.dsl.frames import Frames
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.triples import minus, product
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.writing.lexicon import Both, Lexicon, UnreadError

Side = tuple[Frames, Mechanism]


def gap_at_start(lexicon: Lexicon, frames: tuple[Frames, Frames], number: int) -> Polynomial:
    """Return the gap between the partners of a meeting, m; UnreadError if the text's numbers give no simple function.

    For a disc and a wall the gap may be a sum of three lengths: the positions of the wall and the disc, and the radius.
    """
    sides: list[Side] = [(frames[0], lexicon.mechanism), (frames[1], lexicon.twin)]
    whole = Both(*(_place(*side, number) - side[1].meetings[number].distance for side in sides))
    try:
        return lexicon.read(whole)
    except UnreadError:
        found = _of_three(lexicon, whole) if lexicon.mechanism.meetings[number].a is None else None
        if found is None:
            raise
        return found


def _of_three(lexicon: Lexicon, whole: Both) -> Polynomial | None:
    """Return a gap as a length of the text, or its negative, plus a sum of two lengths; None if no length fits."""
    for length in reversed(lexicon.lengths):
        for sign in (1.0, -1.0):
            try:
                rest = lexicon.read(whole - Both(sign * length.here, sign * length.there))
            except UnreadError:
                continue
            return lexicon.read(length).scaled(sign) + rest
    return None


def _place(frames: Frames, mechanism: Mechanism, number: int) -> float:
    """Return the position of the second partner of a meeting along the normal, from the first or the room's origin."""
    met = mechanism.meetings[number]
    assert met.normal is not None
    other = frames.center(met.b).place
    return float(product(met.normal, other if met.a is None else minus(other, frames.center(met.a).place)))
