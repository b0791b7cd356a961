"""Tests of structured questions for optima, limits and equilibria."""

from math import atan, degrees, sqrt

import pytest

from plain_scenes import G, atwood, ramp, row
from sim2reason.errors import TextError
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import words_of
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.text.prose.description import describe

FLIGHT = Scene(
    entities=(Named(name="throw", entity=Projectile(ball=Ball(mass=0.5), height=20.0, speed=15.0, angle=40.0)),)
)
BEST = 15.0 / sqrt(15.0**2 + 2.0 * G * 20.0)


def answer(scene: Scene, **parts: str) -> float | None:
    """Return the answer to a structured question."""
    motion, words = simulate_scene(scene), words_of(describe(scene))
    return pose_question(StructuredQuestion.read(parts), motion, words).simulate_answer(motion).answer


@pytest.mark.parametrize(
    ("scene", "parts", "value"),
    [
        (
            FLIGHT,
            {"find": "throw.angle", "given": "displacement = greatest", "along": "x", "when": "landed"},
            degrees(atan(BEST)),
        ),
        (
            FLIGHT,
            {"find": "displacement", "change": "throw.angle = greatest", "along": "x", "when": "landed"},
            15.0**2 / G / BEST,
        ),
        (atwood(), {"find": "acceleration", "of": "block A", "change": "one.system.blocks.0.mass = infinity"}, G),
        (atwood(), {"find": "tension", "change": "other.system.blocks.0.mass = infinity"}, 6.0 * G),
    ],
)
def test_optima_and_limits_have_a_structured_form(scene: Scene, parts: dict[str, str], value: float) -> None:
    """The questions ask for the best angle of a throw from a height, and for the limit of a heavy block."""
    assert answer(scene, **parts) == pytest.approx(value, rel=1e-6)


@pytest.mark.parametrize(
    ("scene", "find", "told"),
    [
        (ramp(angle=0.0, friction=0.2, speed=3.0), "displacement", "no place at which all would stay at rest"),
        (row((2.0,), (50.0,), "left", speed=1.5), "velocity", "in equilibrium nothing moves"),
    ],
)
def test_what_is_not_found_in_equilibrium_says_why(scene: Scene, find: str, told: str) -> None:
    """The error suggests another question."""
    with pytest.raises(TextError, match=told):
        answer(scene, find=find, when="equilibrium")
