"""Tests that a spring is one zigzag, with the dashpot of a damped one on the other side of its axis."""

import pytest

from sim2reason.figures.paths import spring
from sim2reason.figures.plane import cross
from sim2reason.scenes.dsl.mechanism import Elastic, Inextensible, Line

A, B = 1.0 + 2.0j, 4.0 + 6.0j


def line(law: Elastic | Inextensible) -> Line:
    return Line("spring", "spring", ("a", "b"), law=law)


@pytest.mark.parametrize("held", [None, line(Elastic(40.0, 1.0)), line(Inextensible())])
def test_alone_it_is_one_stroke_from_end_to_end(held: Line | None) -> None:
    (points,) = spring(A, B, held)
    assert (points[0], points[-1]) == (A, B)
    assert len(points) > 6


def test_a_dashpot_lies_beside_it() -> None:
    strokes = list(spring(A, B, line(Elastic(40.0, 1.0, 2.0))))
    ends = [point for points in strokes for point in points]
    assert {A, B} <= set(ends)
    coil = max(strokes, key=len)
    cup = next(points for points in strokes if len(points) == 4)
    assert all(cross(B - A, point - A) > 0.0 for point in coil)
    assert all(cross(B - A, point - A) < 0.0 for point in cup)
    pistons = [points for points in strokes if abs(cross(points[1] - points[0], 1j * (B - A))) < 1e-9]
    assert len(pistons) == 3  # one, and the two pieces across that join both
