"""Through which angle something swings in all, to and fro, from one place where it turns back to the next."""

from collections.abc import Callable
from math import ceil, pi

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number
from sim2reason.solutions.algebra.functions import PI
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.setting import joined
from sim2reason.solutions.swings.angle import SwingAngle
from sim2reason.solutions.writing.steps import UnsolvedError

SAMPLES = 48  # of a period of small swings, at least
TWICE = 2
SLOW = 1e-7  # of the fastest: the end of what comes to rest there

Seen = Callable[[Array], tuple[Array, Array]]
"""Angles and their rates at times, each (n,)."""


def swept(swing: SwingAngle, seen: Seen) -> Expression:
    """The sum of all angles; what is `seen` decides signs and numbers of turns alone."""
    end = swing.setting.time
    count = SAMPLES * max(1, ceil(end * swing.book.value(swing.natural) / (2.0 * pi)))
    angles, rates = seen(np.linspace(0.0, end, count + 1))
    kept = np.sign(rates[np.abs(rates) > SLOW * np.abs(rates).max()])
    turns = int((kept[1:] != kept[:-1]).sum()) + swing.still
    if swing.goes_round:
        return _round(swing, float(np.unwrap(angles)[-1]))
    if not swing.falls:
        raise UnsolvedError("its centre of mass is on the other side of the axle")
    if not turns:
        return swing.between
    way = float(kept[0])
    _tell_way(swing, turns, way)
    reach, found = Polynomial.of(swing.reach), _place(swing.first).scaled(-way)
    found = found + reach.scaled(2.0 * turns - 1.0)
    if not swing.still:
        found = found + reach - _place(swing.angle).scaled(way if turns % 2 else -way)
    return found.factored()


def _tell_way(swing: SwingAngle, turns: int, way: float) -> None:
    """Write from where to where it goes between turning points, and where it ends if that is none."""
    inward, ends = way < 0.0 and swing.first != ZERO, ZERO if swing.still else swing.angle
    reach, through = f"${swing.reach.latex()}$", " through the lowest point"
    begins = f"${swing.first.latex()}$" if swing.first != ZERO else "the lowest point"
    said = [f"From {begins} it swings{through if inward else ''} to {reach}{' on the other side' if inward else ''}"]
    if turns > 1:
        often = "once" if turns == TWICE else f"{turns - 1} times"
        said.append(f"{often} from one turning point to the other")
    if not swing.still:
        side = way if turns % 2 else -way
        crosses = ends != ZERO and side * swing.book.value(ends) < 0.0
        size = f"${(-ends if ends.negative else ends).latex()}$" if ends != ZERO else "the lowest point"
        said.append(f"back{through if crosses else ''} to {size}")
    step = swing.book.open("names")
    step.say(f"{joined(said)}.")
    step.close()


def _round(swing: SwingAngle, end: float) -> Expression:
    """What goes round never turns back; straight up or down it is after whole half turns."""
    halves = round(end / pi)
    there = swing.angle
    if there == ZERO or isinstance(there, Number):
        there = Number(float(halves)) * PI if halves else ZERO
    apart = there - swing.first
    return apart if swing.book.value(apart) >= 0.0 else -apart


def _place(held: Expression) -> Polynomial:
    """An angle with its sign, as a term."""
    if held == ZERO:
        return Polynomial({})
    negative = held.latex().startswith("-")
    return Polynomial.of(-held).scaled(-1.0) if negative else Polynomial.of(held)
