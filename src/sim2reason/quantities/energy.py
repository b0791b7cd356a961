"""Kinetic and potential energy of each body by itself."""

import numpy as np

from sim2reason.dsl.kinematics import hinge_of
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import quantity
from sim2reason.quantities.kinematics import displacement, velocity


@quantity("kinetic energy", unit="J", symbol="K", of="body")
def kinetic_energy(state: State, body: str) -> Array:
    """K = ½ m v² + ½ I ω² (König), (n,); ω is that of the body's own hinge, since frames do not turn."""
    found = state.mechanism.body[body]
    speed = velocity(state, body)
    energy = 0.5 * found.mass * np.einsum("ij,ij->i", speed, speed)
    hinge = hinge_of(state.mechanism, body)
    return energy if hinge is None else energy + 0.5 * found.inertia * state.v[:, hinge] ** 2


@quantity("potential energy", unit="J", symbol="U", of="body")
def potential_energy(state: State, body: str) -> Array:
    """The gravitational potential energy less that at the start, ΔU = −m g·s, (n,)."""
    mass = state.mechanism.body[body].mass
    return -mass * displacement(state, body) @ np.array(state.mechanism.gravity)
