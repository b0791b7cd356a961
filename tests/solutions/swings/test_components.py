"""Tests of arms on axles: components of the acceleration, side of the centre of mass, and sense of rotation."""

from math import acos, cos, degrees, radians, sin

import pytest

from sim2reason.questions import Query, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import LowestPoint, Stopped
from sim2reason.scenes.bodies.oscillators import FixedBall
from sim2reason.scenes.bodies.round_bodies import Hoop
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import RotationEntity
from sim2reason.scenes.entities.pieces import OTHER_SIDE, SAME_SIDE, AxialPiece, BallPiece
from worked import derived, solution_text

G, ANGLE, RADIUS, HOOP, NEAR, FAR = 9.8, 47.0, 0.17, 9.0, 0.2, 0.4
PIECE = "arm.pieces.0"


def arm(ball: float, *, together: bool = False, rate: float | None = None) -> Scene:
    """Return a scene with a hoop and a ball on opposite sides of an axle, or on one side if `together` is true."""
    hoop = AxialPiece(distance=NEAR, body=Hoop(mass=HOOP, radius=RADIUS), axis="along the arm")
    weight = BallPiece(distance=FAR, side=SAME_SIDE if together else OTHER_SIDE, body=FixedBall(mass=ball))
    entity = RotationEntity(pieces=(hoop, weight), angle=ANGLE, rate=rate)
    return Scene(entities=(Named(name="arm", entity=entity),))


def body(scene: Scene) -> str:
    return next(held.name for held in scene.mechanism.bodies if held.mass == HOOP)


def about_axle(ball: float, *, together: bool = False) -> tuple[float, float]:
    """Return Σ m r and the moment of inertia about the axle; that of the hoop is one about a diameter."""
    moment = HOOP * NEAR + (ball if together else -ball) * FAR
    return moment, HOOP * (0.5 * RADIUS**2 + NEAR**2) + ball * FAR**2


@pytest.mark.parametrize("ball", [2.0, 8.0])
def test_just_after_release_there_is_only_a_tangential_acceleration(ball: float) -> None:
    """a = d |S| g sin θ/I; the angular velocity is zero, so there is no centripetal acceleration."""
    scene = arm(ball)
    found = derived(scene, Query("start", Target("acceleration", body(scene)), AtStart()))
    moment, inertia = about_axle(ball)
    assert found.answer == pytest.approx(NEAR * abs(moment) * G * sin(radians(ANGLE)) / inertia)
    assert "Just after release the angular velocity is zero, so the acceleration is only tangential:" in found.text
    assert "centripetal" not in found.text
    assert f"As $S {'<' if moment < 0.0 else '>'} 0$, the centre of mass is on" in found.text


def test_at_the_lowest_point_there_is_only_a_centripetal_acceleration() -> None:
    scene = arm(2.0)
    found = derived(scene, Query("event", Target("acceleration", body(scene)), LowestPoint(body(scene))))
    moment, inertia = about_axle(2.0)
    assert found.answer == pytest.approx(NEAR * 2.0 * moment * G * (1.0 - cos(radians(ANGLE))) / inertia)
    assert "so the acceleration is only centripetal" in found.text


def test_where_all_is_on_one_side_no_sign_is_spoken_of() -> None:
    scene = arm(2.0, together=True)
    found = derived(scene, Query("start", Target("acceleration", body(scene)), AtStart()))
    moment, inertia = about_axle(2.0, together=True)
    assert found.answer == pytest.approx(NEAR * moment * G * sin(radians(ANGLE)) / inertia)
    assert "counted as positive" not in found.text


def test_the_way_of_an_arm_is_told_from_turning_point_to_turning_point() -> None:
    """An arm launched downward at θ turns back at φ on the other side, and the text lists each part of its path."""
    scene, rate = arm(2.0, rate=3.0), 3.0
    moment, inertia = about_axle(2.0)
    reach = acos(cos(radians(ANGLE)) - inertia * rate**2 / (2.0 * moment * G))
    whole = StretchQuery("sum", None, Stopped(body(scene)), "total angle", "arm.arm")
    found = derived(scene, whole)
    assert found.answer == pytest.approx(ANGLE + degrees(reach))
    assert r"From $\theta$ it swings through the lowest point to $\phi_{\text{max}}$ on the other side." in found.text
    later = StretchQuery("sum", None, AtTime(0.8), "total angle", "arm.arm")
    text = derived(scene, later).text
    assert r"$\phi_{\text{max}}$ on the other side and back" in text
    assert "As $k < 1$, the energy does not suffice to reach the top of the circle" in text
    assert "it has turned back once since the start" in text


def test_a_function_and_its_value_have_names_of_their_own() -> None:
    """F is the elliptic integral and φ the variable angle, so their values have the names u and φ with an index."""
    found = derived(arm(2.0, rate=3.0), Query("state", Target("deflection", "arm.arm"), AtTime(0.8)))
    assert "F" not in {name.partition("_")[0] for name in found.values}
    assert r"\varphi" not in found.values
    assert r"\phi_t" in found.values


def test_an_angular_acceleration_of_either_sign_is_no_magnitude() -> None:
    """The centre of mass of an arm in symbols may be on either side, so S may be negative."""
    text = solution_text("rotation-hard-symbolic-301926-1")
    assert "Apart from its sign, the angular acceleration is the torque of gravity" in text


def test_the_position_without_a_tangential_component_is_named() -> None:
    """The position is named again, as gravity has a tangential component at the turning point mentioned before."""
    text = solution_text("rotation-medium-numeric-301926-0")
    assert "straight below or above the axis of rotation, gravity has no tangential component" in text


def test_the_side_of_the_centre_of_mass_is_checked_once_the_unknown_is_found() -> None:
    """With d = 0.10008 m, S = m_A d − m_B d_2 = 4.7 · 0.10008 − 3.1 · 0.22 = −0.2116 kg m."""
    text = solution_text("rotation-hard-reverse-301926-1")
    assert "Assume that $S < 0$, so that the centre of mass is on the opposite side." in text
    assert r"With this, $S = -0.21161\ \text{kg m} < 0$, as was assumed." in text


def test_a_place_beyond_the_axle_is_no_distance() -> None:
    text = solution_text("rotation-hard-choice-301926-1")
    assert "Its distance from the axle" not in text
    assert "positive on the side of shell A, the centre of mass of cap C is at $r_C = -d_3 - c_C" in text


def test_the_side_of_the_centre_of_mass_is_assumed_before_it_is_used() -> None:
    text = solution_text("rotation-medium-reverse-301930-0")
    assert 0 < text.index("Assume that $S < 0$") < text.index("the torque of gravity is")
    assert "the centre of mass of hemisphere B is at $r_B = c_B - d_2$." in text


def test_it_is_said_which_body_is_at_its_highest_point() -> None:
    """The text names a body on one side, as an arm with bodies on both sides has no highest point."""
    text = solution_text("rotation-hard-multipart-301932-1")
    assert "The arm turns back, with hemisphere A at its highest point, where all kinetic energy" in text


def test_a_path_round_the_axle_is_not_measured_by_a_radius() -> None:
    text = solution_text("rotation-medium-reverse-301928-0")
    assert "The path is as long as the distance from the axle times the total angle:" in text
    assert "The shell turns back at its highest point, where" in text
