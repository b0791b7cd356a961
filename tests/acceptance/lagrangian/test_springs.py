"""Tests of springs against Newton's equations (`tests/support/lagrangian/springs.py`)."""

from math import cos, radians, sin

import numpy as np

from agreement import Agreement, axis, in_plane, plane_body, rate, speeds
from lagrangian import springs
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import ZERO, X, Z
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import Vector

TWO = np.linspace(0.0, 2.0, 41)


def test_spring_chain_with_friction(agree: Agreement) -> None:
    """Three rough blocks in a row of three springs from a wall stop, stick and slip independently."""
    masses, friction, stiffness, stretched = (1.0, 1.5, 0.8), (0.1, 0.15, 0.2), (60.0, 40.0, 30.0), (0.3, -0.1, 0.25)
    start = (0.0, 1.2, -0.5)
    builder = Builder()
    room = builder.room()
    room.site("wall", (-1.0, 0.0, 0.0))
    last = "wall"
    for i, (mass, mu, k, e, v) in enumerate(zip(masses, friction, stiffness, stretched, start, strict=True)):
        room.body(f"b{i}", mass, at=(float(i), 0.0, 0.0)).rest(X, Z, mu, v).site(f"hook{i}")
        room.spring(f"spring{i}", last, f"hook{i}", stiffness=k, length=1.0 - e)
        last = f"hook{i}"

    def columns(state: State) -> list[Array]:
        names = [f"b{i}" for i in range(3)]
        places, speed = [[read(state, f"{n}.slide") for n in names] for read in (axis, rate)]
        return [*places, *speed, *(state.friction[n] for n in names)]

    chain = springs.RoughChain(masses, friction, stiffness, stretched)
    first = chain.begin(start)
    events = {"stick": "stop", "slip": "stop|slip"}  # one that reverses begins to slip to the other side
    record = agree(builder.finish(), (first, [0.0, 0.0, 0.0, *start]), TWO, columns, events)
    assert len(record.events) >= 8


def test_block_on_three_springs_at_angles(agree: Agreement) -> None:
    """A particle between three nails is launched under gravity; two springs are stretched, one is compressed."""
    nails = [np.array([-0.8, 0.3]), np.array([0.6, 0.9]), np.array([0.1, -0.7])]
    data = [(120.0, 0.7, 0.0), (80.0, 0.9, 0.0), (200.0, 0.85, 0.0)]
    table = [(0, nail, *each) for nail, each in zip(nails, data, strict=True)]
    net(agree, (0.9,), [(0.0, 0.0)], [(1.5, -0.7)], table, 9.8)


def test_ring_of_damped_springs(agree: Agreement) -> None:
    """Three particles in a ring of damped springs hang from two nails on two more springs."""
    table = [(one, other, 150.0, 0.5, 1.2) for one, other in springs.ring([0, 1, 2])]
    table += [(0, np.array([-0.3, 1.0]), 90.0, 0.6, 0.4), (1, np.array([0.9, 1.1]), 70.0, 0.7, 0.3)]
    places = [(0.0, 0.3), (0.6, 0.3), (0.3, -0.2)]
    net(agree, (0.5, 0.8, 0.6), places, [(0.0, 1.0), (-0.5, 0.0), (2.0, 0.3)], table, 9.8)


