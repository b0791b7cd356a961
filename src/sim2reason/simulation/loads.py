"""Loads on a mechanism at rest: the formulas of the exact engine with zero velocities and accelerations."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.system import System
from sim2reason.simulation.engines.exact.tape import Tape

Vector = NDArray[np.float64]

EQUILIBRIUM_TOL = 1e-10  # fraction of the largest force, or m: accuracy of an equilibrium
ZERO_FORCE_TOL = 1e-6  # fraction of the largest force, or m: smaller values count as zero
REFERENCE_STRAIN = 1e-3  # strain of the stiffest spring that sets the scale of forces
DIFFERENCE_STEP = 6e-6  # m or rad, for central differences


@dataclass(frozen=True, slots=True)
class Loads:
    """The load on each coordinate, and the length left of each constraint (`spare`) with its gradient."""

    force: Vector  # (n,)
    spare: Vector  # (rows,)
    along: Vector  # (rows, n)


class RestingLoads:
    """The loads of a mechanism as a function of its coordinates."""

    def __init__(self, mechanism: Mechanism) -> None:
        """Generate the code of the loads.

        Raises:
            UnsupportedError, SceneError: what the exact engine raises.
            ZeroDivisionError: two sites coincide.
        """
        self.mechanism, self.system = mechanism, System(mechanism)
        self.size = self.system.size
        self.kinds = self.system.kinds(self.system.phase)
        self.slips = [grip for grip in self.system.grips if grip.never]
        self.both = [kind.both for kind in self.kinds] + [True] * len(self.slips)
        self.hinges: NDArray[np.bool_] = np.array([c.kind == "hinge" for c in mechanism.coordinates], dtype=np.bool_)
        self._code = self._written()
        self._sticking: Vector = np.array([grip.slip.along for grip in self.slips], dtype=np.float64).reshape(
            len(self.slips), self.size
        )

    def _written(self) -> Callable[..., tuple[float, ...]]:
        n, system = self.size, self.system
        tape = Tape(["t", *(f"q{number}" for number in range(n))])
        _, *q = tape.inputs.values()
        assembly = Assembly(system.mechanism, system.phase, (q, [0.0] * n, 0.0), tape)
        rows = assembly.rows(system.starts)
        entries = [row.along.get(k, 0.0) for row in rows for k in range(n)]
        return tape.code([*assembly.force, *(row.value for row in rows), *entries])(math)

    def at(self, places: Vector) -> Loads:
        """Return the loads at coordinates (n,), m or rad; raise ZeroDivisionError if two sites coincide."""
        outputs: Vector = np.array(self._code(0.0, places.tolist()), dtype=np.float64)
        n, last = self.size, self.size + len(self.kinds)
        spare, along = outputs[n:last], outputs[last:].reshape(len(self.kinds), n)
        if self.slips:
            spare = np.concatenate([spare, -self._sticking @ places])
            along = np.concatenate([along, self._sticking])
        return Loads(outputs[:n], spare, along)

    def assembly(self, places: Vector) -> Assembly:
        """Return the exact engine's assembly of the mechanism at rest at these coordinates."""
        return Assembly(self.mechanism, self.system.phase, (places.tolist(), [0.0] * self.size, 0.0), math)

    def largest(self, places: Vector) -> float:
        """Return the scale of forces: the largest load, or that of a small strain of the stiffest spring, N or N m."""
        springs = (
            REFERENCE_STRAIN * line.law.stiffness * (self.system.starts[line.name] or 1.0)
            for line in self.mechanism.lines
            if isinstance(line.law, Elastic)
        )
        return max(float(np.abs(self.at(places).force).max(initial=0.0)), *springs, 0.0) or 1.0

    def forces(self, loads: Loads, active: list[int]) -> Vector:
        """Return the least-squares forces of all rows that balance the loads; zero for inactive rows."""
        forces: Vector = np.zeros(len(loads.spare))
        if active:
            forces[active] = np.linalg.lstsq(loads.along[active].T, loads.force, rcond=1e-9)[0]
        return forces

    def stiffness(self, places: Vector, forces: Vector, active: list[int]) -> Vector:
        """Return the stiffness matrix −∂(F − Jᵀλ)/∂q at fixed λ, (n, n)."""

        def load(q: Vector) -> Vector:
            loads = self.at(q)
            return loads.force - forces[active] @ loads.along[active] if active else loads.force

        columns = [load(places - step) - load(places + step) for step in DIFFERENCE_STEP * np.eye(self.size)]
        matrix: Vector = np.array(columns).T / (2.0 * DIFFERENCE_STEP)
        return matrix

    def tightening(self, loads: Loads, active: list[int]) -> Vector:
        """Return the shortest change of the coordinates, (n,), that satisfies all active rows to first order."""
        change: Vector = np.zeros(self.size)
        if active:
            change = change + np.linalg.lstsq(loads.along[active], loads.spare[active], rcond=1e-9)[0]
        return change

    def linear(self, points: Vector, scale: float) -> bool:
        """Return whether loads are linear in the coordinates, from zero to each of the points (k, n)."""
        first = self.at(np.zeros(self.size))
        for point in points:
            half, full = self.at(0.5 * point), self.at(point)
            bend = float(np.abs(first.force - 2.0 * half.force + full.force).max(initial=0.0))
            if (
                bend > EQUILIBRIUM_TOL * scale
                or float(np.abs(full.along - first.along).max(initial=0.0)) > EQUILIBRIUM_TOL
            ):
                return False
        return True


def null_space(rows: Vector, size: int) -> Vector:
    """Return an orthonormal basis of the null space of the rows, (size, m)."""
    if not rows.size:
        return np.eye(size)
    _, sizes, right_vectors = np.linalg.svd(rows, full_matrices=True)
    return right_vectors[int((sizes > ZERO_FORCE_TOL).sum()) :].T


def undetermined_forces(rows: Vector) -> NDArray[np.bool_]:
    """Return, for each row, whether its force is undetermined, since other rows could bear the load, (rows,)."""
    if not rows.size:
        return np.zeros(len(rows), dtype=np.bool_)
    sides, sizes, _ = np.linalg.svd(rows, full_matrices=True)
    spare: Vector = np.abs(sides[:, int((sizes > ZERO_FORCE_TOL).sum()) :]).max(axis=1, initial=0.0)
    return spare > ZERO_FORCE_TOL


def symmetric(matrix: Vector) -> Vector:
    """Return the symmetric part of a matrix."""
    return 0.5 * (matrix + matrix.T)
