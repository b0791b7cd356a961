"""Tests that motions are followed until the event in question, or that a reason says why it never happens."""

from math import pi, sqrt

import pytest

from plain_scenes import G, atwood, ramp, swing
from sim2reason.questions.following import SimulatedAnswer, simulate_scene, simulate_until_answer, simulate_until_event
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import parse_prompt, words_of
from sim2reason.questions.sentences import parse_question
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.scenes.dsl.scene import Scene, World
from sim2reason.scenes.files import load, loads
from sim2reason.text.prose.description import describe

MOON = 1.62
FORM = r" Give your answer in {}, to three significant figures, inside \boxed{{}}."


def asked(scene: Scene, question: str) -> SimulatedAnswer:
    """Return the answer to a question about a scene."""
    motion, words = simulate_scene(scene), words_of(describe(scene))
    query = parse_question(question, motion.study, words)
    assert query is not None, question
    return simulate_until_answer(query, motion)


def alone(entity: str, **world: float) -> Scene:
    """Build the scene of one entity, given in YAML."""
    return load(f"scene: {{name: own, entities: [{entity}], world: {{gravity: {world.get('gravity', G)}}}}}")


def planet(speed: float) -> Scene:
    """Build a planet at 1 au from its star, moving at right angles to the line between them."""
    one = f"{{kind: planet, x: 1.0, y: 0.0, vx: 0.0, vy: {speed}}}"
    return alone(f"{{name: sun, type: SolarSystem, parameters: {{star: {{mass: 1.0}}, planets: [{one}]}}}}")


SLIDING = ramp(angle=0.0, friction=0.05, speed=5.0)


def test_a_block_that_slides_for_ten_seconds_comes_to_rest() -> None:
    """The block stops after v/μg, at v²/2μg, beyond the horizon of 2 s."""
    assert asked(SLIDING, "How long after t = 0 does the block first come to rest?").answer == pytest.approx(
        5.0 / (0.05 * G), rel=1e-9
    )
    far = asked(SLIDING, "What is the distance between the block and its starting point when it first comes to rest?")
    assert far.answer == pytest.approx(25.0 / (0.1 * G), rel=1e-9)


def test_a_stated_time_beyond_the_horizon_is_reached() -> None:
    """The horizon of 2 s does not limit a question."""
    assert asked(SLIDING, "What is the speed of the block at t = 9.0 s?").answer == pytest.approx(5.0 - 0.05 * G * 9.0)
    assert asked(SLIDING, "What is the speed of the block at t = 90 s?").answer == 0.0


def test_nearly_equal_masses_move_slowly() -> None:
    """The acceleration is (m − m′)g/(m + m′)."""
    found = asked(atwood(5.1, 5.0), "Find the time from release until block A has moved 1.0 m.")
    assert found.answer == pytest.approx(sqrt(2.0 / (0.1 * G / 10.1)), rel=1e-9)


DAMPED = """scene:
  entities:
  - name: rail
    type: SpringMassChain
    parameters:
      track: {angle: 0.0}
      carts: [{mass: 1.0}]
      ends: left
      springs: [{stiffness: 20.0}]
      damping: 0.5
      strain: {spring: 0, way: stretched, by: 0.2}
"""


@pytest.mark.parametrize("when", ["moved 0.5 m", "extension = 0.3 m"])
def test_too_little_energy_to_reach_a_place_is_a_reason(when: str) -> None:
    """A damped motion is neither periodic nor finite, but has turned back on both sides."""
    scene = loads(DAMPED)
    motion, words = simulate_scene(scene), words_of(describe(scene))
    found = pose_question(StructuredQuestion("time", when=when), motion, words).simulate_answer(motion)
    assert found.answer is None
    assert "has no energy to come any farther" in found.reason


def test_a_place_within_its_turning_points_is_reached() -> None:
    """The block reaches 0.3 m before it has turned back on both sides."""
    scene = loads(DAMPED)
    motion, words = simulate_scene(scene), words_of(describe(scene))
    asked = StructuredQuestion("time", when="moved 0.3 m")
    assert pose_question(asked, motion, words).simulate_answer(motion).answer == pytest.approx(0.4989, rel=1e-3)


def test_there_is_as_much_room_as_it_takes() -> None:
    """Lengths that the text does not give do not end a motion: 90 m are more than any string's default."""
    found = asked(atwood(), "Find the time from release until block A has moved 90 m.")
    assert found.answer == pytest.approx(sqrt(180.0 / (0.2 * G)), rel=1e-9)


