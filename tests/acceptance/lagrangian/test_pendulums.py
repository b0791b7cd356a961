"""Tests of pendulums against Lagrange's equations (`tests/support/lagrangian/pendulums.py`)."""

from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

from agreement import Agreement, about_y, axis, in_plane, plane_body, rate, speeds
from lagrangian import pendulums
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Y, Z
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import Vector

TWO = np.linspace(0.0, 2.0, 41)


def down(long: float, angle: float) -> Vector:
    """Return the point at distance `long` from the origin, at `angle` from straight down towards +x."""
    return (long * sin(angle), 0.0, -long * cos(angle))


def test_double_compound_pendulum(agree: Agreement) -> None:
    """Two hinged bars start at 70° and at 160°, both with an angular velocity."""
    first, second, long, angles, turns = (
        (2.0, 0.21, 0.4),
        (1.2, 0.08, 0.35),
        0.9,
        (radians(70), radians(160)),
        (1.0, -2.0),
    )
    builder = Builder()
    upper = builder.room().body("upper", first[0], center=down(first[2], angles[0]), inertia=about_y(first[1]))
    upper.hinge(Y, -turns[0])
    lower = upper.body(
        "lower",
        second[0],
        at=down(long, angles[0]),
        center=down(second[2], angles[1]),
        inertia=about_y(second[1]),
    )
    lower.hinge(Y, -(turns[1] - turns[0]))

    def columns(state: State) -> list[Array]:
        one, other = axis(state, "upper.hinge", 0.0, -1.0), axis(state, "lower.hinge", 0.0, -1.0)
        w1, w2 = rate(state, "upper.hinge", -1.0), rate(state, "lower.hinge", -1.0)
        return [one + angles[0], one + other + angles[1], w1, w1 + w2]

    phase = pendulums.double_compound((*first, long), second)
    agree(builder.finish(), (phase, [*angles, *turns]), TWO, columns)


def test_double_pendulum_on_rods(agree: Agreement) -> None:
    """Two bobs on light rods are both released from above their supports."""
    m1, m2, l1, l2, t1, t2 = 1.5, 0.7, 0.8, 0.6, radians(120), radians(100)
    builder = Builder()
    room = builder.room()
    p1 = down(l1, t1)
    p2 = tuple(a + b for a, b in zip(p1, down(l2, t2), strict=True))
    room.site("nail")
    plane_body(room, "one", m1, p1)
    plane_body(room, "two", m2, (p2[0], 0.0, p2[2]))
    room.rod("upper", "nail", "one.hook")
    room.rod("lower", "one.hook", "two.hook")

    def columns(state: State) -> list[Array]:
        places = [*in_plane(state, "one", p1), *in_plane(state, "two", (p2[0], 0.0, p2[2]))]
        return [*places, *speeds(state, "one"), *speeds(state, "two"), state.tension["upper"], state.tension["lower"]]

    phase = pendulums.double_rods(m1, m2, l1, l2)
    agree(builder.finish(), (phase, [t1, t2, 0.0, 0.0]), TWO, columns)


@pytest.mark.parametrize("k", [2.5, 3.5, 4.8])
def test_pendulum_whose_string_goes_slack(agree: Agreement, k: float) -> None:
    """Launched at the bottom with v² = kgℓ, 2 < k < 5, the bob follows a circle, a parabola, a jerk, and goes on."""
    mass, long = 0.4, 0.7
    speed = sqrt(k * pendulums.G * long)
    builder = Builder()
    room = builder.room()
    room.site("nail")
    plane_body(room, "bob", mass, down(long, 0.0), (speed, 0.0))
    room.string("string", "nail", "bob.hook")

    def columns(state: State) -> list[Array]:
        return [*in_plane(state, "bob", down(long, 0.0)), *speeds(state, "bob"), state.tension["string"]]

    reference = (pendulums.on_string(mass, long), [0.0, speed / long])
    record = agree(builder.finish(), reference, TWO, columns, {"slack": "slack", "taut": "taut"})
    assert len(record.events) >= 2


