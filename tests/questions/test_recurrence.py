"""Tests of the recurrence of motions, against closed forms."""

from collections.abc import Callable
from math import cos, pi, radians, sin, sqrt
from pathlib import Path

import numpy as np
import pytest

from motions import Motion, charge, light_rod, orbit, rolling_ball, slab, spring_block, string_pendulum, thrown_ball
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.phrasing import attracted_by
from sim2reason.questions.recurrence import Repetition, drift_return, escapes, first_return, has_known_continuation
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.fields import Magnetic, Profile, Push
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism, X, Y, Z
from sim2reason.scenes.files import load
from sim2reason.simulation.engines.exact import simulate

G = 9.8
SCENES = Path(__file__).parents[1] / "data" / "ordinary_scenes"
SEEDS = range(4)


def period(mechanism: Mechanism, name: str, duration: float) -> float | None:
    """Return the period by the exact engine."""
    return Repetition(name).time(simulate(mechanism, np.linspace(0.0, duration, 5)))


def mean(a: float, b: float) -> float:
    """Return the arithmetic-geometric mean."""
    while abs(a - b) > 1e-15 * a:
        a, b = 0.5 * (a + b), sqrt(a * b)
    return a


def rod(length: float, angle: float, rate: float = 0.0) -> Mechanism:
    """Build a bob on a light rod, at an angle from its lowest point, turning at a rate, rad/s."""
    builder = Builder()
    away = (length * sin(angle), 0.0, -length * cos(angle))
    builder.room().body("rod").hinge(Y, rate).body("bob", 0.7, at=away)
    return builder.finish()


@pytest.mark.parametrize("angle", [10.0, 60.0, 120.0, 170.0])
def test_a_pendulum_of_any_amplitude(angle: float) -> None:
    """T = 2π √(ℓ/g) / M(1, cos ½θ), with the arithmetic-geometric mean M (C. F. Gauss)."""
    length, away = 0.8, radians(angle)
    expected = 2.0 * pi * sqrt(length / G) / mean(1.0, cos(0.5 * away))
    assert period(rod(length, away), "bob", 1.3 * expected) == pytest.approx(expected, rel=1e-8)
    assert period(rod(length, away), "bob", 0.9 * expected) is None
    rate = 2.0 * sqrt(G / length) * sin(0.5 * away)  # that at the lowest point
    assert period(rod(length, 0.0, rate), "bob", 1.3 * expected) == pytest.approx(expected, rel=1e-8)


def test_a_pendulum_that_goes_right_round() -> None:
    """T = 2π/(ω₀ M(1, √(1 − (2 √(g/ℓ)/ω₀)²))) for one turn, half the complete elliptic integral of a swing."""
    length, rate = 0.5, 11.0
    expected = 2.0 * pi / (rate * mean(1.0, sqrt(1.0 - 4.0 * G / length / rate**2)))
    assert period(rod(length, 0.0, rate), "bob", 1.2 * expected) == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize("eccentricity", [0.0, 0.3, 0.6])
def test_keplers_third_law(eccentricity: float) -> None:
    """T² = 4π² a³/(GM): one year at 1 au about one solar mass."""
    mechanism = orbit(eccentricity).mechanism
    assert period(mechanism, "sky.planet", 1.2) == pytest.approx(1.0, rel=1e-8)
    assert attracted_by(mechanism, "sky.planet") == "sky.star"
    assert attracted_by(mechanism, "sky.star") == ""


@pytest.mark.parametrize(("share", "outward", "flies"), [(0.99, 1.0, False), (1.01, 1.0, True), (1.01, -1.0, False)])
def test_what_is_faster_than_it_must_be_to_escape_never_comes_back(share: float, outward: float, flies: bool) -> None:
    """With v² > 2GM/r the planet escapes if it moves away from the star, but not yet if it moves towards it."""
    builder = Builder(gravity=ZERO)
    room = builder.room()
    star = room.body("star", 5.0)
    speed = share * sqrt(2.0 * 2.0 * 5.0 / 3.0)
    planet = room.body("planet", 1e-3, at=(3.0, 0.0, 0.0))
    planet.slide(X, outward * 0.8 * speed, name="x").slide(Y, 0.6 * speed, name="y").attract(star, 2.0)
    trace = simulate(builder.finish(), np.linspace(0.0, 0.1, 3))
    assert escapes(trace, "planet") is flies
    assert not escapes(trace, "star")


