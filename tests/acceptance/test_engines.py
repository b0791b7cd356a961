"""Tests that both engines agree on the motion of random scenes."""

import pytest

from cells import CELLS, drawn
from sim2reason.questions.difficulty import Difficulty
from sim2reason.simulation.certify import CHANGES, EVENTFUL_RTOL, SMOOTH_RTOL, certify_trace
from sim2reason.simulation.scenes import simulate

SCENES = [3, pytest.param(20, marks=pytest.mark.slow)]  # of each cell; benchmarks/certified.py takes 100
SHARE = 0.9


@pytest.mark.parametrize("scenes", SCENES)
@pytest.mark.parametrize(("recipe", "difficulty"), CELLS)
def test_most_scenes_are_certified_as_long_as_their_motion_is_described(
    recipe: str, difficulty: Difficulty, scenes: int
) -> None:
    certified = 0
    for scene in drawn(recipe, difficulty, scenes):
        described = simulate(scene)
        trace, certificate = certify_trace(described)
        changes = any(match.event.kind in CHANGES for match in certificate.matched)
        assert certificate.tolerance == (EVENTFUL_RTOL if changes else SMOOTH_RTOL)
        if 0.0 < described.stable_until <= certificate.stable_until * (1.0 + 1e-6):
            certified += 1
            assert max(certificate.agreement.values()) <= certificate.tolerance
            assert trace.stable_until == described.stable_until
    assert certified >= SHARE * scenes


def test_the_tolerances_are_those_promised() -> None:
    assert (SMOOTH_RTOL, EVENTFUL_RTOL) == (1e-4, 1e-3)
