"""The compiled mechanism behind a narrow typed interface, the only access of the engine to MuJoCo."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import ConstantTension, Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.specification import IMPEDANCE, STEP, TINY, Specification, mujoco
from sim2reason.simulation.trace import OPERATIONS, Budget

__all__ = ["STEP", "TINY", "CompiledModel", "Flags", "Integers", "Softness"]

Integers = NDArray[np.intp]
Flags = NDArray[np.bool_]

LOAD = 5_000  # operations to compute the forces of a state
SOFTNESS = 1e-5  # fraction of a constraint, relative to the inverse of the largest mass


class Softness(NamedTuple):
    """MuJoCo's soft-constraint parameters of each active row: rate' = stiffness·overlap − damping·rate − R·force."""

    gradient: Array  # (rows, joints)
    regularisation: Array  # (rows,), 1/kg
    stiffness: Array  # 1/s²
    damping: Array  # 1/s


class CompiledModel:
    """The compiled MuJoCo model and its state, with frequently used data kept in arrays.

    A *slot* numbers what can act: first the strings, then the collisions, then the faces, then the friction
    of each contact. `q` and `v` here have one entry per joint of the library, `coordinates` picks those of
    the mechanism.
    """

    def __init__(self, mechanism: Mechanism) -> None:
        """Compile the mechanism; raise SimulationError if MuJoCo rejects it."""
        self.mechanism = mechanism
        self.budget = Budget(2 * OPERATIONS)
        spec = Specification(mechanism)
        self.pulls = [line.law.force for line in spec.pulls if isinstance(line.law, ConstantTension)]  # N
        compiled: tuple[Any, Any] = spec.compile()
        self._model, self._data = compiled
        model = self._model
        self.coordinates: Integers = np.array([j.id for j in spec.joints.values()], dtype=np.intp)
        self.faces: Integers = np.array([j.id for j in spec.faces.values()], dtype=np.intp)
        index = {c.name: int(i) for c, i in zip(mechanism.coordinates, self.coordinates, strict=True)}
        self.index = index
        self.rubs: Integers = np.array([index[c.slip[0][0]] for c in mechanism.contacts.values()], dtype=np.intp)
        self.friction: Array = np.array([c.friction for c in mechanism.contacts.values()])
        self.static_friction: Array = np.array([c.static_friction for c in mechanism.contacts.values()])
        self.size = int(model.nv)
        self.paths: Integers = np.array([t.id for t in spec.paths], dtype=np.intp)
        self.tendons: Integers = np.array([t.id for t in spec.strings], dtype=np.intp)
        self.pairs: Integers = np.array([t.id for t in spec.pairs], dtype=np.intp)
        self.locks: Integers = np.array([e.id for e in spec.locks], dtype=np.intp)
        self.strings = slice(0, len(self.tendons))
        self.hits = slice(self.strings.stop, self.strings.stop + len(self.pairs))
        self.presses = slice(self.hits.stop, self.hits.stop + len(self.faces))
        self.grips = slice(self.presses.stop, self.presses.stop + len(self.faces))
        self.slots = self.grips.stop
        self._bodies = {name: int(body.id) for name, body in spec.bodies.items()}
        self._sites = {name: int(site.id) for name, site in spec.sites.items()}
        self._slot_of_row = self._number_rows()
        self._lengths: Array = np.zeros(int(model.ntendon))
        self._heights: Array = np.zeros(len(self.faces))
        self._places: Array = np.zeros(len(self.rubs))
        self._begin(spec)

    def _number_rows(self) -> NDArray[np.intp]:
        """Return the library's index (slot) of each constraint, by MuJoCo's type and joint or tendon index."""
        most = max(self.size, int(self._model.ntendon), int(self._model.neq), 1)
        table = np.zeros((16, most), dtype=np.intp)
        kinds = mujoco.mjtConstraint
        table[int(kinds.mjCNSTR_EQUALITY), self.locks] = np.arange(self.grips.start, self.grips.stop)
        table[int(kinds.mjCNSTR_FRICTION_DOF), self.rubs] = np.arange(self.grips.start, self.grips.stop)
        table[int(kinds.mjCNSTR_LIMIT_JOINT), self.faces] = np.arange(self.presses.start, self.presses.stop)
        table[int(kinds.mjCNSTR_LIMIT_TENDON), self.tendons] = np.arange(self.strings.stop)
        table[int(kinds.mjCNSTR_LIMIT_TENDON), self.pairs] = np.arange(self.hits.start, self.hits.stop)
        return table

    def _begin(self, spec: Specification) -> None:
        """Read the initial gradients and give all constraints the same softness."""
        model, data = self._model, self._data
        mujoco.mj_forward(model, data)
        self.mass: Array = np.zeros((self.size, self.size))
        if self.size:
            mujoco.mj_fullM(model, data, self.mass)
        heaviest = max((b.mass for b in self.mechanism.bodies), default=1.0) or 1.0
        softness = SOFTNESS / (1.0 - IMPEDANCE) / heaviest
        model.dof_invweight0[:] = softness
        model.tendon_invweight0[:] = softness
        gradients = self._tendon_gradients()
        self.start: Array = np.array(data.ten_length)
        radii = np.zeros((len(spec.lines), self.size))
        for number, line in enumerate(spec.lines):
            for wheel in line.wheels:
                radii[number, self.index[wheel.coordinate]] += wheel.radius
        self.gradients: Array = gradients[self.paths] + radii  # of strings, then of pulls
        for tendon, gradient in zip(spec.carriers, self.gradients, strict=True):
            if tendon.id not in self.paths:
                self._fill(int(tendon.id), gradient)
        self.bare = gradients[self.paths]
        self.loads(on=True)
        weights = [body.mass * float(np.linalg.norm(self.mechanism.gravity)) for body in self.mechanism.bodies]
        self.load_scale = max((*weights, *self.pulls, 1e-3))  # N

    def _fill(self, tendon: int, gradient: Array) -> None:
        first, count = int(self._model.tendon_adr[tendon]), int(self._model.tendon_num[tendon])
        joints = self._model.wrap_objid[first : first + count]
        self._model.wrap_prm[first : first + count] = gradient[joints]

    def _tendon_gradients(self) -> Array:
        """Return MuJoCo's gradient of every tendon's length, (tendons, joints)."""
        model, data = self._model, self._data
        dense = np.zeros((int(model.ntendon), self.size))
        for number in range(int(model.ntendon)):
            first, count = int(model.ten_J_rowadr[number]), int(model.ten_J_rownnz[number])
            dense[number, model.ten_J_colind[first : first + count]] = data.ten_J[first : first + count]
        return dense

    # ---- geometry at the start, for what watches for events

    def site(self, name: str) -> tuple[Array, Array]:
        """Return the position of a site, (3,), and its Jacobian, (3, joints)."""
        number, jacobian = self._sites[name], np.zeros((3, self.size))
        mujoco.mj_jacSite(self._model, self._data, jacobian, None, number)
        return np.array(self._data.site_xpos[number]), jacobian

    def center(self, name: str) -> tuple[Array, Array]:
        """Return the position of a body's centre of mass, (3,), and its Jacobian, (3, joints)."""
        number, jacobian = self._bodies[name], np.zeros((3, self.size))
        mujoco.mj_jacBodyCom(self._model, self._data, jacobian, None, number)
        return np.array(self._data.xipos[number]), jacobian

    # ---- what acts

    def stand(self, q: Array) -> None:
        """Define the lengths of strings and gaps at coordinates `q` as the limits of their constraints."""
        self._data.qpos[:] = q
        mujoco.mj_fwdPosition(self._model, self._data)
        self._lengths = np.array(self._data.ten_length)
        self._heights, self._places = np.array(q[self.faces]), np.array(q[self.rubs])

    def overlap(self, overlaps: Array) -> None:
        """Shift each constraint limit so that the state set by `stand` violates the limit by a given distance, m."""
        ranges = self._model.tendon_range
        ranges[self.tendons, 1] = self._lengths[self.tendons] - overlaps[self.strings]
        ranges[self.pairs, 1] = self._lengths[self.pairs] - overlaps[self.hits]
        self._model.jnt_range[self.faces, 0] = self._heights + overlaps[self.presses]
        self._model.eq_data[self.locks, 0] = self._places + overlaps[self.grips]

    def aim(self, gradients: Array) -> None:
        """Set the gradients of the gaps of the pairs, (pairs, joints)."""
        for tendon, gradient in zip(self.pairs, gradients, strict=True):
            self._fill(int(tendon), -gradient)

    def arm(self, strings: Flags, pairs: Flags, locked: Flags, limits: Array, applied: Array) -> None:
        """Set which strings, pairs and locks may act, the friction limit of each contact, and applied forces, N."""
        model = self._model
        model.tendon_limited[self.tendons] = strings
        model.tendon_limited[self.pairs] = pairs
        self._data.eq_active[self.locks] = locked
        model.dof_frictionloss[self.rubs] = limits
        self._data.qfrc_applied[:] = applied

    def loads(self, *, on: bool) -> None:
        """Switch gravity and pulls on or off; impacts are computed without them."""
        self._model.opt.gravity[:] = self.mechanism.gravity if on else 0.0
        self._data.ctrl[:] = [-pull if on else 0.0 for pull in self.pulls]

    # ---- motion

    def load(self, q: Array, v: Array) -> None:
        """Set a state and compute its accelerations and forces with MuJoCo."""
        self.budget.spend(LOAD)
        self._data.qpos[:] = q
        self._data.qvel[:] = v
        mujoco.mj_forward(self._model, self._data)

    def step(self, duration: float) -> None:
        """Advance by one step of RK4."""
        self.budget.spend(5 * LOAD)
        self._model.opt.timestep = duration
        mujoco.mj_RungeKutta(self._model, self._data, 4)
        mujoco.mj_forward(self._model, self._data)

    @property
    def q(self) -> Array:
        """Return the joint positions, m or rad."""
        return np.array(self._data.qpos)

    @property
    def v(self) -> Array:
        """Return the joint velocities, m/s or rad/s."""
        return np.array(self._data.qvel)

    @property
    def a(self) -> Array:
        """Return the joint accelerations, m/s² or rad/s²."""
        return np.array(self._data.qacc)

    @property
    def lengths(self) -> Array:
        """Return the changes of the lengths of strings and pulls since the start, m."""
        return np.array(self._data.ten_length)[self.paths] - self.start[self.paths]

    def rows(self) -> Integers:
        """Return, for each constraint row of MuJoCo that acts at present, the index of its constraint (slot)."""
        data = self._data
        return self._slot_of_row[data.efc_type[: data.nefc], data.efc_id[: data.nefc]]

    def forces(self, rows: Integers) -> Array:
        """Return the force of every constraint, N, zero for idle ones; `rows` are the indices of the acting ones."""
        found = np.zeros(self.slots)
        found[rows] = self._data.efc_force[: len(rows)]
        return found

    def softness(self) -> Softness:
        """Return MuJoCo's parameters of the present constraint rows."""
        data, count = self._data, int(self._data.nefc)
        gradient = np.array(data.efc_J).ravel()[: count * self.size].reshape(count, self.size)
        law = np.array(data.efc_KBIP).reshape(-1, 4)[:count]
        return Softness(gradient, np.array(data.efc_R[:count]), law[:, 0] * law[:, 2], law[:, 1])

    def check(self) -> None:
        """Raise SimulationError if MuJoCo has issued a warning or computed non-finite numbers."""
        if np.any(self._data.warning.number):
            kinds = [str(mujoco.mjtWarning(k).name) for k in np.flatnonzero(self._data.warning.number)]
            raise SimulationError(f"MuJoCo warns of {', '.join(kinds)}; the scene may be too stiff or too fast for it")
        if not (np.all(np.isfinite(self._data.qpos)) and np.all(np.isfinite(self._data.qacc))):
            raise SimulationError("MuJoCo lost its numbers; the scene may be too stiff or too fast for it")
