"""Tests of moments of inertia from the table against those from which the bodies are built."""

import numpy as np
import pytest

from sim2reason.scenes.dsl.body import BODIES
from sim2reason.scenes.dsl.model import draw
from sim2reason.scenes.dsl.solids import Shape
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.swings.rigid_shapes import candidates, mean_squares

WITHOUT = {"HollowSphereWithHole"}  # a lens, for which no table has a formula


def shapes() -> list[type[Shape]]:
    return [cls for cls in BODIES.values() if issubclass(cls, Shape)]


@pytest.mark.parametrize("cls", shapes(), ids=lambda cls: cls.__name__)
def test_the_table_has_what_the_body_is_built_of(cls: type[Shape]) -> None:
    rng = np.random.default_rng(3)
    for _ in range(3):
        shape = draw(cls, rng, {})
        spread = mean_squares(shape, Symbol)
        if spread is None:
            assert cls.__name__ in WITHOUT
            return
        at = {name: float(size) for name, size in shape.model_dump().items() if isinstance(size, int | float)}
        solid = shape.solid
        xx, yy, zz, *_ = (part / solid.size for part in solid.second)
        assert [part.value(at) for part in candidates(spread)] == pytest.approx([xx + zz, xx + yy, yy + zz], rel=1e-12)
        assert spread.center.value(at) == pytest.approx(solid.center[2], rel=1e-12, abs=1e-15)


def test_a_hemisphere() -> None:
    """The centroid is at 3R/8, and I about a diameter of the flat face is 2/5 m R².

    Source: Halliday, Resnick, table 10-2, with half of a sphere.
    """
    from sim2reason.scenes.bodies.eccentric_bodies import Hemisphere

    spread = mean_squares(Hemisphere(mass=2.0, radius=0.3), Symbol)
    assert spread is not None
    at = {"radius": 0.3}
    center, about = float(spread.center.value(at).real), float(candidates(spread)[0].value(at).real)
    assert center == pytest.approx(3.0 * 0.3 / 8.0)
    assert about + center**2 == pytest.approx(2.0 / 5.0 * 0.3**2)
