"""Contract tests of the drawings of every body, entity and connection."""

from collections.abc import Callable
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from pydantic import ValidationError

from figure_parts import RodPendulum, Slider, scene_of
from sim2reason.errors import SceneError
from sim2reason.figures import canvas
from sim2reason.figures.drawing import drawing
from sim2reason.figures.plane import overlap_area
from sim2reason.figures.scaled.lines import PIVOT
from sim2reason.figures.shapes import Arc, Area, Drawing, LineShape, Shape, outline
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import Ball, LightRod
from sim2reason.scenes.dsl.body import BODIES, BodyLook
from sim2reason.scenes.dsl.choices import choices, close_ports
from sim2reason.scenes.dsl.connection import CONNECTIONS, Connection, Link
from sim2reason.scenes.dsl.entity import ENTITIES, Named, outer_ports
from sim2reason.scenes.dsl.model import draw
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.string_ends import FixedSupport
from sim2reason.text.prose.description import describe

TRIES = 60


def one(kind: str, seed: int) -> Scene:
    """Return a random scene of an entity whose ports are closed by available entities."""
    for attempt in range(TRIES):
        rng = np.random.default_rng([seed, attempt])
        try:
            entity = draw(ENTITIES[kind], rng, choices(ENTITIES[kind], rng))
            scene = close_ports(Named(name="it", entity=entity), rng)
            scene.check()
        except (SceneError, ValidationError):
            continue
        return scene
    raise AssertionError(f"nothing valid in {TRIES} draws of {kind}")


def check(scene: Scene, drawn: Drawing) -> None:
    """Check that labels have the text's names and do not overlap, and that all shapes lie on the canvas."""
    names = describe(scene).names
    for address, body in scene.bodies.items():
        if body.letters:
            wanted = names.letters.get(address, "") or names.noun(body)
            texts = [label.text for label in drawn.labels if label.subject == address and label.name]
            assert len(texts) == 1
            assert texts[0] == wanted or texts[0].startswith(f"{wanted} (")
    for a, b in combinations(drawn.labels, 2):
        smaller = min((box[2] - box[0]) * (box[3] - box[1]) for box in (a.box, b.box))
        assert overlap_area(a.box, b.box) <= 0.02 * smaller, (a, b)
    left, low, right, high = drawn.box()
    assert 0.5 < right - left < 45.0
    assert 0.5 < high - low < 45.0
    for shape in drawn.shapes:
        assert all(left <= p.real <= right and low <= p.imag <= high for p in outline(shape))


@pytest.mark.parametrize("name", BODIES)
def test_every_body_declares_its_look(name: str) -> None:
    look = BODIES[name].look
    assert isinstance(look, property)
    held = draw(BODIES[name], np.random.default_rng(1), {"mass?": 1.0})
    assert isinstance(held.look, BodyLook)


@pytest.mark.parametrize("seeds", [1, pytest.param(4, marks=pytest.mark.slow)])
@pytest.mark.parametrize("name", ENTITIES)
def test_every_entity_is_drawn(name: str, seeds: int, tmp_path: Path) -> None:
    for seed in range(seeds):
        scene = one(name, seed)
        drawn = drawing(scene, numbers=seed % 2 == 1)
        check(scene, drawn)
        if seed == 0:
            paths = [tmp_path / f"{n}.svg" for n in range(2)]
            for path in paths:
                canvas.draw(drawing(scene, numbers=False), path)
            assert paths[0].read_bytes() == paths[1].read_bytes()


MARKS: dict[str, Callable[[Shape], bool]] = {
    "string": lambda s: isinstance(s, LineShape) and s.weight == "string",
    "spring": lambda s: isinstance(s, LineShape) and len(s.points) > 6,
    "rod": lambda s: isinstance(s, LineShape) and s.weight == "rod",
    "pivot": lambda s: isinstance(s, Arc) and s.radius == PIVOT,
    "weld": lambda s: isinstance(s, Area) and s.fill == "ink",
}


def joined_by(kind: type[Connection]) -> Scene:
    """Return two entities joined by a connection of a kind."""
    rod = RodPendulum(bob=Ball(mass=1.0), rod=LightRod(length=1.2))
    slider = Slider(carriage=Block(mass=2.0))
    pairs = [(slider, "pivot", rod, "top"), (slider, "right", FixedSupport(), "end")]
    for a, first, b, last in pairs:
        one, other = outer_ports(type(a))[first], outer_ports(type(b))[last]
        if kind.admits(one, 0, 1) and kind.admits(other, 1, 1):
            links = (Link(entity="a", port=first), Link(entity="b", port=last))
            return scene_of(draw(kind, np.random.default_rng(1), {}, {"links": links}), a=a, b=b)
    raise AssertionError(kind)


@pytest.mark.parametrize("name", CONNECTIONS)
def test_every_connection_is_drawn(name: str) -> None:
    scene = joined_by(CONNECTIONS[name])
    drawn = drawing(scene)
    check(scene, drawn)
    assert any(MARKS[CONNECTIONS[name].look](shape) for shape in drawn.shapes)
