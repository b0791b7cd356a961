"""Tests of bodies in contact at the start: Newton's cradle, a rack of discs, a block against a wall."""

from math import sqrt

import pytest

from sim2reason.datasets.scene_questions import solve
from sim2reason.errors import SceneError
from sim2reason.figures.drawing import drawing
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import dump, loads
from sim2reason.simulation.scenes import certify
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose import describe

V = 2.0


def scene(kind: str, parameters: str) -> Scene:
    """Return a scene with one entity."""
    return loads(f"scene: {{entities: [{{name: it, type: {kind}, parameters: {{{parameters}}}}}]}}")


def discs(count: int, e: float = 1.0, masses: tuple[float, ...] = (1.0,) * 5) -> Scene:
    """Build a disc that runs into a row of discs in contact."""
    rows = zip(masses, (-1.0, 0.0, 0.2, 0.4, 0.6), (V, 0.0, 0.0, 0.0, 0.0), strict=True)
    pucks = [f"{{mass: {m}, x: {x}, y: 0.0, vx: {v}, vy: 0.0}}" for m, x, v in rows][:count]
    return scene("TwoDCollisionPlane", f"table: {{}}, radius: 0.1, restitution: {e}, pucks: [{', '.join(pucks)}]")


def carts(count: int, e: float = 1.0, wall: str = "") -> Scene:
    """Build a cart that runs into a row of carts in contact, the last possibly against a wall."""
    rows = [
        f"{{kind: glider, mass: 1.0, x: {-1.0 if i == 0 else 0.0}, v: {V if i == 0 else 0.0}}}" for i in range(count)
    ]
    return scene("ComplexCollisionPlane", f"track: {{}}, restitution: {e}, gliders: [{', '.join(rows)}]{wall}")


def rack() -> Scene:
    """Build a disc that runs into the middle of two discs in contact."""
    half, gap = 0.1, 0.1 * sqrt(3.0)
    pucks = [
        f"{{mass: 1.0, x: {-gap - 1.0}, y: 0.0, vx: {V}, vy: 0.0}}",
        f"{{mass: 1.0, x: 0.0, y: {half}, vx: 0.0, vy: 0.0}}",
        f"{{mass: 1.0, x: 0.0, y: {-half}, vx: 0.0, vy: 0.0}}",
    ]
    return scene("TwoDCollisionPlane", f"table: {{}}, radius: 0.1, restitution: 1.0, pucks: [{', '.join(pucks)}]")


CRADLES = [
    (discs(3), [0.0, 0.0, V]),
    (discs(4), [0.0, 0.0, 0.0, V]),
    (discs(5), [0.0, 0.0, 0.0, 0.0, V]),
    (discs(3, masses=(1.0, 2.0, 1.0, 1.0, 1.0)), [-V / 3.0, 2.0 / 9.0 * V, 8.0 / 9.0 * V]),
    (discs(3, 0.5), [0.203125 * V, 0.234375 * V, 0.5625 * V]),
    (carts(4), [0.0, 0.0, 0.0, V]),
    (carts(3, 0.5), [0.203125 * V, 0.234375 * V, 0.5625 * V]),
    (carts(3, wall=", right: 0.0"), [-V, 0.0, 0.0]),
]


@pytest.mark.parametrize(("held", "wanted"), CRADLES)
def test_collisions_pass_from_pair_to_pair(held: Scene, wanted: list[float]) -> None:
    """All pairs collide one after the other at the same instant, with u' = u (m − e M)/(m + M)."""
    trace, certificate = certify(held, duration=1.0)
    assert certificate.stable_until == 1.0, certificate.reason
    slides = [number for number, c in enumerate(trace.mechanism.coordinates) if c.label != "y"]
    assert trace.state.v[-1, slides] == pytest.approx(wanted, abs=1e-9)
    assert len({round(event.time, 9) for event in trace.events if event.kind == "collision"}) == 1


def test_two_that_are_hit_at_once_take_part_at_once() -> None:
    """The first disc rebounds with a fifth of its speed; the others move off along the lines of centres."""
    trace, certificate = certify(rack(), duration=1.0)
    assert certificate.stable_until == 1.0, certificate.reason
    size = 2.0 * sqrt(3.0) / 5.0 * V
    wanted = [-V / 5.0, 0.0, size * sqrt(0.75), size * 0.5, size * sqrt(0.75), -size * 0.5]
    assert trace.state.v[-1] == pytest.approx(wanted, abs=1e-8)


@pytest.mark.parametrize("held", [held for held, _ in CRADLES] + [rack()])
def test_they_are_told_read_back_and_drawn(held: Scene) -> None:
    """The text says that the bodies touch."""
    assert loads(dump(held)) == held
    for seed in range(3):
        text = describe(held, seed).text
        assert "touch" in text
        assert parse_scene(text).scene.entities[0].entity == held.entities[0].entity, text
    assert drawing(held, describe(held)).shapes


@pytest.mark.parametrize(("held", "name"), [(discs(5), "pucks.4"), (carts(4), "gliders.3")])
def test_they_are_solved_in_steps(held: Scene, name: str) -> None:
    """The solution takes one pair after the other, each with the equations of its collision."""
    found = solve(held, find="speed", of=f"it.{name}", when="1 s")
    assert found.answer == pytest.approx(V)
    assert found.solution.text, found.solution.reason


def test_what_overlaps_is_refused() -> None:
    pucks = "{mass: 1.0, x: 0.0, y: 0.0, vx: 1.0, vy: 0.0}, {mass: 1.0, x: 0.19, y: 0.0, vx: 0.0, vy: 0.0}"
    with pytest.raises(SceneError, match="overlap; move them apart by two radii or more"):
        scene("TwoDCollisionPlane", f"table: {{}}, radius: 0.1, restitution: 1.0, pucks: [{pucks}]")
