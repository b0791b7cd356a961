"""Momentum and its rate of change."""

from sim2reason.dsl.state import Array, State
from sim2reason.quantities import quantity
from sim2reason.quantities.kinematics import acceleration, velocity


@quantity("momentum", unit="kg m/s", symbol="p", of="body", vector=True)
def momentum(state: State, body: str) -> Array:
    """P = m v of the centre of mass, (n, 3); of the body alone, whatever it carries."""
    return state.mechanism.body[body].mass * velocity(state, body)


@quantity("net force", unit="N", symbol="F", of="body", vector=True)
def net_force(state: State, body: str) -> Array:
    """F = m a, the sum of all forces on the body alone, (n, 3)."""
    return state.mechanism.body[body].mass * acceleration(state, body)