@pytest.mark.parametrize(("angle", "rate"), [(0.3, 0.0), (0.0, 0.0)])
def test_what_repeats_itself_or_rests_brings_nothing_new(angle: float, rate: float) -> None:
    """A swing is known after one period, a bob at rest at once."""
    mechanism, whole = rod(0.8, angle, rate), 2.0 * pi * sqrt(0.8 / G)
    assert has_known_continuation(simulate(mechanism, np.linspace(0.0, 1.1 * whole, 5)))
    assert has_known_continuation(simulate(mechanism, np.linspace(0.0, 0.5 * whole, 5))) is (angle == 0.0)


def particle(electric: float) -> Mechanism:
    """Build a charge of 0.4 C and 0.1 kg in 1.5 T, perhaps with a perpendicular electric field."""
    builder = Builder(gravity=ZERO)
    bead = builder.room().body("bead", 0.1).slide(X, 2.0, name="x").slide(Z, 1.0, name="y")
    bead.force("field", Magnetic(Y, Profile(0.4 * 1.5)))
    if electric:
        bead.force("other", Push(X, Profile(0.4 * electric)))
    return builder.finish()


def test_a_charge_in_a_magnetic_field() -> None:
    """T = 2πm/(qB) at any speed; with a perpendicular electric field the charge drifts, and never returns."""
    expected = 2.0 * pi * 0.1 / (0.4 * 1.5)
    assert period(particle(0.0), "bead", 3.0 * expected) == pytest.approx(expected, rel=1e-9)
    assert period(particle(0.7), "bead", 3.0 * expected) is None


@pytest.mark.parametrize("seed", SEEDS)
def test_a_spring_block(seed: int) -> None:
    """T = 2π √(m/k), whether released or struck."""
    mass, stiffness, speed = np.random.default_rng(seed).uniform((0.3, 20.0, 0.0), (3.0, 90.0, 1.0)).tolist()
    builder = Builder(gravity=ZERO)
    room = builder.room().site("wall")
    room.body("block", mass, at=(1.1, 0.0, 0.0)).slide(X, speed).site("hook")
    room.spring("spring", "wall", "hook", stiffness=stiffness, length=1.0)
    expected = 2.0 * pi * sqrt(mass / stiffness)
    assert period(builder.finish(), "block", 2.5 * expected) == pytest.approx(expected, rel=1e-9)


def test_a_ball_that_bounces_without_loss() -> None:
    """T = 2 √(v² + 2gh)/g for a ball thrown straight up at v, 0.4 m above the floor."""
    builder = Builder()
    room = builder.room()
    ball = room.body("ball", 0.2, at=(0.0, 0.0, 0.4)).slide(Z, 1.0)
    room.bump(room, ball, Z, 0.0, 1.0)
    expected = 2.0 * sqrt(1.0 + 2.0 * G * 0.4) / G
    assert period(builder.finish(), "ball", 3.0 * expected) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize(
    ("made", "name"),
    [
        (lambda: string_pendulum(3.5), "swing.bob"),
        (rolling_ball, "lane.ball"),
        (charge, "lab.charge"),
        (slab, "bench.block"),
        (thrown_ball, "field.ball"),
    ],
)
def test_what_never_comes_back(made: Callable[[], Motion], name: str) -> None:
    """A slack string, a slipping ball, a region's border, friction, and a lossy bounce prevent recurrence."""
    motion = made()
    assert period(motion.mechanism, name, motion.duration) is None


def test_whatever_it_carries_comes_back_with_it() -> None:
    """The rod of a pendulum has the same period as its bob."""
    for motion, names in ((light_rod(60.0), ("swing.hanger", "swing.bob")), (spring_block(), ("bench.block",))):
        found = {period(motion.mechanism, name, 3.0) for name in names}
        assert len(found) == 1
        assert None not in found


def test_what_drifts_on_repeats_itself_elsewhere() -> None:
    """Two trolleys on a spring repeat their relative oscillation; a wall would be a special place."""
    masses, stiffness = (1.1, 3.5), 40.0
    reduced = masses[0] * masses[1] / sum(masses)
    free = simulate_scene(load(SCENES / "struck_trolleys.yaml"), 2.0).study.trace
    assert first_return(free) is None
    assert drift_return(free) == pytest.approx(2.0 * pi * sqrt(reduced / stiffness), rel=1e-6)
    assert drift_return(simulate_scene(load(SCENES / "elastic_balls.yaml")).study.trace) is None


def test_what_starts_on_a_relaxed_spring_and_drifts_repeats_itself() -> None:
    """Trolleys of 4.1 kg and 2.1 kg on a relaxed spring of 139 N/m have no acceleration at first."""
    reduced = 4.1 * 2.1 / (4.1 + 2.1)
    trace = simulate_scene(load(SCENES / "struck_second_trolley.yaml"), 3.0).study.trace
    assert not trace.at(0.0).a[0].any()
    assert drift_return(trace) == pytest.approx(2.0 * pi * sqrt(reduced / 139.0), rel=1e-6)
