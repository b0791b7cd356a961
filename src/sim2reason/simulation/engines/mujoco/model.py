"""The MuJoCo model of a mechanism: mass matrix, bias and Jacobians at any state.

Loads beyond gravity (lines, forces, attraction, engines) are added here by means of MuJoCo's Jacobians; MuJoCo's own
soft constraints are not used.
"""

from itertools import pairwise
from math import isfinite, nan

import numpy as np

from sim2reason.errors import SceneError, SimulationError
from sim2reason.scenes.dsl.mechanism import Inextensible, Line, Mechanism, Prop, Rigid
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.structure import changing, steady
from sim2reason.scenes.dsl.vectors import Triple
from sim2reason.simulation.engines.mujoco.distances import (
    Attractions,
    Lengths,
    Lines,
    Pulls,
)
from sim2reason.simulation.engines.mujoco.forces import (
    UNLIMITED_FRICTION,
    Faces,
    Row,
    SwitchState,
    is_moderate,
    solve_regular,
)
from sim2reason.simulation.engines.mujoco.points import ModelPoints
from sim2reason.simulation.engines.mujoco.specification import SUBSTITUTE_MASS, Specification, mujoco
from sim2reason.simulation.trace import OPERATIONS, Budget

MIN_INERTIA_RATIO = 1e-6  # of the least to the largest; below it, accelerations without constraints are too large
OVERLAP, COINCIDENCE_DISTANCE = 1e-8, 1e-10  # m; limits at the start; the exact engine refuses whatever exceeds these
ZERO_DERIVATIVE_TOL = 1e-9  # largest derivative of the separation of two points that do not move apart
STAND, JOINT = 2_000, 800  # operations to set a state, and for each joint in addition


