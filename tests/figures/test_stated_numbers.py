"""Tests that drawings show the numbers of the text wherever that is unambiguous."""

import pytest

from sim2reason.figures.curves import Mark
from sim2reason.figures.drawing import drawing
from sim2reason.figures.plot import event_lines
from sim2reason.figures.shapes import Label, LineShape
from sim2reason.generation.item_search import generator
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.scenes.bodies.blocks import Glider
from sim2reason.scenes.bodies.simple_machines import Track
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.spring_blocks import SpringBlock
from sim2reason.scenes.entities.track_collisions import ComplexCollisionPlane
from sim2reason.scenes.files import loads
from sim2reason.text.prose.description import describe


def labels(scene: Scene) -> list[Label]:
    return list(drawing(scene, describe(scene)).labels)


@pytest.mark.parametrize("scenes", [1, pytest.param(4, marks=pytest.mark.slow)])
@pytest.mark.parametrize("recipe", RECIPES)
def test_every_stated_angle_is_marked(recipe: str, scenes: int) -> None:
    for difficulty in DIFFICULTIES:
        for index in range(scenes):
            scene = RECIPES[recipe](difficulty, generator("angles", recipe, difficulty, index))
            shown, text = [label.text for label in labels(scene)], describe(scene).text
            for parameter in scene.parameters:
                if parameter.measure.unit == "deg" and parameter.value and not parameter.hidden:
                    said = parameter.measure.say(parameter.value)  # but for directions along an axis
                    marked = said not in text or any(said in label for label in shown)
                    assert marked, (recipe, difficulty, index, parameter.path)


@pytest.mark.parametrize("difficulty", DIFFICULTIES)
def test_the_letter_of_a_field_is_no_name_of_a_body(difficulty: Difficulty) -> None:
    for index in range(4):
        scene = RECIPES["electromagnetic"](difficulty, generator("letters", index))
        shown = {label.text for label in labels(scene)}
        assert not {"B", "E"} & shown
        assert shown & {"B field", "E field"}


def test_the_friction_between_two_slabs_says_between_which() -> None:
    scene = loads("""
scene:
  entities:
  - name: stack
    type: StackedMassPlane
    parameters:
      plane: {angle: 38.0, friction: 0.24}
      lower: {mass: 5.1}
      upper: {mass: 4.8}
      friction: 0.45
      top: {mass: 8.1}
      top_friction: 0.35
""")
    shown = {label.text for label in labels(scene) if "=" in label.text}
    assert shown == {"µ = 0.24", r"$\mu_{AB}$ = 0.45", r"$\mu_{BC}$ = 0.35"}


def track(tilt: float) -> Scene:
    """Build two carts on a track with a wall at its left end, at x = -1.5 m."""
    carts = (Glider(mass=2.0, x=-0.5, v=1.0), Glider(mass=1.0, x=1.0, v=0.0))
    entity = ComplexCollisionPlane(track=Track(angle=tilt), gliders=carts, left=-1.5, restitution=0.5)
    return Scene(entities=(Named(name="track", entity=entity),))


@pytest.mark.parametrize("tilt", [0.0, 20.0])
def test_positions_along_a_track_have_an_axis(tilt: float) -> None:
    found = {label.text: label.at for label in labels(track(tilt))}
    assert "x (m)" in found
    assert {"0", "1"} <= found.keys()
    drawn = drawing(track(tilt), describe(track(tilt)))
    walls = [shape for shape in drawn.shapes if isinstance(shape, LineShape) and len(shape.points) == 2]
    way = found["1"] - found["0"]
    across = [w for w in walls if abs(((w.points[1] - w.points[0]) / way).real) < 1e-6 and w.weight == "edge"]
    assert across, "the wall stands square to the track"


@pytest.mark.parametrize("difficulty", DIFFICULTIES)
def test_no_spring_is_drawn_through_the_nail_of_another(difficulty: Difficulty) -> None:
    drawn = (RECIPES["springs"](difficulty, generator("nails", difficulty, index)) for index in range(400))
    tables = [held for scene in drawn if isinstance(held := scene.entities[0].entity, SpringBlock)]
    assert len(tables) >= 10
    for held in tables:
        block, nails = complex(held.x, held.y), [complex(spring.x, spring.y) for spring in held.springs]
        for nail in nails:
            points = [block + share / 200.0 * (nail - block) for share in range(201)]
            others = [other for other in nails if other != nail]
            assert all(abs(point - other) > 0.07 for point in points for other in others)


def test_a_long_list_of_events_says_how_many_more_there_are() -> None:
    marks = [Mark(0.1 * number, "A hits B") for number in range(1, 21)]
    assert event_lines(marks[:12], "s")[-1] == "12   1.200 s   A hits B"
    lines = event_lines(marks, "s")
    assert len(lines) == 13
    assert lines[-1] == "and 8 more, until 2.000 s"
