"""Answers from the state at the end of the last phase."""

from collections.abc import Callable, Mapping
from dataclasses import replace

from sim2reason.questions import Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.simulation.quantities.positions import Height, HeightAboveStart, height_at_start
from sim2reason.simulation.quantities.subjects.interactions import members
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol, multiply_factors
from sim2reason.solutions.algebra.functions import Absolute, sum_of_squares
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.goals import GOALS, Components, VectorName, write_answer
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.straight_way import COMPONENT_ATOL, WORLD_AXES, StraightMotion
from sim2reason.solutions.phases.conditions import vector_magnitude
from sim2reason.solutions.phases.equations import PhaseEquations
from sim2reason.solutions.phases.extremes import quantity_of
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.writing.lexicon import DualValue
from sim2reason.solutions.writing.notation import METRES
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError


class EndState(StraightMotion):
    """The state at the end of the last phase, in the symbols of its equations."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder, equations: PhaseEquations) -> None:
        """Take the equations whose symbols have the values at the end."""
        super().__init__(setting, book)
        self._equations = equations

    @property
    def newton(self) -> Newton:
        """Return Newton's laws of the first segment, used only for masses and gravity."""
        return Newton(self.setting.lexicon, self.setting.motion.segments[0])

    def mass(self, body: str) -> Polynomial:
        """Return the mass of a body."""
        m, twin = self.setting.lexicon.mechanism, self.setting.lexicon.twin
        if m.burns:
            raise UnsolvedError("its mass changes")
        return self.setting.lexicon.read(DualValue(m.body[body].mass, twin.body[body].mass))

    @property
    def gravity(self) -> Polynomial:
        """Return the acceleration of free fall, m/s²."""
        m, twin = self.setting.lexicon.mechanism, self.setting.lexicon.twin
        return self.setting.lexicon.read(DualValue(-m.gravity[2], -twin.gravity[2]))

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return the acceleration, velocity or displacement along a coordinate."""
        names = self._equations.names
        return {"a": names.acceleration, "v": names.rate, "s": names.place}[kind](k)

    def vector(self, kind: str, body: str) -> Components:
        """Return a vector of a body by component, along its own axes where the text gives it some."""
        own = self._own(body)
        if kind == "u" or own:
            return super().vector(kind, body)
        equations = self._equations
        if kind == "v":
            return equations.kinematic_vector("velocity", body)
        return equations.acceleration(body) if kind == "a" else equations.displacement(body)

    def component(self, kind: str, body: str, way: Vector) -> Polynomial:
        """Return a vector's component along a world axis, or along the only line on which its body moves."""
        if kind == "u" or way not in (*WORLD_AXES, *((-x, -y, -z) for x, y, z in WORLD_AXES)):
            return super().component(kind, body, way)
        own = self._own(body)
        if own:
            return super().component(kind, body, way)
        return total(
            part.scale(w) for part, w in zip(self.vector(kind, body), way, strict=True) if abs(w) > COMPONENT_ATOL
        )

    def line_component(self, kind: str, body: str) -> Polynomial | None:
        """Return a vector's component along the only straight line on which a body moves; None if there is no line."""
        moving = self.moving([body])
        hinged = any(self.mechanism.coordinates[k].kind == "hinge" for k in moving)
        return None if hinged else super().line_component(kind, body)

    def initial_separation(self, one: str, other: str) -> Components:
        """Return the vector from one body to another at the end, by component."""
        places = self._equations.kinematic_vector("place", one), self._equations.kinematic_vector("place", other)
        x, y, z = (b - a for a, b in zip(*places, strict=True))
        return x, y, z

    def force(self, kind: str, name: str) -> Symbol:
        """Return the symbol of a tension, a normal force or a friction force."""
        equations = self._equations
        if kind == "T":
            rows = [row for row in equations.rows if equations.kind(row).name == name]
            key = f"row{rows[0]}" if rows else ""
        else:
            key = f"{ {'N': 'normal', 'f': 'friction'}[kind] }{self.mechanism.face_number[name]}".replace(" ", "")
        if key not in equations.forces:
            raise UnsolvedError(f"the equations of the last phase have no {kind} of {name}")
        return equations.forces[key]

    # ---- rotation

    def rim(self, kind: str, body: str) -> Polynomial:
        """Return the displacement, velocity or acceleration of a rim of radius 1: those of the angle of rotation."""
        turns = bool(initial_frames(self.mechanism)[body].hinges)
        return self.rate(kind, self._equations.hinge(body)) if turns else NIL

    def radius(self, body: str) -> Polynomial:
        """Return 1, so that quantities of the rim are those of the angle of rotation."""
        del body
        return Polynomial.from_expression(1.0)

    def rim_inertia(self, body: str) -> Polynomial:
        """Return the moment of inertia about the axis through the centre of mass."""
        m, twin = self.setting.lexicon.mechanism, self.setting.lexicon.twin
        hinge = m.coordinates[self._equations.hinge(body)]
        if hinge.body != body or any(m.body[body].center):
            raise UnsolvedError("it does not turn about its centre of mass")
        axis = max(range(3), key=lambda n: abs(hinge.axis[n]))
        return self.setting.lexicon.read(DualValue(m.body[body].inertia[axis], twin.body[body].inertia[axis]))

    def write_arcs(self, body: str) -> None:
        """Write nothing, since the angle itself is a coordinate."""
        del body

    # ---- springs

    def spring(self, what: str, line: str) -> Polynomial:
        """Return a parameter of a spring; the ``strain`` and the ``length`` are those at the end."""
        if what == "length":
            return self._equations.length(line)
        if what == "strain":
            return self._equations.length(line) - self._equations.law(line, "length")
        return self._equations.law(line, what)

    def growth(self, kind: str, line: str) -> Polynomial:
        """Return the rate of a line's length for the kind ``v``; zero for ``s``, since lengths are those at the end."""
        return self._equations.length(line, "rate") if kind == "v" else NIL


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
        return vector_magnitude(parts)
    pairs = zip(parts, target.sense.vector, strict=True)
    return total(part.scale(w) for part, w in pairs if part and w).factored()


