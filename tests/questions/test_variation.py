"""Tests of structured questions about a changed scene, against closed forms."""

from dataclasses import replace
from functools import cache
from math import cos, hypot, pi, radians, sin, sqrt
from pathlib import Path

import pytest

from sim2reason.errors import TextError
from sim2reason.questions.following import FollowedMotion, simulate_scene
from sim2reason.questions.posing import PosedQuestion, pose_question
from sim2reason.questions.prompt import words_of
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.variation import find_removable, variation
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Magnetic
from sim2reason.scenes.files import load
from sim2reason.text.prose.description import describe

SCENES = Path(__file__).parents[1] / "data" / "ordinary_scenes"
G = 9.8
LOAD, BLOCK = "mass_with_fixed_pulley.system.blocks.0.mass", "two_side_mass_plane.blocks.0.mass"


@cache
def scene(name: str) -> tuple[FollowedMotion, Words]:
    """Return the motion of a scene and the words of its description."""
    held = load(SCENES / f"{name}.yaml")
    return simulate_scene(held), words_of(describe(held))


def question(name: str, asked: StructuredQuestion) -> PosedQuestion:
    """Return a structured question as posed about a scene."""
    return pose_question(asked, *scene(name))


def found(name: str, asked: StructuredQuestion) -> float:
    """Return the answer to a structured question."""
    answer = question(name, asked).simulate_answer(scene(name)[0]).answer
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
        (f"{LOAD} x 2", pulled(3.2, 1.4)),
        (f"{LOAD} X2", pulled(3.2, 1.4)),
        (f"{LOAD} * 2", pulled(3.2, 1.4)),
        (f"{LOAD} × 2, {BLOCK} = 2.0 kg", pulled(3.2, 2.0)),
        ("two_side_mass_plane.plane.angle = 20°, world.gravity = 1.62", pulled(1.6, 1.4, 20.0, 1.62)),
    ],
)
def test_the_value_in_a_changed_scene_is_found(change: str, value: float) -> None:
    """The new value, its ratio to the old one and their difference agree with closed forms."""
    asked = StructuredQuestion("acceleration", "block A", "at start", change=change)
    now = pulled(1.6, 1.4)
    told = {"value": value, "ratio": value / now, "difference": value - now}
    for compare, wanted in told.items():
        got = found("doubled_load", StructuredQuestion(asked.find, asked.of, asked.when, "", "", change, compare))
        assert got == pytest.approx(wanted, rel=1e-7)


def test_a_body_is_held_fixed() -> None:
    """With the box held fixed, the block and its load accelerate as over a fixed pulley."""
    asked = StructuredQuestion("acceleration", "block A", "at start", change="the box fixed", compare="value")
    assert found("recoiling_box", asked) == pytest.approx(0.51 * G / (0.51 + 0.68), rel=1e-9)


def test_the_ratio_of_what_both_scenes_have_needs_a_value_in_both() -> None:
    """A velocity that is zero in both scenes has no ratio, and the reason says so."""
    asked = StructuredQuestion("velocity", "block A", "at 0 s", change=f"{LOAD} × 2, {BLOCK} × 2")
    followed = question("doubled_load", asked).simulate_answer(scene("doubled_load")[0])
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
    """The error message names the faulty part and the remedy."""
    motion, words = scene("doubled_load")
    with pytest.raises(TextError, match=told):
        variation(change, motion.study.scene, words, lambda _when, _other: 0.0)


def test_a_change_to_no_scene_has_a_reason() -> None:
    """A negative mass gives no answer, with the reason that there is no such motion."""
    asked = StructuredQuestion("acceleration", "block A", "at start", change=f"{LOAD} = -1 kg", compare="value")
    followed = question("doubled_load", asked).simulate_answer(scene("doubled_load")[0])
    assert followed.answer is None
    assert "there is no such motion" in followed.reason


NOW, ESCAPES = sqrt(0.61**2 + 7.10**2), sqrt(8.0 * pi**2 * 1.9 / sqrt(1.10**2 + 0.14**2))
"""The speed of a planet at the start, and that with which it escapes, au/yr."""


