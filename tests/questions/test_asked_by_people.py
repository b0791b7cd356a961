"""Tests of questions that only people ask: power, relative velocity, curvature, returns, later events."""

from collections.abc import Callable
from math import cos, exp, log, pi, radians, sin, sqrt

import numpy as np
import pytest

from plain_scenes import G, atwood, ramp
from sim2reason.questions import KINDS, MOMENTS
from sim2reason.questions.choices import draw_target
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import targets
from sim2reason.questions.sentences import parse_question
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import loads
from sim2reason.simulation.certify import certify_trace
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose.description import describe

ROCKET = """
scene:
  entities:
  - {name: pad, type: RocketEntity, parameters: {rocket: {mass: 1000.0, dry: 200.0}, place: {kind: deep_space},
      exhaust: 3.0, rate: 5.0}}
"""
CIRCLE = """
scene:
  entities:
  - {name: s, type: EmEntity, parameters: {magnetic: {kind: uniform_magnetic, strength: 0.5, way: positive z},
      particle: {mass: 100.0, charge: 400.0, sign: positive}, start: {kind: launched, speed: 2.0, angle: 0.0}}}
"""
BALL = """
scene:
  entities:
  - {name: s, type: Projectile, parameters: {ball: {mass: 0.5}, height: 2.0, speed: 3.0, angle: 0.0, restitution: 0.5}}
"""
CHARGED = """
scene:
  entities:
  - {name: s, type: EmEntity, parameters: {magnetic: {kind: uniform_magnetic, strength: 0.5, way: positive z},
      electric: {kind: uniform_electric, strength: 3.0, way: positive x},
      particle: {mass: 100.0, charge: 400.0, sign: positive}, start: {kind: launched, speed: 2.0, angle: 0.0}}}
"""
DRAGGED = """
scene:
  entities:
  - {name: s, type: EmEntity, parameters: {medium: {kind: linear_drag, coefficient: 0.75},
      magnetic: {kind: uniform_magnetic, strength: 1.2, way: positive z},
      particle: {mass: 1.5, charge: 2.7, sign: negative}, start: {kind: launched, speed: 2.0, angle: 0.0}}}
"""
PRISM = """
scene:
  entities:
  - name: roller
    type: TumblingPrism
    parameters: {prism: {mass: 1.0, shape: hexagonal, radius: 0.1}, plane: {angle: 12.0}, rate: 4.0}
"""
LANDS = sqrt(4.0 * G)  # the speed at which the ball meets the ground, m/s
TAKES = LANDS / G
CENTRAL = 0.1**2 * (2.0 + cos(pi / 3.0)) / 6.0
"""The moment of inertia of the prism about its axis, per mass, m²."""
TUMBLED = sqrt(4.0**2 + 2.0 * G * 0.1 * sin(radians(12.0)) / (CENTRAL + 0.1**2))
STRUCK = TUMBLED * (CENTRAL + 0.5 * 0.1**2) / (CENTRAL + 0.1**2)
"""The angular velocities of the prism just before and just after its next edge lands, rad/s."""


def pulled() -> Scene:
    """Return a block of 3 kg on a smooth floor, pulled by a hand with 12 N."""
    return parse_scene(
        "A block of mass 3.0 kg lies on a smooth, fixed horizontal plane. A light string tied to the block runs to the"
        " right along the plane and is pulled at its far end by a hand with a constant force of 12 N. The motion starts"
        " from rest. Take g = 9.8 m/s²."
    ).scene


def scene(text: str) -> Callable[[], Scene]:
    """Return a function that parses a scene."""
    return lambda: loads(text.strip())


