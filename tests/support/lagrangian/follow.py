"""Integration of reference solutions in fixed steps, phase by phase.

A *phase* has equations y′ = f(t, y), observed quantities, and margins that are positive while it lasts. When one
of them falls below zero, `after` gives the next phase and its initial values.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

Array = NDArray[np.float64]
Rate = Callable[[float, Array], Sequence[float] | Array]
Margin = Callable[[float, Array], float]

STAGES = 6  # the order is twice that
ROUNDS = 80  # of the iteration that solves for the stages
PARTS = 16  # of a step in which something happens
EPSILON = 2.3e-16


@dataclass(frozen=True)
class Phase:
    """Phase of a motion; `after` gives the phase that follows an event, or None at the end."""

    rate: Rate
    observe: Callable[[float, Array], Sequence[float]]
    margins: Mapping[str, Margin] = field(default_factory=dict[str, Margin])
    after: "Callable[[str, float, Array], tuple[Phase, Sequence[float]] | None]" = lambda _, __, ___: None


@dataclass
class Record:
    """Observed quantities at the requested times, shape (m, k), and the events."""

    times: list[float] = field(default_factory=list[float])
    observed: list[list[float]] = field(default_factory=list[list[float]])
    events: list[tuple[float, str]] = field(default_factory=list[tuple[float, str]])

    @property
    def array(self) -> Array:
        """Observed quantities as columns."""
        return np.array(self.observed)


def _tableau() -> tuple[Array, Array, Array]:
    """Return Gauss's nodes and weights, and the integrals of the Lagrange polynomials from 0 to each node.

    The matrix has ∫ over [0, cᵢ] of the polynomial that is 1 at cⱼ, 0 at the other nodes.
    Legendre's polynomials on [0, 1] have the integrals (Pₖ₊₁ − Pₖ₋₁) / (2(2k + 1)).
    """
    nodes, weights = legendre.leggauss(STAGES)
    values = np.array([legendre.legval(nodes, np.eye(STAGES + 1)[k]) for k in range(STAGES + 1)])
    below = np.vstack(
        [-np.ones(STAGES), values[: STAGES - 1]]
    )  # P₋₁ stands for the constant that makes P₀'s start at 0
    integrals = np.array([(values[k + 1] - below[k]) / (2.0 * (2 * k + 1)) for k in range(STAGES)])
    return 0.5 * (nodes + 1.0), 0.5 * weights, np.linalg.solve(values[:STAGES], integrals).T


NODES, WEIGHTS, MATRIX = _tableau()


def step(rate: Rate, t: float, y: Array, h: float) -> Array:
    """Take one step of collocation at Gauss's nodes.

    Source: Hairer, Lubich, Wanner, Geometric Numerical Integration, II.1.3.
    """
    slopes = np.repeat(np.asarray(rate(t, y), dtype=float)[None, :], STAGES, axis=0)
    best = np.inf
    for _ in range(ROUNDS):
        stages = y + h * (MATRIX @ slopes)
        found = np.array([rate(t + c * h, stage) for c, stage in zip(NODES, stages, strict=True)], dtype=float)
        change = abs(h) * float(np.abs(found - slopes).max(initial=0.0))
        slopes = found
        if change <= EPSILON * float(np.abs(y).max(initial=1e-3)) or (change >= best and change <= 1e-11):
            return y + h * (WEIGHTS @ slopes)
        best = min(best, change)
    raise ArithmeticError(f"the step of {h:g} at {t:g} is too long to be solved")


def at_margin(rate: Rate, margin: Margin, t: float, y: Array) -> tuple[float, Array]:
    """Return the time and values of an event near (t, y), by integrating over the margin instead of the time.

    M. Hénon, On the numerical computation of Poincaré maps, Physica D 5 (1982): dy/dg = f/ġ and dt/dg = 1/ġ. The
    slope ġ is a difference quotient, so the step is repeated until the margin is zero.
    """

    def speed(t: float, y: Array) -> float:
        slope, small = np.asarray(rate(t, y), dtype=float), 1e-4
        return (margin(t + small, y + small * slope) - margin(t - small, y - small * slope)) / (2.0 * small)

    def by_margin(_: float, z: Array) -> Array:
        return np.append(np.asarray(rate(float(z[-1]), z[:-1]), dtype=float), 1.0) / speed(float(z[-1]), z[:-1])

    for _ in range(4):
        left = margin(t, y)
        if left == 0.0:
            break
        z = step(by_margin, left, np.append(y, t), -left)
        t, y = float(z[-1]), z[:-1]
    return t, y


def follow(phase: Phase | None, y: Sequence[float], times: Array, substeps: int) -> Record:
    """Return the motion from `phase` and `y` at times[0], with at least `substeps` steps between two times."""
    record, now, values = Record(), float(times[0]), np.asarray(y, dtype=float)
    for target in map(float, times):
        full = (float(times[1]) - float(times[0])) / substeps
        while phase is not None and target - now > 1e-12 * abs(target):
            h = min(full, target - now)
            after = step(phase.rate, now, values, h)
            struck = _struck(phase, now, values, now + h, after)
            if not struck:
                now, values = (target if h < full else now + h), after
                continue
            name, now, values = _first(phase, now, values, h)
            record.events.append((now, name))
            following = phase.after(name, now, values)
            phase = None if following is None else following[0]
            values = values if following is None else np.asarray(following[1], dtype=float)
        if phase is None:
            break
        record.times.append(target)
        record.observed.append([float(part) for part in phase.observe(target, values)])
    return record


def _struck(phase: Phase, t: float, y: Array, later: float, after: Array) -> list[str]:
    return [name for name, margin in phase.margins.items() if margin(later, after) < 0.0 < margin(t, y)]


def _first(phase: Phase, t: float, y: Array, h: float) -> tuple[str, float, Array]:
    """Return the first event of a step, with its time and values, by shorter steps."""
    for _ in range(PARTS):
        after = step(phase.rate, t, y, h / PARTS)
        names = _struck(phase, t, y, t + h / PARTS, after)
        if names:
            found = [(*at_margin(phase.rate, phase.margins[name], t, y), name) for name in names]
            now, values, name = min(found, key=lambda each: each[0])
            return name, now, values
        t, y = t + h / PARTS, after
    raise ArithmeticError(f"an event near {t:g} is gone when looked at closely")
