"""The linear system of all forces for one state of the constraint rows, contacts and friction."""

from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations
from typing import NamedTuple

import numpy as np

from sim2reason.base.records import record
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.trace import Budget

MAX_VERTICES = 3000  # largest number of vertices to examine
VERTEX_VIOLATION_RTOL = 1e-9  # fraction of the largest value of a condition: violation tolerated at a vertex
SINGULAR_VALUE_RTOL = 1e-10  # fraction of the largest: a smaller singular value counts as zero
TRY, FORCE = 4_000, 1_500  # operations for one contact mode, and for each row and face in addition
UNLIMITED_FRICTION = 1e9  # friction coefficient that represents a contact that never slips
MAX_ACCELERATION = 1e9  # larger accelerations or forces belong to an unsupported massless part
ZERO_PATTERN_TOL = 1e-8  # fraction of a force pattern without effect: smaller entries count as zero
MAX_GROWTH = 1e12  # limit on the growth of a solution by division by a small pivot


class ContactMode(NamedTuple):
    """A contact mode: which rows act, which faces are closed, and how each face rubs: 0 sticks, ±1 slips."""

    rows: tuple[bool, ...]
    faces: tuple[bool, ...]
    rubbing: tuple[int, ...]


class Faces(NamedTuple):
    """The faces: the joints by which bodies leave them, gradients of slip (faces, joints), friction coefficients."""

    rises: list[int]
    slips: Array
    friction: list[float]  # kinetic
    holds: list[float]  # coefficients of static friction
    guided: list[bool]


@record()
class ForceProblem:
    """All data that determine the forces at one instant, in arrays over joints."""

    inertia: Array
    loads: Array
    rows: Array  # (rows, joints)
    targets: list[float]
    both: tuple[bool, ...]
    follows: tuple[int, ...]
    faces: Faces
    sliding: tuple[int, ...]  # the direction in which a face slips already; else 0
    allowed: tuple[bool, ...]  # whether each row may act
    budget: Budget  # of the motion to which the instant belongs

    def spend(self, mode: ContactMode) -> None:
        """Subtract the operations of one contact mode from the budget."""
        self.budget.spend(TRY + FORCE * (len(mode.rows) + len(mode.faces)))


@record()
class ForceSolution:
    """Accelerations and all forces of one contact mode; `unknown` marks forces that the motion does not determine."""

    mode: ContactMode
    x: Array
    rows: Array
    normal: Array
    friction: Array
    unknown: Array  # (rows + faces + faces,), 1 if a force is undetermined


class ActiveSet(NamedTuple):
    """The active constraints of a contact mode, by index: rows, closed faces, and the sticking ones among these."""

    rows: list[int]
    closed: list[int]
    sticking: list[int]


def active_set(mode: ContactMode, friction: list[float]) -> ActiveSet:
    """Return the active constraints of a contact mode."""
    closed = [i for i, shut in enumerate(mode.faces) if shut]
    sticking = [i for i in closed if friction[i] > 0.0 and mode.rubbing[i] == 0]
    return ActiveSet([i for i, acts in enumerate(mode.rows) if acts], closed, sticking)


def system(
    inertia: Array,
    loads: Array,
    rows: Array,
    targets: list[float],
    faces: Faces,
    mode: ContactMode,
    acts: ActiveSet,
) -> tuple[Array, Array]:
    """Return a contact mode's matrix and right side: accelerations, acting `rows`, normal forces, friction."""
    n, first, second = len(loads), len(targets), len(targets) + len(acts.closed)
    size = n + second + len(acts.sticking)
    matrix, wanted = np.zeros((size, size)), np.zeros(size)
    matrix[:n, :n], wanted[:n] = inertia, loads
    if first:
        matrix[:n, n : n + first], matrix[n : n + first, :n] = rows.T, rows
        wanted[n : n + first] = targets
    for index, i in enumerate(acts.closed, start=n + first):
        joint = faces.rises[i]
        matrix[joint, index], matrix[index, joint] = -1.0, 1.0
        if mode.rubbing[i]:
            matrix[:n, index] += faces.friction[i] * mode.rubbing[i] * faces.slips[i]
    for index, i in enumerate(acts.sticking, start=n + second):
        matrix[:n, index], matrix[index, :n] = -faces.slips[i], faces.slips[i]
    return matrix, wanted


