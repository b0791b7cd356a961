"""Linear equations of motion with constant coefficients, M ẍ + K x = Q, in the symbols of the text.

x are the displacements of the *free* coordinates; strings and rolling contacts tie the other coordinates to these at
fixed ratios. By Lagrange's equations every term follows from the ratios and Newton's laws; tensions cancel.
"""

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import replace

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import Elastic, Line, Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.structure import changing, rotating_line
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import ZERO, Expression
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.laws.newton import Newton, Row, symbol
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.writing.lexicon import DualValue, UnreadError
from sim2reason.solutions.writing.steps import UnsolvedError


class SpringLaws(Newton):
    """Newton's laws in a segment of a motion in which springs act."""

    @property
    def springs(self) -> list[int]:
        """Return the indices of the lines that are springs."""
        return [number for number, line in enumerate(self.mechanism.lines) if isinstance(line.law, Elastic)]

    def tension(self, number: int, line: Line) -> Polynomial:
        """Return the tension of a line; that of a spring is a symbol of its own."""
        if not isinstance(line.law, Elastic):
            return Newton.tension(self, number, line)
        if line.law.side:
            raise UnreadError("a spring acts only one way")
        return symbol("S", number)

    def _elastic(self, number: int, what: str) -> Polynomial:
        """Return a parameter of a spring, such as the stiffness, in the symbols of the text."""
        return self.read(lambda m, _: getattr(m.lines[number].law, what))

    def stiffness(self, number: int) -> Polynomial:
        """Return the stiffness of a spring, N/m."""
        return self._elastic(number, "stiffness")

    def damping(self, number: int) -> Polynomial:
        """Return the damping constant of the dashpot parallel to a spring, N s/m."""
        return self._elastic(number, "damping")

    def strain(self, number: int) -> Polynomial:
        """Return the initial extension of a spring, m."""
        return self.read(lambda m, f: _length(m.lines[number], f) - _natural(m, number))

    def length(self, number: int) -> Polynomial:
        """Return the initial length of a spring, m."""
        return self.read(lambda m, f: _length(m.lines[number], f))

    def changes(self, number: int, k: int) -> DualValue:
        """Return the change of a spring's length per unit of a coordinate, as numbers."""
        return self._stretch(number, k) / self.scale[k]


def _length(line: Line, frames: Frames) -> float:
    """Return the initial length of a line, m."""
    return sum(float(piece.value) for piece in frames.pieces(line))


def _natural(mechanism: Mechanism, number: int) -> float:
    """Return the natural length of a spring, m."""
    law = mechanism.lines[number].law
    assert isinstance(law, Elastic)
    return law.length


RATIO_TOLERANCE = 1e-9  # tolerance of ratios and direction components
ACCELERATION_RTOL = 1e-7  # relative tolerance of accelerations to the engine's


def nonlinear_reason(mechanism: Mechanism) -> str:
    """Return why the equations are not linear with constant coefficients; empty if they are."""
    frames = initial_frames(mechanism)
    plain = replace(mechanism, lines=tuple(line for line in mechanism.lines if not isinstance(line.law, Elastic)))
    cause = changing(plain, frames)
    if cause and not _on_a_ring(mechanism):
        return f"{cause} makes the equations change"
    springs = [line for line in mechanism.lines if isinstance(line.law, Elastic) and line.circle is None]
    return next((f"{line.name} turns" for line in springs if rotating_line(line, frames)), "")


def min_free_coordinates(mechanism: Mechanism) -> int:
    """Return the number of free coordinates if all strings are taut and no contact slips, the least possible."""
    rough = [face for face in mechanism.faces if face.friction]
    return len(mechanism.coordinates) - len(mechanism.constraints) - len(rough)


def _on_a_ring(mechanism: Mechanism) -> bool:
    """Return whether all moving bodies are beads on one level circle, pulled only by springs along it."""
    level = all(c.kind == "hinge" and abs(c.axis[2]) > 1.0 - RATIO_TOLERANCE for c in mechanism.coordinates)
    alone = all(len(body.coordinates) == 1 and body.parent is None for body in mechanism.bodies)
    return level and alone and not mechanism.faces and all(line.circle for line in mechanism.lines)


