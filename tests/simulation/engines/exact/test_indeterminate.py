"""Tests that statically indeterminate forces, and no others, are NaN."""

from collections.abc import Callable
from math import atan, cos, isnan, radians, sin, tan

import numpy as np
import pytest

from sim2reason.scenes.dsl.builder import Builder, Rim
from sim2reason.scenes.dsl.mechanism import X, Z
from sim2reason.simulation.engines.exact import Segment, motion

G = 9.8


def first(builder: Builder) -> Segment:
    found = motion(builder.finish(), 1.0)
    assert found.events == ()
    return found.segments[0]


def tied_to_a_wall(mu: float) -> Builder:
    builder = Builder()
    room = builder.room()
    room.site("wall", at=(5.0, 0.0, 0.0))
    room.body("A", 2.0).rest(X, Z, mu).site("A.hook")
    room.string("s", "A.hook", "wall")
    return builder


def test_a_resting_block_tied_to_a_wall(agree: Callable[..., None]) -> None:
    """Any tension up to µ m g is balanced by friction."""
    found = first(tied_to_a_wall(0.3))
    assert isnan(found.tension[0])
    assert isnan(found.friction[0])
    agree(found.normal, [2.0 * G])
    assert found.a == [0.0]


def test_without_friction_it_is_settled() -> None:
    found = first(tied_to_a_wall(0.0))
    assert found.tension == [0.0]
    assert found.friction == [0.0]


def faces(
    m1: float,
    m2: float,
    angles: tuple[float, float],
    mu: tuple[float, float],
    static: tuple[float | None, float | None] = (None, None),
) -> Builder:
    builder = Builder()
    room = builder.room()
    room.site("left", at=(-0.1, 0.0, 0.0)).site("right", at=(0.1, 0.0, 0.0))
    sides = zip("AB", (m1, m2), (-1, 1), angles, mu, static, strict=True)
    for name, mass, side, angle, friction, held in sides:
        uphill, outward = (-side * cos(angle), 0.0, sin(angle)), (side * sin(angle), 0.0, cos(angle))
        at = (side * 0.1 - 20.0 * uphill[0], 0.0, -20.0 * uphill[2])
        room.body(name, mass, at=at).rest(uphill, outward, friction, static=held)
        builder.add_site(f"{name}.eye", name, at)
    room.string("s", "A.eye", "left", "right", "B.eye")
    return builder


def test_two_rough_blocks_over_a_wedge(agree: Callable[..., None]) -> None:
    """Both blocks would rest without the string, so its tension has a range of values."""
    theta = radians(20.0)
    found = first(faces(1.0, 2.0, (theta, theta), (0.5, 0.6)))
    assert [isnan(force) for force in (*found.tension, *found.friction)] == [True, True, True]
    agree(found.normal, [G * cos(theta), 2.0 * G * cos(theta)])


def test_a_block_too_steep_to_rest_alone_is_held_by_the_other() -> None:
    """Block A slips at T = 0, yet there are tensions at which both blocks rest."""
    found = first(faces(1.0, 6.0, (radians(50.0), radians(10.0)), (0.3, 0.6)))
    assert found.a == [0.0, 0.0]
    assert isnan(found.tension[0])
    assert not np.isnan(found.normal).any()


@pytest.mark.parametrize("kinetic", [1.0, 0.1])
@pytest.mark.parametrize(("share", "rests"), [(0.999, True), (1.001, False)])
def test_two_blocks_too_steep_to_rest_alone_hold_each_other_up_to_a_limit(
    share: float, rests: bool, kinetic: float
) -> None:
    """The tension must be from m1 g (sin α − µ1 cos α), for the steep block, to m2 g (sin β + µ2 cos β).

    The coefficients µ are those of static friction, of which kinetic friction is a part.
    """
    alpha, beta, mu1, mu2, m2 = radians(50.0), radians(10.0), 0.3, 0.6, 6.0
    m1 = share * m2 * (sin(beta) + mu2 * cos(beta)) / (sin(alpha) - mu1 * cos(alpha))
    builder = faces(m1, m2, (alpha, beta), (kinetic * mu1, kinetic * mu2), static=(mu1, mu2))
    assert (first(builder).a == [0.0, 0.0]) is rests


