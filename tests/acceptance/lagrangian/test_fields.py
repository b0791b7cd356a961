"""Tests of gravity, thrust, drag and fields against Newton's equations (`tests/support/lagrangian/fields.py`)."""

from math import hypot, pi, radians, sin, sqrt

import numpy as np
import pytest

from agreement import Agreement, axis, rate
from lagrangian import fields
from sim2reason.scenes.dsl.builder import Builder, Frame
from sim2reason.scenes.dsl.fields import Magnetic, Profile, Push, Resistance
from sim2reason.scenes.dsl.mechanism import ZERO, X, Y, Z
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import DiscRegion
from sim2reason.simulation.engines.exact import simulate

Pair = tuple[float, float]


def planet(room: Frame, name: str, mass: float, at: tuple[float, float], speed: tuple[float, float]) -> Frame:
    body = room.body(name, mass, at=(at[0], at[1], 0.0))
    return body.slide(X, speed[0], name="x").slide(Y, speed[1], name="y")


def flat(state: State, names: list[str], places: list[tuple[float, float]]) -> list[Array]:
    found = [axis(state, f"{n}.{k}", at[i]) for n, at in zip(names, places, strict=True) for i, k in enumerate("xy")]
    return [*found, *(rate(state, f"{name}.{k}") for name in names for k in "xy")]


def gravitating(
    agree: Agreement,
    masses: list[float],
    places: list[Pair],
    start: list[Pair],
    constant: float,
    duration: float,
    fixed: bool,
) -> None:
    """Compare bodies that all attract each other with the reference; with `fixed` the first does not move."""
    builder = Builder(ZERO)
    room = builder.room()
    names = [f"p{i}" for i in range(len(masses))]
    bodies = [
        room.body(name, mass, at=(*at, 0.0)) if fixed and name == "p0" else planet(room, name, mass, at, v)
        for name, mass, at, v in zip(names, masses, places, start, strict=True)
    ]
    for number, body in enumerate(bodies):
        for other in bodies[:number]:
            body.attract(other, constant)
    phase = fields.attracting(masses, constant, 0 if fixed else None)
    n, kept = len(masses), 1 if fixed else 0

    def columns(state: State) -> list[Array]:
        return flat(state, names[kept:], places[kept:])

    def observe(_: float, y: Array) -> Array:
        return np.concatenate([y[2 * kept : 2 * n], y[2 * n + 2 * kept :]])

    y = [*np.array(places).ravel(), *np.array(start).ravel()]
    reference = fields.Phase(phase.rate, observe)
    agree(builder.finish(), (reference, y), np.linspace(0.0, duration, 61), columns, substeps=3)


def test_interacting_planets(agree: Agreement) -> None:
    """Two planets of 1 % and 2 % of the mass of their fixed star move for three years, in astronomical units."""
    star, v = 4.0 * pi**2, 2.0 * pi
    places, start = [(0.0, 0.0), (1.0, 0.0), (-1.5, 0.2)], [(0.0, 0.0), (0.0, v), (0.3, -v / sqrt(1.5))]
    gravitating(agree, [1.0, 0.01, 0.02], places, start, star, 3.0, fixed=True)


def test_three_bodies_on_a_figure_of_eight(agree: Agreement) -> None:
    """The periodic solution of Chenciner and Montgomery (2000) with G = m = 1 is followed for nearly one period."""
    x, v = (0.97000436, -0.24308753), (0.93240737, 0.86473146)
    places = [x, (-x[0], -x[1]), (0.0, 0.0)]
    start = [(v[0] / 2, v[1] / 2), (v[0] / 2, v[1] / 2), (-v[0], -v[1])]
    gravitating(agree, [1.0, 1.0, 1.0], places, start, 1.0, 6.0, fixed=False)


def test_three_unequal_bodies(agree: Agreement) -> None:
    """Burrau's Pythagorean problem: masses 3, 4, 5 start at rest at a triangle's corners, up to a close passage."""
    places = [(1.0, 3.0), (-2.0, -1.0), (1.0, -1.0)]
    gravitating(agree, [3.0, 4.0, 5.0], places, [(0.0, 0.0)] * 3, 1.0, 1.8, fixed=False)


def test_ellipse_over_ten_periods() -> None:
    """The orbit satisfies Kepler's equation with e = 0.5, a = 1, GM = 4π² at 400 times."""
    e, strength = 0.5, 4.0 * pi**2
    times = np.linspace(0.0, 10.0, 401)
    expected = fields.kepler(1.0, e, strength, times)
    builder = Builder(ZERO)
    room = builder.room()
    body = planet(room, "planet", 2.0, (1.0 - e, 0.0), (0.0, sqrt(strength * (1.0 + e) / (1.0 - e))))
    body.attract(room.body("star", 1.0), strength)
    found = np.stack(flat(simulate(builder.finish(), times).state, ["planet"], [(1.0 - e, 0.0)]), axis=1)
    assert found == pytest.approx(expected, abs=1e-8 * np.abs(expected).max())


def test_rocket_from_a_planet(agree: Agreement) -> None:
    """The rocket burns 70 % of its mass, its nozzle always straight down, while it drifts sideways."""
    full, burn, pull, radius = 5.0, (1.4, 4.0, 2.5), 0.8, 1.0
    builder = Builder(ZERO)
    room = builder.room()
    rocket = room.body("rocket", full, at=(0.0, 0.0, radius)).slide(X, 0.9, name="x").slide(Z, name="z")
    rocket.burn(*burn)
    rocket.attract(room.body("planet", 1.0), pull)

    def columns(state: State) -> list[Array]:
        places = [axis(state, "rocket.x"), axis(state, "rocket.z", radius)]
        return [*places, rate(state, "rocket.x"), rate(state, "rocket.z")]

    reference = (fields.rocket(full, burn, pull), [0.0, radius, 0.9, 0.0])
    agree(builder.finish(), reference, np.linspace(0.0, 4.0, 41), columns, {"burn-out": "burn-out"})


