"""Tests of two blocks on a stepped pulley, against the closed form of their acceleration."""

import pytest

from sim2reason.datasets.scene_questions import solve
from sim2reason.errors import SceneError
from sim2reason.figures.drawing import drawing
from sim2reason.figures.shapes import Arc, LineShape
from sim2reason.scenes.bodies.simple_machines import SteppedPulley
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pulleys import BlocksOnSteppedPulley
from sim2reason.scenes.files import dump, loads
from sim2reason.simulation.scenes import certify
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose import describe

G, OUTER, INNER, INERTIA, BIG, SMALL = 9.8, 0.3, 0.1, 0.2, 2.0, 3.0
SIDES = {"opposite": -1.0, "same": 1.0}


def scene(sides: str) -> Scene:
    """Build a scene whose blocks hang on opposite sides of the axle, or on the same side."""
    pulley = f"{{outer: {OUTER}, inner: {INNER}, inertia: {INERTIA}}}"
    parameters = f"pulley: {pulley}, outer_block: {{mass: {BIG}}}, inner_block: {{mass: {SMALL}}}, sides: {sides}"
    return loads(f"scene: {{entities: [{{name: it, type: BlocksOnSteppedPulley, parameters: {{{parameters}}}}}]}}")


def turning(sides: str) -> float:
    """Return the angular acceleration α = (M R ± m r) g/(I + M R² + m r²) in rad/s²."""
    return (BIG * OUTER + SIDES[sides] * SMALL * INNER) * G / (INERTIA + BIG * OUTER**2 + SMALL * INNER**2)


@pytest.mark.parametrize("sides", SIDES)
def test_both_engines_turn_it_as_the_torques_do(sides: str) -> None:
    """The accelerations are R α and ± r α, the tensions M (g − R α) and m (g ∓ r α)."""
    trace, certificate = certify(scene(sides), duration=0.5)
    assert certificate.stable_until == 0.5, certificate.reason
    alpha, sign = turning(sides), SIDES[sides]
    assert abs(trace.state.a[-1]) == pytest.approx([alpha, OUTER * alpha, INNER * alpha], rel=1e-10)
    assert trace.state.tension["it.outer_string"] == pytest.approx(BIG * (G - OUTER * alpha), rel=1e-10)
    assert trace.state.tension["it.inner_string"] == pytest.approx(SMALL * (G - sign * INNER * alpha), rel=1e-10)


@pytest.mark.parametrize("sides", SIDES)
def test_it_is_told_read_back_and_written_to_a_file(sides: str) -> None:
    """Every wording is read back; none states the lengths of the strings."""
    own = scene(sides)
    assert loads(dump(own)) == own
    for seed in range(6):
        text = describe(own, seed).text
        read = parse_scene(text).scene.entities[0].entity
        assert isinstance(read, BlocksOnSteppedPulley)
        lengths = {"outer_length": read.outer_length, "inner_length": read.inner_length}
        assert own.entities[0].entity.model_copy(update=lengths) == read, text


@pytest.mark.parametrize("sides", SIDES)
@pytest.mark.parametrize(
    ("find", "of", "when", "per_alpha"),
    [
        ("acceleration", "it.outer_block", "", OUTER),
        ("acceleration", "it.inner_block", "", INNER),
        ("angular acceleration", "it.pulley", "", 1.0),
        ("angular velocity", "it.pulley", "0.4 s", 0.4),
        ("velocity", "it.inner_block", "0.4 s", 0.4 * INNER),
    ],
)
def test_it_is_asked_about_and_solved(sides: str, find: str, of: str, when: str, per_alpha: float) -> None:
    """The solution uses Newton's second law for each block and the torque on the pulley."""
    found = solve(scene(sides), find=find, of=of, when=when)
    assert found.answer == pytest.approx(per_alpha * turning(sides), rel=1e-10)
    assert "Torque on the stepped pulley, whose moment of inertia is $I$" in found.solution.text, found.solution.reason


def test_a_tension_is_solved() -> None:
    """The tension on the rising block is m (g + r α)."""
    question = "What is the tension in the string between the stepped pulley and block B 0.4 s after release?"
    found = solve(scene("opposite"), question=question)
    assert found.answer == pytest.approx(SMALL * (G + INNER * turning("opposite")), rel=1e-10)
    assert "Torque" in found.solution.text, found.solution.reason


def test_the_outer_radius_is_the_larger_one() -> None:
    with pytest.raises((SceneError, ValueError), match="not greater than inner"):
        SteppedPulley(outer=0.1, inner=0.1, inertia=0.2)


def test_a_figure_shows_two_rims_and_a_string_from_each() -> None:
    """The strings end at the rims and nowhere else."""
    own = scene("opposite")
    shapes = drawing(own, describe(own)).shapes
    outer, inner = sorted((s for s in shapes if isinstance(s, Arc)), key=lambda s: -s.radius)[:2]
    assert outer.center == inner.center
    assert outer.radius == pytest.approx(OUTER / INNER * inner.radius)
    tops = sorted(s.points[0].real for s in shapes if isinstance(s, LineShape) and s.weight == "string")
    assert tops == pytest.approx([outer.center.real - outer.radius, outer.center.real + inner.radius])
