"""Tests of limiting values at which a pendulum goes right round or its string goes slack, by energy."""

from math import acos, cos, degrees, radians, sqrt

import numpy as np
import pytest

from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.outcomes import PossibleOutcome
from sim2reason.questions.outcomes.strings import GoesRound, GoesSlack
from sim2reason.scenes.bodies.eccentric_bodies import SphericalCap
from sim2reason.scenes.bodies.oscillators import Ball, Cord, LightRod, UniformRod
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum, RotationEntity
from sim2reason.scenes.entities.pieces import AxialPiece, CappedPiece
from sim2reason.solutions import Solution, solve
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import RTOL_BY_KIND, faults
from worked import asked

G, LENGTH, ANGLE = 9.8, 0.8, 40.0


def limit(name: str, entity: Entity, outcome: PossibleOutcome, path: str, about: float) -> Solution:
    query = ThresholdQuery("threshold", None, None, outcome, f"{name}.{path}", "", about=about)
    setting = asked(Scene(entities=(Named(name=name, entity=entity),)), query)
    found = solve(setting)
    assert setting.answer is not None
    assert found.strategy == "limiting swing", found.reason
    assert not faults(found, setting.answer, RTOL_BY_KIND["threshold"])
    assert not read(found.text).broken
    return found


def bob(speed: float, *, rod: bool = False) -> Pendulum:
    hanger = LightRod(length=LENGTH) if rod else Cord(length=LENGTH)
    return Pendulum(bob=Ball(mass=0.5), hanger=hanger, angle=ANGLE, speed=speed)


def test_a_bob_on_a_rod_goes_round_if_it_just_comes_to_the_top() -> None:
    """The limiting speed is given by v² = 2 g ℓ (1 + cos θ)."""
    expected = sqrt(2.0 * G * LENGTH * (1.0 + cos(radians(ANGLE))))
    found = limit("pendulum", bob(5.0, rod=True), GoesRound("pendulum.bob"), "speed", expected)
    assert found.answer == pytest.approx(expected, rel=1e-8)


def test_a_string_stays_taut_if_the_bob_does_not_rise_above_the_nail() -> None:
    """The limiting speed is given by v² = 2 g ℓ cos θ."""
    expected = sqrt(2.0 * G * LENGTH * cos(radians(ANGLE)))
    found = limit("pendulum", bob(3.4), GoesSlack("pendulum.hanger"), "speed", expected)
    assert found.answer == pytest.approx(expected, rel=1e-7)


def test_a_string_stays_taut_if_the_bob_is_fast_enough_on_top() -> None:
    """The limiting speed is given by v² = g ℓ (3 + 2 cos θ)."""
    expected = sqrt(G * LENGTH * (3.0 + 2.0 * cos(radians(ANGLE))))
    found = limit("pendulum", bob(6.2), GoesSlack("pendulum.hanger"), "speed", expected)
    assert found.answer == pytest.approx(expected, rel=1e-7)


def test_a_rod_goes_round_if_its_energy_is_enough() -> None:
    """The limiting angular velocity is given by ½ I ω² = m g d (1 + cos θ)."""
    mass, length, place, rate = 2.0, 0.9, 0.3, 6.0
    rod = AxialPiece(distance=place, body=UniformRod(mass=mass, length=length), axis="along the arm")
    arm = RotationEntity(pieces=(rod,), angle=100.0, rate=rate)
    inertia = mass * (length**2 / 12.0 + place**2)
    expected = degrees(acos(0.5 * inertia * rate**2 / (mass * G * place) - 1.0))
    assert limit("arm", arm, GoesRound("arm.arm"), "angle", expected).answer == pytest.approx(expected, rel=1e-7)


def test_a_height_that_no_formula_gives_is_found_by_numbers() -> None:
    """½ I ω² = m g s (1 + cos θ), with the centre of mass s and I of a spherical cap summed over thin discs."""
    radius, height, place = 0.39, 0.33, 0.15
    z = (np.arange(200_000) + 0.5) * height / 200_000
    disc = radius**2 - (radius - height + z) ** 2  # the square of its radius
    s = np.average(place + z, weights=disc)
    inertia = np.average(disc / 4.0 + (place + z) ** 2, weights=disc)  # of each kilogram
    rate = sqrt(2.0 * G * s * (1.0 + cos(radians(ANGLE))) / inertia)
    cap = CappedPiece(distance=place, body=SphericalCap(mass=6.5, radius=radius, height=height), faces="the axle")
    arm = RotationEntity(pieces=(cap,), angle=ANGLE, rate=rate)
    found = limit("arm", arm, GoesRound("arm.arm"), "pieces.0.body.height", height)
    assert found.answer == pytest.approx(height, rel=1e-6)
    assert "have the numerical solution" in found.text