@pytest.mark.parametrize(
    ("compare", "value"),
    [("", ESCAPES), ("value", ESCAPES), ("difference", ESCAPES - NOW), ("ratio", ESCAPES / NOW)],
)
def test_a_speed_is_found_from_its_components(compare: str, value: float) -> None:
    """A planet's escape speed is found, and compared with the planet's own speed."""
    asked = StructuredQuestion("system.planets.0.speed", "system.planets.0 & system.star", "at start")
    assert found("escaping_planet", replace(asked, given="eccentricity = 1", compare=compare)) == pytest.approx(value)


def test_of_several_values_the_least_or_the_greatest_is_told() -> None:
    """Two launch angles have the same range; without "least" or "greatest" there is no answer."""
    asked = StructuredQuestion("throw.angle", "the ball", "landed", "x", "displacement = 8 m")
    followed = question("low_throw", asked).simulate_answer(scene("low_throw")[0])
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
    """Thresholds are found for a rocket that lifts off at once and a ball on a string that completes its circle."""
    assert found(name, StructuredQuestion(find, when=when)) == pytest.approx(value, rel=1e-6)
    asked = StructuredQuestion(find, when=when, compare="ratio")
    held = load(SCENES / f"{name}.yaml")
    assert found(name, asked) == pytest.approx(value / float(held.value(find)), rel=1e-6)


def test_the_coefficient_of_friction_that_rolling_needs_is_a_quantity() -> None:
    """A disc needs a third of the tangent of the slope's angle."""
    got = found("climbing_disc", StructuredQuestion("coefficient of friction needed", "roller.body", "at start"))
    assert got == pytest.approx(sin(radians(31.0)) / cos(radians(31.0)) / 3.0, rel=1e-9)


HUNG, CUT = "hung_load", "tendon_1 removed"
MASS = "hanging_mass.system.blocks.0.mass"


def hung(load: float, block: float, angle: float, friction: float) -> tuple[float, float]:
    """Return the acceleration of a block on a rough slope with a hanging load, and its deceleration without it."""
    back = G * (sin(radians(angle)) + friction * cos(radians(angle)))
    return (load * G - block * back) / (load + block), back


def held(name: str, *paths: str) -> list[float]:
    """Return the values at some addresses of a scene."""
    read = load(SCENES / f"{name}.yaml")
    return [float(read.value(path)) for path in paths]


def pair() -> tuple[float, float]:
    """Return the accelerations of the scene in which a hanging load draws a block up a rough slope."""
    plane = "two_side_mass_plane.plane"
    return hung(*held(HUNG, LOAD, BLOCK, f"{plane}.angle", f"{plane}.friction"))


@pytest.mark.parametrize("change", [f"{CUT} at 0.5 s", "the string cut at 0.5 s", f"{CUT} when block A moved SPAN m"])
def test_a_motion_goes_on_after_a_string_is_cut(change: str) -> None:
    """The block decelerates to rest from its speed at the cut; the load falls freely."""
    up, back = pair()
    change = change.replace("SPAN", f"{0.5 * up * 0.5**2:.12g}")
    speed = up * 0.5
    wanted = {
        ("displacement", "block A", "stopped"): speed**2 / (2.0 * back),
        ("time", "", "block A stopped"): speed / back,
        ("velocity", "block B", "at 0.2 s"): -(speed + G * 0.2),
    }
    for (find, of, when), value in wanted.items():
        along = "up" if find == "velocity" else ""
        asked = StructuredQuestion(find, of, when, along, change=change)
        assert found(HUNG, asked) == pytest.approx(value, rel=1e-8)
        assert "ratio" not in asked.text


def test_other_numbers_may_change_too() -> None:
    """With twice the load, the block is faster when the string is cut."""
    plane = "two_side_mass_plane.plane"
    mass, *others = held(HUNG, LOAD, BLOCK, f"{plane}.angle", f"{plane}.friction")
    up, back = hung(2.0 * mass, *others)
    asked = StructuredQuestion("displacement", "block A", "stopped", change=f"{LOAD} × 2, {CUT} at 0.5 s")
    assert found(HUNG, asked) == pytest.approx((up * 0.5) ** 2 / (2.0 * back), rel=1e-8)


