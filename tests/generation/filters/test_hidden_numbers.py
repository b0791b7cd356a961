"""Tests of the dependence on lengths that no text gives, in a scene that is integrated with small errors."""

import numpy as np
import pytest

from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.questions import KINDS, Query, Question, SimulatedScene, Target
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.files import load

BLOCK = "spring.block"
DRAWN = """
scene:
  name: drawn
  entities:
  - name: spring
    type: AnchoredSpring
    parameters: {spring: {stiffness: 184.0, length: 0.45}, block: {mass: 4.1}, support: wall, start: 0.71}
  - name: weight
    type: MassWithFixedPulley
    parameters:
      system: {kind: hanging, length: 3.9, blocks: [{mass: 4.2}]}
      pulley: {mass: 2.0}
  connections:
  - tendon: [{entity: spring, direction: end}, {entity: weight, direction: tail}]
    free: 3.9
"""


@pytest.mark.parametrize("time", [1.3, 0.9])
def test_an_answer_that_small_errors_grow_in_hangs_on_no_length(time: float) -> None:
    """Near the turning point of the block the speed, 0.08 m/s after 1.3 s, has a far larger relative error."""
    scene = load(DRAWN)
    study = SimulatedScene.of(scene, np.linspace(0.0, scene.horizon, 41))
    query = Query("state", Target("velocity", BLOCK), AtTime(time))
    answer = KINDS["state"].answer(query, study)
    assert answer is not None
    question = Question("numeric", query, "?", answer, "m/s")
    assert FILTERS["hidden numbers"].reason(Candidate(study, question, "a b c")) == ""