@pytest.mark.parametrize(
    ("made", "parts", "answer"),
    [
        (lambda: ramp(2.0, 30.0), {"find": "power of gravity", "when": "2 s"}, 2.0 * (G / 2.0) ** 2 * 2.0),
        (lambda: ramp(2.0, 30.0), {"find": "power of the net force", "when": "2 s"}, 2.0 * (G / 2.0) ** 2 * 2.0),
        (atwood, {"find": "relative velocity", "when": "0.5 s"}, 2.0 * (G / 5.0) * 0.5),
        (scene(ROCKET), {"find": "power of the thrust", "when": "60 s"}, 15_000.0 * 3000.0 * log(1000.0 / 700.0)),
        (pulled, {"find": "power of a hand", "when": "2 s"}, 12.0 * 12.0 / 3.0 * 2.0),
        (scene(CIRCLE), {"find": "radius of curvature", "when": "0.3 s"}, 1e-4 * 2.0 / (4e-4 * 0.5)),
        (scene(CIRCLE), {"find": "time", "when": "returned"}, 2.0 * pi * 1e-4 / (4e-4 * 0.5)),
        (scene(BALL), {"find": "radius of curvature", "when": "at start"}, 9.0 / G),
        (scene(BALL), {"find": "time", "when": "top after bounce"}, TAKES + 0.5 * LANDS / G),
        (scene(BALL), {"find": "height above the ground", "when": "second top after bounce"}, 2.0 * 0.5**4),
        (scene(BALL), {"find": "number of bounces", "when": "stayed below 0.2 m"}, 2.0),
        (scene(BALL), {"find": "time", "when": "stayed below 0.2 m"}, TAKES * 2.0),
        (scene(PRISM), {"find": "angular velocity", "when": "edge landed before"}, TUMBLED),
        (scene(PRISM), {"find": "angular velocity", "when": "edge landed"}, STRUCK),
        (scene(CHARGED), {"find": "electric force", "when": "at start"}, 1200.0),
        (scene(CHARGED), {"find": "magnetic force", "when": "at start"}, 400.0),
        (scene(DRAGGED), {"find": "resisting force", "when": "at 3 s"}, 1.5 * exp(-1.5 * 3.0 / 3.0)),
        (lambda: ramp(angle=20.0, speed=3.0), {"find": "time", "when": "returned"}, 6.0 / (G * sin(radians(20.0)))),
    ],
)
def test_the_answer_is_that_of_the_closed_form(made: Callable[[], Scene], parts: dict[str, str], answer: float) -> None:
    """The answer follows from one structured question; both engines agree, and the sentence is read back."""
    found = made()
    motion, words = simulate_scene(found), words_of(describe(found))
    if parts["find"] == "relative velocity":
        parts = {**parts, "of": QUANTITIES["relative velocity"].of.names(words.mechanism)[0]}
    question = pose_question(StructuredQuestion.read(parts), motion, words)
    followed = question.simulate_answer(motion)
    assert followed.answer == pytest.approx(answer, rel=1e-6)
    certificate = certify_trace(followed.study.trace)[1]
    query = question.query
    assert KINDS[query.kind].doubt(query, followed.study, certificate) == ""
    sentence = question.sentence(words)
    assert not sentence or parse_question(sentence, followed.study, words) == query


COORDINATES = "x coordinate", "y coordinate", "distance from the origin"


def test_recipes_ask_none_of_it() -> None:
    """Recipes never draw quantities marked as not drawn; this lists the moments and functionals so marked."""
    words = words_of(describe(ramp(2.0, 30.0)))
    spared = [target for target in targets(words) if not QUANTITIES[target.quantity].drawn_by_recipes]
    assert {target.quantity for target in spared} == {"power of gravity", "power of the net force"}
    assert draw_target(spared, np.random.default_rng(0)) is None
    people = {"fastest", "lifted_off", "returned", "top_after_bounce", "edge_landed", "stayed_below"}
    assert {name for name, cls in MOMENTS.items() if not cls.drawn_by_recipes} == people
    undrawn = {name for name, held in FUNCTIONALS.items() if not held.drawn_by_recipes}
    least = {"least deflection", "greatest rod pull", "greatest angular acceleration"}
    places = {f"{size} {name}" for size in ("greatest", "least") for name in COORDINATES}
    assert undrawn == {"amplitude", "greatest spring force", *least, *places}
