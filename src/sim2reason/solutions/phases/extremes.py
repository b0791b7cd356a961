"""Greatest and least values within a motion: the formula that vanishes where a quantity is extreme."""

from collections.abc import Callable, Mapping

import numpy as np

from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.simulation.engines.exact.motion import Motion
from sim2reason.solutions.algebra.expressions import Expression
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.goals import Components
from sim2reason.solutions.phases.equations import PhaseEquations
from sim2reason.solutions.writing.steps import UnsolvedError

SAMPLES = 4000  # instants at which the quantity is looked at
ROUNDS = 60  # bisections of an interval with the zero of a rate


def top(motion: Motion, functional: str, name: str, end: float) -> float:
    """Return about when an extreme functional of a subject has its value, s, in the motion up to `end`."""
    found = FUNCTIONALS[functional]
    if not isinstance(found, Extreme):
        raise UnsolvedError(f"{functional} is no greatest or least value")
    times = np.linspace(0.0, end, SAMPLES + 1)[1:-1]
    return float(times[int(np.argmax(found.height(motion.state(times), name)))])


def quantity_of(functional: str) -> str:
    """Return the quantity whose greatest or least value a functional is; empty if it is none."""
    found = FUNCTIONALS[functional]
    return found.quantity.name if isinstance(found, Extreme) else ""


def rate_formulas(equations: PhaseEquations, functional: str, name: str) -> list[Expression]:
    """Return formulas that vanish where the functional is extreme, the simplest first.

    Raises:
        UnsolvedError: no formula is known for its quantity.
    """
    quantity = "height" if functional == "greatest height" else quantity_of(functional)
    if quantity not in RATES:
        raise UnsolvedError(f"no rate is known for the quantity {quantity}")
    return RATES[quantity](equations, name)


def refined(equations: PhaseEquations, formula: Expression, near: float, width: float) -> float:
    """Return the zero of a formula near an instant, s, in the motion of the engine.

    Raises:
        UnsolvedError: the formula does not change its sign there.
    """

    def at(time: float) -> float:
        known = {key: float(value[0]) for key, value in equations.sampled(np.array([time])).items()}
        return float(formula.value(known).real)

    low, high = near - width, near + width
    below, above = at(low), at(high)
    if not below * above < 0.0:
        raise UnsolvedError("the extreme value is no zero of the rate")
    for _ in range(ROUNDS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if at(middle) * below > 0.0 else (low, middle)
    return 0.5 * (low + high)


def _inner(one: Components, other: Components) -> Polynomial:
    return total(a * b for a, b in zip(one, other, strict=True))


def _speed(equations: PhaseEquations, name: str) -> list[Expression]:
    velocity, acceleration = equations.triple("velocity", name), equations.acceleration(name)
    moving = [(v, a) for v, a in zip(velocity, acceleration, strict=True) if v or a]
    simple = [moving[0][1].factored()] if len(moving) == 1 else []
    return [*simple, _inner(velocity, acceleration).expression()]


def _displacement(equations: PhaseEquations, name: str) -> list[Expression]:
    displacement, velocity = equations.displacement(name), equations.triple("velocity", name)
    moving = [v for v in velocity if v]
    simple = [moving[0].factored()] if len(moving) == 1 else []
    return [*simple, _inner(displacement, velocity).expression()]


def _height(equations: PhaseEquations, name: str) -> list[Expression]:
    return [equations.triple("velocity", name)[2].factored()]


def _extension(equations: PhaseEquations, name: str) -> list[Expression]:
    return [equations.length(name, "rate").expression()]


def _hinge(equations: PhaseEquations, name: str, symbols: str) -> list[Expression]:
    return [getattr(equations.names, symbols)[equations.hinge(name)]]


RATES: Mapping[str, Callable[[PhaseEquations, str], list[Expression]]] = {
    "velocity": _speed,
    "kinetic energy": _speed,
    "displacement": _displacement,
    "height": _height,
    "extension": _extension,
    "spring energy": _extension,
    "angular velocity": lambda equations, name: _hinge(equations, name, "accelerations"),
}
