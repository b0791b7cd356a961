"""Tests of the search for zero crossings of event margins within a step."""

from collections.abc import Callable
from math import hypot, sin

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import ZERO, X
from sim2reason.simulation.engines.exact.crossings import ARMING_MARGIN, Crossing, MarginWatch
from sim2reason.simulation.engines.exact.engine import motion

Margin = Callable[[float], float]


def first(margin: Margin, start: float | None = None) -> Crossing | None:
    """Return the first crossing of a margin over the whole step; `start` is its value when the mode began."""
    watch = MarginWatch([margin(0.0) if start is None else start])
    found = watch.crossings([(margin(0.0),), (margin(0.5),), (margin(1.0),)], lambda x: (margin(x),))
    return found[0][1] if found else None


@given(root=st.floats(0.01, 0.99), speed=st.floats(0.1, 50.0))
def test_a_margin_that_is_used_up_has_an_interval_around_its_root(root: float, speed: float) -> None:
    found = first(lambda x: speed * (root - x))
    assert found is not None
    assert found.low <= root <= found.high


@settings(max_examples=500)
@given(place=st.floats(0.02, 0.98), radius=st.floats(0.004, 0.1), aside=st.floats(0.0, 0.6))
def test_a_straight_path_past_a_small_disc_is_not_stepped_over(place: float, radius: float, aside: float) -> None:
    """The margin is a hyperbola with a narrow dip, on a path 10 to 100 radii long."""

    def margin(x: float) -> float:
        return hypot(x - place, aside * radius) - radius

    found = first(margin, 1.0)
    if margin(0.0) > 0.0 and margin(1.0) > 0.0:
        assert found is not None
        assert margin(found.low) > 0.0 > margin(found.high)


@pytest.mark.parametrize("least", [1e-9, 1e-3])
def test_a_dip_that_does_not_reach_zero_is_none(least: float) -> None:
    assert first(lambda x: (x - 0.4) ** 2 + least) is None


def test_a_dip_far_above_zero_is_ruled_out_by_its_tangents() -> None:
    """The margin is taken at three samples and for two slopes on each side of the minimum, at no place more."""
    places = set[float]()

    def margin(x: float) -> float:
        places.add(x)
        return (x - 0.4) ** 2 + 0.1

    assert first(margin) is None
    assert len(places) <= 7


def test_what_rises_from_nothing_is_due_when_it_comes_back_in_the_same_step() -> None:
    found = first(lambda x: 1e-4 * x * (0.3 - x))
    assert found is not None
    assert found.low < 0.3 <= found.high
    assert found.room == 0.0


def test_what_falls_from_nothing_is_due_where_it_falls_short_by_more_than_rounding() -> None:
    found = first(lambda x: -2e-4 * x)
    assert found is not None
    assert (found.low, found.room) == (0.0, ARMING_MARGIN)


def test_rounding_below_zero_at_the_start_is_no_event_again_and_again() -> None:
    """A margin of −1e-9 from the rounding of the last crossing does not cause another event."""
    assert first(lambda x: -1e-9 + 0.05 * x) is None
    assert first(lambda x: -1e-9 - 5e-10 * sin(20.0 * x)) is None


def test_a_margin_that_is_far_below_zero_is_due_at_once() -> None:
    found = first(lambda x: -1.0 + 0.0 * x)
    assert found == Crossing(0.0, 0.0)


def test_a_ball_that_chases_a_block_on_a_spring_hits_it_at_the_right_times_until_hits_crowd() -> None:
    """Before the eighth collision, the gap opens and closes within one step."""
    builder = Builder(ZERO)
    room = builder.room()
    ball = room.body("ball", 2.0, at=(-0.6, 0.0, 0.0)).slide(X, 1.8)
    block = room.body("block", 0.7).slide(X).site("hook")
    room.site("wall", (1.0, 0.0, 0.0))
    room.spring("spring", "hook", "wall", stiffness=50.0)
    room.collide(ball, block, 0.1, 0.6)
    found = motion(builder.finish(), 2.0)
    assert found.cut == "crowd"
    hits = [event.time for event in found.events if event.kind == "collision"]
    gaps = [found.state(np.array([time - 1e-9])) for time in hits]
    assert len(hits) == 9
    assert all(abs(state.q[0, 1] - state.q[0, 0] + 0.5) < 1e-8 for state in gaps)