def test_pendulum_on_a_slider(agree: Agreement) -> None:
    """A bob on a rod swings from a cart on a smooth rail; the rod's and the rail's forces agree as well."""
    cart, bob, long, angle = 1.3, 0.8, 0.75, radians(100)
    builder = Builder()
    room = builder.room()
    room.body("cart", cart).rest(X, Z, speed=0.5).site("pivot")
    plane_body(room, "bob", bob, down(long, angle), (0.5, 0.0))
    room.rod("rod", "pivot", "bob.hook")

    def columns(state: State) -> list[Array]:
        x, v = axis(state, "cart.slide"), rate(state, "cart.slide")
        place = in_plane(state, "bob", down(long, angle))
        forces = [state.tension["rod"], state.normal["cart"]]
        return [x, place[0] - x, place[1], v, *speeds(state, "bob"), *forces]

    agree(builder.finish(), (pendulums.on_cart(cart, bob, long), [0.0, angle, 0.5, 0.0]), TWO, columns)


def test_compound_pendulum_on_a_sprung_cart_on_an_incline(agree: Agreement) -> None:
    """A hinged bar swings on a cart that a damped spring holds on a slope of 25°."""
    masses, long, slope, angle = (2.0, 0.9, 0.05), 0.4, radians(25), radians(75)
    k, damping, stretched = 30.0, 0.8, 0.2
    uphill, out = (cos(slope), 0.0, sin(slope)), (-sin(slope), 0.0, cos(slope))
    builder = Builder()
    room = builder.room()
    cart = room.body("cart", masses[0]).rest(uphill, out)
    cart.site("back")
    bar = cart.body("bar", masses[1], center=down(long, angle), inertia=about_y(masses[2]))
    bar.hinge(Y, -1.5)
    room.site("wall", at=(-3.0 * uphill[0], 0.0, -3.0 * uphill[2]))
    room.spring("spring", "wall", "back", stiffness=k, length=3.0 - stretched, damping=damping)

    def columns(state: State) -> list[Array]:
        turned, turn = axis(state, "bar.hinge", angle, -1.0), rate(state, "bar.hinge", -1.0)
        return [axis(state, "cart.slide"), turned, rate(state, "cart.slide"), turn]

    phase = pendulums.on_spring_cart(masses, long, (k, damping, -stretched), slope)
    agree(builder.finish(), (phase, [0.0, angle, 0.0, 1.5]), TWO, columns)


def test_swinging_atwood_machine(agree: Agreement) -> None:
    """A string over a pulley of two rim points connects a weight with a swinging bob."""
    heavy, bob, long, angle = 2.2, 1.0, 1.1, radians(65)
    builder = Builder()
    room = builder.room()
    rim = room.pulley("pulley", at=(-0.05, 0.0, 0.0))
    plane_body(room, "bob", bob, down(long, angle))
    room.body("weight", heavy, at=(-0.1, 0.0, -2.0)).slide(Z).site("weight.hook")
    room.string("string", "weight.hook", rim, "bob.hook")

    def columns(state: State) -> list[Array]:
        place = in_plane(state, "bob", down(long, angle))
        r, v = axis(state, "weight.slide", long), rate(state, "weight.slide")
        return [r, *place, v, *speeds(state, "bob"), state.tension["string"]]

    agree(builder.finish(), (pendulums.swinging_atwood(heavy, bob), [long, angle, 0.0, 0.0]), TWO, columns)


def test_pendulum_whose_string_is_drawn_in(agree: Agreement) -> None:
    """A winch takes in the string at 0.25 m/s; the bob starts with that speed along the string."""
    mass, long, reel, angle, turn = 0.6, 1.2, 0.25, radians(40), 0.7
    u, n = (sin(angle), -cos(angle)), (cos(angle), sin(angle))
    speed = tuple(-reel * a + long * turn * b for a, b in zip(u, n, strict=True))
    mechanism = winch(mass, long, angle, (speed[0], speed[1]), reel)

    def columns(state: State) -> list[Array]:
        return [*in_plane(state, "bob", down(long, angle)), *speeds(state, "bob"), state.tension["string"]]

    agree(mechanism, (pendulums.winched(mass, long, reel), [angle, turn]), TWO, columns)


