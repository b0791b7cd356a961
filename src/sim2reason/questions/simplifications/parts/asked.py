"""The part of a motion that a query is about, and motion with constant accelerations."""

from collections.abc import Callable

import numpy as np

from sim2reason.questions.kinds import KINDS
from sim2reason.questions.query import Query
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.constancy import changing
from sim2reason.scenes.dsl.state import Array, Dynamics, State
from sim2reason.simulation.trace import Trace, events_before


def query_time(query: Query, study: SimulatedScene) -> float:
    """Return the time, s, of the query's moment; the end of the motion if it has none."""
    time = study.time(query.moment) if query.moment is not None else None
    return float(study.trace.state.times[-1]) if time is None else time


def asked_name(query: Query) -> str:
    """Return the name of the quantity or functional asked for, as in an item's answer."""
    return KINDS[query.kind].measured(query).name


Formulas = Callable[[Array, Array, Array], tuple[Array, Array]]
"""Coordinates and their rates from times (n, 1), rates and accelerations of the start (1, n)."""


def is_steady(query: Query, study: SimulatedScene) -> bool:
    """Return whether bodies start from rest and move with constant accelerations up to the query's moment."""
    if any(coordinate.speed for coordinate in study.mechanism.coordinates):
        return False
    return not events_before(study.trace.events, query_time(query, study)) and not changing(study.mechanism)


def with_formulas(trace: Trace, formulas: Formulas) -> Trace:
    """Return a motion by formulas from the initial state and the initial accelerations, with constant forces."""
    first = trace.sample(np.zeros(1))

    def sample(times: Array) -> State:
        repeated = np.zeros(len(times), dtype=int)
        moved, rates = formulas(times[:, None], first.v, first.a)
        dynamics = Dynamics(
            first.a[repeated],
            {name: values[repeated] for name, values in first.constraint_tension.items()},
            {name: values[repeated] for name, values in first.normal.items()},
            {name: values[repeated] for name, values in first.friction.items()},
        )
        return State.of(first.mechanism, times, (first.q + moved, rates), dynamics)

    times = trace.state.times
    end = float(times[-1])
    return Trace(trace.engine, sample(times), (), end, "", sample, lambda: np.array([0.0, end]))
