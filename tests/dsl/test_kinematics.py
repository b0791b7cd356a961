"""Points that slides carry, seen two ways: compiled for an engine and looked up one by one."""

import numpy as np
import pytest

from sim2reason.dsl.builder import Builder
from sim2reason.dsl.kinematics import carried, hinge_of, kinematics, lengths, points_of, slides_of
from sim2reason.dsl.mechanism import Mechanism, X, Y, Z

UPHILL = (0.8, 0.0, 0.6)


@pytest.fixture
def cart() -> Mechanism:
    """A cart with a sloping top, a block on it, and a wheel fixed to the block."""
    builder = Builder()
    room = builder.room("r", at=(1.0, 0.0, 0.0))
    room.site("nail", at=(0.0, 0.0, 5.0))
    wagon = room.body("cart", 2.0, at=(1.0, 0.0, 0.0)).rest(X, Z)
    block = wagon.body("block", 1.0, at=(0.0, 0.5, 0.0)).rest(UPHILL, (-0.6, 0.0, 0.8)).slide(Y, name="aside")
    block.pulley("wheel", at=(0.0, 0.0, 1.0), mass=0.5)
    return builder.finish()


def test_a_chain_of_slides(cart: Mechanism) -> None:
    assert slides_of(cart, "r.block") == ((0, X), (1, UPHILL), (2, Y))
    assert slides_of(cart, "r.wheel") == slides_of(cart, "r.block")
    assert slides_of(cart, None) == ()
    assert (hinge_of(cart, "r.wheel"), hinge_of(cart, "r.block")) == (3, None)


def test_compiled_and_looked_up_agree(cart: Mechanism) -> None:
    compiled = kinematics(cart)
    for body in cart.body:
        assert compiled.bodies[body].slides == slides_of(cart, body)
    for site in cart.site:
        (point,) = points_of(cart, (site,))
        assert point.at == compiled.sites[site].at
        assert point.slides == compiled.sites[site].slides
    assert compiled.hinges == {"r.wheel": 3}
    assert compiled.bodies["r.wheel"].normals == ((0, Z), (1, (-0.6, 0.0, 0.8)))
    assert compiled.bodies["r.wheel"].at == (2.0, 0.5, 1.0)


def test_displacement_is_linear(cart: Mechanism) -> None:
    moved = carried(slides_of(cart, "r.block"), np.array([[1.0, 2.0, 3.0, 9.0], [0.0, 0.0, 0.0, 9.0]]))
    assert moved == pytest.approx(np.array([[2.6, 3.0, 1.2], [0.0, 0.0, 0.0]]))


def test_lengths_and_their_rates(cart: Mechanism) -> None:
    """By central differences."""
    points = points_of(cart, ("r.nail", "r.wheel.left", "r.wheel.right"))
    rng = np.random.default_rng(0)
    q, v, h = rng.normal(size=(3, 4)), rng.normal(size=(3, 4)), 1e-6
    length, rate = lengths(points, q, v)
    (before, _), (after, _) = lengths(points, q - h * v, v), lengths(points, q + h * v, v)
    assert rate == pytest.approx((after - before) / (2.0 * h), rel=1e-7)
    assert (length > 0.1).all()


def test_points_that_coincide_have_no_rate(cart: Mechanism) -> None:
    (point,) = points_of(cart, ("r.nail",))
    length, rate = lengths((point, point), np.zeros((1, 4)), np.ones((1, 4)))
    assert (length[0], rate[0]) == (0.0, 0.0)


def test_unknown_names(cart: Mechanism) -> None:
    with pytest.raises(KeyError, match="nobody"):
        slides_of(cart, "nobody")
