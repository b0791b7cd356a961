"""Strings and what they carry; a string that massive pulleys cut has these for each part."""

import numpy as np

from sim2reason.dsl.kinematics import lengths, points_of
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import quantity


@quantity("length", unit="m", symbol="l", of="string")
def length(state: State, string: str) -> Array:
    """The change since the start of the length of the free part, site to site, (n,).

    What a massive pulley winds on or off changes it. A slack string counts as the shortest line.
    """
    points = points_of(state.mechanism, _through(state, string))
    now, _ = lengths(points, state.q, state.v)
    start, _ = lengths(points, np.zeros_like(state.q[:1]), np.zeros_like(state.v[:1]))
    return now - start


@quantity("rate of change of length", unit="m/s", symbol="u", of="string")
def rate(state: State, string: str) -> Array:
    """The rate at which the free part grows, (n,)."""
    _, found = lengths(points_of(state.mechanism, _through(state, string)), state.q, state.v)
    return found


@quantity("tension", unit="N", symbol="T", of="string")
def tension(state: State, string: str) -> Array:
    """The tension, (n,): 0 where the string is slack, NaN where the mechanism does not determine it."""
    return state.tension[string]


def _through(state: State, string: str) -> tuple[str, ...]:
    lines = (*state.mechanism.strings, *state.mechanism.pulls)
    return next(line.through for line in lines if line.name == string)