class CompiledModel(ModelPoints):
    """The compiled mechanism, set to one state at a time."""

    def __init__(self, mechanism: Mechanism) -> None:
        """Compile the mechanism; raise SimulationError if MuJoCo rejects it."""
        spec = Specification(mechanism)
        super().__init__(mechanism, spec)
        self.budget = Budget(2 * OPERATIONS)
        self.constant = not changing(mechanism)
        self.coordinates = np.array([self.index[c.name] for c in mechanism.coordinates], dtype=np.intp)
        self._mass = np.zeros((self.size, self.size))
        self._qpos, self._qvel, self._bias = self._data.qpos, self._data.qvel, self._data.qfrc_bias
        self._gravcomp = self._data.qfrc_gravcomp if self._model.ngravcomp else None
        self._cost = STAND + JOINT * self.size
        self._massless = any(body.coordinates and body.mass == 0.0 for body in mechanism.bodies)
        compiled_in = self._site_id, self.index, self._model, self._data
        pulls = tuple(line for line in mechanism.lines if not line.law.row)
        self.directions = steady(mechanism)
        self._rowed = Lines(mechanism.constraints, *compiled_in, straight=self._straight, directions=self.directions)
        self._drawn = Lines(pulls, *compiled_in, straight=self._straight, directions=self.directions)
        self.pulls = Pulls(self._drawn, mechanism.half_springs)
        self._attracted = Attractions(
            mechanism.attractions, self._body_id, self._model, self._data, straight=self._straight
        )
        self._light = [burn.body for burn in mechanism.burns]
        self.faces = self._faces({name: int(joint.id) for name, joint in spec.faces.items()})
        self.time, self.q = nan, np.zeros(0)
        self.begin()

    def _faces(self, rises: dict[str, int]) -> Faces:
        """Return the faces, from the joints by which bodies leave them."""
        faces, slips = self.mechanism.faces, np.zeros((len(self.mechanism.faces), self.size))
        for number, face in enumerate(faces):
            for name, factor in face.slip:
                slips[number, self.index[name]] = factor
        return Faces(
            [rises[face.subject] for face in faces],
            slips,
            [min(face.friction, UNLIMITED_FRICTION) for face in faces],
            [face.static_friction for face in faces],
            [face.guided for face in faces],
        )

    # ---- one state

    def begin(self) -> None:
        """Set the initial state and store the initial lengths.

        Raises:
            SceneError: two sites of a line coincide, or two bodies overlap.
        """
        rest = np.zeros(self.size)
        burns, meetings, halves = self.mechanism.burns, self.mechanism.meetings, self.mechanism.half_springs
        start = SwitchState([], [False] * len(burns), [False] * len(meetings), [False] * len(halves))
        self.set_state(0.0, rest, rest, start)
        self._check_apart()
        self._attracted.begin()
        self._starts = self._lines()[0].values
        masses = self.inertia().diagonal()
        self.uneven = bool((masses < MIN_INERTIA_RATIO * float(masses.max(initial=0.0))).any())

    def _check_apart(self) -> None:
        for line in self.mechanism.lines:
            for first, last in pairwise(line.through):
                one, other = self.site(first), self.site(last)
                moves = np.abs(other.jacobian - one.jacobian).max(initial=0.0) > ZERO_DERIVATIVE_TOL
                if moves and np.linalg.norm(other.place - one.place) <= COINCIDENCE_DISTANCE:
                    message = f"sites {first} and {last} coincide at the start"
                    raise SceneError(line.name, message, "leave some string between")
        for pair in self.mechanism.meetings:
            if self.separation(pair)[0] < -OVERLAP:
                other = "what is fixed" if pair.a is None else pair.b
                raise SceneError(pair.names[0], f"it overlaps {other} at the start", "move them apart")

    def set_state(self, time: float, q: Array, v: Array, switches: SwitchState) -> None:
        """Set the positions and velocities of the joints at a time."""
        self.spend()
        was = self.time
        self._switches_now = switches
        self._rows: list[Row] | None = None
        if time == was and not self._light and q.tobytes() == self.q.tobytes() and v.tobytes() == self.v.tobytes():
            return
        self.time, self.q, self.v = time, q, v
        self._points = {}
        self._measured: tuple[Lengths, list[float]] | None = None
        if self._light:
            self._qpos[:], self._qvel[:] = q, v
            self._burn()
        self._qpos[:], self._qvel[:] = q, v
        mujoco.mj_fwdPosition(self._model, self._data)
        mujoco.mj_fwdVelocity(self._model, self._data)

    def spend(self) -> None:
        """Subtract the operations of one state from the budget."""
        self.budget.spend(self._cost)

    def _burn(self) -> None:
        for burn, burning in zip(self.mechanism.burns, self._switches_now.burning, strict=True):
            spent = burn.rate * (self.time if burning or self.time < burn.until else burn.until)
            left = self.mechanism.body[burn.body].mass - spent
            if left <= 0.0:
                raise SimulationError(f"{burn.body} has burnt all of its mass at {self.time:.6g} s")
            self._model.body_mass[self._body_id[burn.body]] = left
        mujoco.mj_setConst(self._model, self._data)

    def inertia(self) -> Array:
        """Return MuJoCo's mass matrix, (joints, joints)."""
        if self.size:
            mujoco.mj_fullM(self._model, self._data, self._mass)
        return self._mass

    def weightless(self) -> Array:
        """Return the motions of massless parts that need no force, (joints, k), orthonormal."""
        if not self._massless:
            return np.zeros((self.size, 0))
        sizes, motions = np.linalg.eigh(self.inertia())
        return motions[:, sizes < 10.0 * SUBSTITUTE_MASS]

    def accelerate(self, loads: Array, x: Array) -> None:
        """Store in `x` (joints,) the accelerations under `loads` (joints,) without any constraint."""
        mujoco.mj_solveM(self._model, self._data, x[None], loads[None])

    def constrained_acceleration(self, loads: Array, gradients: list[Array], targets: list[float]) -> Array | None:
        """Return the accelerations (joints,) under `loads` with only rows of these gradients acting; None on failure.

        They are the accelerations without rows, corrected by the few constraint forces: M⁻¹Jᵀλ.
        """
        sides = np.array([loads, *gradients])
        found = np.empty_like(sides)
        mujoco.mj_solveM(self._model, self._data, found, sides)
        free, given = found[0], found[1:]
        if not all(map(isfinite, found.ravel().tolist())):  # a part without mass
            return None
        if len(targets) > 1:
            rows = sides[1:]
            pulls = solve_regular(rows.dot(given.T), rows.dot(free) - targets)
            return None if pulls is None else np.asarray(free - pulls.dot(given), dtype=np.float64)
        gradient, answer = gradients[0], given[0]
        yielding = float(gradient.dot(answer))
        if not yielding > 0.0:
            return None
        x = free - (float(gradient.dot(free)) - targets[0]) / yielding * answer
        return x if is_moderate(x) else None

    # ---- loads

    def loads(self) -> Array:
        """Return all loads except constraint forces, (joints,), including gravity and inertial loads."""
        total: Array = np.negative(self._bias)
        if self._gravcomp is not None:
            total += self._gravcomp
        mechanism = self.mechanism
        if self._drawn.lines:
            idle: list[Line] = []
            if mechanism.half_springs:
                halves = zip(mechanism.half_springs, self._switches_now.strained, strict=True)
                idle = [line for (line, _), on in halves if not on]
            total += self.pulls.load(self.q, self.v, idle)
        for number, force in enumerate(mechanism.forces):
            if all(self._switches_now.inside[number]):
                point = self.center(force.body)
                pushed = force.law.force(_triple(point.place), _triple(point.velocity), self.time, np)
                total += np.array([float(part) for part in pushed]).dot(point.jacobian)
        if mechanism.attractions:
            total += self._attracted.load()
        for burn, burning in zip(mechanism.burns, self._switches_now.burning, strict=True):
            if burning:
                frame = self._data.xmat[self._body_id[burn.body]].reshape(3, 3)
                thrust = burn.rate * burn.exhaust * frame.dot(burn.direction)
                total += thrust.dot(self.center(burn.body).jacobian)
        return total

    def closeness(self) -> float:
        """Return the smallest ratio of an attracting pair's present distance to the initial one, at most 1."""
        return self._attracted.closeness()

    # ---- lengths and rows

    def _lines(self) -> tuple[Lengths, list[float]]:
        """Return the lengths of the constrained lines, and their second derivatives at q̈ = 0."""
        if self._measured is None:
            found = self._rowed.lengths(self.q)
            self._measured = found, self._rowed.bends(self.v, found.segments)
        return self._measured

    def rows(self) -> list[Row]:
        """Return all constraint rows: lines, two rows for each foot, pairs that stick together."""
        if self._rows is None:
            self._rows = [self.row(number) for number in range(self.count)]
        return self._rows

    @property
    def count(self) -> int:
        """Return the number of constraint rows."""
        return len(self._rowed.lines) + 2 * len(self.mechanism.feet) + sum(self._switches_now.stuck)

    def row(self, number: int) -> Row:
        """Return one constraint row by its index."""
        lines, feet = len(self._rowed.lines), 2 * len(self.mechanism.feet)
        if number < lines:
            return self._line_row(number)
        if number < lines + feet:
            return self._foot_row((number - lines) // 2, number)
        stuck = [m for m, held in zip(self.mechanism.meetings, self._switches_now.stuck, strict=True) if held]
        meeting = stuck[number - lines - feet]
        gap, rate, gradient, bias = self.separation(meeting)
        return Row("stuck", " and ".join(meeting.names), -gradient, gap, -rate, bias)

    def condition(self, number: int) -> tuple[Array, float]:
        """Return the gradient (joints,) and the target of a constraint row by its index."""
        if number >= len(self._rowed.lines):
            row = self.row(number)
            return row.gradient, row.target
        found, bends = self._lines()
        gradient, bias = found.gradients[number], bends[number]
        return (-gradient, bias) if isinstance(self._rowed.lines[number].law, Prop) else (gradient, -bias)

    def _foot_row(self, index: int, number: int) -> Row:
        """Return the row that keeps a foot above its plane (even index) or from slipping on it."""
        foot = self.mechanism.feet[index]
        point, normal = self.site(foot.site), np.array(foot.normal)
        gap = float(normal @ point.place) - foot.height
        bias = self._bias_of(point.place, self._carriers[self._site_id[foot.site]])
        if number % 2 == len(self._rowed.lines) % 2:
            down = -normal @ point.jacobian
            return Row("foot", foot.name, down, gap, float(down @ self.v), float(normal @ bias))
        along = np.array(foot.along)
        aside = along @ point.jacobian
        return Row("hold", foot.name, aside, gap, float(aside @ self.v), -float(along @ bias), number - 1)

    def _line_row(self, number: int) -> Row:
        law, name = self._rowed.lines[number].law, self._rowed.lines[number].name
        gradient, target = self.condition(number)
        rate, over = float(gradient.dot(self.v)), self._lines()[0].values[number] - self._starts[number]
        if isinstance(law, Prop):
            return Row(law.row, name, gradient, over, rate, target)
        if isinstance(law, Rigid):
            return Row(law.row, name, gradient, -over, rate, target)
        assert isinstance(law, Inextensible)
        spare = law.slack - over - law.reel * self.time
        return Row(law.row, name, gradient, spare, rate + law.reel, target)

    def borders(self, number: int) -> list[float]:
        """Return the distances, m, to the borders of a force's region, positive inside; none if it acts everywhere."""
        force = self.mechanism.forces[number]
        if force.region is None:
            return []
        place = _triple(self._centers[force.body])
        return [float(margin) for margin in force.region.margins(place, np)]


def _triple(vector: Array) -> Triple:
    return (float(vector[0]), float(vector[1]), float(vector[2]))