@pytest.mark.parametrize(
    ("scene", "question", "reason"),
    [
        (
            SLIDING,
            "Find the time from t = 0 until the block has moved 26 m.",
            "everything is at rest for good from 10.2",
        ),
        (
            ramp(angle=0.0, friction=0.0, speed=5.0),
            "How long after t = 0 does the block first come to rest?",
            "no acceleration changes any more",
        ),
        (
            planet(20.0),
            "How long does the planet take to complete one orbit, counted from t = 0?",
            "flies off for ever",
        ),
        (
            ramp(angle=30.0, friction=0.1, speed=6.0),
            "Find the time from t = 0 until the block has moved 30 m.",
            "turns back before it has moved so far",
        ),
        (atwood(), "Find the time from release until block A has moved 900 m.", "the description of the motion ends"),
        (planet(5.0), "How long after t = 0 is the planet first 9.0 au from its starting point?", "repeats itself"),
    ],
)
def test_what_never_happens_has_a_reason(scene: Scene, question: str, reason: str) -> None:
    found = asked(scene, question)
    assert found.answer is None
    assert reason in found.reason


def test_events_before_a_singularity_can_be_asked_about() -> None:
    """A planet released at 1 au falls with v² = 2GM(1/r − 1), and reaches the star after 1/(4√2) yr."""
    falling, question = planet(0.0), "What is the speed of the planet when it is first {} au from its starting point?"
    found = asked(falling, question.format("0.50"))
    assert found.answer == pytest.approx(2.0 * pi * sqrt(2.0), rel=1e-6)
    never = asked(falling, question.format("1.5"))
    assert never.answer is None
    assert "singular at 0.176777 yr" in never.reason


@pytest.mark.parametrize("gravity", [MOON, G, 24.8])
def test_horizons_follow_the_gravity_of_the_scene(gravity: float) -> None:
    """All times of falling or swinging motions are proportional to 1/√g."""
    for scene in (ramp(), swing()):
        there = scene.model_copy(update={"world": World(gravity=gravity)})
        assert there.horizon == pytest.approx(scene.horizon * sqrt(G / gravity))


def test_a_horizon_without_gravity_is_finite() -> None:
    """Nothing swings or falls without gravity, so the horizon needs another bound."""
    for scene in (ramp(), swing()):
        assert 0.0 < scene.model_copy(update={"world": World(gravity=0.0)}).horizon < 100.0


def test_a_ball_lands_on_the_moon() -> None:
    """The time of flight follows from the Moon's gravity."""
    ball = "{name: ball, type: Projectile, parameters: {ball: {mass: 0.5}, height: 10.0, speed: 15.0, angle: 45.0}}"
    found = asked(alone(ball, gravity=MOON), "How long after t = 0 does the ball reach the ground?")
    rise = 15.0 / sqrt(2.0)
    assert found.answer == pytest.approx((rise + sqrt(rise**2 + 20.0 * MOON)) / MOON, rel=1e-9)


def test_a_slow_motion_is_followed_until_something_happens() -> None:
    """A motion without events is left as it is."""
    assert simulate_until_event(simulate_scene(SLIDING)).study.trace.events[0].kind == "stick"
    steady = simulate_scene(ramp(angle=0.0, speed=5.0))
    assert simulate_until_event(steady) == steady


def test_a_prompt_is_followed_as_far() -> None:
    """A prompt has the answer, or the reason why there is none."""
    text = describe(SLIDING).text
    rests = parse_prompt(f"{text} How long after t = 0 does the block first come to rest?{FORM.format('s')}")
    assert rests.answer == pytest.approx(5.0 / (0.05 * G))
    assert not rests.reason
    never = parse_prompt(f"{text} Find the time from t = 0 until the block has moved 26 m.{FORM.format('s')}")
    assert never.answer is None
    assert "at rest for good" in never.reason


def test_queries_share_the_longer_motions_that_they_follow() -> None:
    """A second query about the same motion reuses the longer motion."""
    begun = simulate_scene(ramp())
    words = words_of(describe(ramp()))
    late = StructuredQuestion("time", when="speed of block = 60 m/s")
    one = pose_question(late, begun, words).simulate_answer(begun)
    other = pose_question(late, begun, words).simulate_answer(begun)
    assert one.study is not begun.study
    assert one.study is other.study
