"""What a face does to the body that lies on it; the body does the opposite to the face."""

from sim2reason.dsl.state import Array, State
from sim2reason.quantities import quantity


@quantity("normal force", unit="N", symbol="N", of="contact")
def normal_force(state: State, body: str) -> Array:
    """The force along the contact's normal on the body that rests, (n,); never negative."""
    return state.normal[body]


@quantity("friction force", unit="N", symbol="f", of="contact")
def friction_force(state: State, body: str) -> Array:
    """The force on the body that rests along the direction of its sliding coordinate, with sign, (n,)."""
    return state.friction[body]