@pytest.mark.parametrize(
    ("change", "compare", "told"),
    [
        (f"{CUT} at 0.5 s", "ratio", "not compared"),
        ("the pulley removed at 0.5 s", "", "there is no 'the pulley'"),
        (f"{CUT} at 5 kg", "", "not measured in s"),
        (f"{CUT} when block A landed", "", "nothing of that kind"),
    ],
)
def test_a_removal_without_a_meaning_is_refused(change: str, compare: str, told: str) -> None:
    """The error message names the comparison, body, unit or event that is not accepted."""
    asked = StructuredQuestion("displacement", "block A", "stopped", change=change, compare=compare)
    with pytest.raises(TextError, match=told):
        question(HUNG, asked)


def test_a_hand_lets_go_and_a_field_is_switched_off() -> None:
    """The force of a hand and an electric field can be removed; the bead then has the period 2πm/(qB)."""
    scene_of = {"hand_drawn_block": "the hand", "crossed_fields": "the electric field"}
    for name, what in scene_of.items():
        assert what in find_removable(scene(name)[1]).values()
    asked = StructuredQuestion("period", change="the electric field switched off at 0.3 s")
    read = load(SCENES / "crossed_fields.yaml").mechanism
    field = next(force for force in read.forces if force.name.endswith("magnetic"))
    assert isinstance(field.law, Magnetic)
    strength = abs(field.law.profile.value)
    assert found("crossed_fields", asked) == pytest.approx(2.0 * pi * read.body[field.body].mass / strength, rel=1e-6)


def test_a_light_pulley_stays_behind_without_its_load() -> None:
    """A block is in free fall after its string to a light movable pulley is cut."""
    asked = StructuredQuestion("acceleration", "block A", "at 0.01 s", "up", change="CUT removed at 0.2 s")
    for name in ("hung_pulley", "lifted_pulley", "under_pulley", "hand_on_pulley", "lifting_pulley"):
        cords = [line.whole for line in load(SCENES / f"{name}.yaml").mechanism.lines if line.whole.endswith("cord")]
        if cords:
            told = replace(asked, change=asked.change.replace("CUT", cords[0]))
            assert found(name, told) == pytest.approx(-G, rel=1e-9)
            return
    pytest.fail("there is no such scene")


def test_the_speed_of_a_circular_orbit_is_a_quantity() -> None:
    """The speed of a circular orbit is the root of G M / r, whatever the planet's actual velocity."""
    asked = StructuredQuestion("circular speed", "system.planets.0 & system.star", "at start")
    assert found("escaping_planet", asked) == pytest.approx(sqrt(4.0 * pi**2 * 1.9 / hypot(1.10, 0.14)), rel=1e-9)


def test_the_length_of_the_equivalent_pendulum_is_found() -> None:
    """A rod's equivalent simple pendulum has the length I/(m d), with I the moment of inertia about the axle."""
    pieces = "arm.pieces.0"
    length, distance = held("long_rod", f"{pieces}.body.length", f"{pieces}.distance")
    asked = StructuredQuestion("equivalent pendulum length", when="equilibrium")
    assert found("long_rod", asked) == pytest.approx((length**2 / 12.0 + distance**2) / distance, rel=1e-6)


def test_a_body_without_named_directions_may_be_asked_about_along_its_path() -> None:
    """The load for which the box has no acceleration is found, although the box has no named direction."""
    asked = StructuredQuestion(MASS, "the box", "at start", "its path", "acceleration = 0 m/s^2")
    mass = found("hauled_box", asked)
    change = f"{MASS} = {mass:.15g} kg"
    at = StructuredQuestion("acceleration", "the box", "at start", change=change)
    assert found("hauled_box", replace(at, compare="value")) == pytest.approx(0.0, abs=1e-7)
