"""Forces and impulses from MuJoCo's solver, corrected for the softness of its constraints.

The solver gives a constraint the acceleration K·overlap − B·rate − R·force. So the limit of a string under
tension must be overstepped slightly, by R·f/K, and a body held by friction must creep, at −R·f/B, or the
acceleration is wrong; once a contact is known to stick, an equality constraint locks it instead. The
corrections are found by iteration: solve, shift limits and speeds according to the forces, solve again. Each
iteration reduces the error by a factor of about R, 1e-5. The force of a sliding contact is µN, with N from the
previous iteration.
"""

from dataclasses import dataclass

import numpy as np

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.compiled_model import CompiledModel, Flags, Integers

MAX_OVERLAP_ITERATIONS = 24  # largest number of iterations of overlaps and creep
MAX_NORMAL_ITERATIONS = 60  # largest number of iterations of the normal forces behind the friction
PATIENT = 30  # rounds after which small forces may keep changing
FORCE_RTOL = 1e-10  # fraction of the largest force: smaller differences count as equal
EQUAL = 1e-7  # fraction of the largest force or acceleration: equality of forces that are not unique
MIN_OVERLAP = 1e-12  # m; an overlap that still creates a constraint row


@dataclass(frozen=True)
class ForceDemand:
    """The constraints that may act at an instant, and the applied loads."""

    q: Array
    v: Array
    strings: Flags  # those that are just straight
    pairs: Flags  # those that touch
    sliding: Array  # of each contact: ±1 if it slides, else 0
    locked: Flags  # contacts known to stick; other contacts that do not slide have a friction limit
    applied: Array  # joint forces, N
    targets: Array  # of each slot: the least acceleration at which its gap opens, m/s²
    normal: Array | None = None  # a first guess of the normal forces, N


@dataclass(frozen=True)
class ForceBalance:
    """The accelerations and constraint forces that balance at an instant."""

    a: Array
    forces: Array  # by slot, N
    rows: Integers


def balance(model: CompiledModel, demand: ForceDemand) -> ForceBalance:
    """Compute all constraint forces and the accelerations.

    Raises:
        SimulationError: friction and normal forces drive each other without end.
    """
    model.stand(demand.q)
    rough = model.friction > 0.0
    normal = np.zeros(len(rough)) if demand.normal is None else demand.normal
    history: list[tuple[Array, Array]] = []
    for number in range(MAX_NORMAL_ITERATIONS):
        found = _turns(model, demand, normal)
        fresh = found.forces[model.presses]
        change = np.where(rough, fresh - normal, 0.0)
        close = 10.0 * (FORCE_RTOL if number < PATIENT else EQUAL)
        if np.abs(change).max(initial=0.0) <= close * (_largest(found.forces) + 1e-6):
            return found
        history.append((normal, change))
        mixed = _mixed(history)
        if (mixed < 0.0).any():  # the line through the last guesses crosses where something begins to slide or stick
            history, mixed = [], fresh
        normal = np.maximum(mixed, 0.0)
    raise SimulationError("MuJoCo: friction and normal forces find no balance; friction may be too strong")


def _mixed(history: list[tuple[Array, Array]]) -> Array:
    """Return Anderson's mixing of previous iterates: the next guess of a nearly linear fixed-point iteration."""
    guess, change = history[-1]
    if len(history) == 1:
        return guess + change
    guesses = np.array([guess - g for g, _ in history[-6:-1]]).T
    changes = np.array([change - c for _, c in history[-6:-1]]).T
    weights = np.linalg.lstsq(changes, change, rcond=1e-9)[0]
    return guess + change - (guesses + changes) @ weights


def _turns(model: CompiledModel, demand: ForceDemand, normal: Array) -> ForceBalance:
    """Return the forces at given friction limits, iterated until MuJoCo's soft constraints act as rigid ones."""
    limits = np.where((demand.sliding == 0.0) & ~demand.locked, model.static_friction * normal, 0.0)
    applied = demand.applied.copy()
    np.subtract.at(applied, model.rubs, demand.sliding * model.friction * normal)
    model.arm(demand.strings, demand.pairs, demand.locked, limits, applied)
    overlap, creep = np.full(model.slots, MIN_OVERLAP), np.zeros(model.size)
    last: ForceBalance | None = None
    for turn in range(MAX_OVERLAP_ITERATIONS):
        model.overlap(overlap)
        model.load(demand.q, demand.v + creep)
        rows = model.rows()
        found = ForceBalance(model.a, model.forces(rows), rows)
        if last is not None and _same(found, last, FORCE_RTOL if turn < 5 else EQUAL):
            return found
        overlap, creep = _corrected(model, demand, found, limits)
        last = found
    raise SimulationError("MuJoCo: its constraints find no balance")


def _largest(values: Array) -> float:
    return float(np.abs(values).max(initial=0.0))


def _same(a: ForceBalance, b: ForceBalance, close: float) -> bool:
    if not np.array_equal(a.rows, b.rows):
        return False
    if _largest(a.forces - b.forces) <= close * _largest(a.forces) + 1e-15:
        return True
    return close == EQUAL and _largest(a.a - b.a) <= EQUAL * (_largest(a.a) + 1.0)


def _corrected(model: CompiledModel, demand: ForceDemand, found: ForceBalance, limits: Array) -> tuple[Array, Array]:
    """Return the constraint overlaps, m, and joint speeds at which MuJoCo's soft constraints yield these forces."""
    overlap = np.full(model.slots, MIN_OVERLAP)
    if not len(found.rows):
        return overlap, np.zeros(model.size)
    soft, forces = model.softness(), found.forces[found.rows]
    give, rate = soft.regularisation * forces, soft.gradient @ demand.v
    stiff = soft.stiffness > 0.0
    needed = (give + demand.targets[found.rows] + soft.damping * rate) / np.where(stiff, soft.stiffness, 1.0)
    overlap[found.rows] = needed
    overlap[: model.grips.start] = np.maximum(overlap[: model.grips.start], MIN_OVERLAP)
    held = ~stiff & (np.abs(forces) < np.append(np.zeros(model.grips.start), limits)[found.rows])
    if not held.any():
        return overlap, np.zeros(model.size)
    kept = stiff | held
    speeds = np.where(held, -give / soft.damping - rate, 0.0)
    creep = np.linalg.lstsq(soft.gradient[kept], speeds[kept], rcond=1e-10)[0]
    return overlap, creep.astype(np.float64)
