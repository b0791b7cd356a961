"""Changes of a scene in structured questions, against closed forms."""

from dataclasses import replace
from functools import cache
from math import cos, pi, radians, sin, sqrt
from pathlib import Path

import pytest

from sim2reason.errors import TextError
from sim2reason.prose.description import describe
from sim2reason.questions.following import FollowedMotion, motion_of
from sim2reason.questions.posing import PosedQuestion, posed
from sim2reason.questions.prompt import words_of
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.variation import variation
from sim2reason.questions.words import Words
from sim2reason.scene_files import load

SCENES = Path(__file__).parents[1] / "data" / "ordinary_scenes"
G = 9.8
LOAD, BLOCK = "mass_with_fixed_pulley.system.blocks.0.mass", "two_side_mass_plane.blocks.0.mass"


@cache
def scene(name: str) -> tuple[FollowedMotion, Words]:
    """Return the motion of a scene, and its words."""
    held = load(SCENES / f"{name}.yaml")
    return motion_of(held), words_of(describe(held))


def question(name: str, asked: StructuredQuestion) -> PosedQuestion:
    """Return a question in parts as it is posed about a scene."""
    return posed(asked, *scene(name))


def found(name: str, asked: StructuredQuestion) -> float:
    """Return the answer to a question in parts."""
    answer = question(name, asked).followed(scene(name)[0]).answer
    assert answer is not None
    return answer


def pulled(load: float, block: float, angle: float = 34.0, gravity: float = G) -> float:
    """Return the acceleration of a block on a smooth slope that a hanging load pulls up."""
    return gravity * (load - block * sin(radians(angle))) / (load + block)


@pytest.mark.parametrize(
    ("change", "value"),
    [
        (f"{LOAD} = 3.2 kg", pulled(3.2, 1.4)),
        (f"{LOAD} × 2", pulled(3.2, 1.4)),
        (f"{LOAD} × 2, {BLOCK} = 2.0 kg", pulled(3.2, 2.0)),
        ("two_side_mass_plane.plane.angle = 20°, world.gravity = 1.62", pulled(1.6, 1.4, 20.0, 1.62)),
    ],
)
def test_the_value_in_a_changed_scene_is_found(change: str, value: float) -> None:
    """The value, its ratio to the value before and its difference from it agree with closed forms."""
    asked = StructuredQuestion("acceleration", "block A", "at start", change=change)
    now = pulled(1.6, 1.4)
    told = {"value": value, "ratio": value / now, "difference": value - now}
    for compare, wanted in told.items():
        got = found("doubled_load", StructuredQuestion(asked.find, asked.of, asked.when, "", "", change, compare))
        assert got == pytest.approx(wanted, rel=1e-7)


def test_a_body_is_held_fixed() -> None:
    """With the box held fixed, the block and the load are accelerated as about a fixed pulley."""
    asked = StructuredQuestion("acceleration", "block A", "at start", change="the box fixed", compare="value")
    assert found("recoiling_box", asked) == pytest.approx(0.51 * G / (0.51 + 0.68), rel=1e-9)


def test_the_ratio_of_what_both_scenes_have_needs_a_value_in_both() -> None:
    """A velocity that is zero in both scenes has no ratio, and the reason says so."""
    asked = StructuredQuestion("velocity", "block A", "at 0 s", change=f"{LOAD} × 2, {BLOCK} × 2")
    followed = question("doubled_load", asked).followed(scene("doubled_load")[0])
    assert followed.answer is None
    assert "nothing to compare it with" in followed.reason
    assert question("doubled_load", asked).unit(scene("doubled_load")[1]) == ""


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ("nonsense", "changes nothing"),
        ("two_side_mass_plane.plane.angle = 3 kg", "not measured in"),
        (", ".join([f"{LOAD} × 2"] * 7), "at most 6"),
        ("the moon fixed", "there is no 'the moon' here"),
    ],
)
def test_a_change_without_a_meaning_is_refused(change: str, told: str) -> None:
    """The error names the place and the remedy."""
    motion, words = scene("doubled_load")
    with pytest.raises(TextError, match=told):
        variation(change, motion.study.scene, words)


