"""Tests of walls around a table on which discs slide."""

from math import hypot, radians, sin, sqrt

import pytest

from sim2reason.datasets.scene_questions import solve
from sim2reason.errors import SceneError
from sim2reason.figures.drawing import drawing
from sim2reason.figures.shapes import LineShape
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import dump, loads
from sim2reason.simulation.scenes import certify
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose import describe

E = 0.8


def table(walls: str, tilt: float = 0.0) -> Scene:
    """Build a disc of radius 0.1 m that leaves the origin with (2, 1) m/s, and another at rest far away."""
    pucks = "{mass: 1.0, x: 0.0, y: 0.0, vx: 2.0, vy: 1.0}, {mass: 1.0, x: -1.0, y: -1.0, vx: 0.0, vy: 0.0}"
    parameters = f"table: {{angle: {tilt}}}, radius: 0.1, restitution: {E}, pucks: [{pucks}], {walls}"
    return loads(f"scene: {{entities: [{{name: it, type: TwoDCollisionPlane, parameters: {{{parameters}}}}}]}}")


CORNER = table("right: 1.1, top: 0.85")


def test_a_disc_rebounds_from_each_wall_it_meets() -> None:
    """The rim hits the walls after (1.1 − 0.1)/2 s and (0.85 − 0.1)/1 s; the normal velocity changes by −e."""
    trace, certificate = certify(CORNER, duration=2.0)
    assert certificate.stable_until == 2.0, certificate.reason
    assert [event.time for event in trace.events] == pytest.approx([0.5, 0.75], rel=1e-9)
    assert trace.state.v[-1] == pytest.approx([-2.0 * E, -E, 0.0, 0.0], abs=1e-9)


def test_walls_on_all_sides_of_a_tilted_table() -> None:
    """Both engines agree up to the given time, before a disc comes to rest on the lower wall."""
    trace, certificate = certify(table("left: -1.5, right: 1.1, bottom: -1.5, top: 0.85", tilt=10.0), duration=0.7)
    assert certificate.stable_until == trace.stable_until == 0.7, certificate.reason


@pytest.mark.parametrize("held", [CORNER, table("left: -1.5, bottom: -1.5", tilt=10.0)])
def test_they_are_told_read_back_and_drawn(held: Scene) -> None:
    """The text has a sentence for each wall, and the figure an edge."""
    assert loads(dump(held)) == held
    for seed in range(4):
        text = describe(held, seed).text
        assert text.count("wall") == 2
        assert parse_scene(text).scene.entities[0].entity == held.entities[0].entity, text
    edges = [s for s in drawing(held, describe(held)).shapes if isinstance(s, LineShape) and s.weight == "edge"]
    assert len(edges) == 2


CHASED = "{mass: 2.0, x: -1.0, y: -1.0, vx: 0.1, vy: -0.3}"


def moving(walls: str, tilt: float = 0.0) -> Scene:
    """Build the disc of `table`, with another one that slides away from it."""
    pucks = f"{{mass: 1.0, x: 0.0, y: 0.0, vx: 2.0, vy: 1.0}}, {CHASED}"
    parameters = f"table: {{angle: {tilt}}}, radius: 0.1, restitution: {E}, pucks: [{pucks}], {walls}"
    return loads(f"scene: {{entities: [{{name: it, type: TwoDCollisionPlane, parameters: {{{parameters}}}}}]}}")


@pytest.mark.parametrize(
    ("find", "when", "answer"),
    [
        ("velocity", "1 s", hypot(2.0 * E, E)),
        ("displacement", "1 s", hypot(1.0 - 2.0 * E * 0.5, 0.75 - E * 0.25)),
        ("kinetic energy", "0.6 s", 0.5 * (4.0 * E**2 + 1.0)),
    ],
)
@pytest.mark.parametrize("held", [CORNER, moving("right: 1.1, top: 0.85")])
def test_what_rebounds_from_walls_is_solved_in_steps(held: Scene, find: str, when: str, answer: float) -> None:
    """The solution takes one wall after the other, and excludes any earlier collision."""
    found = solve(held, find=find, of="it.pucks.0", when=when)
    assert found.answer == pytest.approx(answer, rel=1e-9)
    assert "hits the right wall when $x_W - R = v_{x,A} t_1$" in found.solution.text, found.solution.reason
    assert "far wall" in found.solution.text


def test_a_wall_up_the_slope_is_solved_in_steps() -> None:
    """At s = v t − ½ g t² sin β = 0.75 m the velocity v − g t sin β up the slope changes by the factor −e."""
    held = moving("right: 1.1, top: 0.4, left: -5.0", tilt=5.0)
    slope = 9.8 * sin(radians(5.0))
    time = (1.0 - sqrt(1.0 - 2.0 * slope * 0.3)) / slope
    found = solve(held, find="velocity", of="it.pucks.0", when="0.45 s")
    across, along = 2.0, -E * (1.0 - slope * time) - slope * (0.45 - time)
    assert found.answer == pytest.approx(hypot(across, along), rel=1e-9)
    assert "hits the upper wall" in found.solution.text, found.solution.reason


def test_a_wall_down_the_slope_is_solved_in_steps() -> None:
    """The disc rebounds up the slope, and returns to the wall only after the asked time."""
    slope = 9.8 * sin(radians(5.0))
    pucks = "{mass: 1.0, x: 0.0, y: 0.0, vx: 0.2, vy: -1.0}, {mass: 2.0, x: -1.0, y: 1.0, vx: 0.1, vy: 0.3}"
    parameters = f"table: {{angle: 5.0}}, radius: 0.1, restitution: {E}, pucks: [{pucks}], bottom: -0.5"
    held = loads(f"scene: {{entities: [{{name: it, type: TwoDCollisionPlane, parameters: {{{parameters}}}}}]}}")
    found = solve(held, find="velocity", of="it.pucks.0", when="0.6 s")
    hit = sqrt(1.0 + 2.0 * slope * 0.4)
    along = E * hit - slope * (0.6 - (hit - 1.0) / slope)
    assert found.answer == pytest.approx(hypot(0.2, along), rel=1e-9)
    assert "It would hit the wall again only" in found.solution.text, found.solution.reason
    assert "in the air" not in found.solution.text


@pytest.mark.parametrize("walls", ["right: 0.05", "left: 0.0", "top: -0.5", "bottom: -1.05"])
def test_no_disc_is_in_a_wall(walls: str) -> None:
    """An overlap is refused with an error message."""
    with pytest.raises(SceneError, match="a puck is in the wall or beyond it"):
        table(walls)
