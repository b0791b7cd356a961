"""Tests of all quantities against a direct calculation, for a machine in which all kinds of parts move."""

from math import cos, radians, sin

import numpy as np
import pytest

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import X, Y, Z
from sim2reason.scenes.dsl.state import State
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.quantities import QUANTITIES, Quantity
from sim2reason.simulation.quantities.subjects.bodies import Bodies, TurningBodies

G = 9.8
THETA = radians(35.0)
UPHILL, OUTWARD = np.array([cos(THETA), 0.0, sin(THETA)]), np.array([-sin(THETA), 0.0, cos(THETA)])
MU, RADIUS = 0.15, 0.1
NAMES = (
    "acceleration",
    "displacement",
    "friction force",
    "kinetic energy",
    "length",
    "momentum",
    "net force",
    "normal force",
    "potential energy",
    "rate of change of length",
    "tension",
    "velocity",
)


@pytest.fixture(scope="module")
def state() -> State:
    """Return states of a block on a rough movable wedge, tied over its massive pulley to a load, pulled by a hand."""
    builder = Builder()
    room = builder.room()
    wedge = room.body("W", 5.0).rest(X, Z)
    top = tuple(20.0 * UPHILL)
    wheel = wedge.pulley("P", at=(top[0] + RADIUS, 0.0, top[2]), mass=0.8, radius=RADIUS)
    wedge.body("A", 2.0).rest(tuple(UPHILL), tuple(OUTWARD), MU)
    wedge.body("B", 4.0, at=(top[0] + 2 * RADIUS, 0.0, top[2] - 10.0)).slide(Z)
    builder.add_site("A.eye", "A", (0.0, 0.0, 0.0))
    builder.add_site("B.eye", "B", (top[0] + 2 * RADIUS, 0.0, top[2] - 10.0))
    room.string("s", "A.eye", wheel, "B.eye")
    wedge.site("eye")
    room.site("hand", at=(50.0, 0.0, 0.0)).pull("F", "eye", "hand", force=3.0)
    trace = simulate(builder.finish(), np.linspace(0.0, 1.0, 5))
    assert trace.events == ()
    return trace.state


def value(state: State, quantity: str, subject: str) -> np.ndarray:
    return QUANTITIES[quantity].evaluate(state, subject)


def test_the_machine_has_what_turns_no_body_of_the_text_and_bends_no_line() -> None:
    drawn = {name for name, held in QUANTITIES.items() if held.drawn_by_recipes}
    assert {name for name in drawn if QUANTITIES[name].of.name in ("string", "contact")} <= set(NAMES) <= {*QUANTITIES}


@pytest.mark.parametrize("name", NAMES)
def test_shapes_and_subjects(name: str, state: State) -> None:
    found: Quantity = QUANTITIES[name]
    assert found.name == name
    assert type(found).__doc__
    assert found.evaluate.__doc__
    subjects = found.subjects(state.mechanism)
    assert (
        subjects == {"body": ("W", "P", "A", "B"), "string": ("s/1", "s/2", "F"), "contact": ("W", "A")}[found.of.name]
    )
    for subject in subjects:
        result = found.evaluate(state, subject)
        assert result.shape == ((5, 3) if found.vector else (5,))
        assert result.dtype == np.float64
        assert np.isfinite(result).all()


def test_symbols_are_one_letter_and_units_are_si() -> None:
    assert all(len(found.symbol) == 1 for found in QUANTITIES.values())
    for found in QUANTITIES.values():
        unit = parse_unit(found.unit)
        assert unit.factor == 1.0 or found.unit == "deg", "angles that one sees are in degrees"


