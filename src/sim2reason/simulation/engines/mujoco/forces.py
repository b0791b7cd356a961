"""What acts at an instant, decided by MuJoCo's solver: which strings pull, which contacts stick or slide."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.simulation.engines.mujoco.balance import Balance, Demand, balance
from sim2reason.simulation.engines.mujoco.plant import TINY, Flags, Plant
from sim2reason.simulation.engines.mujoco.watch import STILL, TOUCHING, Watch

SCALE = 1e-3  # an impact is solved for a thousandth of its velocities, so that no overlap is large
FAINT = 1e-7  # of the largest load: no tension
LIFT = 1e-6  # of the largest speed: a face is left only faster


class Mode(NamedTuple):
    """Which strings are taut, and how each contact rubs: 0 sticks or is smooth, ±1 slides to that side."""

    taut: Flags
    rubbing: Array


@dataclass(frozen=True)
class Settled:
    """The mode of a stretch of time, the forces in it, and what is wrong with it, if anything is."""

    mode: Mode
    balance: Balance
    undetermined: Flags  # by slot
    lifted: tuple[int, ...]  # contacts that leave their face
    loose: bool  # a massless part that nothing holds


def settle(plant: Plant, watch: Watch, q: Array, v: Array, taut: Flags) -> Settled:
    """Find the mode and the forces at a state between impacts.

    `taut` are the strings that were so, or have just become so: they remain so under no tension while nothing
    moves their ends together. Raises SimulationError if no forces are found.
    """
    zero = np.zeros(plant.size)
    spare = watch.strings(q, v, zero)
    tight = (spare.value <= TOUCHING) & (np.abs(spare.rate) <= STILL)
    rough = plant.friction > 0.0
    sliding = np.where(rough, np.sign(v[plant.rubs]), 0.0)
    none = np.zeros(len(plant.pairs), dtype=bool)
    demand = Demand(q, v, tight, none, sliding, zero, np.zeros(plant.slots))
    first = balance(plant, demand)
    idle = taut & (np.abs(watch.strings(q, v, first.a).second) <= STILL)
    pulling = tight & (first.forces[plant.strings] > FAINT * plant.load_scale)
    started = rough & (sliding == 0.0) & (np.abs(first.a[plant.rubs]) > STILL)
    rubbing = np.where(started, np.sign(first.a[plant.rubs]), sliding)
    last = first
    if started.any() or not np.array_equal(pulling, tight):
        last = balance(plant, replace(demand, strings=pulling, sliding=rubbing, normal=first.forces[plant.presses]))
    lifted = tuple(int(i) for i in np.flatnonzero(last.a[plant.faces] > STILL))
    still = tight & (np.abs(watch.strings(q, v, last.a).second) <= STILL)
    held = rough & (v[plant.rubs] == 0.0) & (np.abs(last.a[plant.rubs]) <= STILL)
    open_ended = _undetermined(plant, still, held, rubbing)
    mode = Mode(pulling | (tight & idle), rubbing)
    return Settled(mode, last, open_ended, lifted, _loose(plant, pulling, rubbing))


def strike(plant: Plant, watch: Watch, q: Array, v: Array) -> tuple[Array, tuple[int, ...]]:
    """The velocities just after an impact, and the contacts that it lifts off their faces.

    The solver sees impulses as forces, and velocities as accelerations from M·v, with neither gravity nor pulls.
    """
    zero = np.zeros(plant.size)
    full = watch.strings(q, v, zero).value <= TOUCHING
    gaps = watch.approach(q, v, zero).gaps
    touching = gaps.value <= TOUCHING
    restitution = np.array([pair.restitution for pair in plant.mechanism.collisions])
    targets = np.zeros(plant.slots)
    targets[plant.hits] = SCALE * np.maximum(-restitution * gaps.rate, 0.0)
    plant.aim(watch.closing(q))
    plant.loads(on=False)
    demand = Demand(q, zero, full, touching, np.zeros(len(plant.friction)), SCALE * plant.mass @ v, targets)
    found = balance(plant, demand)
    plant.loads(on=True)
    after = found.a / SCALE
    lifted = tuple(int(i) for i in np.flatnonzero(after[plant.faces] > LIFT * np.abs(v).max()))
    after[plant.faces] = 0.0
    return after, lifted


def weightless(plant: Plant) -> Array:
    """Directions in which nothing has mass, (joints, k), orthonormal."""
    sizes, vectors = np.linalg.eigh(plant.mass)
    return vectors[:, sizes < 1e3 * TINY]


def _loose(plant: Plant, taut: Flags, rubbing: Array) -> bool:
    """Whether some massless part is held neither by a string that pulls nor by a contact that sticks."""
    free = weightless(plant)
    if not free.shape[1]:
        return False
    stuck = (plant.friction > 0.0) & (rubbing == 0.0)
    holding = np.vstack([plant.gradients[: len(taut)][taut], np.eye(plant.size)[plant.rubs[stuck]]])
    holding = np.vstack([holding, np.eye(plant.size)[plant.faces]])
    return int(np.linalg.matrix_rank(holding @ free, tol=1e-6)) < free.shape[1]


def _undetermined(plant: Plant, strings: Flags, held: Flags, rubbing: Array) -> Flags:
    """The forces that could be others with all that is motionless counted as acting: a pattern has no effect."""
    unit = np.eye(plant.size)
    drag = np.where(held, 0.0, rubbing) * plant.friction
    faces = -unit[plant.faces] + drag[:, None] * unit[plant.rubs]
    slots = np.arange(plant.slots)
    columns = np.vstack([plant.gradients[: len(strings)][strings], faces, unit[plant.rubs[held]]])
    numbers = np.concatenate([slots[plant.strings][strings], slots[plant.presses], slots[plant.grips][held]])
    found = np.zeros(plant.slots, dtype=bool)
    if not len(numbers):
        return found
    _, sizes, right = np.linalg.svd(columns.T)
    rank = int((sizes > 1e-8 * sizes[0]).sum())
    found[numbers] = (np.abs(right[rank:]) > 1e-8).any(axis=0)
    return found