def winch(mass: float, long: float, angle: float, speed: tuple[float, float], reel: float) -> Mechanism:
    """Build a bob on a string that is drawn in over a nail at a constant speed."""
    builder = Builder()
    room = builder.room()
    room.site("nail")
    plane_body(room, "bob", mass, down(long, angle), speed)
    room.string("string", "nail", "bob.hook", reel=reel)
    return builder.finish()


def test_pendulum_in_space(agree: Agreement) -> None:
    """A bob on a rod swings around in three dimensions, with Cartesian coordinates."""
    mass, long, tilt, turn = 0.9, 0.8, radians(50), 2.5
    start = (long * sin(tilt), 0.0, -long * cos(tilt))
    builder = Builder()
    room = builder.room()
    room.site("nail")
    bob = room.body("bob", mass, at=start).slide(X, name="x").slide(Y, long * sin(tilt) * turn, name="y")
    bob.slide(Z, name="z").site("bob.hook")
    room.rod("rod", "nail", "bob.hook")

    def columns(state: State) -> list[Array]:
        place = [axis(state, f"bob.{name}", at) for name, at in zip("xyz", start, strict=True)]
        return [*place, *(rate(state, f"bob.{name}") for name in "xyz"), state.tension["rod"]]

    phase = pendulums.conical(mass, long)
    agree(builder.finish(), (phase, [tilt, 0.0, 0.0, turn * sin(tilt) ** 2]), TWO, columns)


def test_bob_on_a_string_from_a_compound_pendulum(agree: Agreement) -> None:
    """A bob on a string from a hinged bar starts so fast that the string goes slack and jerks."""
    body, bob, long, angles, turns = (1.6, 0.15, 0.4, 0.8), 0.5, 0.6, (radians(10), radians(20)), (3.0, 9.0)
    mass, inertia, center, arm = body
    builder = Builder()
    room = builder.room()
    end = down(arm, angles[0])
    place = tuple(a + b for a, b in zip(end, down(long, angles[1]), strict=True))
    at = (place[0], 0.0, place[2])
    vx = arm * turns[0] * cos(angles[0]) + long * turns[1] * cos(angles[1])
    vz = arm * turns[0] * sin(angles[0]) + long * turns[1] * sin(angles[1])
    bar = room.body("bar", mass, center=down(center, angles[0]), inertia=about_y(inertia))
    bar.hinge(Y, -turns[0]).site("end", at=end)
    plane_body(room, "bob", bob, at, (vx, vz))
    room.string("string", "end", "bob.hook")

    def columns(state: State) -> list[Array]:
        turned, turn = axis(state, "bar.hinge", angles[0], -1.0), rate(state, "bar.hinge", -1.0)
        return [turned, *in_plane(state, "bob", at), turn, *speeds(state, "bob"), state.tension["string"]]

    reference = (pendulums.bob_on_string_on_body(body, bob, long), [*angles, *turns])
    record = agree(builder.finish(), reference, TWO, columns, {"slack": "slack", "taut": "taut"})
    assert {name for _, name in record.events} == {"slack", "taut"}


def test_the_period_of_a_large_swing() -> None:
    """T = 4√(ℓ/g)·K(sin ½θ₀) with K = ½π/agm(1, cos ½θ₀); turning points are T/2 apart."""
    from sim2reason.simulation.engines.exact.engine import motion

    long, angle = 0.9, radians(150)
    a, b = 1.0, cos(0.5 * angle)
    for _ in range(8):
        a, b = 0.5 * (a + b), sqrt(a * b)
    period = 2.0 * pi * sqrt(long / pendulums.G) / a
    builder = Builder()
    builder.room().body("bob", 1.0, center=down(long, angle)).hinge(Y)
    turns = [event.time for event in motion(builder.finish(), 5.0 * period).events if event.kind == "turn"]
    assert np.array(turns[:9]) == pytest.approx(0.5 * period * np.arange(1, 10), rel=1e-10)