def test_net_force_is_the_sum_of_forces(state: State) -> None:
    """Newton's second law holds for every body, with the recorded weights, tensions and contact forces."""
    weight = np.array([0.0, 0.0, -G])
    part1, part2 = (value(state, "tension", name)[:, None] for name in ("s/1", "s/2"))
    pull = value(state, "tension", "F")[:, None]
    normal, friction = value(state, "normal force", "A")[:, None], value(state, "friction force", "A")[:, None]
    floor = value(state, "normal force", "W")[:, None] * np.array(Z)
    face = normal * OUTWARD + friction * UPHILL
    block = 2.0 * weight + part1 * UPHILL + face
    assert value(state, "net force", "A") == pytest.approx(block, abs=1e-12)
    load = value(state, "net force", "B")
    assert load[:, 2] == pytest.approx((4.0 * weight + part2 * np.array(Z))[:, 2])
    guide = load[:, :1] * np.array(X)  # what the guide on the wedge adds
    wheel = value(state, "net force", "P")
    axle = wheel - 0.8 * weight + part1 * UPHILL + part2 * np.array(Z)  # of the wedge on the wheel
    wedge = 5.0 * weight + floor - face - guide - axle + pull * np.array(X)
    assert value(state, "net force", "W") == pytest.approx(wedge, abs=1e-12)
    assert value(state, "friction force", "A") == pytest.approx(-MU * normal[:, 0])  # it slides uphill


def test_momentum_and_velocity_are_derivatives(state: State) -> None:
    """With constant accelerations, s = a t²/2, v = a t, p = m v, u = dl/dt."""
    t = state.times[:, None]
    for body, mass in (("W", 5.0), ("P", 0.8), ("A", 2.0), ("B", 4.0)):
        a = value(state, "acceleration", body)
        assert value(state, "velocity", body) == pytest.approx(a * t)
        assert value(state, "displacement", body) == pytest.approx(a * t**2 / 2.0)
        assert value(state, "momentum", body) == pytest.approx(mass * a * t)
        assert value(state, "net force", body) == pytest.approx(mass * a)
    for line in ("s/1", "s/2", "F"):
        rate = value(state, "rate of change of length", line)
        assert value(state, "length", line) == pytest.approx(rate * state.times / 2.0, abs=1e-12)


def test_the_wheel_turns_as_the_string_runs(state: State) -> None:
    """One free part grows as the other shrinks, and K of the wheel is ½ m v² + ½ (m R²/2) ω² with ω = u/R."""
    u = value(state, "rate of change of length", "s/2")
    assert value(state, "length", "s/1") == pytest.approx(-value(state, "length", "s/2"), abs=1e-12)
    speed = value(state, "velocity", "P")
    expected = 0.4 * (speed**2).sum(axis=1) + 0.5 * (0.4 * RADIUS**2) * (u / RADIUS) ** 2
    assert value(state, "kinetic energy", "P") == pytest.approx(expected)


def test_work_and_energy(state: State) -> None:
    """The sum ΔK + ΔU is the work of the hand and of friction along the face."""
    bodies = state.mechanism.body
    energy = sum(value(state, "kinetic energy", body) + value(state, "potential energy", body) for body in bodies)
    hand = 3.0 * value(state, "displacement", "W")[:, 0]
    rubbed = value(state, "friction force", "A") * (
        (value(state, "displacement", "A") - value(state, "displacement", "W")) @ UPHILL
    )
    assert energy == pytest.approx(hand + rubbed)


def test_tension_of_a_slack_string_is_zero() -> None:
    builder = Builder()
    room = builder.room()
    room.site("nail")
    room.body("A", 1.0, at=(0.0, 0.0, -1.0)).slide(Z).site("A.eye")
    builder.add_site("eye", "A", (0.0, 0.0, -1.0))
    room.string("s", "nail", "eye", slack=0.5)
    state = simulate(builder.finish(), np.array([0.0, 0.1, 1.0])).state
    assert value(state, "tension", "s") == pytest.approx([0.0, 0.0, G])
    assert value(state, "length", "s") == pytest.approx([0.0, 0.049, 0.5])


def test_a_light_arm_has_no_centre_of_mass() -> None:
    """The arm turns, but has no velocity to ask about, even if a carriage moves its axle."""
    builder = Builder()
    carriage = builder.room().body("carriage", 2.0).slide(X)
    arm = carriage.body("arm").hinge(Y)
    arm.body("disc", 1.0, at=(0.0, 0.0, -0.5), inertia=(0.1, 0.1, 0.1, 0.0, 0.0, 0.0))
    made, mentions = builder.finish(), {name: f"the {name}" for name in ("carriage", "arm", "disc")}
    assert set(Bodies().phrases(made, mentions)) == {"carriage", "disc"}
    assert set(TurningBodies().phrases(made, mentions)) == {"arm", "disc"}