def test_a_change_to_no_scene_has_a_reason() -> None:
    """A negative mass leads to the reason that there is no such motion."""
    asked = StructuredQuestion("acceleration", "block A", "at start", change=f"{LOAD} = -1 kg", compare="value")
    followed = question("doubled_load", asked).followed(scene("doubled_load")[0])
    assert followed.answer is None
    assert "there is no such motion" in followed.reason


NOW, ESCAPES = sqrt(0.61**2 + 7.10**2), sqrt(8.0 * pi**2 * 1.9 / sqrt(1.10**2 + 0.14**2))
"""The speed of a planet at the start, and that with which it escapes, au/yr."""


@pytest.mark.parametrize(
    ("compare", "value"),
    [("", ESCAPES), ("value", ESCAPES), ("difference", ESCAPES - NOW), ("ratio", ESCAPES / NOW)],
)
def test_a_speed_is_found_from_its_components(compare: str, value: float) -> None:
    """The speed with which a planet escapes is found, and compared with the speed that the planet has."""
    asked = StructuredQuestion("system.planets.0.speed", "system.planets.0 & system.star", "at start")
    assert found("escaping_planet", replace(asked, given="eccentricity = 1", compare=compare)) == pytest.approx(value)


def test_of_several_values_the_least_or_the_greatest_is_told() -> None:
    """Two angles lead a ball equally far; without an end, both are named."""
    asked = StructuredQuestion("throw.angle", "the ball", "landed", "x", "displacement = 8 m")
    followed = question("low_throw", asked).followed(scene("low_throw")[0])
    assert followed.answer is None
    assert "several values" in followed.reason
    for end, other in (("least", "greatest"), ("greatest", "least")):
        angle = found(
            "low_throw", StructuredQuestion("throw.angle", "the ball", "landed", "x", f"displacement = 8 m, {end}")
        )
        time = 8.0 / (9.4 * cos(radians(angle)))
        assert 3.2 + 9.4 * sin(radians(angle)) * time - 0.5 * G * time**2 == pytest.approx(0.0, abs=1e-6)
        assert (angle > 30.0) is (other == "least")


def test_what_a_stretch_adds_up_to_may_be_given() -> None:
    """The greatest speed of a trolley on a spring is its compression times the root of k / m."""
    asked = StructuredQuestion("chain.strain.by", "the trolley", given="greatest speed = 1.0 m/s")
    assert found("compressed_trolley", asked) == pytest.approx(sqrt(4.8 / 133.0), rel=1e-7)


@pytest.mark.parametrize(
    ("name", "find", "when", "value"),
    [
        ("heavy_probe", "rocket.rate", "lifts off", 516.0 * G / 1200.0),
        (
            "full_circle",
            "pendulum.speed",
            "circles",
            sqrt(5.0 * G * 0.52 - 2.0 * G * 0.52 * (1.0 - cos(radians(12.0)))),
        ),
    ],
)
def test_what_only_people_ask_about_comes_about_from_a_number_on(name: str, find: str, when: str, value: float) -> None:
    """A rocket rises at once, and a ball goes right round with its string taut."""
    assert found(name, StructuredQuestion(find, when=when)) == pytest.approx(value, rel=1e-6)
    asked = StructuredQuestion(find, when=when, compare="ratio")
    held = load(SCENES / f"{name}.yaml")
    assert found(name, asked) == pytest.approx(value / float(held.value(find)), rel=1e-6)


def test_the_coefficient_of_friction_that_rolling_needs_is_a_quantity() -> None:
    """A disc needs a third of the tangent of the slope's angle."""
    got = found("climbing_disc", StructuredQuestion("coefficient of friction needed", "roller.body", "at start"))
    assert got == pytest.approx(sin(radians(31.0)) / cos(radians(31.0)) / 3.0, rel=1e-9)
