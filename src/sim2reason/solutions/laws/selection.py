"""Which laws an answer rests on: those, and no others, of which a combination gives it."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from sim2reason.solutions.laws.newton import Row
from sim2reason.solutions.writing.steps import UnsolvedError

FAINT = 1e-9  # of the largest weight: a law that takes no part


def needed(
    rows: Sequence[Row], unknowns: Sequence[str], values: Mapping[str, float], goals: Sequence[str]
) -> list[Row]:
    """The rows that determine the goals, in order; UnsolvedError if all together do not.

    The weights with which laws add up to a goal are unique where the laws are independent: those of weight 0 are idle.
    Where they are not (two frictions of which only the sum is fixed), laws are left out one by one.
    """
    matrix = np.array([[row.zero.coefficient(name).value(values) for name in unknowns] for row in rows])
    matrix = matrix.reshape(len(rows), len(unknowns))
    kept: set[int] = set()
    for goal in goals:
        target = np.array([1.0 if name == goal else 0.0 for name in unknowns])
        kept |= _taking_part(matrix, target, goal)
    return [row for number, row in enumerate(rows) if number in kept]


def _taking_part(matrix: NDArray[np.float64], target: NDArray[np.float64], goal: str) -> set[int]:
    everything = list(range(len(matrix)))
    weights = _weights(matrix, target)
    if weights is None:
        raise UnsolvedError(f"the laws do not determine {goal}")
    if np.linalg.matrix_rank(matrix) == len(matrix):
        return {n for n in everything if abs(weights[n]) > FAINT * np.abs(weights).max()}
    kept = everything
    for number in everything:
        fewer = [n for n in kept if n != number]
        if fewer and _weights(matrix[fewer], target) is not None:
            kept = fewer
    return set(kept)


def _weights(matrix: NDArray[np.float64], target: NDArray[np.float64]) -> NDArray[np.float64] | None:
    if not len(matrix):
        return None
    weights = np.asarray(np.linalg.lstsq(matrix.T, target, rcond=1e-12)[0], dtype=np.float64)
    return weights if np.abs(matrix.T @ weights - target).max() <= 1e-8 else None