def test_ball_that_bounces_in_air(agree: Agreement) -> None:
    """The ball bounces five times, with linear and quadratic drag and a restitution of 0.8."""
    mass, drag, restitution, height, start = 0.2, (0.02, 0.015), 0.8, 1.5, (3.0, 2.0)
    builder = Builder()
    room = builder.room()
    ball = room.body("ball", mass, at=(0.0, 0.0, height)).slide(X, start[0], name="x").slide(Z, start[1], name="z")
    ball.force("drag", Resistance(*drag))
    room.bump(room, ball, Z, 0.0, restitution)

    def columns(state: State) -> list[Array]:
        places = [axis(state, "ball.x"), axis(state, "ball.z", height)]
        return [*places, rate(state, "ball.x"), rate(state, "ball.z")]

    reference = (fields.bouncing(mass, drag, restitution), [0.0, height, *start])
    record = agree(builder.finish(), reference, np.linspace(0.0, 3.5, 71), columns, {"collision": "land"})
    assert len(record.events) >= 3


def test_charge_through_a_disc(agree: Agreement) -> None:
    """The charge enters a disc of uniform B with a field E that grows linearly with x, and leaves it again."""
    mass, charge, b, electric, radius, start = 0.5, 2.0, 1.5, (0.8, 1.2), 0.5, (2.0, 0.1)
    builder = Builder(ZERO)
    place = (-1.0, 0.0, 0.1)
    body = builder.room().body("charge", mass, at=place).slide(X, start[0], name="x").slide(Z, start[1], name="z")
    disc = DiscRegion(ZERO, radius, Y)
    # fields count places from where the entity stands, here the room's origin
    body.force("E", Push(X, Profile(charge * electric[0], charge * electric[1], X)), disc)
    # v × B with B along −y: (x′, 0, z′) × (0, −B, 0) = (Bz′, 0, −Bx′)
    body.force("B", Magnetic((0.0, -1.0, 0.0), Profile(charge * b)), disc)

    def columns(state: State) -> list[Array]:
        places = [axis(state, "charge.x", place[0]), axis(state, "charge.z", place[2])]
        return [*places, rate(state, "charge.x"), rate(state, "charge.z")]

    reference = (fields.charge_in_disc((charge / mass, b), electric, (ZERO[:2], radius)), [place[0], place[2], *start])
    record = agree(builder.finish(), reference, np.linspace(0.0, 2.0, 41), columns, {"enter": "enter", "exit": "exit"})
    assert [name for _, name in record.events] == ["enter", "exit"]


def test_charge_in_changing_fields(agree: Agreement) -> None:
    """B grows with time and E oscillates, both uniform in space, so that one linear equation gives the motion."""
    mass, charge, magnetic, electric, start = 0.3, 1.5, (2.0, 0.7), (1.2, 5.0), (1.0, -0.5, 0.4)
    builder = Builder(ZERO)
    body = builder.room().body("charge", mass)
    for name, along, speed in zip("xyz", (X, Y, Z), start, strict=True):
        body.slide(along, speed, name=name)
    body.force("B", Magnetic(Z, Profile(charge * magnetic[0], rate=charge * magnetic[1])))
    body.force("E", Push(X, Profile(charge * electric[0], frequency=electric[1])))

    def columns(state: State) -> list[Array]:
        return [read(state, f"charge.{name}") for read in (axis, rate) for name in "xyz"]

    phase = fields.charge_in_space(charge / mass, magnetic, electric)
    agree(builder.finish(), (phase, [0.0, 0.0, 0.0, *start]), np.linspace(0.0, 3.0, 61), columns)


def test_a_charge_turns_a_hundred_times() -> None:
    """The cyclotron motion x = r sin ωt, ω = qB/m, is accurate over 100 periods."""
    omega, speed = 12.0, 3.0
    times = np.linspace(0.0, 100.0 * 2.0 * pi / omega, 301)
    builder = Builder(ZERO)
    body = builder.room().body("charge", 0.5).slide(X, speed, name="x").slide(Y, name="y")
    body.force("B", Magnetic(Z, Profile(0.5 * omega)))
    state = simulate(builder.finish(), times).state
    r = speed / omega
    expected = np.stack([r * np.sin(omega * times), r * (np.cos(omega * times) - 1.0)], axis=1)
    assert state.q == pytest.approx(expected, abs=1e-8 * r)
    assert np.hypot(*state.v.T) == pytest.approx(speed, rel=1e-9)


def test_the_deflection_of_a_charge_aimed_at_the_centre_of_a_disc() -> None:
    """The deflection is tan ½φ = R/r, and the charge leaves along a radius."""
    omega, speed, radius = 4.0, 2.5, 0.7
    builder = Builder(ZERO)
    tilt = radians(25)
    way = (sin(pi / 2 - tilt), sin(tilt))
    body = builder.room().body("charge", 1.0, at=(-2.0 * way[0], -2.0 * way[1], 0.0))
    body.slide(X, speed * way[0], name="x").slide(Y, speed * way[1], name="y")
    body.force("B", Magnetic(Z, Profile(omega)), DiscRegion(ZERO, radius))
    state = simulate(builder.finish(), np.array([0.0, 3.0])).state
    turned = -np.arctan2(state.v[1, 1], state.v[1, 0]) + np.arctan2(way[1], way[0])
    assert np.tan(0.5 * turned) == pytest.approx(radius / (speed / omega), rel=1e-9)
    assert hypot(*state.v[1]) == pytest.approx(speed, rel=1e-11)
