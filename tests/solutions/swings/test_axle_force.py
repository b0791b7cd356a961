"""Tests of the force of a fixed axle along and across the line to the centre of mass."""

from math import cos, hypot, radians, sin

import pytest

from sim2reason.questions import Query, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.angles import Deflected, TurnedThrough
from sim2reason.questions.moments.times import AtStart, WholeMotion
from sim2reason.questions.moments.turning_points import LowestPoint
from sim2reason.scenes.bodies.oscillators import FixedBall, UniformRod
from sim2reason.scenes.bodies.round_bodies import Sphere
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import RotationEntity
from sim2reason.scenes.entities.pieces import AxialPiece, BallPiece, RoundPiece, WeldedPiece
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.rotating_parts import Axles
from sim2reason.solutions import Solution
from worked import derived

G, WEIGHT, ARM = 9.8, 2.0 * 9.8, "arm.arm"
ROD = AxialPiece(body=UniformRod(mass=2.0, length=0.6), axis="along the arm", distance=0.3)
SPHERE = RoundPiece(body=Sphere(mass=2.3, radius=0.12), distance=0.2)
BALL = BallPiece(body=FixedBall(mass=3.1), distance=0.35, side="on the other side")
MOMENT, INERTIA = 2.3 * 0.2 - 3.1 * 0.35, 2.3 * (0.4 * 0.12**2 + 0.2**2) + 3.1 * 0.35**2


def solved(*pieces: WeldedPiece, angle: float, when: Moment, rate: float | None = None, along: str = "") -> Solution:
    scene = Scene(entities=(Named(name="arm", entity=RotationEntity(pieces=pieces, angle=angle, rate=rate)),))
    senses: list[Sense | None] = [sense for sense in Axles().senses(scene.mechanism, ARM) if sense.axis == along]
    target = Target("axle force", ARM, senses[0] if along else None)
    query = Query("start" if isinstance(when, AtStart) else "event", target, when)
    if isinstance(when, WholeMotion):
        query = StretchQuery("extremum", None, when, "greatest axle force", ARM)
    found = derived(scene, query)
    assert found.strategy == "energy and torque about an axle"
    return found


def test_a_level_rod_at_rest_is_held_upwards_alone() -> None:
    """The force is mg/4 for a uniform rod on an axle at its end (Halliday, Resnick and Walker, chapter 10)."""
    found = solved(ROD, angle=90.0, when=AtStart())
    assert found.answer == pytest.approx(0.25 * WEIGHT, rel=1e-9)
    assert "the axle exerts no force along this line" in found.text
    assert "F_r" not in found.text


def test_straight_below_the_axle_the_force_is_vertical() -> None:
    """The force is 5mg/2 for the same rod released from level (Kleppner and Kolenkow, chapter 7)."""
    found = solved(ROD, angle=90.0, when=LowestPoint("arm.pieces.0.body"))
    assert found.answer == pytest.approx(2.5 * WEIGHT, rel=1e-8)
    assert r"exerts the vertical force $F = m \left(g + d \omega^{2}\right) = 49.000\ \text{N}$" in found.text


def test_between_them_two_components_make_the_force() -> None:
    """The components are F_r = mg (5 cos θ − 3 cos θ₀)/2 and F_t = mg (sin θ)/4."""
    now, began = radians(30.0), radians(80.0)
    inward, aside = 0.5 * WEIGHT * (5.0 * cos(now) - 3.0 * cos(began)), 0.25 * WEIGHT * sin(now)
    for when in (TurnedThrough(ARM, 50.0), Deflected(ARM, 30.0)):
        found = solved(ROD, angle=80.0, when=when)
        assert found.answer == pytest.approx(hypot(inward, aside), rel=1e-8)
        assert found.values["F_r"] == pytest.approx(inward, rel=1e-8)
        assert found.values["F_t"] == pytest.approx(aside, rel=1e-8)


@pytest.mark.parametrize("turned", [50.0, 120.0])
@pytest.mark.parametrize("pieces", [(SPHERE,), (SPHERE, BALL)], ids=["one side", "heavier beyond the axle"])
def test_components_along_the_room_are_those_of_all_pieces(pieces: tuple[WeldedPiece, ...], turned: float) -> None:
    """The force is Σ m (a − g) with a = α × r − ω² r of each piece and ω by energy."""
    both = len(pieces) == 2
    total = 2.3 + 3.1 * both
    moment = MOMENT if both else 2.3 * 0.2
    inertia = INERTIA if both else 2.3 * (0.4 * 0.12**2 + 0.2**2)
    began, rate = radians(70.0), 6.0
    now = began - radians(turned)
    square = rate**2 + 2.0 * moment * G * (cos(now) - cos(began)) / inertia
    growth = -moment * G * sin(now) / inertia
    right = moment * (growth * cos(now) - square * sin(now))
    up = moment * (growth * sin(now) + square * cos(now)) + total * G
    for along, value in (("horizontal", right), ("vertical", up), ("", hypot(right, up))):
        found = solved(*pieces, angle=70.0, rate=rate, when=TurnedThrough(ARM, turned), along=along)
        assert found.answer == pytest.approx(value, rel=1e-7)


def test_several_pieces_are_taken_as_one_mass_at_their_centre_of_mass() -> None:
    found = solved(SPHERE, BALL, angle=70.0, when=AtStart())
    assert found.values["M"] == pytest.approx(5.4, rel=1e-9)
    assert found.values[r"d_{\text{cm}}"] == pytest.approx(-MOMENT / 5.4, rel=1e-9)
    assert "The total mass is $M = m_A + m_B" in found.text


@pytest.mark.parametrize(
    ("rate", "reason"),
    [(1.0, "at the turning points, without angular velocity,"), (12.0, "in the highest position")],
)
def test_it_is_greatest_in_the_lowest_position(rate: float, reason: str) -> None:
    found = solved(ROD, angle=60.0, rate=rate, when=WholeMotion())
    square = rate**2 + 3.0 * G / 0.6 * (1.0 - cos(radians(60.0)))
    assert found.answer == pytest.approx(2.0 * (G + 0.3 * square), rel=1e-8)
    assert reason in found.text
