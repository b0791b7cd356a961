"""A normal mode, and sums of modes as functions of time."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import Call, Power

UNNAMED = Symbol("q")


@dataclass
class Mode:
    """A normal mode: λ = ω² (ω: angular frequency), mode shape, and coefficients from the initial state."""

    number: int
    square: Expression  # λ; zero without a restoring force
    first: int = 0  # the free coordinate of the largest share, which is 1
    shape: list[Expression] = field(default_factory=list[Expression])
    name: Symbol = UNNAMED  # symbol of its coordinate ξ
    rate: Symbol | None = None
    rise: Expression = ZERO  # equilibrium value of ξ, q/µλ; without a restoring force, the acceleration q/µ
    swing: Expression = ZERO  # amplitude p/µω of the sine; without a restoring force, the velocity p/µ


def _summed(modes: Sequence[Mode], i: int, t: Symbol, order: int) -> Expression:
    """Return a free coordinate's displacement as a sum over modes, or its time derivative of the given `order`."""
    found: Expression = ZERO
    for mode in modes:
        inner = _free(mode, t, order) if mode.rate is None else _swung(mode, mode.rate, t, order)
        found = found + mode.shape[i] * inner
    return found


def _free(mode: Mode, t: Symbol, order: int) -> Expression:
    """Return c t + b t²/2, a mode without a restoring force, or its time derivative of the given `order`."""
    if order == 0:
        return mode.swing * t + 0.5 * mode.rise * Power(t, 2)
    if order == 1:
        return mode.swing + mode.rise * t
    return mode.rise if order == 2 else ZERO


def _swung(mode: Mode, rate: Symbol, t: Symbol, order: int) -> Expression:
    """Return b (1 − cos ωt) + c sin ωt, an oscillating mode, or its time derivative of the given `order`."""
    cosine, sine = Call("cos", rate * t), Call("sin", rate * t)
    rises = {0: ONE - cosine, 1: sine, 2: cosine, 3: -sine}[order]
    swings = {0: sine, 1: cosine, 2: -sine, 3: -cosine}[order]
    found = mode.rise * rises + mode.swing * swings
    return found if order == 0 else (Power(rate, order) if order > 1 else rate) * found


def place(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """Return the displacement of a free coordinate, given by its index, at a time."""
    return _summed(modes, i, t, 0)


def speed(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """Return the velocity of a free coordinate, given by its index, at a time."""
    return _summed(modes, i, t, 1)


def acceleration(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """Return the acceleration of a free coordinate, given by its index, at a time."""
    return _summed(modes, i, t, 2)


def jerk(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """Return the jerk of a free coordinate, given by its index, at a time."""
    return _summed(modes, i, t, 3)


def plain(modes: list[Mode]) -> list[Mode]:
    """Return modes with the same zeros in time: a single pure sine or 1 − cosine loses its constant factors."""
    if len(modes) != 1 or modes[0].rate is None or ZERO not in (modes[0].rise, modes[0].swing):
        return modes
    only = modes[0]
    rise, swing = (ONE if part != ZERO else ZERO for part in (only.rise, only.swing))
    return [replace(only, shape=[ONE for _ in only.shape], rise=rise, swing=swing)]
