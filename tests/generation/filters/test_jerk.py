"""Tests of strings that become taut again, with and without a text that states the effect."""

import pytest

from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.questions import Query, Question, SimulatedScene, Target
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.bodies.oscillators import Ball, Cord
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum
from sim2reason.scenes.files import loads
from sim2reason.simulation.scenes import simulate

OVER_A_PULLEY = """
scene:
  entities:
  - name: held
    type: AnchoredSpring
    parameters:
      spring: {stiffness: 71.0, length: 0.42}
      block: {mass: 1.1}
      start: 0.86
  - name: load
    type: MassWithFixedPulley
    parameters:
      system: {kind: hanging, length: 3.1, blocks: [{mass: 1.0}]}
      pulley: {mass: 0.39}
  connections:
  - tendon:
    - {entity: held, direction: end}
    - {entity: load, direction: tail}
"""
"""The string goes slack at 0.475 s, beside the massive pulley, and is taut again at 0.819 s."""


def reason(scene: Scene, subject: str, time: float) -> str:
    study = SimulatedScene(scene, simulate(scene, duration=2.0))
    question = Question("numeric", Query("state", Target("velocity", subject), AtTime(time)), "?", 1.0, "m/s")
    return FILTERS["jerk"].reason(Candidate(study, question, "a b c"))


@pytest.mark.parametrize(("time", "refused"), [(0.4, False), (0.7, False), (0.9, True)])
def test_what_hangs_on_a_jerk_is_refused(time: float, refused: bool) -> None:
    assert ("becomes taut again" in reason(loads(OVER_A_PULLEY), "held.block", time)) is refused


def test_a_text_that_says_what_a_jerk_takes_is_none_the_worse() -> None:
    """A bob with 2 g l < v² < 5 g l leaves its circle, and comes back to it within a second."""
    entity = Pendulum(bob=Ball(mass=0.5), hanger=Cord(length=1.0), angle=0.0, speed=(3.0 * 9.8) ** 0.5)
    scene = Scene(entities=(Named(name="swing", entity=entity),))
    assert any(event.kind == "taut" and event.time < 1.9 for event in simulate(scene, duration=2.0).events)
    assert reason(scene, "swing.bob", 1.9) == ""
