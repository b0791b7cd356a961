"""One normal mode, and sums of modes over time."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import Call, Power

UNNAMED = Symbol("q")


@dataclass
class Mode:
    """One mode: λ, how much each free coordinate takes part, and what the start excites."""

    number: int
    square: Expression  # λ; zero where nothing drives it back
    first: int = 0  # the free coordinate that moves the most, and by 1
    shape: list[Expression] = field(default_factory=list[Expression])
    name: Symbol = UNNAMED  # of its coordinate ξ
    rate: Symbol | None = None
    rise: Expression = ZERO  # of ξ at the place of balance, q/µλ; of a mode without λ its acceleration q/µ
    swing: Expression = ZERO  # p/µω; of a mode without λ its speed p/µ


def _summed(modes: Sequence[Mode], i: int, t: Symbol, order: int) -> Expression:
    """Return the sum of the modes, or its derivative of some order by the time."""
    found: Expression = ZERO
    for mode in modes:
        inner = _free(mode, t, order) if mode.rate is None else _swung(mode, mode.rate, t, order)
        found = found + mode.shape[i] * inner
    return found


def _free(mode: Mode, t: Symbol, order: int) -> Expression:
    """Of a mode that nothing drives back: c t + b t²/2."""
    if order == 0:
        return mode.swing * t + 0.5 * mode.rise * Power(t, 2)
    if order == 1:
        return mode.swing + mode.rise * t
    return mode.rise if order == 2 else ZERO


def _swung(mode: Mode, rate: Symbol, t: Symbol, order: int) -> Expression:
    """B (1 − cos ωt) + c sin ωt."""
    cosine, sine = Call("cos", rate * t), Call("sin", rate * t)
    rises = {0: ONE - cosine, 1: sine, 2: cosine, 3: -sine}[order]
    swings = {0: sine, 1: cosine, 2: -sine, 3: -cosine}[order]
    found = mode.rise * rises + mode.swing * swings
    return found if order == 0 else (Power(rate, order) if order > 1 else rate) * found


def place(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """Return how far a free coordinate (by its place among them) has come at a time."""
    return _summed(modes, i, t, 0)


def speed(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """Return its rate."""
    return _summed(modes, i, t, 1)


def acceleration(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """Return the rate of that."""
    return _summed(modes, i, t, 2)


def jerk(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """And of that."""
    return _summed(modes, i, t, 3)


def plain(modes: list[Mode]) -> list[Mode]:
    """A single mode that only one thing excites, of size one: when it passes zero, how large it is has no bearing."""
    if len(modes) != 1 or modes[0].rate is None or ZERO not in (modes[0].rise, modes[0].swing):
        return modes
    only = modes[0]
    rise, swing = (ONE if part != ZERO else ZERO for part in (only.rise, only.swing))
    return [replace(only, shape=[ONE for _ in only.shape], rise=rise, swing=swing)]
