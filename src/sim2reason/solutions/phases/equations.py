"""The equations of one phase of a motion, as polynomials of coordinates, their derivatives, forces and time."""

from collections.abc import Mapping

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.engines.exact.lengths import RowKind
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.polynomials import Polynomial, common_monomial, divide_by_term, total
from sim2reason.solutions.goals import Components
from sim2reason.solutions.laws.equations_of_motion import EquationsOfMotion, Names, phase_at
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.solution import Relation
from sim2reason.solutions.writing.lexicon import DualValue
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

ACCELERATION_RTOL = 1e-12  # relative to the largest acceleration: below it an acceleration counts as zero
LETTERS = {"foot": "N", "hold": "f", "stuck": "F", "prop": "N"}  # for constraint forces; others are tensions


class PhaseEquations:
    """The equations of motion of a segment in given symbols, and the kinematics of bodies and lines."""

    def __init__(
        self,
        setting: ProblemContext,
        book: SolutionBuilder,
        segment: Segment,
        names: Names,
        forces: Mapping[str, Symbol],
    ) -> None:
        """Derive the equations; `forces` has the symbols of forces, by ``row`` or ``face`` and number.

        Raises:
            UnsolvedError: an equation cannot be expressed in the numbers of the text.
        """
        self.setting, self.book, self.segment, self.names = setting, book, segment, names
        self.mechanism, self.lexicon = setting.mechanism, setting.lexicon
        self.forces = forces
        self.stated: list[tuple[str, float, str]] = []  # numbers that the question states: symbol, value, unit
        stuck = tuple(
            any(kind.kind == "stuck" and kind.name == " and ".join(meeting.names) for kind in segment.kinds)
            for meeting in self.mechanism.meetings
        )
        phase = phase_at(amid(setting, segment))._replace(stuck=stuck)
        self.motion = EquationsOfMotion(self.lexicon, book, phase, names)

    # ---- forces

    @cached_property
    def rows(self) -> list[int]:
        """Return the indices of the active constraints."""
        return [n for n in range(len(self.segment.kinds)) if self.segment.found.mode.acting[n]]

    @cached_property
    def rough(self) -> dict[int, int]:
        """Return, by rough face, the sign of the slip velocity; 0 if the contact sticks."""
        rough = [n for n, face in enumerate(self.mechanism.faces) if face.friction > 0.0]
        return dict(zip(rough, self.segment.found.mode.rubbing, strict=True))

    def kind(self, row: int) -> RowKind:
        """Return the kind of a constraint."""
        return self.segment.kinds[row]

    def force(self, of: str, number: int) -> Polynomial:
        """Return the force of a constraint, or the normal force or friction on a face."""
        return Polynomial.from_expression(self.forces[f"{of}{number}"])

    # ---- equations

    @cached_property
    def laws(self) -> list[Relation]:
        """Return the equations of motion of all coordinates, then the constraints and the forces on faces."""
        size = len(self.mechanism.coordinates)
        loads = [
            self.motion.load(k)
            - total(self.motion.constraint_derivative(n, k) * self.force("row", n) for n in self.rows)
            for k in range(size)
        ]
        contacts: list[tuple[Expression, Expression]] = []
        for face, side in self.rough.items():
            contacts += self._contact(face, side, loads)
        accelerations = [s.name for s in self.names.accelerations]
        equations: list[tuple[Expression, Expression]] = []
        for k in range(size):
            sense = self.names.senses[k]
            left, right = self._reduced(self.motion.inertia(k).scale(sense), loads[k].scale(sense))
            equations.append((left.collected(accelerations), right.expression()))
        pairs = (self._reduced(*self.motion.constraint_sides(row)) for row in self.rows)
        equations += [(left.expression(), right.expression()) for left, right in pairs]
        return [Relation(*pair, "law") for pair in (*equations, *contacts) if pair[0] != pair[1]]

    @cached_property
    def steady(self) -> bool:
        """Return whether accelerations and forces are constant: no equation has coordinates, their rates or time."""
        changing = {s.name for s in (*self.names.places, *self.names.rates, self.names.time)}
        names = (name for law in self.laws for side in (law.left, law.right) for name in side.symbols())
        return changing.isdisjoint(names)

    def is_still(self, k: int) -> bool:
        """Return whether the acceleration of a coordinate is zero throughout the segment."""
        return self.steady and abs(self.segment.found.a[k]) <= ACCELERATION_RTOL * max(map(abs, self.segment.found.a))

    def _reduced(self, left: Polynomial, right: Polynomial) -> tuple[Polynomial, Polynomial]:
        """Return both sides of an equation divided by their common given factors and sign."""
        shared = common_monomial([*left.terms, *right.terms])
        kept = tuple((atom, power) for atom, power in shared if isinstance(atom, Symbol) and self._is_fixed(atom.name))
        sign = -1.0 if left.terms and all(part < 0.0 for part in left.terms.values()) else 1.0
        divided_sides = divide_by_term(left, kept, sign), divide_by_term(right, kept, sign)
        if divided_sides[0] is None or divided_sides[1] is None:
            return left, right
        return divided_sides[0], divided_sides[1]

    def _is_fixed(self, name: str) -> bool:
        """Return whether a symbol is a nonzero number of the text."""
        return self.setting.is_given(name) and self.book.values.get(name, 0.0) != 0.0

    def _contact(self, face: int, side: int, loads: list[Polynomial]) -> list[tuple[Expression, Expression]]:
        """Add the friction of a rough contact to the forces along coordinates; return the equations for its forces."""
        slips = {self.mechanism.number[name]: index for index, (name, _) in enumerate(self.mechanism.faces[face].slip)}
        parts = {k: self._slip(face, index) for k, index in slips.items()}
        if side == 0:
            friction = self.force("friction", face)
            still = total(part * self.names.acceleration(k) for k, part in parts.items())
            equations: list[tuple[Expression, Expression]] = [(still.expression(), ZERO)]
        else:
            normal = self.force("normal", face)
            pressing = self.contact_force(face)
            friction = (self._coefficient(face) * normal).scale(float(-side))
            equations = [(normal.expression(), pressing.expression())]
        for k, part in parts.items():
            loads[k] = loads[k] + part * friction
        return equations

    def is_round(self, face: int) -> bool:
        """Return whether the body on a face can roll on it."""
        return any(self.mechanism.coordinates[k].kind == "hinge" for k in self._slipping(face))

    def turning_inertia(self, face: int) -> str:
        """Return the moment of inertia of the body that rolls on a face, in LaTeX; empty if no law has it."""
        turning = [k for k in self._slipping(face) if self.mechanism.coordinates[k].kind == "hinge"]
        inertia = self.motion.mass(turning[0], turning[0]) if len(turning) == 1 else Polynomial({})
        return inertia.expression().latex() if inertia else ""

    def _slipping(self, face: int) -> list[int]:
        """Return the indices of the coordinates whose rates enter the slip velocity."""
        return [self.mechanism.number[name] for name, _ in self.mechanism.faces[face].slip]

    def contact_force(self, face: int) -> Polynomial:
        """Return the normal force on a face from Newton's second law."""
        lifted = total(self.motion.normal_force_contribution(n, face) * self.force("row", n) for n in self.rows)
        return self.motion.unconstrained_normal_force(face) + lifted

    def slip(self, face: int) -> Polynomial:
        """Return the slip velocity of the surfaces at a face, m/s."""
        slips = enumerate(self.mechanism.faces[face].slip)
        return total(
            self._slip(face, index) * self.names.rate(self.mechanism.number[name]) for index, (name, _) in slips
        )

    def _coefficient(self, face: int) -> Polynomial:
        faces = self.lexicon.mechanism.faces[face], self.lexicon.twin.faces[face]
        return self.motion.number(DualValue(faces[0].friction, faces[1].friction))

    def kinetic_friction(self, face: int) -> Polynomial:
        """Return the coefficient of kinetic friction times the normal force."""
        return self._coefficient(face) * self.contact_force(face)

    def friction_bound(self, face: int) -> Polynomial:
        """Return the coefficient of static friction times the normal force."""
        faces = self.lexicon.mechanism.faces[face], self.lexicon.twin.faces[face]
        return self.motion.number(DualValue(faces[0].static_friction, faces[1].static_friction)) * self.contact_force(
            face
        )

    def _slip(self, face: int, place: int) -> Polynomial:
        faces = self.lexicon.mechanism.faces[face], self.lexicon.twin.faces[face]
        return self.motion.number(DualValue(faces[0].slip[place][1], faces[1].slip[place][1]))

    def sampled(self, times: Array) -> dict[str, Array]:
        """Return the values of all symbols, each (m,), at instants of the phase in the engine's motion."""
        state = self.setting.motion.state(times)
        values = {name: np.full(len(times), value) for name, value in self.book.values.items()}
        values[self.names.time.name] = times
        for k, sense in enumerate(self.names.senses):
            origin = self.book.value(self.names.origins[k].expression())
            values[self.names.places[k].name] = origin + sense * state.q[:, k]
            values[self.names.rates[k].name] = sense * state.v[:, k]
            values[self.names.accelerations[k].name] = sense * state.a[:, k]
        for key, symbol in self.forces.items():
            values[symbol.name] = self._force_values(key, state)
        return values

    def _force_values(self, key: str, state: State) -> Array:
        """Return the values of a force along a motion, (m,); NaN where the engine does not record it."""
        of, number = key.rstrip("0123456789"), int(key.lstrip("abcdefghijklmnopqrstuvwxyz"))
        if of == "row":
            kind = self.segment.kinds[number]
            values = state.constraint_tension.get(kind.name) if kind.kind not in ("foot", "hold", "stuck") else None
            return values if values is not None else np.full(len(state.times), np.nan)
        subject = self.mechanism.faces[number].subject
        return state.normal[subject] if of == "normal" else state.friction[subject]

    # ---- kinematics

    def hinge(self, body: str) -> int:
        """Return the index of the coordinate that rotates a body; UnsolvedError unless there is exactly one."""
        hinges = initial_frames(self.mechanism)[body].hinges
        if len(hinges) != 1:
            raise UnsolvedError("it does not turn about a single axle")
        return hinges[0].number

    def kinematic_vector(self, part: str, body: str) -> Components:
        """Return the ``place`` or ``velocity`` of a body's centre of mass, by component in the world frame."""
        here, there = (getattr(a.frames.center(body), part) for a in self.motion.assemblies)
        x, y, z = (self.motion.read(one, other) for one, other in zip(here, there, strict=True))
        return x, y, z

    def acceleration(self, body: str) -> Components:
        """Return the acceleration of the centre of mass of a body, by component."""
        components = list(self.kinematic_vector("bias", body))
        here, there = (a.frames.center(body).gradient for a in self.motion.assemblies)
        for k, ways in ((k, (here[k], there[k])) for k in here):
            for n in range(3):
                components[n] = components[n] + self.motion.read(ways[0][n], ways[1][n]) * self.names.acceleration(k)
        return components[0], components[1], components[2]

    def displacement(self, body: str) -> Components:
        """Return the displacement of the centre of mass of a body since the start, by component."""
        here, there = (initial_frames(m).center(body).place for m in (self.lexicon.mechanism, self.lexicon.twin))
        begun = [self.motion.number(DualValue(float(a), float(b))) for a, b in zip(here, there, strict=True)]  # type: ignore[arg-type]
        x, y, z = (now - then for now, then in zip(self.kinematic_vector("place", body), begun, strict=True))
        return x, y, z

    def length(self, line: str, part: str = "value") -> Polynomial:
        """Return the length of a line, or its ``rate``."""
        entry = self.mechanism.line[line]
        number = self.mechanism.lines.index(entry)
        ways = (
            a.length(m.lines[number])
            for a, m in zip(self.motion.assemblies, (self.lexicon.mechanism, self.lexicon.twin), strict=True)
        )
        here, there = (getattr(line_length, part) for line_length in ways)
        return self.motion.read(here, there)

    def law(self, line: str, part: str) -> Polynomial:
        """Return a parameter of a line's law: its ``stiffness``, natural ``length``, ``damping`` or ``force``."""
        number = self.mechanism.lines.index(self.mechanism.line[line])
        laws = (m.lines[number].law for m in (self.lexicon.mechanism, self.lexicon.twin))
        here, there = (float(getattr(law, part)) for law in laws)
        return self.motion.number(DualValue(here, there))


def amid(setting: ProblemContext, segment: Segment) -> State:
    """Return the state in the middle of a segment, since its ends may lie on the border of a region."""
    motion, begins = setting.motion, segment.start
    ends = min((other.start for other in motion.segments if other.start > begins), default=motion.end)
    return motion.state(np.array([0.5 * (begins + ends)]))