def test_a_smooth_block_settles_the_tension(agree: Callable[..., None]) -> None:
    """The tension is T = m1 g sin α, and the rough block's friction balances the rest."""
    alpha, beta = radians(30.0), radians(15.0)
    found = first(faces(2.0, 3.0, (alpha, beta), (0.0, 0.9)))
    tension = 2.0 * G * sin(alpha)
    agree(found.tension, [tension])
    agree(found.friction, [0.0, 3.0 * G * sin(beta) - tension], G)


def test_at_the_limit_of_friction_it_still_holds() -> None:
    """The block rests on a slope with tan θ = µ up to rounding."""
    mu = 0.37
    builder = Builder()
    theta = atan(mu)
    builder.room().body("A", 1.3).rest((cos(theta), 0.0, sin(theta)), (-sin(theta), 0.0, cos(theta)), mu)
    assert first(builder).a == [0.0]


def test_what_moves_is_determined(agree: Callable[..., None]) -> None:
    """A body that slides down a rough slope has known forces, beside an indeterminate pair."""
    builder = tied_to_a_wall(0.3)
    theta = radians(40.0)
    builder.room().body("C", 1.0).rest((cos(theta), 0.0, sin(theta)), (-sin(theta), 0.0, cos(theta)), 0.2)
    found = first(builder)
    assert np.isnan([*found.tension, *found.friction]).tolist() == [True, True, False]
    agree(found.a[1], -G * (sin(theta) - 0.2 * cos(theta)))


def test_two_strings_side_by_side(agree: Callable[..., None]) -> None:
    """The tensions of two equal strings with one load are NaN; the string below the load has a known one."""
    builder = Builder()
    room = builder.room()
    room.site("left", at=(-1.0, 0.0, 0.0)).site("right", at=(1.0, 0.0, 0.0))
    room.body("A", 2.0, at=(0.0, 0.0, -3.0)).slide(Z)
    for name, x in (("left", -1.0), ("right", 1.0)):
        builder.add_site(f"A.{name}", "A", (x, 0.0, -3.0))
        room.string(f"s.{name}", name, f"A.{name}")
    builder.add_site("A.low", "A", (0.0, 0.0, -3.0))
    room.body("B", 1.0, at=(0.0, 0.0, -5.0)).slide(Z).site("B.hook")
    builder.add_site("B.top", "B", (0.0, 0.0, -5.0))
    room.string("lower", "A.low", "B.top")
    found = first(builder)
    assert [isnan(force) for force in found.tension] == [True, True, False]
    agree(found.tension[2], G)


@pytest.mark.parametrize("mu", [0.2, 0.5])
def test_a_wedge_and_its_block_stick_together(mu: float, agree: Callable[..., None]) -> None:
    """A rough block at rest on a rough wedge on a rough floor is statically determinate."""
    theta = radians(10.0)
    builder = Builder()
    wedge = builder.room().body("W", 4.0).rest(X, Z, 0.3)
    wedge.body("A", 1.0).rest((cos(theta), 0.0, sin(theta)), (-sin(theta), 0.0, cos(theta)), mu)
    found = first(builder)
    agree(found.friction, [0.0, G * sin(theta)], G)
    agree(found.normal, [5.0 * G, G * cos(theta)])
    assert tan(theta) < mu


def test_pulley_as_value_is_a_stop() -> None:
    """A massless fixed pulley adds no unknown: equal masses are in equilibrium with T = m g."""
    builder = Builder()
    room = builder.room()
    pulley = room.pulley("P")
    assert isinstance(pulley, Rim)
    room.body("A", 1.0, at=(-0.05, 0.0, -1.0)).slide(Z).site("A.hook", at=(0.0, 0.0, 0.0))
    room.body("B", 1.0, at=(0.05, 0.0, -1.0)).slide(Z).site("B.hook")
    room.string("s", "A.hook", pulley, "B.hook")
    assert first(builder).tension == pytest.approx([G])
