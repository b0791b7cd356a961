"""Tests of electric fields that oscillate with an initial phase."""

from cmath import exp
from math import cos, pi, radians, sin

import pytest

from sim2reason.datasets.scene_questions import solve
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import dump, loads
from sim2reason.simulation.scenes import certify
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose import describe

RATE, PULL = 2.0, 1.5 * 1.2 / 2.0  # rad/s and q E₀/m


def bead(phase: float | None, beside: str = "") -> Scene:
    """Build a bead released in a field with a phase, and optionally in another field or a medium (`beside`)."""
    field = "kind: oscillating_electric, strength: 1.2, way: positive x, frequency: 2.0"
    field += f", phase: {phase}" if phase is not None else ""
    start = "particle: {mass: 2.0, charge: 1.5, sign: positive}, start: {kind: released}"
    return loads(
        f"scene: {{entities: [{{name: it, type: EmEntity, parameters: {{{start}, electric: {{{field}}}{beside}}}}}]}}"
    )


@pytest.mark.parametrize("phase", [-90.0, 30.0, 120.0])
def test_the_bead_moves_by_the_double_integral_of_a_cosine(phase: float) -> None:
    """Both engines find x = (q E₀/m ω²)(cos φ − cos(ωt + φ) − ωt sin φ)."""
    trace, certificate = certify(bead(phase), duration=4.0)
    assert certificate.stable_until == 4.0, certificate.reason
    turn, phi, size = RATE * trace.state.times, radians(phase), PULL / RATE**2
    wanted = [size * (cos(phi) - cos(t + phi) - t * sin(phi)) for t in turn]
    assert trace.state.q[:, 0] == pytest.approx(wanted, abs=1e-9 * size)


def test_it_is_told_and_read_back() -> None:
    """The text states the phase instead of the field's being greatest at the start."""
    held = bead(30.0)
    assert loads(dump(held)) == held
    for seed in range(4):
        text = describe(held, seed).text
        assert "phase" in text
        assert "30°" in text
        assert parse_scene(text).scene.entities[0].entity == held.entities[0].entity, text
    assert "phase" not in describe(bead(None)).text


def test_it_is_asked_about() -> None:
    """The speed is greatest after a quarter of a period without a phase, and after half of one with −90°."""
    for phase, when in ((None, 0.25), (-90.0, 0.5)):
        found = solve(bead(phase), find="greatest speed", when=f"{2.0 * pi / RATE * when:.12f} s")
        wanted = PULL / RATE * (1.0 if phase is None else 2.0)
        assert found.answer == pytest.approx(wanted, rel=1e-9)


def closed_form(find: str, time: float, phi: float) -> float:
    """Return an integral of cos(ωt + φ) from rest, for unit acceleration."""
    turn = RATE * time + phi
    return {
        "acceleration": cos(turn),
        "speed": (sin(turn) - sin(phi)) / RATE,
        "displacement": (cos(phi) - cos(turn)) / RATE**2 - time * sin(phi) / RATE,
    }[find]


@pytest.mark.parametrize("phase", [-90.0, 30.0, 120.0])
@pytest.mark.parametrize("find", ["acceleration", "speed", "displacement"])
def test_it_is_solved_in_closed_form(phase: float, find: str) -> None:
    """No step of the solution integrates numerically."""
    found = solve(bead(phase), find=find, of="it.particle", when="1 s")
    assert found.answer == pytest.approx(abs(PULL * closed_form(find, 1.0, radians(phase))), rel=1e-9)
    assert r"\varphi" in found.solution.text, found.solution.reason
    assert "umerical" not in found.solution.text


def test_the_first_acceleration_is_solved_in_closed_form() -> None:
    """The initial acceleration is (q E₀/m) cos φ."""
    found = solve(bead(30.0), find="acceleration", of="it.particle")
    assert found.answer == pytest.approx(PULL * cos(radians(30.0)), rel=1e-9)
    assert r"\cos\varphi" in found.solution.text, found.solution.reason


def test_the_greatest_speed_is_solved_in_closed_form() -> None:
    """The speed is (q E₀/m ω)(1 + sin φ) where ωt + φ is an odd multiple of 90°."""
    found = solve(bead(30.0), find="greatest speed", of="it.particle", when="2.5 s")
    assert found.answer == pytest.approx(1.5 * PULL / RATE, rel=1e-9)
    assert "passes through zero" in found.solution.text, found.solution.reason


def in_a_magnetic_field(time: float, phi: float, turn: float) -> float:
    """Return |w| from ẇ = −iΩw + cos(ωt + φ), starting from rest, for unit acceleration."""
    waves = ((RATE, exp(1j * phi)), (-RATE, exp(-1j * phi)))
    return abs(sum(0.5 * way * (exp(1j * w * time) - exp(-1j * turn * time)) / (1j * (turn + w)) for w, way in waves))


def in_a_medium(time: float, phi: float, decay: float) -> float:
    """Return |v| from v̇ = −γv + cos(ωt + φ), starting from rest, for unit acceleration."""
    return abs((exp(1j * phi) * (exp(1j * RATE * time) - exp(-decay * time)) / (decay + 1j * RATE)).real)


@pytest.mark.parametrize(
    ("beside", "speed"),
    [
        ("magnetic: {kind: uniform_magnetic, strength: 0.5, way: positive z}", in_a_magnetic_field(1.2, pi / 6, 0.375)),
        ("medium: {kind: linear_drag, coefficient: 3.0}", in_a_medium(1.2, pi / 6, 1.5)),
    ],
)
def test_a_phase_beside_a_magnetic_field_or_a_medium_is_solved(beside: str, speed: float) -> None:
    """The solution starts from equations of motion with the phase and agrees with the closed form."""
    found = solve(bead(30.0, f", {beside}"), find="velocity", of="it.particle", when="1.2 s")
    assert found.answer == pytest.approx(PULL * speed, rel=1e-8)
    assert r"\varphi" in found.solution.text, found.solution.reason