def solve_mode(instant: ForceProblem, mode: ContactMode) -> ForceSolution | None:
    """Return the solution of the linear system of one contact mode; None if it has none."""
    instant.spend(mode)
    n, acts = len(instant.loads), active_set(mode, instant.faces.friction)
    targets = [instant.targets[i] for i in acts.rows]
    acting = instant.rows if len(targets) == len(mode.rows) else instant.rows[acts.rows]
    matrix, wanted = system(instant.inertia, instant.loads, acting, targets, instant.faces, mode, acts)
    scale = _scale(matrix)
    solution = solve_regular(matrix, wanted, scale) if _is_regular(matrix, scale) else None
    if solution is not None:
        return _arranged(instant, mode, acts, solution, np.zeros(len(wanted)))
    solution, free = _least_norm(matrix, wanted)
    null = np.zeros(len(wanted))
    null[free.any(axis=0)] = 1.0
    if solution is None or null[:n].any():
        return None
    if len(free):
        solution = maximize_least_condition(solution, free, _conditions(instant, acts, len(wanted)))
    return _arranged(instant, mode, acts, solution, null)


def _arranged(instant: ForceProblem, mode: ContactMode, acts: ActiveSet, solution: Array, null: Array) -> ForceSolution:
    """Return a solution of the linear system by kind of force; `null` marks undetermined unknowns by 1."""
    rows, normal, friction = np.zeros(len(mode.rows)), np.zeros(len(mode.faces)), np.zeros(len(mode.faces))
    unknown = np.zeros(len(rows) + 2 * len(normal))
    first = len(instant.loads)
    second = first + len(acts.rows)
    third = second + len(acts.closed)
    if acts.rows:
        rows[acts.rows], unknown[acts.rows] = solution[first:second], null[first:second]
    for index, i in enumerate(acts.closed, start=second):
        normal[i], unknown[len(rows) + i] = solution[index], null[index]
        if mode.rubbing[i]:
            friction[i] = -instant.faces.friction[i] * mode.rubbing[i] * normal[i]
    for index, i in enumerate(acts.sticking, start=third):
        friction[i], unknown[len(rows) + len(normal) + i] = solution[index], null[index]
    return ForceSolution(mode, solution[:first], rows, normal, friction, unknown)


def _conditions(instant: ForceProblem, acts: ActiveSet, size: int) -> Array:
    """Return, as rows over all unknowns, what must not be negative: tensions, normal forces, unused static friction."""
    n, first = len(instant.loads), len(acts.rows)
    normal = {i: n + first + index for index, i in enumerate(acts.closed)}
    conditions = [[(n + index, 1.0)] for index, i in enumerate(acts.rows) if not instant.both[i]]
    conditions += [[(index, 1.0)] for i, index in normal.items() if not instant.faces.guided[i]]
    for index, i in enumerate(acts.sticking, start=n + first + len(acts.closed)):
        conditions += [[(normal[i], instant.faces.holds[i]), (index, side)] for side in (1.0, -1.0)]
    matrix = np.zeros((len(conditions), size))
    for number, entries in enumerate(conditions):
        for index, part in entries:
            matrix[number, index] = part
    return matrix


def maximize_least_condition(solution: Array, free: Array, conditions: Array) -> Array:
    """Return the solution plus the null vectors in `free` that make the least entry of conditions · solution largest.

    It lies where k + 1 of the conditions (m, size) are equal, so all such corners are tried. Where nothing bounds it,
    the solution stays as it is.
    """
    left, sizes, right = np.linalg.svd(conditions @ free.T)
    del left
    rank = int((sizes > SINGULAR_VALUE_RTOL * max(float(sizes.max(initial=0.0)), 1e-300)).sum())
    directions = right[:rank] @ free
    base, change = conditions @ solution, conditions @ directions.T
    corners = np.array(list(combinations(range(len(base)), rank + 1))[:MAX_VERTICES], dtype=np.intp)
    if rank == 0 or not len(corners):
        return solution
    matrix = np.concatenate([change[corners], -np.ones((*corners.shape, 1))], axis=2)
    sound = np.abs(np.linalg.det(matrix)) > SINGULAR_VALUE_RTOL
    if not sound.any():
        return solution
    vertices = np.linalg.solve(matrix[sound], -base[corners[sound]][:, :, None])[:, :, 0]
    margins = base + vertices[:, :-1] @ change.T
    near = VERTEX_VIOLATION_RTOL * max(float(np.abs(base).max(initial=0.0)), 1.0)
    allowed = margins.min(axis=1) >= vertices[:, -1] - near
    if not allowed.any():
        return solution
    best = vertices[np.where(allowed, vertices[:, -1], -np.inf).argmax()]
    return np.asarray(solution + best[:-1] @ directions, dtype=np.float64)


