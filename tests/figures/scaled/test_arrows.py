"""Tests of velocity arrows: longer than their heads, which nothing covers."""

from itertools import combinations

import pytest

from sim2reason.figures.drawing import drawing
from sim2reason.figures.labels import HEAD
from sim2reason.figures.plane import length_inside, unit_vector
from sim2reason.figures.scaled.arrows import ARROW_GAP, SHORTEST
from sim2reason.figures.shapes import LineShape
from sim2reason.generation.item_search import sample
from sim2reason.text.prose.description import describe


@pytest.mark.parametrize("numbers", [False, True])
@pytest.mark.parametrize(("seed", "index"), [(12, 0), (12, 3), (5, 0), (9, 1)])
def test_heads_are_free(seed: int, index: int, numbers: bool) -> None:
    scene = sample("collision", "hard", seed=seed, index=index)
    drawn = drawing(scene, describe(scene), numbers=numbers)
    arrows = [s.points for s in drawn.shapes if isinstance(s, LineShape) and s.arrow]
    assert arrows
    for tail, tip in arrows:
        assert abs(tip - tail) > SHORTEST - 1e-9 > 2.0 * HEAD
        head = tip - HEAD * unit_vector(tip - tail)
        assert not any(length_inside(head, tip, label.box) for label in drawn.labels)
    assert all(abs(one[1] - other[1]) > ARROW_GAP for one, other in combinations(arrows, 2))
