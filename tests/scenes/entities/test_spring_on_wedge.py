"""Tests of a block on a spring that oscillates on a freely sliding wedge."""

from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

from sim2reason.datasets.scene_questions import solve
from sim2reason.figures.drawing import drawing
from sim2reason.figures.shapes import Area, LineShape
from sim2reason.scenes.files import dump, loads
from sim2reason.simulation.scenes import certify
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose import describe

G, BIG, SMALL, STIFF, SLOPE = 9.8, 3.0, 2.0, 100.0, radians(30.0)
RATE = sqrt(STIFF * (BIG + SMALL) / (SMALL * (BIG + SMALL * sin(SLOPE) ** 2)))
MIDDLE = 0.5 - SMALL * G * sin(SLOPE) / STIFF
PARAMETERS = "wedge: {mass: 3.0, angle: 30.0}, block: {mass: 2.0}, spring: {stiffness: 100.0, length: 0.5}, start: 0.6"
SCENE = loads(f"scene: {{entities: [{{name: it, type: SpringOnWedge, parameters: {{{PARAMETERS}}}}}]}}")


def test_the_motion_is_harmonic() -> None:
    """The motion has ω² = k (M + m)/(m (M + m sin² θ)) about ℓ₀ − m g sin θ/k, with zero total momentum."""
    trace, certificate = certify(SCENE, duration=2.0)
    assert certificate.stable_until == 2.0, certificate.reason
    turn = RATE * trace.state.times
    along = (0.6 - MIDDLE) * (np.cos(turn) - 1.0)
    assert trace.state.q[:, 1] == pytest.approx(along, abs=1e-9)
    assert trace.state.q[:, 0] == pytest.approx(-SMALL * cos(SLOPE) / (BIG + SMALL) * along, abs=1e-9)


def test_it_is_told_read_back_and_written_to_a_file() -> None:
    """Every wording is read back."""
    assert loads(dump(SCENE)) == SCENE
    for seed in range(5):
        text = describe(SCENE, seed).text
        assert parse_scene(text).scene.entities[0].entity == SCENE.entities[0].entity, text


@pytest.mark.parametrize(
    ("find", "of", "when", "answer"),
    [
        ("period", "it.block", "", 2.0 * pi / RATE),
        ("greatest speed", "it.wedge", "1 s", SMALL * cos(SLOPE) / (BIG + SMALL) * RATE * (0.6 - MIDDLE)),
        ("acceleration", "it.wedge", "", SMALL * cos(SLOPE) / (BIG + SMALL) * RATE**2 * (0.6 - MIDDLE)),
    ],
)
def test_it_is_asked_about_and_solved(find: str, of: str, when: str, answer: float) -> None:
    """Answers agree with the closed form of the motion."""
    found = solve(SCENE, find=find, of=of, when=when)
    assert found.answer == pytest.approx(answer, rel=1e-8)
    if find != "period":
        assert found.solution.text, found.solution.reason


def test_a_figure_shows_the_spring_on_the_face() -> None:
    """The spring does not extend beyond the foot of the wedge."""
    shown = drawing(SCENE, describe(SCENE))
    wedge = next(shape for shape in shown.shapes if isinstance(shape, Area) and shape.fill == "wedge")
    coil = max((s.points for s in shown.shapes if isinstance(s, LineShape)), key=len)
    assert min(p.real for p in wedge.points) < min(p.real for p in coil)
    assert min(p.imag for p in wedge.points) < min(p.imag for p in coil)
