"""Tests of traces cut off after a given time."""

import numpy as np
import pytest

from plain_scenes import atwood, table
from sim2reason.questions import SimulatedScene
from sim2reason.simulation.certify import certify_trace

TIMES = np.linspace(0.0, 2.0, 41)


def test_it_ends_at_the_second_sample_after_the_time() -> None:
    whole = SimulatedScene.of(atwood(), TIMES).trace
    part = whole.through(0.52)
    assert part.state.times == pytest.approx(TIMES[:13])  # 0.55 s and 0.60 s come after it
    assert part.stable_until == part.state.times[-1]
    assert np.array_equal(part.state.q, whole.state.q[:13])
    assert whole.through(1.96) is whole


def test_events_after_its_end_are_left_out_and_those_before_it_kept() -> None:
    whole = SimulatedScene.of(table(), TIMES).trace
    hit = next(event for event in whole.events if event.kind == "collision")
    assert hit not in whole.through(0.5 * hit.time).events
    assert hit in whole.through(hit.time).events


def test_both_engines_vouch_for_it_by_itself() -> None:
    certificate = certify_trace(SimulatedScene.of(table(), TIMES).trace.through(0.3))[1]
    assert not certificate.reason
    assert certificate.stable_until < 0.5
