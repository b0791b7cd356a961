"""Tests of real rockets, moons and electrons, whose numbers are far from those drawn for problems."""

from math import cos, log, pi, sin, sqrt

import numpy as np
import pytest

from sim2reason.datasets.scene_questions import solve
from sim2reason.scenes.dsl.measures import Measure
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import dump, loads
from sim2reason.simulation.scenes import certify, simulate
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose import describe

MASS, CHARGE = 9.109e-31, 1.602e-19  # kg and C, of an electron
SPEED, FIELD = 1e7, 1e-3
G, MOON, LOW = 4.0 * pi**2, 3.69e-8, 1.25e-5  # au³/(Msun yr²), Msun, au


def scene(kind: str, parameters: str) -> Scene:
    """Return a scene with one entity."""
    return loads(f"scene: {{entities: [{{name: it, type: {kind}, parameters: {{{parameters}}}}}]}}")


def electron(rest: str) -> Scene:
    """Build an electron in electric and magnetic fields."""
    return scene("EmEntity", f"particle: {{mass: 9.109e-25, charge: 1.602e-13, sign: negative}}, {rest}")


TURNING = electron(
    f"start: {{kind: launched, speed: {SPEED}, angle: 0.0}}, "
    f"magnetic: {{kind: uniform_magnetic, strength: {FIELD}, way: positive z}}"
)
DRIVEN = electron(
    "start: {kind: released}, electric: {kind: uniform_electric, strength: 1000.0, way: positive x}",
)
ORBITER = scene(
    "SolarSystem",
    f"star: {{mass: {MOON}}}, planets: [{{kind: planet, x: {LOW}, y: 0.0, vx: 0.0, vy: {sqrt(G * MOON / LOW)}}}]",
)
STAGE = "rocket: {mass: 2.97e6, dry: 8.1e5}, exhaust: 2.58, rate: 13300.0"
ROCKET = scene("RocketEntity", f"{STAGE}, place: {{kind: level_ground}}")
FROM_EARTH = scene("RocketEntity", f"{STAGE}, place: {{kind: airless_planet, radius: 6371.0, gravity: 9.81}}")


@pytest.mark.parametrize("held", [TURNING, DRIVEN, ORBITER, ROCKET, FROM_EARTH])
def test_they_are_written_told_and_read_back(held: Scene) -> None:
    """Very small and very large numbers have a power of ten and a unit without prefix."""
    assert loads(dump(held)) == held
    for seed in range(3):
        text = describe(held, seed).text
        assert parse_scene(text).scene.entities[0].entity == held.entities[0].entity, text
        assert "e\N{MINUS SIGN}" not in text
    assert "9.109 × 10^−31 kg" in describe(TURNING).text


@pytest.mark.parametrize(
    ("value", "unit", "said"),
    [
        (9.109e-25, "mg", "9.109 × 10^\N{MINUS SIGN}31 kg"),
        (1e7, "m/s", "1.0 × 10^7 m/s"),
        (-1.25e-5, "au", "\N{MINUS SIGN}1.25 × 10^\N{MINUS SIGN}5 au"),
        (2.97e6, "kg", "2970000 kg"),
        (2.0, "kg", "2.0 kg"),
    ],
)
def test_tiny_and_vast_numbers_are_said_with_a_power_of_ten(value: float, unit: str, said: str) -> None:
    """Other numbers are printed without one."""
    assert Measure("size", unit, "x").say(value) == said


def test_an_electron_turns_in_a_magnetic_field() -> None:
    """The radius of the circle is m v/(q B); the simulation covers about one turn."""
    rate = CHARGE * FIELD / MASS
    trace = simulate(TURNING)
    times, radius = trace.state.times, SPEED / rate
    assert 1.0 < rate * float(times[-1]) < 10.0
    for place, wanted in zip(trace.state.q[1:], rate * times[1:], strict=True):
        assert place == pytest.approx([radius * sin(wanted), radius * (1.0 - cos(wanted))], abs=1e-8 * radius)


PROTON = scene(
    "EmEntity",
    "particle: {mass: 1.673e-21, charge: 1.602e-13, sign: positive}, "
    "start: {kind: launched, speed: 3.0e5, angle: 90.0}, "
    "electric: {kind: uniform_electric, strength: 2000.0, way: positive x}, "
    "magnetic: {kind: uniform_magnetic, strength: 0.02, way: positive z}",
)


@pytest.mark.parametrize("held", [TURNING, DRIVEN, PROTON])
def test_both_engines_follow_electrons_and_protons(held: Scene) -> None:
    """The engines agree to the end, at accelerations of 10^15 m/s² and masses of 10^−31 kg."""
    trace, certificate = certify(held)
    assert certificate.stable_until == trace.state.times[-1] == pytest.approx(held.horizon), certificate.reason
    assert certificate.agreement
    assert max(certificate.agreement.values()) < 1e-6


def test_the_second_engine_turns_an_electron_by_itself() -> None:
    """The circle has the radius m v/(q B), and the states are in SI units."""
    rate = CHARGE * FIELD / MASS
    trace = simulate(TURNING, engine="mujoco")
    radius, turned = SPEED / rate, rate * trace.state.times
    assert trace.state.q[:, 0] == pytest.approx(radius * np.sin(turned), abs=1e-7 * radius)
    assert trace.state.v[:, 1] == pytest.approx(SPEED * np.sin(turned), abs=1e-6 * SPEED)
    assert trace.state.a[:, 1] == pytest.approx(SPEED * rate * np.cos(turned), abs=1e-6 * SPEED * rate)
    half = trace.sample(np.array([pi / rate])).q[0]
    assert half == pytest.approx([0.0, 2.0 * radius], abs=1e-7 * radius)


def test_an_electron_in_an_electric_field_is_followed_while_newton_holds() -> None:
    """The acceleration is a = e E/m, and the horizon ends at 3e7 m/s."""
    pull = CHARGE * 1000.0 / MASS
    assert pull * DRIVEN.horizon == pytest.approx(3e7)
    found = solve(DRIVEN, find="speed", when="1e-8 s")
    assert found.answer == pytest.approx(pull * 1e-8, rel=1e-9)
    assert r"9.109 \times 10^{-25}" in found.solution.text, found.solution.reason


def test_a_probe_circles_the_moon() -> None:
    """Both engines find the period 2π √(r³/GM)."""
    trace, certificate = certify(ORBITER)
    assert certificate.stable_until == trace.state.times[-1] == pytest.approx(2.4 * pi * sqrt(LOW**3 / (G * MOON)))
    found = solve(ORBITER, find="time", when="orbited 360°").answer
    assert found == pytest.approx(2.0 * pi * sqrt(LOW**3 / (G * MOON)), rel=1e-8)


def test_a_real_rocket_burns_out() -> None:
    """Both engines find the speed u ln(m₀/m₁) − g t at burn-out."""
    trace, certificate = certify(ROCKET)
    assert certificate.stable_until == trace.state.times[-1]
    wanted = 2580.0 * log(2.97e6 / 8.1e5) - 9.8 * (2.97e6 - 8.1e5) / 13300.0
    found = solve(ROCKET, find="speed", when="burned out")
    assert found.answer == pytest.approx(wanted, rel=1e-8)
    assert found.solution.text
