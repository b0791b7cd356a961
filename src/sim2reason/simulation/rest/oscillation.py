"""Small oscillations about a stable equilibrium: M q̈ + K q = 0 along the motions that the rows allow.

M and K are projected on these, ZᵀMZ and ZᵀKZ; what has no mass follows at once, so that it is eliminated
(K − K₁₂ K₂₂⁻¹ K₂₁, Guyan 1965); the eigenvalues ω² of the rest are the squares of the angular frequencies.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sim2reason.dsl.fields import Push
from sim2reason.dsl.mechanism import Elastic, Mechanism
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.system import System
from sim2reason.simulation.rest.equilibrium import Rest
from sim2reason.simulation.rest.loads import Vector

MASSLESS = 1e-9  # of the largest inertia
STILL = 1e-6  # of the largest ω²: less is none


@dataclass(frozen=True)
class Oscillations:
    """The normal modes of small oscillations, the slowest first."""

    frequencies: Vector  # angular, rad/s, (k,); what nothing drives back is left out
    shapes: Vector  # how the coordinates move in each, m or rad, (n, k), of any size


def oscillations(rest: Rest) -> Oscillations | None:
    """The modes about a stable equilibrium; None where a motion would die away or turn, or stiffness is lacking."""
    mechanism = rest.mechanism
    if not _conserves(mechanism):
        return None
    mass = rest.allowed.T @ inertia(rest) @ rest.allowed
    sizes, axes = np.linalg.eigh(mass)
    heavy = sizes > MASSLESS * float(sizes.max(initial=0.0))
    stiffness = axes.T @ rest.stiffness @ axes
    follow = _following(stiffness, heavy)
    if follow is None or not heavy.any():
        return None
    reduced = stiffness[np.ix_(heavy, heavy)] + stiffness[np.ix_(heavy, ~heavy)] @ follow
    roots = 1.0 / np.sqrt(sizes[heavy])
    squares, turned = np.linalg.eigh(roots[:, None] * reduced * roots)
    moving = squares > STILL * float(squares.max(initial=0.0))
    main = roots[:, None] * turned[:, moving]
    shapes = np.zeros((len(sizes), int(moving.sum())))
    shapes[heavy], shapes[~heavy] = main, follow @ main
    return Oscillations(np.sqrt(squares[moving]), rest.allowed @ axes @ shapes)


def inertia(rest: Rest) -> Vector:
    """The mass matrix of all coordinates in an equilibrium, (n, n)."""
    mechanism, places = rest.mechanism, rest.coordinates.tolist()
    assembly = Assembly(mechanism, System(mechanism).phase, (places, [0.0] * len(places), 0.0), math)
    return np.array(assembly.full_mass(), dtype=np.float64)


def _following(stiffness: Vector, heavy: NDArray[np.bool_]) -> Vector | None:
    """How what has no mass follows what has; None if nothing holds it."""
    light = stiffness[np.ix_(~heavy, ~heavy)]
    if len(light) and float(np.linalg.eigvalsh(light).min()) <= STILL * float(np.abs(stiffness).max()):
        return None
    found: Vector = np.zeros((int((~heavy).sum()), int(heavy.sum())))
    return found - np.linalg.solve(light, stiffness[np.ix_(~heavy, heavy)])


def _conserves(mechanism: Mechanism) -> bool:
    """Whether no force depends on velocities, as those of dashpots, drag and magnets do."""
    dashpots = any(isinstance(line.law, Elastic) and line.law.damping for line in mechanism.lines)
    return not dashpots and all(isinstance(force.law, Push) or force.law.constant for force in mechanism.forces)
