"""Which of all forces that hold something more than once: those that are farthest from giving way."""

from itertools import combinations

import numpy as np

from sim2reason.dsl.state import Array

FLAT = 1e-10  # of the largest: a singular value that is none
MOST = 3000  # corners that are looked at
SLIP = 1e-9  # of the largest margin: by how much a corner may violate a condition


def braced(solution: Array, free: Array, conditions: Array) -> Array:
    """The solution + a combination of the rows of `free` (k, size) for which the least of conditions·x is greatest.

    It lies where k + 1 of the conditions (m, size) are equal, so all such corners are tried. Where nothing bounds it,
    the solution stays as it is.
    """
    left, sizes, right = np.linalg.svd(conditions @ free.T)
    del left
    rank = int((sizes > FLAT * max(float(sizes.max(initial=0.0)), 1e-300)).sum())
    ways = right[:rank] @ free
    base, change = conditions @ solution, conditions @ ways.T
    corners = np.array(list(combinations(range(len(base)), rank + 1))[:MOST], dtype=np.intp)
    if rank == 0 or not len(corners):
        return solution
    matrix = np.concatenate([change[corners], -np.ones((*corners.shape, 1))], axis=2)
    sound = np.abs(np.linalg.det(matrix)) > FLAT
    if not sound.any():
        return solution
    found = np.linalg.solve(matrix[sound], -base[corners[sound]][:, :, None])[:, :, 0]
    margins = base + found[:, :-1] @ change.T
    near = SLIP * max(float(np.abs(base).max(initial=0.0)), 1.0)
    allowed = margins.min(axis=1) >= found[:, -1] - near
    if not allowed.any():
        return solution
    best = found[np.where(allowed, found[:, -1], -np.inf).argmax()]
    return np.asarray(solution + best[:-1] @ ways, dtype=np.float64)
