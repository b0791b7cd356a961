"""Tests that labels are close to what they name, and cover no outline of another body."""

from collections.abc import Iterator
from math import hypot

import pytest

from sim2reason.figures.drawing import drawing
from sim2reason.figures.plane import inside, length_inside
from sim2reason.figures.shapes import Arc, Area, Drawing, Label, LineShape, Shape, outline
from sim2reason.generation.item_search import sample
from sim2reason.text.prose.description import describe

RECIPES = ("incline", "mixed", "hybrid", "box", "pulley")
SEEDS = [range(40, 42), pytest.param(range(42, 46), marks=pytest.mark.slow)]
FAR = 0.6  # units


@pytest.fixture(scope="module", params=SEEDS, ids=lambda seeds: f"from {seeds[0]}")
def seeds(request: pytest.FixtureRequest) -> range:
    return request.param


@pytest.fixture(scope="module", params=RECIPES)
def drawings(request: pytest.FixtureRequest, seeds: range) -> list[Drawing]:
    """Draw hard scenes with and without numbers."""
    scenes = [sample(request.param, "hard", seed=seed) for seed in seeds]
    return [drawing(scene, describe(scene), numbers=numbers) for scene in scenes for numbers in (False, True)]


def blocks(drawn: Drawing) -> list[Shape]:
    return [s for s in drawn.shapes if not isinstance(s, LineShape) and s.fill in ("block", "ball", "disc")]


def crossed(drawn: Drawing) -> Iterator[tuple[Label, Shape]]:
    """Yield each label with the bodies whose outlines it covers, except for the body it lies in."""
    for label in drawn.labels:
        for shape in blocks(drawn):
            points = outline(shape)
            if isinstance(shape, Arc):
                points = tuple(shape.center + shape.radius * 1j ** (n / 6.0) for n in range(24))
            edges = zip(points, (*points[1:], points[0]), strict=True)
            if not inside(label.at, points) and any(length_inside(a, b, label.box) > 0.0 for a, b in edges):
                yield label, shape


def test_no_label_hides_the_outline_of_a_body_in_which_it_does_not_lie(drawings: list[Drawing]) -> None:
    assert [(label.text, label.at) for drawn in drawings for label, _ in crossed(drawn)] == []


def test_a_mass_stands_in_its_body_or_near_one_or_has_a_line_to_it(drawings: list[Drawing]) -> None:
    for drawn in drawings:
        bodies = [outline(shape) for shape in drawn.shapes if isinstance(shape, Area | Arc)]
        ends = [s.points[0] for s in drawn.shapes if isinstance(s, LineShape) and s.weight == "hair"]
        for label in drawn.labels:
            if label.text.endswith(" kg") or "mu" in label.text:
                within = any(inside(label.at, body) for body in bodies)
                led = any(away(label, end) < 1e-6 for end in ends)
                assert within or led or near(label, bodies), label


def near(label: Label, bodies: list[tuple[complex, ...]]) -> bool:
    left, low, right, high = label.box
    area = (left - FAR, low - FAR, right + FAR, high + FAR)
    pairs = ((a, b) for body in bodies for a, b in zip(body, (*body[1:], body[0]), strict=True))
    return any(length_inside(a, b, area) > 0.0 for a, b in pairs)


def away(label: Label, point: complex) -> float:
    """Return the distance of a point from the box of a label."""
    left, low, right, high = label.box
    return hypot(max(left - point.real, 0.0, point.real - right), max(low - point.imag, 0.0, point.imag - high))
