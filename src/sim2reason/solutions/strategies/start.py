"""The start of a motion: initial forces by Newton's law, and speeds that are extreme at the start."""

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.times import AtStart
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Elastic, Line, Mechanism
from sim2reason.scenes.dsl.vectors import Vector, dot, subtract_triples
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol, multiply_factors, ratio, sum_terms
from sim2reason.solutions.algebra.functions import Power, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.goals import GOALS
from sim2reason.solutions.laws.dynamics import gravitational_constant
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.oscillations.linear_motion import nonlinear_reason
from sim2reason.solutions.setting import ProblemContext, capitalized, join_words
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.lexicon import DualValue
from sim2reason.solutions.writing.notation import ACCELERATION, METRES, NEWTONS, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError


@strategy
class ForcesAtStart(Strategy):
    """The strategy for the initial acceleration or net force on a body under springs, weight and attractions."""

    name = "forces at the start"
    cost = 1.2
    kinds = frozenset({"start"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        free = any(body.coordinates and not _bound(mechanism, body.name) for body in mechanism.bodies)
        return "" if free else "every body is led, or pushed by something"

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: all, or none if a force changes direction."""
        return frozenset[str]() if nonlinear_reason(mechanism) else self.kinds

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        target = setting.query.target
        if not isinstance(setting.query.moment, AtStart) or target is None:
            return "it is not about the start"
        if target.quantity not in ("acceleration", "net force"):
            return "neither an acceleration nor a net force is asked for"
        return _bound(setting.mechanism, target.subject)

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write each force and the acceleration, and return the symbol of the answer."""
        model = _InitialAccelerations(setting, book)
        assert model.target is not None
        return GOALS[model.target.quantity].write(model.target, model).name


def _bound(m: Mechanism, name: str) -> str:
    """Return the reason that a body cannot move freely, such as *it rides on something*; empty if it moves freely."""
    if name not in m.body or m.body[name].parent is not None:
        return "it rides on something"
    if any(body.parent == name for body in m.bodies):
        return "something rides on it"
    if any(c.kind != "slide" for c in m.body[name].coordinates):
        return "it turns"
    faces = any(face.subject == name and face.friction for face in m.faces)
    other = any(not isinstance(line.law, Elastic) for line in _held(m, name))
    pushed = any(one.body == name for one in (*m.forces, *m.burns))
    return "other forces than those of springs and weight act" if faces or other or pushed else ""


def _held(m: Mechanism, body: str) -> list[Line]:
    return [line for line in m.lines if any(m.site[site].body == body for site in line.through)]


class _InitialAccelerations(StraightMotion):
    """The accelerations at t = 0."""

    @property
    def newton(self) -> Newton:
        """Return Newton's laws, for masses alone."""
        return self._newton

    @cached_property
    def _newton(self) -> Newton:
        return Newton(self.setting.lexicon, self.setting.motion.segments[0])

    def mass(self, body: str) -> Polynomial:
        """Return the mass of a body."""
        return self.setting.lexicon.formula_for(lambda m: m.body[body].mass)

    def force(self, kind: str, name: str) -> Symbol:
        """Raise UnsolvedError, since only net forces follow."""
        raise UnsolvedError(f"no {kind} of {name}")

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return the initial acceleration of a coordinate; UnsolvedError for velocities and displacements."""
        if kind != "a":
            raise UnsolvedError("only accelerations follow from the forces at the start")
        if k in self._axes and k not in self._wanted():
            return NIL  # square to the component that is asked for, which has no part of it
        if k not in self._accelerations:
            raise UnsolvedError("what carries it is accelerated, too")
        return Polynomial.from_expression(self._accelerations[k])

    # ---- places

    @cached_property
    def _body(self) -> str:
        assert self.target is not None
        return self.target.subject

    @cached_property
    def _axes(self) -> dict[int, tuple[Vector, Vector]]:
        """Return the direction of each coordinate of the body, in the mechanism and in its twin."""
        lexicon = self.setting.lexicon
        pairs = zip(lexicon.mechanism.coordinates, lexicon.twin.coordinates, strict=True)
        return {k: (a.axis, b.axis) for k, (a, b) in enumerate(pairs) if a.body == self._body}

    def _vector_between(self, ends: list[tuple[Vector, Vector]]) -> dict[int, Polynomial]:
        """Return the vector between two points by coordinate; `ends` has both, in the mechanism and in its twin."""
        found: dict[int, Polynomial] = {}
        for k, axes in self._axes.items():
            values = [float(dot(subtract_triples(b, a), axis)) for (a, b), axis in zip(ends, axes, strict=True)]
            found[k] = self.setting.lexicon.read(DualValue(values[0], values[1]))
        return found

    def _distance(self, apart: dict[int, Polynomial], base: str, mark: str, said: str) -> Symbol:
        kept = [part for part in apart.values() if part]
        squares: Expression = ZERO
        for part in kept:
            squares = sum_terms(squares, Power(part.expression(), 2))
        only = kept[0].expression() if len(kept) == 1 else ZERO
        sign = 1.0 if len(kept) == 1 and self.book.value(only) >= 0.0 else -1.0
        formula = (only if sign > 0.0 else -only) if len(kept) == 1 else Root(squares)
        step, name = self.book.begin_step("length"), self.book.fresh(base, mark)
        step.add_text(f"{said} {step.result(name, formula, METRES, law=True)}.")
        step.close()
        return name

    # ---- forces

    @cached_property
    def _accelerations(self) -> dict[int, Symbol]:
        pulls = [*self._springs(), *self._attractions()]
        heavy = any(not per_mass for *_, per_mass in pulls)
        mass: Expression = self.mass(self._body).expression() if heavy else ZERO
        found = dict[int, Symbol]()
        step, said = self.book.begin_step("newton"), list[str]()
        asked = self._wanted()
        for k in asked:
            whole: Expression = ZERO
            for strength, apart, length, per_mass in pulls:
                if apart[k]:
                    along = multiply_factors(strength, ratio(apart[k].expression(), length))
                    whole = sum_terms(whole, along if per_mass else ratio(along, mass))
            weight = self._weight(k)
            whole = sum_terms(whole, weight.expression())
            label = self.mechanism.coordinates[k].label
            several = len(self._axes) > 1
            mark = self.setting.subscript_of(self._body)
            parts = [part for part in (mark, label if several else "") if part]
            found[k] = self.book.fresh("a", ",".join(parts))
            said.append(step.result(found[k], whole, ACCELERATION, law=True))
        step.add_text(f"By Newton's second law, {join_words(said)}.")
        step.close()
        return found

    def _wanted(self) -> list[int]:
        """Return the coordinates whose acceleration is asked for: one for a component, otherwise all."""
        target = self.target
        assert target is not None
        if target.sense is None or not any(target.sense.vector):
            return list(self._axes)
        return [k for k, (axis, _) in self._axes.items() if abs(dot(axis, target.sense.vector)) > 1e-9]

    def _weight(self, k: int) -> Polynomial:
        lexicon = self.setting.lexicon
        return lexicon.formula_for(lambda m: -m.gravity[2]) * lexicon.formula_for(lambda m: -m.coordinates[k].axis[2])

    def _springs(self) -> list[tuple[Expression, dict[int, Polynomial], Expression, bool]]:
        """Write the force of each spring; return it, the vector to the other end, its length, and False (a force)."""
        m, lexicon = self.mechanism, self.setting.lexicon
        found: list[tuple[Expression, dict[int, Polynomial], Expression, bool]] = []
        for line in _held(m, self._body):
            number, law = m.lines.index(line), line.law
            twin = lexicon.twin.lines[number]
            assert isinstance(law, Elastic)
            assert isinstance(twin.law, Elastic)
            if law.side or len(line.through) != 2:
                raise UnsolvedError("a spring that acts only one way")
            first = m.site[line.through[0]].body == self._body
            near, far = (line.through[0], line.through[1]) if first else (line.through[1], line.through[0])
            ends = [(f.site(near).place, f.site(far).place) for f in (initial_frames(m), initial_frames(lexicon.twin))]
            apart = self._vector_between(ends)
            mark = str(len(found) + 1) if len(_held(m, self._body)) > 1 else ""
            which = f"Spring {mark}" if mark else "The spring"
            length = self._distance(apart, r"\ell", mark, f"{which} has the length")
            stiffness = lexicon.read(DualValue(law.stiffness, twin.law.stiffness)).expression()
            natural = lexicon.read(DualValue(law.length, twin.law.length)).expression()
            step, name = self.book.begin_step("spring"), self.book.fresh("F", mark)
            formula, pulls = multiply_factors(stiffness, sum_terms(length, -natural)), "It pulls"
            if growth := self._growing(line, apart, length):
                damping = lexicon.read(DualValue(law.damping, twin.law.damping)).expression()
                formula, pulls = (
                    sum_terms(formula, multiply_factors(damping, growth)),
                    f"{which} and its dashpot together pull",
                )
            sure = self.book.value(formula) >= 0.0 and not self.book.is_hidden(formula)
            sign = "" if sure else ", a negative value being a push"
            step.add_text(f"{pulls} with the force {step.result(name, formula, NEWTONS, law=True)}{sign}.")
            step.close()
            found.append((name, apart, length, False))
        return found

    def _growing(self, line: Line, apart: dict[int, Polynomial], length: Expression) -> Expression | None:
        """Write the rate of extension of a damped spring at the start, m/s; return its symbol or None."""
        assert isinstance(line.law, Elastic)
        others = [c for c in self.mechanism.coordinates if self.mechanism.number[c.name] not in self._axes]
        speeds = {k: self.first_speeds[k] for k in self._axes if k in self.first_speeds}
        if not line.law.damping or not (speeds or any(c.speed for c in others)):
            return None
        if any(c.speed for c in others):
            raise UnsolvedError("a damped spring between two that move")
        away = total(apart[k] * speed for k, speed in speeds.items()).scale(-1.0)
        step, name = self.book.begin_step("growth"), self.book.fresh("u")
        step.add_text(
            f"Its length changes at the rate {step.result(name, ratio(away.expression(), length), SPEED, law=True)}."
        )
        step.close()
        return name

    def _attractions(self) -> list[tuple[Expression, dict[int, Polynomial], Expression, bool]]:
        """Write the acceleration by each attraction; return it, the vector to that body, its length, and True."""
        m, lexicon = self.mechanism, self.setting.lexicon
        found: list[tuple[Expression, dict[int, Polynomial], Expression, bool]] = []
        pulls = [pull for pull in m.attractions if self._body in (pull.a, pull.b)]
        for pull in pulls:
            if pull.power != 2.0:
                raise UnsolvedError("an attraction that does not fall with the square of the distance")
            other = pull.b if pull.a == self._body else pull.a
            ends = [
                (f.center(self._body).place, f.center(other).place)
                for f in (initial_frames(m), initial_frames(lexicon.twin))
            ]
            apart, constant = self._vector_between(ends), gravitational_constant(self.book, pull.constant)
            who = capitalized(self.setting.display_name(other))
            r = self._distance(apart, "r", self.setting.subscript_of(other), f"{who} is at the distance")
            step, name = (
                self.book.begin_step("attraction"),
                self.book.fresh("g", self.setting.subscript_of(other) or "1"),
            )
            heavy = self.mass(other).expression()
            formula = ratio(multiply_factors(constant, heavy), Power(r, 2))
            step.add_text(f"Its acceleration is {step.result(name, formula, ACCELERATION, law=True)}.")
            step.close()
            found.append((name, apart, r, True))
        return found


QUANTITIES = frozenset({"velocity", "kinetic energy"})


@strategy
class InitialValue(Strategy):
    """The strategy for an extreme speed or kinetic energy that is the value at the start, from given velocities."""

    name = "initial value"
    cost = 0.5
    drawn = False
    kinds = frozenset({"start"})

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: none, as no generated question asks for this value."""
        del mechanism
        return frozenset()

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason that a question is about no extreme speed or kinetic energy at the start; else empty."""
        target = setting.target
        if setting.extreme is None or not isinstance(setting.query.moment, AtStart) or target is None:
            return "it is about no extreme value at the start"
        return "" if target.quantity in QUANTITIES else f"no way to the quantity {target.quantity}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the speed or kinetic energy at the start from the components of the velocity; return its symbol."""
        model = _InitialVelocities(setting, book)
        assert model.target is not None
        return GOALS[model.target.quantity].write(model.target, model).name


class _InitialVelocities(StraightMotion):
    """Velocities at t = 0."""

    @property
    def newton(self) -> Newton:
        """Return the laws of the first segment, for masses and directions alone."""
        return self._newton

    @cached_property
    def _newton(self) -> Newton:
        return Newton(self.setting.lexicon, self.setting.motion.segments[0])

    def force(self, kind: str, name: str) -> Symbol:
        """Raise UnsolvedError, since a force would need the accelerations."""
        raise UnsolvedError(f"no {kind} of {name}")

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return the initial velocity along a coordinate."""
        if kind != "v":
            raise UnsolvedError("only velocities are known at the start")
        return self.first_speeds.get(k, NIL)
