"""Where bodies are and how they move: of their centres of mass, in room coordinates."""

from sim2reason.dsl.fields import minus, plus, times
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import quantity


@quantity("displacement", unit="m", symbol="s", of="body", vector=True)
def displacement(state: State, body: str) -> Array:
    """The displacement of the centre of mass from where it was at the start, (n, 3)."""
    began = state.began.center(body).place
    return state.vector(minus(state.frames.center(body).place, began))


@quantity("velocity", unit="m/s", symbol="v", of="body", vector=True)
def velocity(state: State, body: str) -> Array:
    """The velocity of the centre of mass, (n, 3)."""
    return state.vector(state.frames.center(body).velocity)


@quantity("acceleration", unit="m/s^2", symbol="a", of="body", vector=True)
def acceleration(state: State, body: str) -> Array:
    """The acceleration of the centre of mass, (n, 3): J q̈ and what its path and its carriers bend."""
    point = state.frames.center(body)
    total = point.bias
    for number, way in point.gradient.items():
        total = plus(total, times(state.a[:, number], way))
    return state.vector(total)
