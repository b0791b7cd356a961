"""The Runge–Kutta pair of order 8(5, 3) by Dormand and Prince, with its dense output of order 7.

Coefficients: E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I (1993), code DOP853.
A step is straight-line code, generated once for each number of unknowns, because loops over so few unknowns cost more
than the arithmetic.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from itertools import chain
from math import sqrt
from typing import NamedTuple

from sim2reason.simulation.engines.exact.code import compiled
from sim2reason.simulation.engines.exact.dop853_table import DENSE, ERROR_3, ERROR_5, NODES, STAGES

Values = tuple[float, ...]
Rate = Callable[[float, Values], Values]
Stages = tuple[Values, ...]
"""The rates (time derivatives) at all stages; the last stage is at the end of the step."""

ERROR_ORDER = 8  # order of the error estimate
COEFFICIENT_COUNT = 7  # coefficients of the polynomial of each unknown over a step
SAFETY, MIN_STEP_RATIO, MAX_STEP_RATIO = 0.9, 0.2, 8.0  # safety factor, smallest and largest ratio of successive steps


class Advance(NamedTuple):
    """An attempted step: the values at its end, the rates of its stages, and its error relative to the tolerance."""

    values: Values
    stages: Stages
    error: float


def advance(rate: Rate, time: float, values: Values, first: Values, h: float, tolerance: Sequence[float]) -> Advance:
    """Attempt a step of size `h` from `values`, where the rate is `first`; `tolerance` is absolute and relative."""
    new, stages, fifth, third = _stepper(len(values))(rate, time, values, first, h, *tolerance)
    if fifth == 0.0:
        return Advance(new, stages, 0.0)
    return Advance(new, stages, abs(h) * fifth / sqrt((fifth + 0.01 * third) * len(values)))


def step_ratio(error: float) -> float:
    """Return the ratio of the next step size to this one, given the error relative to the tolerance."""
    return (
        MAX_STEP_RATIO
        if error == 0.0
        else min(MAX_STEP_RATIO, max(MIN_STEP_RATIO, SAFETY * error ** (-1.0 / ERROR_ORDER)))
    )


def dense(rate: Rate, time: float, values: Values, h: float, new: Values, stages: Stages) -> tuple[Values, ...]:
    """Return the polynomial of each unknown over a step: seven coefficients, lowest power first."""
    more = _extension(len(values))(rate, time, values, h, stages)
    return _polynomial(len(values))(h, values, new, stages, more)


def interpolated(values: Values, polynomial: tuple[Values, ...], x: float) -> Values:
    """Return all unknowns at a fraction `x` of the step."""
    unknowns: Values = _interpolation(len(values))(values, polynomial, x)
    return unknowns


def interpolated_one(start: float, coefficients: Values, x: float) -> float:
    """Return one unknown at a fraction `x` of the step, given its value at the start."""
    a, b, c, d, e, f, g = coefficients
    y = 1.0 - x
    return start + x * (a + y * (b + x * (c + y * (d + x * (e + y * (f + x * g))))))


def first_step(rate: Rate, time: float, values: Values, first: Values, tolerance: Sequence[float]) -> float:
    """Return the size of the first step: Hairer, Nørsett, Wanner, section II.4."""
    absolute, relative = tolerance
    scales = [absolute + relative * abs(value) for value in values]
    d0, d1 = _norm(values, scales), _norm(first, scales)
    h = 1e-6 if d0 < 1e-5 or d1 < 1e-5 else 0.01 * d0 / d1
    ahead = rate(time + h, tuple(value + h * slope for value, slope in zip(values, first, strict=True)))
    d2 = _norm([b - a for a, b in zip(first, ahead, strict=True)], scales) / h
    most = max(d1, d2)
    return min(100.0 * h, (0.01 / most) ** (1.0 / ERROR_ORDER) if most > 1e-15 else max(1e-6, 1e-3 * h))


def _norm(values: Sequence[float], scales: Sequence[float]) -> float:
    total = 0.0  # no `sum`, which compensates rounding from Python 3.12 on
    for value, scale in zip(values, scales, strict=True):
        total += (value / scale) ** 2
    return sqrt(total / max(len(scales), 1))


# ---- the code of a step


def _names(letter: str, size: int) -> str:
    return "(" + "".join(f"{letter}{i}, " for i in range(size)) + ")"


def _sum(weights: Mapping[int, float], unknown: int) -> str:
    return " + ".join(f"{weight!r} * k{stage}_{unknown}" for stage, weight in weights.items())


def _stage(number: int, size: int) -> list[str]:
    """Return the lines of code that evaluate one stage."""
    weights = STAGES[number - 1]
    values = "".join(f"y{i} + h * ({_sum(weights, i)}), " for i in range(size))
    return [f"k{number} = rate(t + {NODES[number]!r} * h, ({values}))", f"{_names(f'k{number}_', size)} = k{number}"]


@cache
def _stepper(size: int) -> Callable[..., tuple[Values, Stages, float, float]]:
    lines = [f"{_names('y', size)} = y", f"{_names('k0_', size)} = k0"]
    lines += chain.from_iterable(_stage(number, size) for number in range(1, 12))
    lines += [f"n{i} = y{i} + h * ({_sum(STAGES[11], i)})" for i in range(size)]
    lines += [f"k12 = rate(t + h, {_names('n', size)})", f"{_names('k12_', size)} = k12", "fifth = third = 0.0"]
    for i in range(size):
        lines.append(f"scale = absolute + relative * max(abs(y{i}), abs(n{i}))")
        lines.append(f"fifth += (({_sum(ERROR_5, i)}) / scale) ** 2")
        lines.append(f"third += (({_sum(ERROR_3, i)}) / scale) ** 2")
    lines.append(f"return {_names('n', size)}, {_names('k', 13)}, fifth, third")
    return compiled("rate, t, y, k0, h, absolute, relative", lines)


@cache
def _extension(size: int) -> Callable[..., Stages]:
    """Compile the function that computes the three extra stages of dense output."""
    lines = [f"{_names('y', size)} = y", f"{_names('k', 13)} = stages"]
    lines += [f"{_names(f'k{number}_', size)} = k{number}" for number in range(13)]
    lines += chain.from_iterable(_stage(number, size) for number in range(13, 16))
    lines.append("return k13, k14, k15")
    return compiled("rate, t, y, h, stages", lines)


@cache
def _interpolation(size: int) -> Callable[..., Values]:
    lines = [f"{_names('y', size)} = values", "z = 1.0 - x"]
    lines += [f"a{i}, b{i}, c{i}, d{i}, e{i}, f{i}, g{i} = polynomial[{i}]" for i in range(size)]
    expressions = (
        f"y{i} + x * (a{i} + z * (b{i} + x * (c{i} + z * (d{i} + x * (e{i} + z * (f{i} + x * g{i})))))), "
        for i in range(size)
    )
    lines.append(f"return ({''.join(expressions)})")
    return compiled("values, polynomial, x", lines)


@cache
def _polynomial(size: int) -> Callable[..., tuple[Values, ...]]:
    lines = [f"{_names('y', size)} = y", f"{_names('n', size)} = n", f"{_names('k', 16)} = (*stages, *more)"]
    lines += [f"{_names(f'k{number}_', size)} = k{number}" for number in range(16)]
    rows: list[str] = []
    for i in range(size):
        lines.append(f"d{i} = n{i} - y{i}")
        high = ", ".join(f"h * ({_sum(weights, i)})" for weights in DENSE)
        rows.append(f"(d{i}, h * k0_{i} - d{i}, 2.0 * d{i} - h * (k12_{i} + k0_{i}), {high})")
    lines.append(f"return ({', '.join(rows)},)")
    return compiled("h, y, n, stages, more", lines)
