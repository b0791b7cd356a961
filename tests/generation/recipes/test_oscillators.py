"""Tests that hard pendulums on strings leave their circles, and that problems are about the later motion."""

import numpy as np
import pytest

from sim2reason.generation.recipes.oscillators import PENDULUM_IDEAS
from sim2reason.generation.recipes.ranges import draw_idea
from sim2reason.questions import SimulatedScene
from sim2reason.questions.choices import data_relevant_from

SAMPLES = 41


@pytest.mark.parametrize("seed", range(8))
def test_every_hard_string_goes_slack_and_what_comes_before_is_no_problem(seed: int) -> None:
    scene = draw_idea(PENDULUM_IDEAS["hard"], np.random.default_rng(seed), "pendulum")
    trace = SimulatedScene.of(scene, np.linspace(0.0, scene.horizon, SAMPLES)).trace
    slack = [event.time for event in trace.events if event.kind == "slack"]
    assert slack
    assert data_relevant_from(trace) == slack[0]
