"""Tests of slips about strings, pulleys, friction and orbits, against results by hand."""

from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

from motions import Motion, orbit
from plain_scenes import G, atwood, bight, half_atwood, ramp
from sim2reason.questions import Query, SimulatedScene, Target
from sim2reason.questions.simplifications import MISCONCEPTIONS
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import FixedPulley, MovablePulley
from sim2reason.scenes.connections.string import String
from sim2reason.scenes.dsl.connection import Link
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley, MassWithMovablePulley
from sim2reason.scenes.entities.string_ends import Hanging
from sim2reason.simulation.trace import Trace

BLOCK, OTHER = "one.system.blocks.0", "other.system.blocks.0"
PLANET = "sky.planet"
END = 1.0  # s


def slipped(name: str, study: SimulatedScene, quantity: str, about: str | None = None) -> Trace:
    """Return the motion with a slip in a question about a quantity."""
    slip = MISCONCEPTIONS[name]
    subjects = list(slip.subjects(Query("state", Target(quantity, "")), study))
    assert about is None or about in subjects
    found = slip.simplified(study, about if about is not None else subjects[0], END)
    assert found is not None
    return found.trace


def size(name: str, scene: Scene, quantity: str, subject: str, about: str | None = None) -> float:
    """Return the magnitude of a quantity at the end of that motion."""
    trace = slipped(name, SimulatedScene.of(scene, np.linspace(0.0, END, 41)), quantity, about)
    return Target(quantity, subject).value(trace.at(END))


def _hung(name: str, mass: float) -> Named:
    entity = MassWithFixedPulley(system=Hanging(blocks=(Block(mass=mass),)), pulley=FixedPulley())
    return Named(name=name, entity=entity)


def double_atwood(mass: float, left: float, right: float) -> Scene:
    """Build a block on a string over a fixed pulley to the axle of a movable one with two hanging blocks."""
    sides = (Hanging(blocks=(Block(mass=each),)) for each in (left, right))
    hanging = MassWithMovablePulley(left=next(sides), right=next(sides), pulley=MovablePulley())
    links = (Link(entity="one", port="tail"), Link(entity="moved", port="top"))
    entities = (_hung("one", mass), Named(name="moved", entity=hanging))
    return Scene(entities=entities, connections=(String(links=links),))


def test_the_weight_of_one_block_pulls_the_other() -> None:
    """T = m₂g gives (m₁ - m₂)g/m₁ = g/3 for 3 kg and 2 kg; the block with that weight is at rest."""
    found = size("weight as tension", atwood(), "acceleration", BLOCK, OTHER)
    assert found == pytest.approx(G / 3.0)
    assert size("weight as tension", atwood(), "acceleration", OTHER, OTHER) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("disc", [None, 2.0])
def test_two_pieces_of_a_string_share_the_weight_in_its_bight(disc: float | None) -> None:
    """T = (M + m)g/2, where m is the mass of the pulley."""
    scene = bight(4.0, 5.0, disc)
    string = next(line.name for line in reversed(scene.mechanism.lines) if line.whole != "loaded.cord")
    found = size("weight as tension", scene, "tension", string, "loaded.carrier")
    assert found == pytest.approx((5.0 + (disc or 0.0)) * G / 2.0)


def test_the_string_of_a_movable_pulley_carries_both_weights() -> None:
    """T = (m₁ + m₂)g, although the blocks move."""
    scene = double_atwood(4.0, 1.0, 3.0)
    string = next(line.name for line in scene.mechanism.lines if line.name != "moved.rope")
    assert size("weight as tension", scene, "tension", string, "moved.carrier") == pytest.approx(4.0 * G)


def test_a_body_on_a_slope_is_not_held_by_its_weight() -> None:
    slip = MISCONCEPTIONS["weight as tension"]
    study = SimulatedScene.of(half_atwood(), np.linspace(0.0, END, 11))
    assert list(slip.subjects(Query("state", Target("acceleration", BLOCK)), study)) == [OTHER]


def test_without_strings_each_falls_or_slides_alone() -> None:
    """The accelerations are g, and g sin 30° on the slope."""
    assert size("strings left out", half_atwood(), "acceleration", OTHER) == pytest.approx(G)
    assert size("strings left out", half_atwood(), "acceleration", "ramp.blocks.0") == pytest.approx(G / 2.0)


def test_half_of_the_distance_is_forgotten() -> None:
    """On a smooth slope of 30°, a = 4.9 m/s²: after 1 s a t² = 4.9 m, with a t = 4.9 m/s."""
    assert size("half forgotten", ramp(), "displacement", "ramp.blocks.0") == pytest.approx(4.9)
    assert size("half forgotten", ramp(), "velocity", "ramp.blocks.0") == pytest.approx(4.9)


def test_the_mean_velocity() -> None:
    """The velocity becomes a t/2, at the distance a t²/2."""
    assert size("mean velocity", ramp(), "velocity", "ramp.blocks.0") == pytest.approx(2.45)
    assert size("mean velocity", ramp(), "displacement", "ramp.blocks.0") == pytest.approx(2.45)


@pytest.mark.parametrize("name", ["half forgotten", "mean velocity"])
def test_what_is_sent_off_has_no_such_distance(name: str) -> None:
    study = SimulatedScene.of(ramp(speed=3.0), np.linspace(0.0, END, 11))
    assert not list(MISCONCEPTIONS[name].subjects(Query("state", Target("velocity", BLOCK)), study))


