"""Kinetic and potential energy of each body by itself."""

import numpy as np

from sim2reason.dsl.fields import applied, product
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import quantity
from sim2reason.quantities.kinematics import displacement, velocity


@quantity("kinetic energy", unit="J", symbol="K", of="body")
def kinetic_energy(state: State, body: str) -> Array:
    """K = ½ m v² + ½ ω·Iω (König), (n,), with its own inertia about its centre of mass."""
    found, speed = state.mechanism.body[body], velocity(state, body)
    energy = 0.5 * found.mass * np.einsum("ij,ij->i", speed, speed)
    frame = state.frames[body]
    if frame.spin is None:
        return energy
    spin = frame.unturned(frame.spin)
    return energy + 0.5 * product(spin, applied(found.inertia, spin))


@quantity("potential energy", unit="J", symbol="U", of="body")
def potential_energy(state: State, body: str) -> Array:
    """The gravitational potential energy less that at the start, ΔU = −m g·s, (n,)."""
    mass = state.mechanism.body[body].mass
    return -mass * displacement(state, body) @ np.array(state.mechanism.gravity)
