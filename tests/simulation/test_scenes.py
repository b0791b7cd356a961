"""Tests of the traces of simulated scenes and of their end."""

import warnings

import numpy as np
import pytest

import sim2reason
from plain_scenes import atwood, ramp
from sim2reason.errors import MotionEndsWarning


def test_no_state_lies_beyond_the_end_of_the_description() -> None:
    """A block reaches its pulley: the trace ends there, with a warning that states the reason."""
    with pytest.warns(MotionEndsWarning, match="two points of a string meet"):
        trace = sim2reason.simulate(atwood(), duration=10.0)
    assert trace.cut == "reach"
    assert trace.state.times[-1] == trace.stable_until < 10.0
    assert np.all(np.diff(trace.state.times) > 0.0)


def test_the_same_by_both_engines_and_without_a_duration() -> None:
    """Without a requested duration there is no warning."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        trace = sim2reason.simulate(atwood(2.0, 20.0))
    assert trace.state.times[-1] == trace.stable_until
    with pytest.warns(MotionEndsWarning):
        both = sim2reason.simulate(atwood(), 10.0, "both")
    assert both.state.times[-1] == both.stable_until


def test_a_whole_motion_is_recorded_as_before() -> None:
    """The trace has all samples."""
    assert len(sim2reason.simulate(ramp(), duration=1.0, samples=11).state.times) == 11
