"""Taut strings and sticking or sliding contacts at an instant, decided by MuJoCo's solver."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.balance import ForceBalance, ForceDemand, balance
from sim2reason.simulation.engines.mujoco.compiled_model import TINY, CompiledModel, Flags
from sim2reason.simulation.engines.mujoco.event_detection import REST_RATE, TOUCHING, EventDetector

SCALE = 1e-3  # an impact is solved at a thousandth of its velocities, so that overlaps stay small
TENSION_RTOL = 1e-7  # fraction of the largest load: smaller tensions count as zero
START = 1e-4  # m/s²; a contact at rest begins to slide only above this acceleration
LIFT = 1e-6  # fraction of the largest speed: a face separates, or a contact slides after an impact, only above this


class ContactMode(NamedTuple):
    """The contact mode: which strings are taut, and how each contact rubs: 0 sticks or is smooth, ±1 slides."""

    taut: Flags
    rubbing: Array


@dataclass(frozen=True)
class SettledForces:
    """The contact mode of a motion segment with its forces and the reasons that end the motion, if any."""

    mode: ContactMode
    balance: ForceBalance
    undetermined: Flags  # by slot
    lifted: tuple[int, ...]  # contacts that separate from their face
    loose: bool  # whether nothing holds some massless part


def solve_forces(model: CompiledModel, detector: EventDetector, q: Array, v: Array, taut: Flags) -> SettledForces:
    """Compute the contact mode and the forces at a state between impacts.

    `taut` are the strings that were so, or have just become so: they remain so under no tension while nothing
    moves their ends together. Raises SimulationError if no forces are found.
    """
    zero = np.zeros(model.size)
    spare = detector.strings(q, v, zero)
    tight = (spare.value <= TOUCHING) & (np.abs(spare.rate) <= REST_RATE)
    rough = model.friction > 0.0
    sliding = np.where(rough, np.sign(v[model.rubs]), 0.0)
    demand = _demand(model, q, v, tight, sliding, zero)
    faint = TENSION_RTOL * model.load_scale
    last, found = _decide(model, demand, START, faint)
    a = found.a
    lifted = tuple(int(i) for i in np.flatnonzero(a[model.faces] > REST_RATE))
    still = tight & (np.abs(detector.strings(q, v, a).second) <= REST_RATE)
    held = rough & (v[model.rubs] == 0.0) & (np.abs(a[model.rubs]) <= REST_RATE)
    open_ended = _undetermined(model, still, held, last.sliding)
    mode = ContactMode(last.strings | (still & taut), last.sliding)
    pulling = last.strings & ((found.forces[model.strings] > faint) | open_ended[model.strings])
    return SettledForces(mode, found, open_ended, lifted, _loose(model, pulling, last.sliding))


def _demand(model: CompiledModel, q: Array, v: Array, strings: Flags, sliding: Array, applied: Array) -> ForceDemand:
    pairs, locked = np.zeros(len(model.pairs), dtype=bool), np.zeros(len(model.friction), dtype=bool)
    return ForceDemand(q, v, strings, pairs, sliding, locked, applied, np.zeros(model.slots))


def _decide(
    model: CompiledModel, demand: ForceDemand, start: float, faint: float, *, impact: bool = False
) -> tuple[ForceDemand, ForceBalance]:
    """Decide which strings pull and which contacts slide by MuJoCo's solver, then solve for these alone.

    A contact at rest slides if its friction is at its limit and it accelerates by more than `start`; a string
    pulls with more than `faint`, but in an impact every string may pull, since no jerk is negligible.
    """
    first = balance(model, demand)
    pulling = demand.strings & ((first.forces[model.strings] > faint) | impact)
    resting = (model.friction > 0.0) & (demand.sliding == 0.0)
    if not resting.any() and np.array_equal(pulling, demand.strings):
        return demand, first
    normal, a = first.forces[model.presses], first.a[model.rubs]
    at_limit = np.abs(first.forces[model.grips]) >= model.static_friction * normal - faint
    started = resting & at_limit & (np.abs(a) > start)
    sliding = np.where(started, np.sign(a), demand.sliding)
    last = replace(demand, strings=pulling, sliding=sliding, locked=resting & ~started, normal=normal)
    found = balance(model, last)
    torn = demand.strings & ~pulling & (model.gradients[: len(pulling)] @ found.a > REST_RATE)
    if not torn.any():
        return last, found
    last = replace(last, strings=pulling | torn)  # a faint pull holds what has hardly any mass
    return last, balance(model, last)


def solve_impact(model: CompiledModel, detector: EventDetector, q: Array, v: Array) -> tuple[Array, tuple[int, ...]]:
    """Return the velocities just after an impact, and the contacts that separate from their faces.

    The solver treats impulses as forces, and velocities as accelerations from M·v, with neither gravity nor pulls.
    """
    zero = np.zeros(model.size)
    full = detector.strings(q, v, zero).value <= TOUCHING
    gaps = detector.approach(q, v, zero).gaps
    restitution = np.array([pair.restitution for pair in model.mechanism.meetings])
    touching = (gaps.value <= TOUCHING) & ((gaps.rate < -REST_RATE) | (restitution == 0.0))  # what rests is struck next
    targets = np.zeros(model.slots)
    targets[model.hits] = SCALE * np.maximum(-restitution * gaps.rate, 0.0)
    model.aim(detector.closing(q))
    model.loads(on=False)
    momenta, fast = SCALE * model.mass @ v, float(np.abs(v).max())
    demand = _demand(model, q, zero, full, np.zeros(len(model.friction)), momenta)
    demand = replace(demand, pairs=touching, targets=targets)
    last, found = _decide(model, demand, LIFT * SCALE * fast, TENSION_RTOL * float(np.abs(momenta).max()), impact=True)
    model.loads(on=True)
    after = found.a / SCALE
    lifted = tuple(int(i) for i in np.flatnonzero(after[model.faces] > LIFT * fast))
    after[model.faces] = 0.0
    after[model.rubs[last.locked]] = 0.0
    return after, lifted


def weightless(model: CompiledModel) -> Array:
    """Return the massless directions of the joint space, (joints, k), orthonormal."""
    sizes, vectors = np.linalg.eigh(model.mass)
    return vectors[:, sizes < 1e3 * TINY]


def _loose(model: CompiledModel, taut: Flags, rubbing: Array) -> bool:
    """Return whether some massless part is held neither by a taut string nor by a sticking contact."""
    free = weightless(model)
    if not free.shape[1]:
        return False
    stuck = (model.friction > 0.0) & (rubbing == 0.0)
    holding = np.vstack([model.gradients[: len(taut)][taut], np.eye(model.size)[model.rubs[stuck]]])
    holding = np.vstack([holding, np.eye(model.size)[model.faces]])
    return int(np.linalg.matrix_rank(holding @ free, tol=1e-6)) < free.shape[1]


def _undetermined(model: CompiledModel, strings: Flags, held: Flags, rubbing: Array) -> Flags:
    """Return which forces are undetermined, with every motionless constraint counted as acting."""
    unit = np.eye(model.size)
    drag = np.where(held, 0.0, rubbing) * model.friction
    faces = -unit[model.faces] + drag[:, None] * unit[model.rubs]
    slots = np.arange(model.slots)
    columns = np.vstack([model.gradients[: len(strings)][strings], faces, unit[model.rubs[held]]])
    numbers = np.concatenate([slots[model.strings][strings], slots[model.presses], slots[model.grips][held]])
    found = np.zeros(model.slots, dtype=bool)
    if not len(numbers):
        return found
    _, sizes, right = np.linalg.svd(columns.T)
    rank = int((sizes > 1e-8 * sizes[0]).sum())
    found[numbers] = (np.abs(right[rank:]) > 1e-8).any(axis=0)
    return found
