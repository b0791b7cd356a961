import pytest

from sim2reason.figures.labels import place_labels
from sim2reason.figures.plane import crosses, depth, hull, length_inside, overlap_area, rectangle, ring
from sim2reason.figures.shapes import LabelRequest, LineShape


def test_a_hull_holds_no_inner_points() -> None:
    square = rectangle(0j, 2.0, 2.0)
    assert set(hull([*square, 0j, 0.5 + 0.5j])) == set(square)
    assert hull([1j, 1j]) == (1j,)


def test_depth_is_how_far_one_must_move() -> None:
    one = rectangle(0j, 2.0, 2.0)
    assert depth(one, rectangle(1.5 + 0j, 2.0, 2.0)) == pytest.approx(0.5)
    assert depth(one, rectangle(3.0 + 0j, 2.0, 2.0)) == pytest.approx(-1.0)
    assert depth(one, (0.5 + 0j, 4.0 + 0j)) == pytest.approx(0.5)
    assert depth(one, (1.5 - 1j, 1.5 + 1j)) < 0.0
    assert depth(one, ring(1.4 + 1.4j, 0.4)) < 0.1


def test_segments_and_boxes() -> None:
    assert crosses(-1.0 + 0j, 1.0 + 0j, -1j, 1j)
    assert not crosses(-1.0 + 0j, 1.0 + 0j, 1j, 2j)
    assert overlap_area((0.0, 0.0, 2.0, 2.0), (1.0, 1.0, 3.0, 3.0)) == pytest.approx(1.0)
    assert overlap_area((0.0, 0.0, 1.0, 1.0), (1.0, 0.0, 2.0, 1.0)) == pytest.approx(0.0)
    assert length_inside(-1.0 + 0.5j, 3.0 + 0.5j, (0.0, 0.0, 1.0, 1.0)) == pytest.approx(1.0)
    assert length_inside(2j, 1.0 + 2j, (0.0, 0.0, 1.0, 1.0)) == pytest.approx(0.0)


def test_a_label_gives_way_to_lines_and_to_labels() -> None:
    line = LineShape((-2.0 + 0j, 2.0 + 0j))
    (first, second), _ = place_labels([LabelRequest("A", (0j, 1j), "a"), LabelRequest("B", (1j, 2j), "b")], [line])
    assert (first.at, second.at) == (1j, 2j)