def test_friction_by_the_whole_weight() -> None:
    """The acceleration is a = g(sin 30° - μ), not g(sin 30° - μ cos 30°)."""
    found = size("weight as normal force", ramp(friction=0.2), "acceleration", "ramp.blocks.0")
    assert found == pytest.approx(0.3 * G)
    assert abs(found - G * (sin(radians(30.0)) - 0.2 * cos(radians(30.0)))) > 0.2


def test_a_movable_pulley_that_is_taken_as_fixed() -> None:
    """The acceleration is that of an Atwood machine below the pulley, (m₂ - m₁)g/(m₁ + m₂)."""
    scene = double_atwood(4.0, 1.0, 3.0)
    found = size("fixed movable pulley", scene, "acceleration", "moved.left.blocks.0")
    assert found == pytest.approx(G / 2.0)


@pytest.mark.parametrize("disc", [None, 2.0])
def test_a_movable_pulley_that_moves_as_far_as_the_string(disc: float | None) -> None:
    """The acceleration is that of an Atwood machine, (M + m - m₁)g/(M + m + m₁), with the mass m of the pulley."""
    load = 5.0 + (disc or 0.0)
    found = size("pulley as string end", bight(2.0, 5.0, disc), "acceleration", "loaded.load")
    assert found == pytest.approx((load - 2.0) * G / (load + 2.0))


def test_a_circle_through_the_starting_point() -> None:
    """From the perihelion at 1/2, with GM = 4π²: T = r^(3/2); the planet is back after T, opposite after T/2."""
    study, _ = orbit().told()
    trace, period = slipped("circular orbit", study, "velocity"), 0.5**1.5
    assert trace.sample(np.array([period])).q == pytest.approx(0.0, abs=1e-9)
    assert trace.sample(np.array([0.5 * period])).q[0] == pytest.approx([-1.0, 0.0], abs=1e-9)
    assert Target("velocity", PLANET).value(trace.at(0.3)) == pytest.approx(2.0 * pi / sqrt(0.5))
    assert Target("acceleration", PLANET).value(trace.at(0.3)) == pytest.approx(4.0 * pi**2 / 0.25)


def test_equal_angles_in_equal_times() -> None:
    """After 1/4 yr it has turned by 90°, to p = a(1 - e²) = 3/4; after 1/2 yr it is at 3/2, with v = r ω."""
    study, _ = orbit().told()
    trace = slipped("uniform angular speed", study, "velocity")
    assert trace.at(0.25).q[0] == pytest.approx([-0.5, 0.75], abs=1e-9)
    assert trace.at(0.5).q[0] == pytest.approx([-2.0, 0.0], abs=1e-9)
    assert Target("velocity", PLANET).value(trace.at(0.5)) == pytest.approx(1.5 * 2.0 * pi)


def test_the_rates_of_a_turn_by_equal_angles_belong_to_its_places() -> None:
    study, _ = orbit(-0.3).told()
    trace, step, times = slipped("uniform angular speed", study, "velocity"), 1e-4, np.linspace(0.1, 0.9, 9)
    before, here, after = (trace.sample(times + shift) for shift in (-step, 0.0, step))
    assert (after.q - before.q) / (2.0 * step) == pytest.approx(here.v, rel=1e-5, abs=1e-5)
    assert (after.v - before.v) / (2.0 * step) == pytest.approx(here.a, rel=1e-5, abs=1e-4)


@pytest.mark.parametrize(
    ("name", "quantity", "expected"),
    [
        ("constant orbital speed", "velocity", 2.0 * pi * sqrt(3.0)),  # that of the perihelion
        ("circular orbit speed", "velocity", 2.0 * pi / sqrt(1.5)),
        ("centripetal acceleration", "acceleration", 0.5 * 4.0 * pi**2 / 1.5**2),  # (1 - e)GM/r²
    ],
)
def test_at_the_aphelion(name: str, quantity: str, expected: float) -> None:
    """The aphelion is r = a(1 + e) = 3/2, half a year after the perihelion at 1/2."""
    study, _ = orbit().told()
    assert Target(quantity, PLANET).value(slipped(name, study, quantity).at(0.5)) == pytest.approx(expected)


@pytest.mark.parametrize("name", ["constant orbital speed", "circular orbit speed"])
def test_what_falls_from_rest_has_no_direction_at_the_start(name: str) -> None:
    """A planet at rest must not give 0/0 at the start, whose warning would fail the test."""
    falling = orbit(-1.0)
    study, _ = Motion(falling.mechanism, falling.mentions, 0.3).told()
    assert Target("velocity", PLANET).value(slipped(name, study, "velocity").at(0.0)) == 0.0


def test_a_movable_disc_whose_rotation_is_forgotten() -> None:
    """a = (m₁ - W/2)g/(2m₁ + W/2), W = M + m, without the term M/4 of the rotation, but with the weight."""
    scene = bight(4.0, 5.0, 2.0)
    found = size("pulley rotation left out", scene, "acceleration", "loaded.load")
    assert found == pytest.approx((4.0 - 3.5) * G / (8.0 + 3.5), rel=1e-5)
    right = Target("acceleration", "loaded.load").value(
        SimulatedScene.of(scene, np.linspace(0.0, END, 5)).trace.at(0.5)
    )
    assert right == pytest.approx((4.0 - 3.5) * G / (8.0 + 3.5 + 0.5))
