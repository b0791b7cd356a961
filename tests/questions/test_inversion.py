"""Tests of the number of a scene for which a query has a given answer, in any range."""

from math import sqrt

import numpy as np
import pytest

from plain_scenes import G, ramp
from sim2reason.questions import SimulatedScene
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.inversion import ThresholdSearch, values_giving, why_not_one
from sim2reason.questions.outcomes import OUTCOMES
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import parse_prompt, words_of
from sim2reason.questions.sentences import parse_question
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.unknown import range_of
from sim2reason.questions.words import Words
from sim2reason.scenes.bodies.oscillators import Ball, LightRod
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum
from sim2reason.scenes.files import loads
from sim2reason.text.prose.description import describe

SLIDING = ramp(angle=0.0, friction=0.05, speed=5.0)
SPEED, FRICTION = "ramp.speed", "ramp.plane.friction"
HAND = """
scene:
  entities:
  - name: well
    type: MassWithFixedPulley
    parameters: {system: {kind: hanging, blocks: [{mass: 9}]}, pulley: {mass: 0}}
  - {name: hand, type: ConstantForcePuller, parameters: {force: 110}}
  connections: [{tendon: [{entity: well, direction: tail}, {entity: hand, direction: end}]}]
"""


def found(question: str, given: float, path: str) -> tuple[list[float], str]:
    """Return the values of a number that give an answer, and the reason if there is not exactly one."""
    motion, words = simulate_scene(SLIDING), words_of(describe(SLIDING))
    query = parse_question(question, motion.study, words)
    assert query is not None
    hidden = Words.of(SLIDING, words.mentions, {path: "p"})
    (unknown,) = (held for held in hidden.unknowns if held.path == path)
    values = values_giving(query, given, unknown, motion.study)
    return values, why_not_one(unknown, values, SLIDING)


@pytest.mark.parametrize("speed", [3.0, 80.0, 900.0])
def test_a_number_is_found_within_its_range_and_beyond(speed: float) -> None:
    """v = √(2μgs), however late the block stops."""
    values, reason = found(
        "What is the distance between the block and its starting point when it first comes to rest?",
        speed**2 / (2.0 * 0.05 * G),
        SPEED,
    )
    assert values == [pytest.approx(speed, rel=1e-6)]
    assert not reason
    assert speed < 50.0 or speed > range_of(SLIDING, SPEED)[-1]


def test_a_time_is_waited_for() -> None:
    """Friction of 0.005 stops the block after 102 s."""
    values, _ = found("How long after t = 0 does the block first come to rest?", 5.0 / (0.005 * G), FRICTION)
    assert values == [pytest.approx(0.005, rel=1e-6)]


def test_what_no_number_gives_is_said() -> None:
    """A block that is slowed down is never faster than at first, at any mass."""
    values, reason = found("What is the speed of the block at t = 1.0 s?", 9.0, "ramp.blocks.0.mass")
    assert not values
    assert reason.startswith("no value of $p$ from ")


def test_a_prompt_says_why_it_has_no_answer() -> None:
    """The prompt leaves a number open."""
    text = describe(SLIDING).text.replace("2.0 kg", "mass $m$")
    asked = parse_prompt(
        f"{text} For which value of $m$ is the speed of the block at t = 1.0 s equal to 9.0 m/s?"
        r" Give your answer in kg, to three significant figures, inside \boxed{}."
    )
    assert asked.answer is None
    assert asked.reason.startswith("no value of $m$")


@pytest.mark.parametrize(
    ("given", "end", "force"),
    [
        ("acceleration = 0", "", 9.0 * G),
        ("net force = 0", "", 9.0 * G),
        ("acceleration = 0.001, least", "least", 9.0 * (G - 1e-3)),
        ("acceleration = 0.001, greatest", "greatest", 9.0 * (G + 1e-3)),
    ],
)
def test_a_magnitude_is_small_without_a_change_of_sign(given: str, end: str, force: float) -> None:
    """A hand that pulls with m g holds the block on the other end of the string."""
    scene = loads(HAND)
    motion, words = simulate_scene(scene), words_of(describe(scene))
    asked = pose_question(StructuredQuestion("hand.force", when="at start", given=given), motion, words)
    assert asked.end == end
    assert asked.simulate_answer(motion).answer == pytest.approx(force, rel=1e-6)


def test_no_number_gives_what_is_beyond_a_minimum() -> None:
    """A magnitude is never negative."""
    scene = loads(HAND)
    motion, words = simulate_scene(scene), words_of(describe(scene))
    asked = pose_question(StructuredQuestion("hand.force", when="at start", given="acceleration = -1"), motion, words)
    assert asked.simulate_answer(motion).reason.startswith("no value of ")


@pytest.mark.parametrize(("error", "within"), [(1e-8, 1e-8), (1e-6, 1e-5)])
def test_a_limit_is_as_accurate_as_the_motions_that_are_compared(error: float, within: float) -> None:
    """A bob on a light rod goes right round if v > 2√(gl) at its lowest point, and does not if it is slower."""
    swing = Pendulum(bob=Ball(mass=0.5), hanger=LightRod(length=1.2), angle=0.0, speed=3.0)
    study = SimulatedScene.of(Scene(entities=(Named(name="p", entity=swing),)), np.linspace(0.0, 1.0, 5))
    trial = ThresholdSearch(study, OUTCOMES["goes_round"]("p.hanger"), "p.speed")
    assert trial.rough_change(above=True, error=error) == pytest.approx(2.0 * sqrt(1.2 * G), rel=within)
    assert trial.rough_change(above=False, error=error) is None
