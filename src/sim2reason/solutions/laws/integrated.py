"""The laws that an integration integrates: Newton's law of each coordinate, and what strings, feet and faces demand."""

import numpy as np

from sim2reason.dsl.state import State
from sim2reason.lazy import cached_property
from sim2reason.simulation.engines.exact.lengths import RowKind
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.laws.common_rates import gravitational_constant
from sim2reason.solutions.laws.equations_of_motion import EquationsOfMotion, Names, phase_at
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.writing.lexicon import Both, Lexicon
from sim2reason.solutions.writing.steps import Book, UnsolvedError, Writing
from sim2reason.solutions.writing.unit_latex import NEWTONS

EASY = 300  # characters of a side of an equation that is written out
LONG = 900  # characters of an equation that nobody reads
SOUND = 1e-9  # relative: how well an equation must hold at the moment that is shown
LETTERS = {"foot": "N", "hold": "f", "stuck": "F"}  # for the forces of rows; all others are tensions


class IntegratedLaws:
    """They are those of one segment, with the values that everything has at one moment in it."""

    def __init__(
        self, setting: Setting, book: Book, segment: Segment, state: State, names: Names, *, plain: bool = False
    ) -> None:
        """Nothing is written yet; UnsolvedError later, where equations have no form. If `plain`, all in numbers."""
        self.setting, self.book, self.mechanism, self._plain = setting, book, setting.mechanism, plain
        self.segment, self.state, self.names = segment, state, names
        self.pulls: list[Symbol] = []  # forces that the equations have to find
        self._told_names = 0  # of those that the equations give to what is long

    @cached_property
    def equations(self) -> EquationsOfMotion:
        """Those of the moment; what is long and occurs several times in them has a name."""
        lexicon, size = self.setting.lexicon, len(self.mechanism.coordinates)
        stuck = tuple(
            any(kind.kind == "stuck" and kind.name == " and ".join(meeting.names) for kind in self.segment.kinds)
            for meeting in self.mechanism.meetings
        )
        phase = phase_at(self._amid)._replace(stuck=stuck)
        if lexicon.constant is not None and not self._plain:
            gravitational_constant(self.book, lexicon.constant)
        draft = EquationsOfMotion(lexicon, self.book.copy(), phase, self.names, plain=self._plain)
        parts = [part for k in range(size) for part in (draft.inertia(k), draft.load(k))]
        if all(len(part.expression().latex()) <= EASY for part in parts):
            return draft.written_in(self.book)
        found = EquationsOfMotion(lexicon, self.book, phase, self.names, plain=self._plain)
        found.shorten()
        return found

    @property
    def _amid(self) -> State:
        """A moment well inside the segment: at its ends a body may be on the border of a region."""
        motion, begins = self.setting.motion, self.segment.start
        ends = min((held.start for held in motion.segments if held.start > begins), default=motion.end)
        return motion.state(np.array([0.5 * (begins + ends)]))

    def write(self) -> None:
        """All of them, in one step."""
        step, equations = self.book.open("newton"), self.equations
        size = len(self.mechanism.coordinates)
        forces = self._forces(step)
        loads = [
            equations.load(k) - total(equations.pull(n, k) * force for n, force in forces.items()) for k in range(size)
        ]
        for k, extra in self._friction(step, forces).items():
            loads[k] = loads[k] + extra
        laws = [
            (equations.inertia(k).collected([s.name for s in self.names.accelerations]), loads[k].expression())
            for k in range(size)
        ]
        laws += [tuple(side.expression() for side in equations.held(number)) for number in forces]  # type: ignore[misc]
        self._name(step)
        for left, right in laws:
            if left != right:
                self._check(left, right)
                step.say(f"{step.law(left, right)}.")
        if equations.stands and self.book.sought:
            step.say(f"Numbers in them that hang on ${self.book.sought}$ are those for the value found below.")
        step.close()

    def _name(self, step: Writing) -> None:
        """Tell what has been named since."""
        for formula, name in list(self.equations.named.items())[self._told_names :]:
            self.book.know(name.name, self.book.value(formula))
            step.say(f"With {step.law(name, formula)}.")
        self._told_names = len(self.equations.named)

    def _check(self, left: Expression, right: Expression) -> None:
        if unknown := {*left.symbols(), *right.symbols()} - {*self.book.values}:
            raise UnsolvedError(f"the text has no number for {', '.join(sorted(unknown))}")
        if len(left.latex()) + len(right.latex()) > LONG:
            raise UnsolvedError("the equations of motion are too long to be written")
        one, other = self.book.value(left), self.book.value(right)
        terms = [abs(self.book.value(t)) for side in (left, right) for t in getattr(side, "terms", (side,))]
        if abs(one - other) > SOUND * max(terms, default=0.0):
            raise UnsolvedError("the equations of motion do not hold as they are written")

    # ---- forces

    def _forces(self, step: Writing) -> dict[int, Polynomial]:
        """The forces of the rows that act, by row: tensions, what feet and pairs that stay together give."""
        acting, kinds = self.segment.found.mode.acting, self.segment.kinds
        rows = [number for number in range(len(kinds)) if acting[number]]
        strung = sum(kinds[number].kind not in LETTERS for number in rows)
        found: dict[int, Polynomial] = {}
        for number in rows:
            kind = kinds[number]
            mark = str(number + 1) if kind.kind not in LETTERS and strung > 1 else ""
            name = self.book.fresh(LETTERS.get(kind.kind, "T"), mark)
            self.pulls.append(name)
            found[number] = Polynomial.of(name)
            step.say(self._introduced(kind, name))
        for number, value in zip(rows, self._sizes(rows), strict=True):
            (name,) = found[number].names()
            self.book.know(name, value, self.book.unit_in_text(NEWTONS))
        return found

    def _introduced(self, kind: RowKind, name: Symbol) -> str:
        """What a force is that no string gives; nothing of a tension."""
        if kind.kind == "foot":
            return f"It stands on an edge, on which the plane presses with ${name.name}$"
        if kind.kind == "hold":
            return f"and which friction ${name.name}$ holds."
        if kind.kind == "stuck":
            names = [self.setting.called(part) for part in kind.name.split(" and ")]
            return f"${name.name}$ keeps {' and '.join(names)} together."
        return ""

    def _sizes(self, rows: list[int]) -> list[float]:
        """Of the forces of rows; those that are no lines', from the equations, which they balance."""
        kinds, tension = self.segment.kinds, self.state.constraint_tension
        if all(kinds[number].kind not in LETTERS for number in rows):
            return [float(tension[kinds[number].name][0]) for number in rows]
        equations, size = self.equations, range(len(self.mechanism.coordinates))
        matrix = np.array([[self._comes_to(equations.pull(n, k)) for n in rows] for k in size])
        left = [self._comes_to(equations.load(k) - equations.inertia(k)) for k in size]
        sizes, _, rank, _ = np.linalg.lstsq(matrix, np.array(left), rcond=None)
        if rank < len(rows):
            raise UnsolvedError("the equations leave forces open")
        return [float(value) for value in sizes]

    def _comes_to(self, held: Polynomial) -> float:
        named = {name.name: self.book.value(formula) for formula, name in self.equations.named.items()}
        return held.value(self.book.values | named)

    def _friction(self, step: Writing, forces: dict[int, Polynomial]) -> dict[int, Polynomial]:
        """What rough faces add to the loads, by coordinate; their normal forces are told."""
        found: dict[int, Polynomial] = {}
        lexicon, equations = self.setting.lexicon, self.equations
        rough = [n for n, face in enumerate(self.mechanism.faces) if face.friction > 0.0]
        for face, side in zip(rough, self.segment.found.mode.rubbing, strict=True):
            held = self.mechanism.faces[face]
            mark = self.setting.mark(held.subject)
            if side == 0:
                force = self._named("f", mark, float(self.state.friction[held.subject][0]))
                self.pulls += [force.symbol] if force.symbol is not None else []
                step.say(f"Friction holds {self.setting.called(held.subject)}: {self._still(step, face)}.")
            else:
                normal = self._named("N", mark, float(self.state.normal[held.subject][0]))
                pressing = equations.pressing(face) + total(equations.lifted(n, face) * t for n, t in forces.items())
                self._name(step)
                self._check(normal.expression(), pressing.expression())
                who = self.setting.called(held.subject)
                step.say(f"The face presses on {who} with {step.law(normal.expression(), pressing.expression())}.")
                coefficient = equations.number(_friction(lexicon, face))
                force = (coefficient * normal).scaled(float(-side))
            for place, (name, _) in enumerate(held.slip):
                k = self.mechanism.number[name]
                part = equations.number(_slip(lexicon, face, place))
                found[k] = found.get(k, NIL) + part * force
        return found

    def _still(self, step: Writing, face: int) -> str:
        """No acceleration along a face."""
        slips, names = self.mechanism.faces[face].slip, self.names.accelerations
        moves = [(place, names[self.mechanism.number[name]]) for place, (name, _) in enumerate(slips)]
        slip = total(
            self.equations.number(_slip(self.setting.lexicon, face, place)) * Polynomial.of(name)
            for place, name in moves
        )
        return step.law(slip.expression(), ZERO)

    def _named(self, base: str, mark: str, value: float) -> Polynomial:
        name = self.book.fresh(base, mark)
        self.book.know(name.name, value, self.book.unit_in_text(NEWTONS))
        return Polynomial.of(name)


def _friction(lexicon: Lexicon, face: int) -> Both:
    return Both(lexicon.mechanism.faces[face].friction, lexicon.twin.faces[face].friction)


def _slip(lexicon: Lexicon, face: int, place: int) -> Both:
    return Both(lexicon.mechanism.faces[face].slip[place][1], lexicon.twin.faces[face].slip[place][1])
