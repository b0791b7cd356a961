"""Where bodies are and how they move: of their centres of mass, in room coordinates."""

from sim2reason.dsl.kinematics import carried, slides_of
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import quantity


@quantity("displacement", unit="m", symbol="s", of="body", vector=True)
def displacement(state: State, body: str) -> Array:
    """The displacement of the centre of mass from where it was at the start, (n, 3)."""
    return carried(slides_of(state.mechanism, body), state.q)


@quantity("velocity", unit="m/s", symbol="v", of="body", vector=True)
def velocity(state: State, body: str) -> Array:
    """The velocity of the centre of mass, (n, 3)."""
    return carried(slides_of(state.mechanism, body), state.v)


@quantity("acceleration", unit="m/s^2", symbol="a", of="body", vector=True)
def acceleration(state: State, body: str) -> Array:
    """The acceleration of the centre of mass, (n, 3)."""
    return carried(slides_of(state.mechanism, body), state.a)