def net(
    agree: Agreement,
    masses: tuple[float, ...],
    places: list[tuple[float, float]],
    start: list[tuple[float, float]],
    table: list[tuple[int, int | Array, float, float, float]],
    gravity: float,
) -> None:
    """Compare particles in a plane and the springs between them with the reference."""
    builder = Builder((0.0, 0.0, -gravity))
    room = builder.room()
    at: list[Vector] = [(x, 0.0, z) for x, z in places]
    for i, mass in enumerate(masses):
        plane_body(room, f"p{i}", mass, at[i], start[i])
    for number, (one, other, k, rest, damping) in enumerate(table):
        if not isinstance(other, int):
            room.site(f"nail{number}", (float(other[0]), 0.0, float(other[1])))
        end = f"p{other}.hook" if isinstance(other, int) else f"nail{number}"
        room.spring(f"s{number}", f"p{one}.hook", end, stiffness=k, length=rest, damping=damping)

    def columns(state: State) -> list[Array]:
        found = [part for i, place in enumerate(at) for part in in_plane(state, f"p{i}", place)]
        found += [part for i in range(len(at)) for part in speeds(state, f"p{i}")]
        return [*found, *(state.tension[f"s{number}"] for number in range(len(table)))]

    y = [*np.array(places).ravel(), *np.array(start).ravel()]
    agree(builder.finish(), (springs.net(masses, table, gravity), y), TWO, columns)


def test_elastic_pendulum(agree: Agreement) -> None:
    """A bob on a spring is close to the resonance at which it alternately swings and bounces."""
    mass, k, rest, angle, long = 0.5, 25.0, 0.6, radians(50), 0.9
    at = (long * sin(angle), 0.0, -long * cos(angle))
    builder = Builder()
    room = builder.room()
    room.site("nail")
    plane_body(room, "bob", mass, at)
    room.spring("spring", "nail", "bob.hook", stiffness=k, length=rest)

    def columns(state: State) -> list[Array]:
        return [*in_plane(state, "bob", at), *speeds(state, "bob"), state.tension["spring"]]

    agree(builder.finish(), (springs.elastic_pendulum(mass, k, rest), [long, angle, 0.0, 0.0]), TWO, columns)


def test_block_tied_by_a_spring_to_the_wedge_that_carries_it(agree: Agreement) -> None:
    """The spring runs from the top of the wedge down its slope to the block; the floor is smooth."""
    wedge, block, angle, k, stretched = 3.0, 1.2, radians(35), 80.0, 0.15
    uphill, out = (cos(angle), 0.0, sin(angle)), (-sin(angle), 0.0, cos(angle))
    builder = Builder()
    room = builder.room()
    carrier = room.body("wedge", wedge).rest(X, Z, speed=0.3)
    carrier.body("block", block).rest(uphill, out, speed=-0.4).site("hook")
    carrier.site("top", at=(uphill[0], 0.0, uphill[2]))
    room.spring("spring", "top", "hook", stiffness=k, length=1.0 - stretched)

    def columns(state: State) -> list[Array]:
        names = ("wedge", "block")
        motion = [read(state, f"{name}.slide") for read in (axis, rate) for name in names]
        return [*motion, *(state.normal[name] for name in names), state.tension["spring"]]

    phase = springs.on_wedge(wedge, block, angle, (k, stretched))
    agree(builder.finish(), (phase, [0.0, 0.0, 0.3, -0.4]), TWO, columns)


def test_ball_that_strikes_a_block_on_a_spring(agree: Agreement) -> None:
    """A heavy ball on a smooth floor hits the block repeatedly until the block sends it back."""
    ball, block, k, distance, restitution, speed = 2.0, 0.7, 50.0, 0.5, 0.9, 1.8
    builder = Builder(ZERO)
    room = builder.room()
    runner = room.body("ball", ball, at=(-distance - 0.1, 0.0, 0.0)).slide(X, speed)
    target = room.body("block", block).slide(X).site("hook")
    room.site("wall", (1.0, 0.0, 0.0))
    room.spring("spring", "hook", "wall", stiffness=k)
    room.collide(runner, target, 0.1, restitution)

    def columns(state: State) -> list[Array]:
        return [read(state, f"{name}.slide") for read in (axis, rate) for name in ("ball", "block")]

    phase = springs.struck(ball, block, k, distance, restitution)
    record = agree(builder.finish(), (phase, [0.0, 0.0, speed, 0.0]), TWO, columns, {"collision": "hit"}, 8)
    assert len(record.events) >= 3
