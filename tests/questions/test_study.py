"""Tests of variants of a motion, which all questions about a scene share."""

import weakref

import numpy as np
import pytest

from plain_scenes import swing
from sim2reason.questions import SimulatedScene

SHORT, LONG = 0.4, 2.5  # s
CHANGE = {"swing.angle": 50.0}


@pytest.mark.parametrize("before", [(), (LONG,), (0.3, LONG), (0.3, 0.4, 1.2)])
def test_how_far_a_variant_is_followed_hangs_on_no_question_before(before: tuple[float, ...]) -> None:
    """The bob passes its lowest point after 0.47 s, which a question about 0.4 s does not simulate."""
    study = SimulatedScene.of(swing(), np.linspace(0.0, 3.0, 41))
    for until in before:
        other = study.with_values(CHANGE, until)
        assert other is not None
        assert other.trace.stable_until == pytest.approx(until)
        assert bool(other.trace.events) == (until > 1.0)
    found = study.with_values(CHANGE, SHORT)
    assert found is not None
    assert found.trace.stable_until == pytest.approx(SHORT)
    assert not found.trace.events
    assert found is study.with_values(CHANGE, SHORT)
    alone = SimulatedScene.of(swing(), np.linspace(0.0, 3.0, 41)).with_values(CHANGE, SHORT)
    assert alone is not None
    assert found.trace.at(SHORT).q == pytest.approx(alone.trace.at(SHORT).q, rel=1e-4)


def test_a_released_study_leaves_nothing_to_the_garbage_collector() -> None:
    """A result cached in a study often refers back to it."""
    study = SimulatedScene.of(swing(), np.linspace(0.0, 3.0, 41))
    varied = study.with_values(CHANGE, SHORT)
    assert varied is not None
    for each in (study, varied):
        each.memoize("itself", lambda it=each: it)
    alive = [weakref.ref(study), weakref.ref(varied)]
    study.release()
    del study, varied, each
    assert [reference() for reference in alive] == [None, None]
