"""Quantities at an instant as formulas of the coordinates, for conditions such as *the speed is 2.1 m/s*."""

from collections.abc import Callable, Mapping

from sim2reason.dsl.frames import start
from sim2reason.quantities.subjects.pairs import members
from sim2reason.questions import Target
from sim2reason.solutions.algebra.expressions import Expression, Number, multiplied
from sim2reason.solutions.algebra.functions import Absolute, squares
from sim2reason.solutions.algebra.polynomials import total
from sim2reason.solutions.goals import Components
from sim2reason.solutions.phases.conditions import size
from sim2reason.solutions.phases.equations import PhaseEquations
from sim2reason.solutions.writing.lexicon import Both
from sim2reason.solutions.writing.steps import UnsolvedError

HALF = Number(0.5)


def formula_of(equations: PhaseEquations, target: Target) -> Expression:
    """Return a quantity of a subject as a formula.

    Raises:
        UnsolvedError: no formula is known for the quantity.
    """
    if target.quantity not in VALUES:
        raise UnsolvedError(f"no formula is known for the quantity {target.quantity}")
    return VALUES[target.quantity](equations, target)


def _vector(parts: Components, target: Target) -> Expression:
    if target.sense is None:
        return size(parts)
    pairs = zip(parts, target.sense.vector, strict=True)
    return total(part.scaled(w) for part, w in pairs if part and w).factored()


def _kinetic(equations: PhaseEquations, target: Target) -> Expression:
    body, lexicon = target.subject, equations.lexicon
    if any(lexicon.mechanism.body[body].inertia) and start(lexicon.mechanism)[body].hinges:
        raise UnsolvedError("its kinetic energy has a part of rotation")
    mass = lexicon.read(Both(lexicon.mechanism.body[body].mass, lexicon.twin.body[body].mass))
    parts = [part.expression() for part in equations.triple("velocity", body) if part]
    return multiplied(HALF, multiplied(mass.expression(), squares(parts)))


def _extension(equations: PhaseEquations, target: Target) -> Expression:
    stretched = equations.length(target.subject) - equations.law(target.subject, "length")
    return stretched.expression() if target.sense is not None else Absolute(stretched.expression())


def _angular(equations: PhaseEquations, target: Target) -> Expression:
    rate = equations.names.rate(equations.hinge(target.subject))
    return rate.expression() if target.sense is not None else Absolute(rate.expression())


def _tension(equations: PhaseEquations, target: Target) -> Expression:
    rows = [row for row in equations.rows if equations.kind(row).name == target.subject]
    if not rows:
        raise UnsolvedError("the string is slack")
    return equations.force("row", rows[0]).expression()


def _turned(equations: PhaseEquations, target: Target) -> Expression:
    return Absolute(equations.names.place(equations.hinge(target.subject)).expression())


def _distance(equations: PhaseEquations, target: Target) -> Expression:
    one, other = members(target.subject)
    pairs = zip(equations.triple("place", one), equations.triple("place", other), strict=True)
    x, y, z = (b - a for a, b in pairs)
    return size((x, y, z))


VALUES: Mapping[str, Callable[[PhaseEquations, Target], Expression]] = {
    "velocity": lambda equations, target: _vector(equations.triple("velocity", target.subject), target),
    "displacement": lambda equations, target: _vector(equations.displacement(target.subject), target),
    "acceleration": lambda equations, target: _vector(equations.acceleration(target.subject), target),
    "kinetic energy": _kinetic,
    "angle turned": _turned,
    "distance": _distance,
    "extension": _extension,
    "angular velocity": _angular,
    "tension": _tension,
}
