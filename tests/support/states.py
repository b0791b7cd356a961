"""Copies of states with some of their arrays changed."""

from collections.abc import Mapping

from sim2reason.scenes.dsl.state import Array, Dynamics, State


def altered(state: State, **changes: Array | Mapping[str, Array]) -> State:
    """Return a copy with other positions, speeds, accelerations or forces, by their names."""
    names = ("q", "v", *Dynamics._fields)
    assert changes.keys() <= {*names}
    q, v, *forces = (changes.get(name, getattr(state, name)) for name in names)
    return State.of(state.mechanism, state.times, (q, v), Dynamics(*forces))  # type: ignore[arg-type]
