"""Strings and what they carry; a string that massive pulleys cut has these for each part."""

import numpy as np

from sim2reason.dsl.state import Array, State
from sim2reason.quantities import quantity


@quantity("length", unit="m", symbol="l", of="string")
def length(state: State, string: str) -> Array:
    """The change since the start of the length of the free part, site to site, (n,).

    What a massive pulley winds on or off changes it. A slack string counts as the shortest line.
    """
    now, _ = state.length(state.mechanism.line[string])
    rest = np.zeros_like(state.q[:1])
    began = State(state.mechanism, state.times[:1], rest, rest, rest, {}, {}, {})
    return now - began.length(state.mechanism.line[string])[0]


@quantity("rate of change of length", unit="m/s", symbol="u", of="string")
def rate(state: State, string: str) -> Array:
    """The rate at which the free part grows, (n,)."""
    return state.length(state.mechanism.line[string])[1]


@quantity("tension", unit="N", symbol="T", of="string")
def tension(state: State, string: str) -> Array:
    """The tension, (n,): 0 where the string is slack, NaN where the mechanism does not determine it."""
    return state.tension[string]
