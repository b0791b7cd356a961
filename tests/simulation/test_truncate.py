"""The statistical rule, and the alarms for transitions that no event explains."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

import machines
from sim2reason.dsl.builder import Builder
from sim2reason.dsl.mechanism import Z
from sim2reason.simulation.trace import ENGINES, Event, Trace
from sim2reason.simulation.truncate import alarms, truncate

TIMES = np.linspace(0.0, 2.0, 201)
Column = Callable[[np.ndarray], np.ndarray]


def falling(a: Column, times: np.ndarray = TIMES, events: tuple[Event, ...] = ()) -> Trace:
    """A body that falls, whose recorded acceleration is `a` of time instead."""
    builder = Builder()
    builder.room().body("stone", 1.0).slide(Z)
    trace = ENGINES["exact"](builder.finish(), times)
    return replace(trace, state=replace(trace.state, a=a(times)[:, None]), events=events)


def jump(times: np.ndarray) -> np.ndarray:
    return np.where(times < 1.2, -9.8, -9.7)


def test_a_jump_cuts_just_before() -> None:
    cut = truncate(falling(jump))
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
    assert truncate(trace) is trace
    assert alarms(trace) == ()


@pytest.mark.parametrize("samples", [2, 25, 49])
def test_a_short_trace_is_not_judged(samples: int) -> None:
    trace = falling(lambda t: np.where(t < 0.1, 0.0, 1.0), np.linspace(0.0, 0.2, samples))
    assert truncate(trace) is trace


@pytest.mark.parametrize("window", [0, 25, 49])
def test_a_window_that_can_not_fire_is_refused(window: int) -> None:
    with pytest.raises(ValueError, match="too short"):
        truncate(falling(jump), window)


def test_what_lies_after_the_end_is_not_looked_at() -> None:
    trace = replace(falling(jump), stable_until=1.0, cut="limit")
    assert truncate(trace) is trace


def test_on_a_whole_trace_the_rule_cuts_at_a_collision() -> None:
    trace = ENGINES["exact"](machines.discs(), TIMES)
    hit = next(event.time for event in trace.events if event.kind == "collision")
    assert truncate(trace).stable_until == pytest.approx(hit, abs=0.01)


def test_a_transition_without_an_event_is_an_alarm() -> None:
    (first, *others) = alarms(falling(jump))
    assert first.column == "acceleration of stone.slide"
    assert first.time == pytest.approx(1.2)
    assert {alarm.rule for alarm in (first, *others)} == {"deviation", "third difference"}


def test_a_transition_with_its_event_is_none() -> None:
    assert alarms(falling(jump, events=(Event(1.195, "slip", ("stone",)),))) == ()


def test_a_hidden_impulse_is_an_alarm() -> None:
    trace = falling(lambda t: np.full_like(t, -9.8))
    kicked = replace(trace, state=replace(trace.state, v=trace.state.v + (TIMES > 0.5)[:, None] * 0.01))
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