def _kinetic(equations: PhaseEquations, target: Target) -> Expression:
    body, lexicon = target.subject, equations.lexicon
    if any(lexicon.mechanism.body[body].inertia) and initial_frames(lexicon.mechanism)[body].hinges:
        raise UnsolvedError("its kinetic energy has a part of rotation")
    mass = lexicon.read(DualValue(lexicon.mechanism.body[body].mass, lexicon.twin.body[body].mass))
    parts = [part.expression() for part in equations.kinematic_vector("velocity", body) if part]
    return multiply_factors(HALF, multiply_factors(mass.expression(), sum_of_squares(parts)))


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


def _angle_turned(equations: PhaseEquations, target: Target) -> Expression:
    return Absolute(equations.names.place(equations.hinge(target.subject)).expression())


def _distance(equations: PhaseEquations, target: Target) -> Expression:
    one, other = members(target.subject)
    pairs = zip(equations.kinematic_vector("place", one), equations.kinematic_vector("place", other), strict=True)
    x, y, z = (b - a for a, b in pairs)
    return vector_magnitude((x, y, z))


def _height(equations: PhaseEquations, target: Target) -> Expression:
    first = NIL
    if target.quantity == Height.name:
        lexicon = equations.lexicon
        first = lexicon.read(
            DualValue(*(height_at_start(m, target.subject) for m in (lexicon.mechanism, lexicon.twin)))
        )
    return Absolute((first + equations.displacement(target.subject)[2]).factored())


VALUES: Mapping[str, Callable[[PhaseEquations, Target], Expression]] = {
    "velocity": lambda equations, target: _vector(equations.kinematic_vector("velocity", target.subject), target),
    "displacement": lambda equations, target: _vector(equations.displacement(target.subject), target),
    "acceleration": lambda equations, target: _vector(equations.acceleration(target.subject), target),
    "kinetic energy": _kinetic,
    "angle turned": _angle_turned,
    "distance": _distance,
    "extension": _extension,
    "angular velocity": _angular,
    "tension": _tension,
    Height.name: _height,
    HeightAboveStart.name: _height,
}


def write_quantity(setting: ProblemContext, book: SolutionBuilder, end: PhaseEquations) -> Symbol:
    """Write the quantity asked for from the state at the end of the last phase, and return its symbol.

    Raises:
        UnsolvedError: the question asks for no quantity, or it has no formula.
    """
    query, target, state = setting.query, setting.target, EndState(setting, book, end)
    if query.kind == "extremum" and isinstance(query, StretchQuery):
        if query.functional == "greatest height":
            height = end.displacement(query.name)[2].factored()
            return write_answer(
                state, height, VectorName("h", METRES, "height"), "", "the height above the starting point"
            )
        target = replace(target, quantity=quantity_of(query.functional)) if target is not None else None
    if target is None:
        raise UnsolvedError("the question asks for no quantity")
    if target.quantity in GOALS:
        return GOALS[target.quantity].write(target, state)
    formula, noun = formula_of(end, target), VectorName.for_quantity(target.quantity)
    return write_answer(state, formula, noun, "", f"the {target.quantity}")
