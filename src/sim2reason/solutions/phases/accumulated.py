"""Rates of quantities that add up over a motion: work, impulse, heat, path length and the like."""

from collections.abc import Callable, Mapping
from math import radians

from sim2reason.dsl.mechanism import Elastic
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.simulation.trace import Trace
from sim2reason.solutions.algebra.expressions import Expression, Number, multiplied
from sim2reason.solutions.algebra.functions import Absolute, Power
from sim2reason.solutions.phases.conditions import size
from sim2reason.solutions.phases.equations import PhaseEquations
from sim2reason.solutions.writing.steps import UnsolvedError

HALF = Number(0.5)


def value_of(functional: str, name: str, trace: Trace, end: float) -> float:
    """Return the value of a functional from the start to a time (s) in the motion of the engine.

    Raises:
        UnsolvedError: it has none.
    """
    found = FUNCTIONALS[functional].value(trace, name, end)
    if found is None:
        raise UnsolvedError(f"the motion has no {functional}")
    return radians(found) if FUNCTIONALS[functional].unit == "deg" else found


def rate_of(functional: str, name: str, equations: PhaseEquations) -> Expression:
    """Return the rate at which a functional of a subject grows during a phase.

    Raises:
        UnsolvedError: no rate is known for the functional.
    """
    rate = RATES.get(functional)
    if rate is None:
        raise UnsolvedError(f"no rate is known for {functional}")
    return rate(equations, name)


def _path(equations: PhaseEquations, name: str) -> Expression:
    return size(equations.triple("velocity", name))


def _tension(equations: PhaseEquations, name: str) -> Expression:
    rows = [row for row in equations.rows if equations.kind(row).name == name]
    if rows:
        return equations.force("row", rows[0]).expression()
    return Number(0.0)


def _dashpot(equations: PhaseEquations, name: str) -> Expression:
    law = equations.mechanism.line[name].law
    assert isinstance(law, Elastic)
    rate = equations.length(name, "rate").expression()
    return multiplied(equations.law(name, "damping").expression(), Power(rate, 2))


def _friction(equations: PhaseEquations, name: str) -> Expression:
    face = equations.mechanism.face_number[name]
    if not equations.rough.get(face, 0):
        return Number(0.0)
    force = equations.kinetic_friction(face).expression()
    return multiplied(force, Absolute(equations.slip(face).expression()))


def _angle(equations: PhaseEquations, name: str) -> Expression:
    return Absolute(equations.names.rates[equations.hinge(name)])


RATES: Mapping[str, Callable[[PhaseEquations, str], Expression]] = {
    "distance travelled": _path,
    "impulse of a tension": _tension,
    "energy dissipated by a dashpot": _dashpot,
    "energy dissipated by friction": _friction,
    "total angle": _angle,
}
