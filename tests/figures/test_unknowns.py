"""Tests that the unknown of a problem can't be measured in its figure."""

from cmath import phase
from collections.abc import Iterator
from math import degrees
from pathlib import Path
from typing import NamedTuple

import pytest

from sim2reason.datasets.items import build_request, make_item
from sim2reason.figures import canvas
from sim2reason.figures.drawing import drawing, figure
from sim2reason.figures.labels import disguise_unknowns, unknowns
from sim2reason.figures.shapes import Area, Drawing, LineShape
from sim2reason.generation.item_search import sample
from sim2reason.questions.unknown import unknowns as offered
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.text.prose.description import Description, describe
from sim2reason.text.prose.voices import symbolic_at, symbolic_but_zero

CHOSEN = ("incline", "mixed", "pendulum", "rotation", "projectile", "box", "springs", "hybrid", "collision")
LEAST = 0.1  # relatively


class Asked(NamedTuple):
    """Scene whose text leaves one number open."""

    scene: Scene
    path: str
    unit: str
    description: Description


def asked() -> Iterator[Asked]:
    for recipe in CHOSEN:
        for seed in range(2):
            scene = sample(recipe, "hard", seed=seed)
            plain = describe(scene)
            mentions = {address: plain.mention(address) for address in scene.bodies}
            for unknown in offered(scene, mentions, plain.symbols):
                hidden = plain.voiced(symbolic_at(unknown.path))
                yield Asked(scene, unknown.path, unknown.unit, hidden)


ASKED = list(asked())
SHAPES = [case for case in ASKED if case.unit in ("deg", "m")]
OTHERS = [case for case in ASKED if case.unit not in ("deg", "m", "au", "km")]


def as_it_is(case: Asked) -> Drawing:
    """Return the figure of the same scene for a text that states everything."""
    return drawing(case.scene, case.description.voiced(describe(case.scene).voice))


def bodies(drawn: Drawing) -> list[Area]:
    return [shape for shape in drawn.shapes if isinstance(shape, Area)]


def outlines(drawn: Drawing) -> list[list[complex]]:
    """Return the outlines of all bodies relative to a corner of the first, since labels may move the whole drawing."""
    found = [shape.points for shape in bodies(drawn)]
    return [[complex(round(p.real, 9), round(p.imag, 9)) for p in (q - found[0][0] for q in one)] for one in found]


def without_leaders(drawn: Drawing) -> list[object]:
    """Return all shapes except hairlines, some of which lead to labels at places that depend on their length."""
    return [shape for shape in drawn.shapes if getattr(shape, "weight", "") != "hair"]


def test_there_are_many_of_several_recipes() -> None:
    assert len(SHAPES) >= 15
    assert len({case.path.split(".", maxsplit=1)[0] for case in SHAPES}) >= 6


@pytest.mark.parametrize(
    "case",
    [
        pytest.param(case, id=case.path, marks=[pytest.mark.slow] if number % 3 else [])
        for number, case in enumerate(SHAPES)
    ],
)
def test_an_unknown_length_or_angle_is_drawn_with_another_value(case: Asked) -> None:
    shown, _ = disguise_unknowns(case.scene, case.description, lambda scene: drawing(scene, describe(scene)))
    value, other = float(case.scene.value(case.path)), float(shown.value(case.path))
    assert abs(other - value) >= LEAST * abs(value)
    drawn = drawing(case.scene, case.description)
    assert outlines(drawn) == outlines(drawing(shown, describe(shown)))
    said = {p.path: p.measure.say(p.value or 0.0) for p in case.scene.parameters}
    texts = {label.text for label in drawn.labels}
    others = {text for path, text in said.items() if path != case.path}
    assert said[case.path] in others or not any(said[case.path] in text.split(" ") for text in texts)


@pytest.mark.parametrize("case", OTHERS[::4], ids=lambda case: case.path)
def test_the_figure_is_the_same_whatever_else_is_unknown(case: Asked) -> None:
    assert unknowns(case.scene, case.description) == ()
    if case.unit not in ("m/s", "rad/s"):  # arrows of unknown speeds have no scale
        assert without_leaders(drawing(case.scene, case.description)) == without_leaders(as_it_is(case))


def test_a_formula_for_an_angle_leaves_the_figure_as_it_is() -> None:
    scene = SHAPES[0].scene
    symbolic = describe(scene, voice=symbolic_but_zero)
    assert unknowns(scene, symbolic) == ()


def slopes(drawn: Drawing) -> list[float]:
    """Return the angles, in degrees, of the edges of fixed planes that are neither horizontal nor vertical."""
    found: list[float] = []
    for shape in drawn.shapes:
        if isinstance(shape, Area) and shape.fill in ("fixed", "wedge"):
            ways = (b - a for a, b in zip(shape.points, (*shape.points[1:], shape.points[0]), strict=True))
            angles = (abs(degrees(phase(way))) for way in ways)
            found += [min(angle, 180.0 - angle) for angle in angles]
    return [angle for angle in found if 0.1 < angle < 89.9]


def test_the_slope_of_an_incline_is_not_the_one_asked_for(tmp_path: Path) -> None:
    item, found = make_item(build_request("mixed", "hard", "reverse", 7730124, 1, {}, "SI"))
    assert item.asked.unknown == "two_side_mass_plane.plane.angle"
    drawn = drawing(found.description.scene, found.description)
    assert slopes(drawn)
    assert all(abs(angle / item.answer.value - 1.0) >= LEAST for angle in slopes(drawn))
    canvas.draw(drawn, tmp_path / "item.svg")
    (tmp_path / "scene.yaml").write_text(item.scene, encoding="utf-8")
    figure(tmp_path / "scene.yaml", tmp_path / "scene.svg")
    assert (tmp_path / "item.svg").read_bytes() == (tmp_path / "scene.svg").read_bytes()


def test_a_pendulum_hangs_at_another_angle() -> None:
    case = next(case for case in SHAPES if case.path.endswith("angle") and "pendulum" in case.path)
    value = float(case.scene.value(case.path))
    lines = [shape for shape in drawing(case.scene, case.description).shapes if isinstance(shape, LineShape)]
    strings = [shape for shape in lines if shape.weight in ("string", "rod")]
    assert strings
    for shape in strings:
        turn = abs(degrees(phase((shape.points[-1] - shape.points[0]) / -1j)))
        assert min(abs(turn - value), abs(180.0 - turn - value)) >= LEAST * abs(value)
