"""Whether the laws that are stated determine what is needed, and all else follows from them: linear algebra.

At the values of all names each relation gives a row, its partial derivatives by the names that are not given. What
follows from laws has a row that is a combination of theirs.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from sim2reason.solutions.checking.equation import ROUNDING, Equation

Array: TypeAlias = npt.NDArray[np.float64]

FAINT = 1e-8  # relative: what a combination of laws may leave of a row that it ought to give
RANK = 1e-12  # relative: singular values below it are taken as zero
LAW = "law"


def undetermined(
    equations: Sequence[Equation], known: frozenset[str], values: Mapping[str, float], needed: Sequence[str]
) -> Iterator[str]:
    """What the laws among some equations do not determine, or does not follow from them, in words.

    Args:
        equations: all relations but those that only verify something, at whose names' `values` they hold.
        known: the names that no law needs to determine.
        values: of all names.
        needed: the names that the laws must determine.
    """
    names = sorted({name for equation in equations for name in equation.names} - known)
    place = {name: number for number, name in enumerate(names)}
    sizes = np.array([abs(values[name]) if abs(values[name]) > ROUNDING else 1.0 for name in names])
    rows = [_row(equation, values, place, sizes) for equation in equations]
    basis = _basis([row for row, equation in zip(rows, equations, strict=True) if equation.role == LAW], len(names))
    for name in needed:
        if name not in known and (name not in place or not _spanned(basis, np.eye(len(names))[place[name]])):
            yield f"the laws that are told do not determine {name}"
    for row, equation in zip(rows, equations, strict=True):
        if equation.role != LAW and not _spanned(basis, row):
            yield f"does not follow from what is told: {equation}"


def _row(equation: Equation, values: Mapping[str, float], place: Mapping[str, int], sizes: Array) -> Array:
    """By relative changes, so that what is large and what is small weigh alike."""
    row = np.zeros(len(place))
    _, slopes = equation.slopes(values)
    for name, slope in slopes.items():
        if name in place:
            row[place[name]] = slope
    row *= sizes
    scale = np.abs(row).max(initial=0.0)
    return row / scale if scale else row


def _basis(rows: Sequence[Array], width: int) -> Array:
    """An orthonormal basis of what rows span, one vector a row."""
    if not rows or not width:
        return np.zeros((0, width))
    _, sizes, ways = np.linalg.svd(np.array(rows), full_matrices=False)
    return ways[sizes > RANK * sizes.max(initial=0.0)]


def _spanned(basis: Array, row: Array) -> bool:
    """Whether a row is a combination of those of a basis."""
    return bool(np.abs(row - basis.T @ (basis @ row)).max(initial=0.0) <= FAINT * np.abs(row).max(initial=0.0))