class LinearMotion:
    """The equations of motion of one segment; coordinates in `wanted` are preferred as free coordinates, in order."""

    def __init__(self, setting: ProblemContext, segment: Segment, wanted: Sequence[int]) -> None:
        """Derive the equations; raise UnsolvedError or UnreadError if they are not linear in the text's numbers."""
        if reason := nonlinear_reason(setting.mechanism):
            raise UnsolvedError(reason)
        self.setting, self.segment, self.mechanism = setting, segment, setting.mechanism
        self.laws = SpringLaws(setting.lexicon, segment)
        self.givens = {g.symbol: g.value for g in setting.lexicon.givens.values()}
        self._wanted = [*wanted]
        self.begin = NIL
        self.free = self._free()
        self._check()

    @classmethod
    def for_segment(cls, setting: ProblemContext, segment: Segment, wanted: tuple[int, ...]) -> "LinearMotion":
        """Return the equations of a segment, cached for all questions with the same preferred free coordinates."""
        if setting.scene is not setting.study.scene:
            return cls(setting, segment, wanted)
        key = "linear motion", setting.lexicon, segment.start, wanted
        cached = setting.study.memoize(key, lambda: _tried(lambda: cls(setting, segment, wanted)))
        if isinstance(cached, UnsolvedError | UnreadError):
            raise cached.with_traceback(None)
        return cached

    def counted_from(self, begin: Expression, at: float) -> "LinearMotion":
        """Return the equations with the free coordinate counted from `begin`, a symbol whose value is `at`, m."""
        shifted = copy(self)
        shifted.begin = NIL if begin == ZERO else Polynomial.from_expression(begin)
        shifted.givens = self.givens | dict.fromkeys(begin.symbols(), at)
        return shifted

    # ---- constraints

    @cached_property
    def rows(self) -> list[Row]:
        """Return the constraints that tie coordinates together: taut strings and rolling contacts."""
        acting = self.segment.found.mode.acting
        string_rows = [self.laws.string(index) for index in range(len(self.laws.lines)) if acting[index]]
        return string_rows + [self.laws.rolling(face) for face, side in self.laws.slip_directions.items() if side == 0]

    def _matrix(self) -> Array:
        """Return the constraint matrix, (rows, coordinates); UnsolvedError unless its entries are plain numbers."""
        size = len(self.mechanism.coordinates)
        matrix = np.zeros((len(self.rows), size))
        for number, row in enumerate(self.rows):
            for k in range(size):
                part = row.inertia.coefficient(f"q{k}").number
                if part is None:
                    raise UnsolvedError("a string binds motions at a ratio that is no plain number")
                matrix[number, k] = part
        return matrix

    def _free(self) -> list[int]:
        """Return the indices of the free coordinates, and set `ratios`: the rate of each coordinate per free one."""
        size, matrix = len(self.mechanism.coordinates), self._matrix()
        order = [*dict.fromkeys(self._wanted), *(k for k in range(size) if k not in self._wanted)]
        pivots: dict[int, int] = {}
        for k in reversed(order):  # the least wanted coordinates depend on the others
            left = [n for n in range(len(matrix)) if n not in pivots.values() and abs(matrix[n, k]) > RATIO_TOLERANCE]
            if not left:
                continue
            n = max(left, key=lambda n, k=k: abs(matrix[n, k]))
            matrix[n] /= matrix[n, k]
            for other in range(len(matrix)):
                if other != n:
                    matrix[other] -= matrix[other, k] * matrix[n]
            pivots[k] = n
        free = [k for k in order if k not in pivots]
        self.ratios: dict[int, dict[int, float]] = {k: {k: 1.0} for k in free}
        for k, n in pivots.items():
            self.ratios[k] = {i: -float(matrix[n, i]) for i in free if abs(matrix[n, i]) > RATIO_TOLERANCE}
        return free

    def ratio(self, k: int, i: int) -> float:
        """Return the rate of the coordinate k divided by the rate of the free coordinate i."""
        return self.ratios[k].get(i, 0.0)

    # ---- equations

    def _bound(self) -> Mapping[str, Polynomial]:
        """Return the accelerations of all coordinates, by name, in terms of those of the free coordinates."""
        return {
            f"q{k}": total(_unknown(i).scale(part) for i, part in parts.items()) for k, parts in self.ratios.items()
        }

    @cached_property
    def _sums(self) -> list[tuple[Polynomial, Polynomial]]:
        """Return force and inertia along each free coordinate: Newton's laws weighted so that tensions cancel."""
        bound, sums = self._bound(), list[tuple[Polynomial, Polynomial]]()
        laws = {k: self.laws.newton(k) for k in self.ratios if self.ratios[k]}
        normal = {f"N{face}": self.normal(face) for face, side in self.laws.slip_directions.items() if side}
        for i in self.free:
            parts = [(row, self.ratio(k, i)) for k, row in laws.items() if self.ratio(k, i)]
            forces = total(row.forces.substitute(normal).scale(part) for row, part in parts)
            inertia = total(row.inertia.substitute(bound).scale(part) for row, part in parts)
            if any(name[0] in "Tf" and name[1:].isdigit() for name in forces.names()):
                raise UnsolvedError("a tension does not cancel")
            sums.append((forces, inertia))
        return sums

    def normal(self, face: int) -> Polynomial:
        """Return the normal force on a face; UnsolvedError unless it is constant."""
        row = self.laws.normal(face)
        normal_force = row.inertia - row.forces.terms_without((f"N{face}",))
        if any(name[0] in "qTSN" and name[1:].isdigit() for name in normal_force.names()):
            raise UnsolvedError("a normal force that changes")
        return normal_force

    def mass(self, i: int, j: int) -> Polynomial:
        """Return the entry of the mass matrix M for two free coordinates."""
        return self._sums[self.free.index(i)][1].coefficient(_unknown_name(j))

    @cached_property
    def springs(self) -> list[int]:
        """Return the indices of the springs that the motion stretches."""
        return [n for n in self.laws.springs if any(self.extension_ratio(n, i) for i in self.free)]

    def extension_ratio(self, number: int, i: int) -> float:
        """Return the rate of a line's length per rate of a free coordinate; UnsolvedError if it is not a number."""
        ratio = 0.0
        for k in self.ratios:
            part = self.ratio(k, i)
            if part and self.laws.changes(number, k).value:
                plain = self.laws.stretch(number, k).number
                if plain is None:
                    raise UnsolvedError("a spring is stretched at a ratio that is no plain number")
                ratio += part * plain
        return ratio if abs(ratio) > RATIO_TOLERANCE else 0.0

    def stiffness(self, i: int, j: int) -> Polynomial:
        """Return the entry of the stiffness matrix K for two free coordinates."""
        return self._matched("stiffness", i, j)

    def damping(self, i: int, j: int) -> Polynomial:
        """Return the entry of the damping matrix for two free coordinates."""
        return self._matched("damping", i, j)

    def _matched(self, what: str, i: int, j: int) -> Polynomial:
        of = {"stiffness": self.laws.stiffness, "damping": self.laws.damping}[what]
        pairs = [(n, self.extension_ratio(n, i) * self.extension_ratio(n, j)) for n in self.springs]
        return total(of(n).scale(part) for n, part in pairs if part)

    def steady(self, i: int) -> Polynomial:
        """Return the sum of all forces along a free coordinate except those of springs."""
        return self._sums[self.free.index(i)][0].terms_without([f"S{n}" for n in self.laws.springs])

    def friction(self, i: int) -> Polynomial:
        """Return the part of `steady` that is kinetic friction."""
        return self._rubbed(i, self.laws.coefficient)

    def greatest_friction(self, i: int) -> Polynomial:
        """Return the greatest static friction along a free coordinate."""
        return self._rubbed(i, self.laws.static_coefficient)

    def _rubbed(self, i: int, coefficient: Callable[[int], Polynomial]) -> Polynomial:
        friction = NIL
        for face, side in self.laws.slip_directions.items():
            along = total(part.scale(self.ratio(k, i)) for k, part in self.laws.slip(face).items())
            if side and along:
                friction = friction + (coefficient(face) * self.normal(face) * along).scale(float(-side))
        return friction

    def load(self, i: int) -> Polynomial:
        """Return Q, the net force along a free coordinate at the zero of this coordinate, by default the start."""
        pulls = [(n, self.extension_ratio(n, i)) for n in self.springs]
        net_force = self.steady(i) - total(self.laws.stiffness(n) * self.laws.strain(n).scale(p) for n, p in pulls if p)
        return net_force - self.stiffness(i, i) * self.begin if self.begin else net_force

    @property
    def damped(self) -> bool:
        """Return whether a spring has a dashpot."""
        return any(self.laws.damping(n) for n in self.springs)

    # ---- in numbers

    def matrix(self, entry: str) -> Array:
        """Return the ``mass``, ``stiffness`` or ``damping`` matrix as numbers, (n, n)."""
        of = getattr(self, entry)
        return np.array([[of(i, j).value(self.givens) for j in self.free] for i in self.free])

    def _check(self) -> None:
        """Raise UnsolvedError unless the initial accelerations agree with those of the engine."""
        if not self.free:
            return
        mass, load = self.matrix("mass"), np.array([self.load(i).value(self.givens) for i in self.free])
        if np.linalg.cond(mass) > 1.0 / RATIO_TOLERANCE:
            raise UnsolvedError("something without mass moves by itself")
        scale = self.laws.scale
        q, v = (np.array([part[i] * scale[i].value for i in self.free]) for part in (self.segment.q, self.segment.v))
        a = np.linalg.solve(mass, load - self.matrix("stiffness") @ q - self.matrix("damping") @ v)
        there = np.array([self.segment.a[i] * scale[i].value for i in self.free])
        if np.abs(a - there).max() > ACCELERATION_RTOL * max(1.0, float(np.abs(there).max())):
            raise UnsolvedError("the equations are not those of the motion")


def _tried(make: Callable[[], LinearMotion]) -> "LinearMotion | UnsolvedError | UnreadError":
    """Return the equations, or the error that prevents them."""
    try:
        return make()
    except (UnsolvedError, UnreadError) as error:
        return error


def _unknown_name(i: int) -> str:
    return f"x{i}"


def _unknown(i: int) -> Polynomial:
    return symbol("x", i)
