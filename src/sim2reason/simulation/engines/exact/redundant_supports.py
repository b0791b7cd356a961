"""Search for admissible forces in a structure with redundant supports.

If multipliers are not unique, those from elimination may make a string push or a contact exceed µN although other
admissible forces exist. This module finds any admissible set.
"""

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.exact.linear import ContactMode, Problem, Row

ROUND_OFF_TOL = 1e-12  # relative threshold of round-off
MAX_RESIDUAL = 1e-9  # fraction of the largest load: admissible residual


def admissible_forces(problem: Problem, mode: ContactMode, x: Row) -> tuple[Row, Row] | None:
    """Return forces λ of acting rows and friction f that obey all inequalities at accelerations x; None if none do.

    Admissible means λ ≥ 0 except for two-sided rows, |f| ≤ µN and N ≥ 0. As equations with nonnegative unknowns:
    λ = p − r if it may have either sign; f = p − r, µN = p + r + spare for a sticking contact, N = spare for any other.
    """
    active = [number for number, acts in enumerate(mode.acting) if acts]
    n, c = len(x), len(problem.press)
    along = np.array([problem.rows[number].along for number in active]).reshape(len(active), n).T
    lift = np.array([problem.rows[number].lift for number in active]).reshape(len(active), c).T
    balance = np.array(problem.force) - np.array(problem.mass) @ np.array(x)
    bare = np.array(problem.lifted).reshape(c, n) @ np.array(x) - np.array(problem.press)  # N without strings
    for grip, side in zip(problem.grips, mode.rubbing, strict=True):
        if side:
            slip = np.array(grip.slip.along)
            along += grip.friction * side * np.outer(slip, lift[grip.contact])
            balance -= grip.friction * side * bare[grip.contact] * slip
    both = [index for index, number in enumerate(active) if problem.held[number]]
    sticking = [number for number, side in enumerate(mode.rubbing) if side == 0]
    matrix = _stacked(problem, along, lift, sticking)
    matrix = np.hstack([matrix, -matrix[:, both]])
    right = np.concatenate([balance, bare])
    scale = max(float(np.abs(right).max(initial=0.0)), ROUND_OFF_TOL)
    unknowns, residual = nonnegative(matrix, right / scale)
    if residual > MAX_RESIDUAL:
        return None
    unknowns *= scale
    rows = unknowns[: len(active)]
    rows[both] -= unknowns[len(unknowns) - len(both) :]
    friction = np.zeros(len(problem.grips))
    pairs = unknowns[len(active) : len(active) + 2 * len(sticking)].reshape(-1, 2)
    friction[sticking] = pairs[:, 0] - pairs[:, 1]
    return rows.tolist(), friction.tolist()


def _stacked(problem: Problem, along: Array, lift: Array, sticking: list[int]) -> Array:
    """Return the matrix of force balance, with columns for forces of rows, parts p and r of friction, and spare."""
    n, rows = along.shape
    c, k = len(lift), len(sticking)
    matrix = np.zeros((n + c, rows + 2 * k + c))
    matrix[:n, :rows] = along
    matrix[n:, :rows] = -lift
    matrix[n:, rows + 2 * k :] = np.eye(c)
    for index, number in enumerate(sticking):
        grip, p = problem.grips[number], rows + 2 * index
        slip = np.array(grip.slip.along)
        matrix[:n, p], matrix[:n, p + 1] = -slip, slip
        matrix[n + grip.contact, [p, p + 1]] = 1.0 / grip.holds
    return matrix


def nonnegative(matrix: Array, right: Array) -> tuple[Array, float]:
    """Return the x ≥ 0 that minimizes |matrix·x − right|, and the largest entry of that residual.

    The active-set method of Lawson and Hanson, Solving Least Squares Problems (1974), chapter 23: add the unknown with
    the largest descent; return to the boundary if another would turn negative, and remove that one. It starts with all
    unknowns in the active set, of which most stay.
    """
    columns = matrix.shape[1]
    x = np.zeros(columns)
    inside = np.ones(columns, dtype=bool)
    _descend(matrix, right, x, inside)
    for _ in range(3 * columns):
        gain = np.where(inside, -np.inf, matrix.T @ (right - matrix @ x))
        if inside.all() or gain.max() <= ROUND_OFF_TOL:
            break
        inside[gain.argmax()] = True
        _descend(matrix, right, x, inside)
    return x, float(np.abs(right - matrix @ x).max(initial=0.0))


def _descend(matrix: Array, right: Array, x: Array, inside: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> None:
    """Change the unknowns `inside` of x to least squares, fixing those at zero that would turn negative."""
    while inside.any():
        goal = np.zeros_like(x)
        goal[inside] = np.linalg.lstsq(matrix[:, inside], right, rcond=None)[0]
        blocked = inside & (goal <= 0.0)
        if not blocked.any():
            x[:] = goal
            return
        reach = x[blocked] / np.maximum(x[blocked] - goal[blocked], ROUND_OFF_TOL**2)
        x += reach.min() * (goal - x)
        out = blocked & (x <= ROUND_OFF_TOL)
        out[np.flatnonzero(blocked)[reach.argmin()]] = True
        inside &= ~out
        x[~inside] = 0.0
