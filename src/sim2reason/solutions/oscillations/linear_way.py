"""Answers about motions with linear equations, in terms of the free coordinates."""

from abc import abstractmethod

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.vectors import Vector, dot
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.elimination import solve_linear
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.goals import Components
from sim2reason.solutions.laws.newton import Newton, Row
from sim2reason.solutions.laws.rolling_words import rim_inertia_words
from sim2reason.solutions.laws.straight_way import COMPONENT_ATOL, StraightMotion
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.oscillations.net_force import greatest_target, time_of_greatest, write_tension_work
from sim2reason.solutions.oscillations.relative_motion import RelativeMotion
from sim2reason.solutions.setting import ProblemContext, capitalized, join_words
from sim2reason.solutions.writing.notation import IMPULSE, NEWTONS
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

TIMES = {0.5: "half as far as", 2.0: "twice as far as", 1.0: "as far as"}


class LinearMotionModel(StraightMotion):
    """A motion model that expresses all quantities by the values and rates of the free coordinates."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Take the question and the solution builder; if a greatest value is asked for, its quantity is the target."""
        super().__init__(setting, book)
        self.greatest = greatest_target(setting)
        self.target = self.greatest or self.target

    @abstractmethod
    def place(self, i: int) -> Polynomial:
        """Return the displacement of the free coordinate with an index at the moment of the question."""

    @abstractmethod
    def speed(self, i: int) -> Polynomial:
        """Return the rate of the free coordinate with an index at the moment of the question."""

    @abstractmethod
    def acceleration(self, i: int) -> Polynomial:
        """Return the second time derivative of the free coordinate with an index at the moment of the question."""

    # ---- the motion

    @cached_property
    def segment(self) -> Segment:
        """Return the only segment of the motion up to the question's moment; UnsolvedError if there are several."""
        until = time_of_greatest(self.setting) if self.greatest else self.setting.time
        segments = [s for s in self.setting.motion.segments if s.start < until or s.start == 0.0]
        if len(segments) > 1:
            raise UnsolvedError("something changes on the way")
        return segments[0]

    @property
    def motion(self) -> LinearMotion | RelativeMotion:
        """Return the equations that give the answer: the whole motion, or a relative motion."""
        return self.linear

    @cached_property
    def linear(self) -> LinearMotion:
        """Return the equations of the motion, with the bodies of the question preferred as free coordinates."""
        moment = self.query.moment
        names = [name for name in (moment.subjects if moment is not None else ()) if name in self.mechanism.body]
        heavy = [k for body in self.mechanism.bodies if body.mass for k in self.moving([body.name])]
        slides = [k for k in heavy if self.mechanism.coordinates[k].kind == "slide"]
        mentioned = [k for k in slides if self.mechanism.coordinates[k].body in self.setting.words.mentions]
        wanted = [*self.moving(names), *self.asked_coordinates(), *mentioned, *slides]
        return LinearMotion.for_segment(self.setting, self.segment, tuple(dict.fromkeys(wanted)))

    @property
    def newton(self) -> Newton:
        """Return Newton's laws with the forces of springs."""
        return self.motion.laws

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return the acceleration, velocity or displacement of a coordinate by those of the free ones."""
        of = {"a": self.acceleration, "v": self.speed, "s": self.place}[kind]
        return total(of(i).scale(part) for i, part in self.motion.ratios[k].items())

    def initial_rate(self, i: int) -> Polynomial:
        """Return the rate of a free coordinate at the start."""
        return self.first_speeds.get(i, NIL)

    def introduce(self, names: dict[int, Symbol], origin: str = "") -> None:
        """Write the names of the free coordinates, their `origin`, and the ratios of other displacements."""
        step = self.book.begin_step("names")
        step.add_text(f"Let {join_words(self._moved(names))}{origin}.")
        bound: list[str] = []
        for k, parts in self.motion.ratios.items():
            if k in names or len(parts) != 1 or self.mechanism.coordinates[k].body not in self.setting.words.mentions:
                continue
            (i, part), *_ = parts.items()
            body = self.mechanism.coordinates[k].body
            if self._turns_by_itself(k) and self.moving([body]):
                bound.append(f"{self.setting.display_name(body)} rolls without slipping")
                continue
            size = TIMES.get(abs(part), f"{abs(part):g} times as far as")
            bound.append(f"{self.mover_phrase(k)} moves {size} {self.mover_phrase(i)}")
        step.add_text(f"{capitalized(join_words(bound))}." if bound else "")
        turning = [k for k, parts in self.motion.ratios.items() if parts and self._turns_by_itself(k)]
        step.add_text(*(rim_inertia_words(self.newton, self.setting, k) for k in turning))
        step.close()

    def _moved(self, names: dict[int, Symbol]) -> list[str]:
        """Return a clause for each name; bodies that move in the same direction share one."""
        ways: dict[tuple[str, bool], list[int]] = {}
        for i in names:
            ways.setdefault((self.towards(i), self._turns_by_itself(i)), []).append(i)
        clauses: list[str] = []
        for (direction, _), indices in ways.items():
            who = [self.mechanism.coordinates[i].body for i in indices]
            called = self.setting.bodies_phrase(who) if len(indices) > 1 else self.mover_phrase(indices[0])
            noun = "displacements" if len(indices) > 1 else "displacement"
            clauses.append(
                f"{join_words([f'${names[i].name}$' for i in indices])} be the {noun} of {called} {direction}"
            )
        return clauses

    def _turns_by_itself(self, k: int) -> bool:
        """Return whether a coordinate is the rotation of a rim."""
        own = self.mechanism.coordinates[k]
        return own.kind == "hinge" and not self.moving([own.body]).count(k)

    def mover_phrase(self, k: int) -> str:
        """Return the phrase for the body, or its rim, that moves with a coordinate."""
        called = self.setting.display_name(self.mechanism.coordinates[k].body)
        return f"the rim of {called}" if self._turns_by_itself(k) else called

    def towards(self, k: int, *, forward: bool = True) -> str:
        """Return the direction of a coordinate, or the opposite one, in words."""
        coordinate = self.mechanism.coordinates[k]
        if coordinate.kind == "hinge":
            turning = "anticlockwise" if forward else "clockwise"
            return turning if coordinate.axis[2] > COMPONENT_ATOL else "round its axis"
        parent, (x, y, z) = self.mechanism.body[coordinate.body].parent, coordinate.axis
        return self.setting.direction_words(coordinate.axis if forward else (-x, -y, -z), on=parent)

    # ---- bodies on a ring

    def _ring(self, body: str) -> int | None:
        """Return the hinge coordinate that moves a bead round a ring; None for other bodies."""
        own = self.moving([body])
        if len(own) == 1 and self.mechanism.coordinates[own[0]].kind == "hinge":
            return own[0]
        return None

    def vector(self, kind: str, body: str) -> Components:
        """Return the components of a vector; on a ring along it, for an acceleration also towards its centre."""
        k = self._ring(body)
        if k is None:
            return StraightMotion.vector(self, kind, body)
        along = self.first_speeds.get(k, NIL) if kind == "u" else self.rate(kind, k)
        if kind == "a":
            return along, self._inward(k), NIL
        if kind == "s":
            raise UnsolvedError("a displacement on a ring is a chord")
        return along, NIL, NIL

    def _inward(self, k: int) -> Polynomial:
        """Return the centripetal acceleration v²/r on a ring."""
        radius = self.newton.read(lambda m, f: _radius(f.center(m.coordinates[k].body).gradient[k]))
        fast = self.rate("v", k)
        if len(fast.terms) != 1 or len(radius.terms) != 1:
            raise UnsolvedError("a speed on a ring that has no name")
        (below, part), *_ = radius.terms.items()
        over = Polynomial({tuple((atom, -power) for atom, power in below): 1.0 / part})
        return fast * fast * over

    def component(self, kind: str, body: str, way: Vector) -> Polynomial:
        """Return the component of a vector along a direction; UnsolvedError on a ring."""
        if self._ring(body) is not None:
            raise UnsolvedError("a component on a ring")
        return StraightMotion.component(self, kind, body, way)

    # ---- springs

    def _number(self, line: str) -> int:
        return self.mechanism.lines.index(self.mechanism.line[line])

    def growth(self, kind: str, line: str) -> Polynomial:
        """Return the increase of a line's length (kind ``s``) or the rate of change of the length (kind ``v``)."""
        number = self._number(line)
        of = {"v": self.speed, "s": self.place}[kind]
        parts = [(i, self.motion.extension_ratio(number, i)) for i in self.motion.free]
        return total(of(i).scale(part) for i, part in parts if part)

    def spring(self, what: str, line: str) -> Polynomial:
        """Return a parameter of a spring, such as its stiffness."""
        parameter: Polynomial = getattr(self.newton, what)(self._number(line))
        return parameter

    def stretching(self, line: str) -> list[int]:
        """Return the coordinates on which the length of a line depends."""
        gradient = set[int]()
        for piece in self._start.pieces(self.mechanism.line[line]):
            gradient |= {k for k, part in piece.along.items() if abs(float(part)) > COMPONENT_ATOL}
        wheels = [self.mechanism.number[wheel.coordinate] for wheel in self.mechanism.line[line].wheels]
        return sorted({*gradient, *wheels})

    # ---- forces

    def force(self, kind: str, name: str) -> Symbol:
        """Return the symbol of a force from Newton's law of one body, once its acceleration is known."""
        if self.target is None or self.goal is None:
            raise UnsolvedError(f"no {kind} of {name}")
        force_name = self.goal.force(self.target, self.setting)
        row = self._alone(force_name, "TNf")
        if row is None:
            raise UnsolvedError("no law of a single body gives the force")
        return self._from(row, force_name, kind, name)

    def _alone(self, asked: str, letters: str) -> Row | None:
        """Return the shortest of Newton's laws with a force but no other force of the given letters; else None."""
        rows = [self.newton.newton(k) for k in self.motion.ratios]
        if asked.startswith("N"):
            rows = [self.newton.normal(int(asked[1:]))]
        for row in sorted(rows, key=lambda row: len(row.zero.terms)):
            others = {n for n in row.zero.names() if n[0] in letters and n[1:].isdigit()} - {asked}
            if asked in row.zero.names() and not others:
                return row
        return None

    @cached_property
    def _pulled(self) -> Row | None:
        """Return Newton's law of a body on which only the tension asked for and its weight act; None without one."""
        if self.target is None or self.goal is None or not self.goal.throughout:
            return None
        force_name = self.goal.force(self.target, self.setting)
        return self._alone(force_name, "TNfS") if force_name.startswith("T") else None

    @property
    def gaining(self) -> list[int]:
        """Return the coordinates of the body whose Newton's law gives the tension asked for; empty if none does."""
        names = self._pulled.inertia.names() if self._pulled is not None else ()
        return sorted(int(name[1:]) for name in names if name[0] == "q" and name[1:].isdigit())

    def impulse(self, line: str) -> Symbol | None:
        """Write the impulse of a tension from the change in momentum of a body, and return its symbol."""
        del line
        row, target, goal = self._pulled, self.target, self.goal
        if row is None or target is None or goal is None:
            raise UnsolvedError("no law of a single body gives the impulse")
        force_name = goal.force(target, self.setting)
        gained = {f"q{k}": self.rate("v", k) - self.first_speeds.get(k, NIL) for k in self.gaining}
        weight = row.forces.substitute({force_name: NIL})
        unknown_impulse = Polynomial.from_expression(self.book.fresh("J"))
        pushed = (row.forces - weight).substitute({force_name: unknown_impulse}) + weight * Polynomial.from_expression(
            self.moment_time()
        )
        step, gain = self.book.begin_step("impulse"), row.inertia.substitute(gained)
        who = self.setting.display_name(self.mechanism.coordinates[row.number].body)
        law = step.law(pushed.expression(), gain.expression())
        assert unknown_impulse.symbol is not None
        formula = solve_linear(pushed - gain, unknown_impulse.symbol.name)
        step.add_text(
            f"The impulse on {who} is its change in momentum: {law}, "
            f"so {step.result(unknown_impulse.symbol, formula, IMPULSE)}."
        )
        step.close()
        return unknown_impulse.symbol

    def work(self, line: str, body: str) -> Symbol | None:
        """Write the work of a tension from the change in kinetic energy of a body, and return its symbol."""
        del line
        return write_tension_work(self, self.motion.laws.springs, body)

    def moment_time(self) -> Symbol:
        """Return the time of the moment of the question; by default raise UnsolvedError."""
        raise UnsolvedError("no way to what adds up over a time")

    def _from(self, row: Row, asked: str, kind: str, name: str) -> Symbol:
        known = {f"q{k}": self.rate("a", k) for k in self.motion.ratios}
        for n in self.motion.laws.springs:
            line = self.mechanism.lines[n].name
            extension = self.spring("strain", line) + self.growth("s", line)
            known[f"S{n}"] = self.spring("stiffness", line) * extension
            if damping := self.spring("damping", line):
                known[f"S{n}"] = known[f"S{n}"] + damping * self.growth("v", line)
        force_symbol = self.book.fresh(kind, self.setting.subscript_of(name) if name in self.mechanism.body else "")
        bound = (row.forces - row.inertia).substitute(known)
        turned = kind == "f" and self.book.value(solve_linear(bound, asked)) < 0.0
        named = {asked: Polynomial.from_expression(force_symbol).scale(-1.0 if turned else 1.0)}
        forces, inertia = row.forces.substitute(known).substitute(named), row.inertia.substitute(known)
        step = self.book.begin_step("newton")
        who = self.setting.display_name(self.mechanism.coordinates[row.number].body) if row.kind == "newton" else "it"
        where = "" if row.kind == "newton" else "Perpendicular to the surface: "
        law = step.law(forces.expression(), inertia.expression())
        formula = solve_linear(forces - inertia, force_symbol.name)
        m = self.mechanism
        noun = f"the tension in {self.setting.string_phrases[name]}" if kind == "T" else ""
        step.add_text(
            f"Let ${force_symbol.latex()}$ be {noun}." if noun and name in (line.name for line in m.lines) else ""
        )
        step.add_text(f"{where}{capitalized(who)}: {law}, so {step.result(force_symbol, formula, NEWTONS)}.")
        step.close()
        return force_symbol


def _radius(vector: Vector) -> float:
    return float(dot(vector, vector)) ** 0.5