def _scale(matrix: Array) -> Array:
    """Return the largest absolute entry of each row, or 1e-300 for rows of zeros."""
    return np.maximum.reduce(abs(matrix), axis=1, initial=1e-300)


@lru_cache(maxsize=64)
def _side(size: int) -> Array:
    """Return a right side with entries that follow no pattern."""
    steps: Array = np.arange(1.0, size + 1.0)
    return np.sqrt(2.0) * steps % 1.0 - 0.5


def _is_regular(matrix: Array, scale: Array) -> bool:
    """Return whether a system is regular, tested by the size of the solution for a random right side."""
    return _solves((matrix / scale[:, None]).tobytes(), len(matrix))


@lru_cache(maxsize=512)
def _solves(scaled: bytes, size: int) -> bool:
    """Return whether a matrix of this size is regular; cached, since that of a motion often stays the same."""
    try:
        solution = np.linalg.solve(np.frombuffer(scaled).reshape(size, size), _side(size))
    except np.linalg.LinAlgError:
        return False
    return all(-MAX_GROWTH < x < MAX_GROWTH for x in solution.tolist())


def is_moderate(solution: Array) -> bool:
    """Return whether accelerations are finite and below the limit of those of unsupported massless parts."""
    return all(-MAX_ACCELERATION < x < MAX_ACCELERATION for x in solution.tolist())


def solve_regular(matrix: Array, wanted: Array, scale: Array | None = None) -> Array | None:
    """Return the solution of a well-conditioned linear system; None if its accuracy is doubtful.

    `scale` is the largest absolute entry of each row, if known.
    """
    try:
        solution: Array = np.asarray(np.linalg.solve(matrix, wanted), dtype=np.float64)
    except np.linalg.LinAlgError:
        return None
    sizes = [abs(x) for x in solution.tolist()]
    if not all(size <= MAX_ACCELERATION for size in sizes):  # no number is not either
        return None
    residual: Array = matrix.dot(solution)
    residual -= wanted
    residual /= _scale(matrix) if scale is None else scale
    limit = 1e-9 * (1.0 + max(sizes, default=0.0))
    return solution if all(-limit <= x <= limit for x in residual.tolist()) else None


def _least_norm(matrix: Array, wanted: Array) -> tuple[Array | None, Array]:
    """Return the solution, None if there is none, and a basis of the null space, (k, unknowns)."""
    if not len(wanted):
        return wanted, np.zeros((0, 0))
    scale = np.maximum(np.abs(matrix).max(axis=1), 1e-300)
    a, b = matrix / scale[:, None], wanted / scale
    left, sizes, right = np.linalg.svd(a)
    rank = int((sizes > SINGULAR_VALUE_RTOL * sizes[0]).sum())
    found = np.asarray(right[:rank].T @ ((left[:, :rank].T @ b) / sizes[:rank]), dtype=np.float64)
    # round-off in a null vector would let a huge force brace
    free = np.where(np.abs(right[rank:]) > ZERO_PATTERN_TOL, right[rank:], 0.0)
    if rank < len(wanted) and np.abs(a @ found - b).max() > 1e-7 * (1.0 + np.abs(b).max()):
        return None, free
    return found, free


@record()
class Row:
    """A constraint, usually one-sided: J·q̈ ≤ target once the length left, `spare`, shrinking at `rate`, is zero."""

    kind: str  # string, rod, prop, foot, hold, stuck
    name: str
    gradient: Array  # (joints,)
    spare: float
    rate: float
    target: float
    follows: int = -1

    @property
    def both(self) -> bool:
        """Return whether the row is two-sided."""
        return self.kind in ("rod", "hold", "stuck")


@dataclass
class SwitchState:
    """The on/off state that events change: forces in regions, engines, pairs stuck together, one-sided springs."""

    inside: list[list[bool]]
    burning: list[bool]
    stuck: list[bool]
    strained: list[bool]

    def copy(self) -> "SwitchState":
        """Return an independent copy."""
        inside = [list(each) for each in self.inside]
        return SwitchState(inside, list(self.burning), list(self.stuck), list(self.strained))
