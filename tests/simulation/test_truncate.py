"""Tests of the statistical truncation rule, and of alarms for transitions without an event."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

import machines
import motions
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Z
from sim2reason.scenes.dsl.state import State
from sim2reason.simulation.scenes import alarms, truncate_trace
from sim2reason.simulation.trace import ENGINES, Event, Trace
from states import altered

TIMES = np.linspace(0.0, 2.0, 201)
Column = Callable[[np.ndarray], np.ndarray]


def falling(a: Column, times: np.ndarray = TIMES, events: tuple[Event, ...] = ()) -> Trace:
    """Return the trace of a falling body whose recorded acceleration is replaced by the function `a` of time."""
    builder = Builder()
    builder.room().body("stone", 1.0).slide(Z)
    trace = ENGINES["exact"](builder.finish(), times)
    return changed(trace, lambda state: altered(state, a=a(state.times)[:, None]), events)


def changed(trace: Trace, change: Callable[[State], State], events: tuple[Event, ...] = ()) -> Trace:
    """Return a trace with falsified states, at its samples and between them."""
    return replace(trace, state=change(trace.state), events=events, sample=lambda times: change(trace.sample(times)))


def jump(times: np.ndarray) -> np.ndarray:
    return np.where(times < 1.2, -9.8, -9.7)


def test_a_jump_cuts_just_before() -> None:
    cut = truncate_trace(falling(jump))
    assert cut.stable_until == pytest.approx(1.19)
    assert cut.cut == "statistics"


@pytest.mark.parametrize(
    "column",
    [
        lambda t: np.full_like(t, -9.8),
        np.zeros_like,
        lambda t: -9.8 + 1e-9 * np.random.default_rng(0).standard_normal(len(t)),
        lambda t: -9.8 + 3.0 * t,
        lambda t: 5.0 * np.sin(6.0 * t),
        lambda t: np.exp(-t),
    ],
    ids=["constant", "zero", "rounding", "ramp", "wave", "decay"],
)
def test_smooth_columns_are_left_alone(column: Column) -> None:
    trace = falling(column)
    assert truncate_trace(trace) is trace
    assert alarms(trace) == ()


@pytest.mark.parametrize("samples", [2, 25, 49])
def test_a_short_trace_is_not_judged(samples: int) -> None:
    trace = falling(lambda t: np.where(t < 0.1, 0.0, 1.0), np.linspace(0.0, 0.2, samples))
    assert truncate_trace(trace) is trace


@pytest.mark.parametrize("window", [0, 25, 49])
def test_a_window_that_can_not_fire_is_refused(window: int) -> None:
    with pytest.raises(ValueError, match="too short"):
        truncate_trace(falling(jump), window)


def test_what_lies_after_the_end_is_not_looked_at() -> None:
    trace = replace(falling(jump), stable_until=1.0, cut="limit")
    assert truncate_trace(trace) is trace


def test_on_a_whole_trace_the_rule_cuts_at_a_collision() -> None:
    trace = ENGINES["exact"](machines.discs(), TIMES)
    hit = next(event.time for event in trace.events if event.kind == "collision")
    assert truncate_trace(trace).stable_until == pytest.approx(hit, abs=0.01)


def test_a_transition_without_an_event_is_an_alarm() -> None:
    (first, *others) = alarms(falling(jump))
    assert first.column == "acceleration of stone.slide"
    assert first.time == pytest.approx(1.2)
    assert {alarm.rule for alarm in (first, *others)} == {"deviation", "third difference"}


def test_a_transition_with_its_event_is_none() -> None:
    assert alarms(falling(jump, events=(Event(1.195, "slip", ("stone",)),))) == ()


def test_a_hidden_impulse_is_an_alarm() -> None:
    trace = falling(lambda t: np.full_like(t, -9.8))
    kicked = changed(trace, lambda state: altered(state, v=state.v + (state.times > 0.505)[:, None] * 0.01))
    assert {alarm.column for alarm in alarms(kicked)} == {"change of velocity of stone.slide"}
    assert {round(alarm.time, 6) for alarm in alarms(kicked)} == {0.51}


def test_the_third_difference_catches_what_is_too_near_a_border_for_the_rule() -> None:
    early = falling(lambda t: np.where(t < 0.05, -9.8, -9.7), np.linspace(0.0, 0.3, 31))
    assert {alarm.rule for alarm in alarms(early)} == {"third difference"}


@pytest.mark.parametrize("engine", ["exact", "mujoco"])
@pytest.mark.parametrize("name", machines.SAMPLES)
def test_the_engines_explain_all_that_they_do(name: str, engine: str) -> None:
    assert alarms(ENGINES[engine](machines.SAMPLES[name](), TIMES)) == ()


def test_random_trains_have_no_unmodelled_transition() -> None:
    for seed in range(40):
        trace = ENGINES["mujoco"](machines.train(np.random.default_rng(seed)), TIMES)
        assert alarms(trace) == (), seed


@pytest.mark.parametrize("samples", [41, 201, 1001])
@pytest.mark.parametrize("eccentricity", [0.5, 0.9, 0.97, -0.9])
def test_a_smooth_orbit_is_left_alone_however_long_it_is(eccentricity: float, samples: int) -> None:
    """At e = 0.9 the acceleration at perihelion is 361 times that at aphelion, where samples deviate by 5σ."""
    motion = motions.orbit(eccentricity)
    trace = ENGINES["exact"](motion.mechanism, np.linspace(0.0, motion.duration, samples))
    assert truncate_trace(trace) is trace
    assert alarms(trace) == ()


@pytest.mark.parametrize("engine", ["exact", "mujoco"])
@pytest.mark.parametrize("name", motions.MOTIONS)
def test_motions_of_every_kind_have_no_unmodelled_transition(name: str, engine: str) -> None:
    motion = motions.MOTIONS[name]()
    assert alarms(ENGINES[engine](motion.mechanism, np.linspace(0.0, motion.duration, 201))) == ()


def hidden() -> list[tuple[Trace, Event]]:
    """Return traces with one event removed each, and the removed event: a slip, impact, burn-out or border."""
    made = [(found().mechanism, found().duration) for found in motions.MOTIONS.values()]
    found: list[tuple[Trace, Event]] = []
    for mechanism, duration in [*made, *((machine(), 2.0) for machine in machines.SAMPLES.values())]:
        trace = ENGINES["exact"](mechanism, np.linspace(0.0, duration, 201))
        near = 0.02 * duration
        real = [e for e in trace.events if e.kind != "turn" and near < e.time < trace.stable_until - near]
        lone = [e for e in real if all(other is e or abs(other.time - e.time) > near for other in real)]
        found += [(replace(trace, events=tuple(e for e in trace.events if e is not event)), event) for event in lone]
    return found


def test_hidden_transitions_are_found() -> None:
    """The 5σ rule finds most (43 of 52 in a prototype), the third difference all."""
    caught = [
        {alarm.rule for alarm in alarms(trace) if abs(alarm.time - event.time) < 0.1} for trace, event in hidden()
    ]
    assert len(caught) >= 15
    assert all("third difference" in rules for rules in caught)
    assert sum("deviation" in rules for rules in caught) >= 0.8 * len(caught)


def test_a_trace_from_a_file_is_judged_by_its_samples_alone() -> None:
    motion = motions.orbit(0.9)
    trace = ENGINES["exact"](motion.mechanism, np.linspace(0.0, motion.duration, 201))

    def unknown(times: np.ndarray) -> State:
        raise ValueError(times)

    assert truncate_trace(replace(trace, sample=unknown)).stable_until == 0.0
