"""Tests of bodies on surfaces against Newton's equations (`tests/support/lagrangian/rolling.py`)."""

from math import acos, cos, pi, radians, sin, sqrt

import numpy as np
import pytest

from agreement import Agreement, about_y, axis, plane_body, rate
from lagrangian import rolling
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Y, Z
from sim2reason.scenes.dsl.state import Array, State

TWO = np.linspace(0.0, 2.0, 41)
RUBS = {"slip": "slip|stick", "stick": "stick", "lift": "lift"}


def roller(
    body: tuple[float, float, float],
    offset: tuple[float, float],
    face: tuple[float, float],
    start: tuple[float, float],
    spring: tuple[float, float] | None = None,
) -> Mechanism:
    """Build a round body on an incline that rises to the right."""
    (mass, inertia, radius), (d, psi), (slope, mu) = body, offset, face
    uphill, out = np.array([cos(slope), 0.0, sin(slope)]), np.array([-sin(slope), 0.0, cos(slope)])
    center = tuple(d * (sin(psi) * uphill + cos(psi) * out))
    builder = Builder()
    room = builder.room()
    disc = room.body("disc", mass, center=center, inertia=about_y(inertia))
    disc.roll(tuple(uphill), tuple(out), radius, mu, start[0], start[1])
    if spring is not None:
        disc.site("axle")
        room.site("wall", tuple(-3.0 * uphill))
        room.spring("spring", "wall", "axle", stiffness=spring[0], length=3.0 + spring[1])
    return builder.finish()


def rolled(state: State) -> list[Array]:
    motion = [read(state, f"disc.{name}") for read in (axis, rate) for name in ("slide", "hinge")]
    return [*motion, state.normal["disc"], state.friction["disc"]]


@pytest.mark.parametrize(
    ("slope", "mu", "start", "least"),
    [(0.0, 5.0, (0.9, 3.0), 0), (8.0, 0.25, (0.6, 2.0), 2), (20.0, 0.35, (-0.5, 4.0), 1), (-15.0, 0.6, (1.0, 8.0), 5)],
    ids=["rolls", "slips at times", "starts slipping", "leaves the face"],
)
def test_off_centre_rolling(agree: Agreement, slope: float, mu: float, start: tuple[float, float], least: int) -> None:
    """A disc with an eccentric load rolls unevenly, slips and sticks, and lifts off when its load is thrown up."""
    body, offset, face = (2.0, 0.06, 0.3), (0.12, radians(30)), (radians(slope), mu)
    if mu == 5.0:
        start = (0.3 * start[1], start[1])
    reference = rolling.Roller(body, offset, face).begin(*start)
    times = np.linspace(0.0, 1.5, 61)
    record = agree(roller(body, offset, face, start), (reference, [0.0, 0.0, *start]), times, rolled, RUBS)
    assert len(record.events) >= least


def test_sphere_on_a_spring_rolls_and_slips_by_turns(agree: Agreement) -> None:
    """A spring moves a sphere to and fro, which slips while the spring force exceeds what static friction holds."""
    mass, radius = 1.5, 0.2
    body, face, spring, start = (mass, 0.4 * mass * radius**2, radius), (0.0, 0.12), (60.0, -0.25), (0.0, 0.0)
    reference = rolling.Roller(body, (0.0, 0.0), face, spring).begin(*start)
    mechanism = roller(body, (0.0, 0.0), face, start, spring)
    record = agree(mechanism, (reference, [0.0, 0.0, *start]), TWO, rolled, RUBS)
    assert len(record.events) >= 4


@pytest.mark.parametrize(("friction", "least"), [(0.15, 2), (0.5, 1)])
def test_block_in_a_rough_trough(agree: Agreement, friction: float, least: int) -> None:
    """The block starts at 75° and slides to and fro until friction holds it."""
    mass, radius, angle = 0.4, 0.8, radians(75)
    builder = Builder()
    block = builder.room().body("block", mass, center=(radius * sin(angle), 0.0, -radius * cos(angle)))
    block.swing(Y, (-sin(angle), 0.0, cos(angle)), radius, friction=friction, guided=False)

    def columns(state: State) -> list[Array]:
        turned, turn = axis(state, "block.hinge", angle, -1.0), rate(state, "block.hinge", -1.0)
        return [turned, turn, state.normal["block"], -state.friction["block"]]

    reference = rolling.in_bowl(mass, radius, friction)
    times = np.linspace(0.0, 3.0, 61)
    trace = agree(builder.finish(), (reference, [angle, 0.0]), times, columns, {"stick": "stop", "slip": "stop"})
    assert len(trace.events) >= least


def test_block_on_a_smooth_dome(agree: Agreement) -> None:
    """A block that starts at rest at the top leaves the dome at two thirds of the radius above the centre."""
    mass, radius, angle, turn = 0.7, 1.3, radians(5), 0.4
    builder = Builder()
    block = builder.room().body("block", mass, center=(radius * sin(angle), 0.0, radius * cos(angle)))
    block.swing(Y, (sin(angle), 0.0, cos(angle)), radius, speed=turn, guided=False)

    def columns(state: State) -> list[Array]:
        return [axis(state, "block.hinge", angle), rate(state, "block.hinge"), state.normal["block"]]

    reference = (rolling.on_dome(mass, radius), [angle, turn])
    record = agree(builder.finish(), reference, TWO, columns, {"lift": "lift"})
    energy = 2.0 * cos(angle) + radius * turn**2 / rolling.G
    assert record.observed
    assert acos(energy / 3.0) > record.observed[-1][0]


def test_bead_on_a_hoop_that_turns(agree: Agreement) -> None:
    """The hoop turns freely about its vertical diameter, so it slows down as the bead rises."""
    mass, inertia, radius, angle, turn = 0.5, 0.12, 0.6, radians(40), 6.0
    builder = Builder()
    hoop = builder.room().body("hoop", 1.0, inertia=(0.06, 0.06, inertia, 0.0, 0.0, 0.0)).hinge(Z, turn)
    bead = hoop.body("bead", mass, center=(radius * sin(angle), 0.0, -radius * cos(angle)))
    bead.swing(Y, (-sin(angle), 0.0, cos(angle)), radius, guided=True)

    def columns(state: State) -> list[Array]:
        bead = axis(state, "bead.hinge", angle, -1.0), rate(state, "bead.hinge", -1.0)
        return [axis(state, "hoop.hinge"), bead[0], rate(state, "hoop.hinge"), bead[1], state.normal["bead"]]

    reference = (rolling.on_turning_hoop(inertia, mass, radius), [0.0, angle, turn, 0.0])
    agree(builder.finish(), reference, TWO, columns)


def test_bead_on_a_rod_that_turns(agree: Agreement) -> None:
    """A spring connects the bead to the axis of the rod, which turns freely about a vertical line."""
    mass, inertia, spring, r, turn, speed = 0.4, 0.05, (30.0, 0.3), 0.25, 7.0, 0.8
    builder = Builder()
    rod = builder.room().body("rod", 0.5, inertia=about_y(inertia)).hinge(Z, turn)
    rod.site("axle")
    rod.body("bead", mass, at=(r, 0.0, 0.0)).slide(X, speed).site("eye")
    builder.room().spring("spring", "axle", "eye", stiffness=spring[0], length=spring[1])

    def columns(state: State) -> list[Array]:
        places = [axis(state, "rod.hinge"), axis(state, "bead.slide", r)]
        return [*places, rate(state, "rod.hinge"), rate(state, "bead.slide")]

    reference = (rolling.on_turning_rod(inertia, mass, spring), [0.0, r, turn, speed])
    agree(builder.finish(), reference, TWO, columns)


@pytest.mark.parametrize("friction", [(0.0, 0.0), (0.1, 0.2)])
def test_blocks_joined_by_a_rod_on_floor_and_wall(agree: Agreement, friction: tuple[float, float]) -> None:
    """The upper block leaves the wall when the rod no longer pushes on it."""
    masses, long, angle = (1.1, 0.9), 1.5, radians(65)
    foot, top = (long * cos(angle), 0.0, 0.0), (0.0, 0.0, long * sin(angle))
    builder = Builder()
    room = builder.room()
    room.body("foot", masses[0], at=foot).rest(X, Z, friction[0], speed=0.02 * sin(angle)).site("low")
    room.body("top", masses[1], at=top).rest(Z, X, friction[1], speed=-0.02 * cos(angle)).site("high")
    room.rod("rod", "low", "high")

    def columns(state: State) -> list[Array]:
        places = [axis(state, "foot.slide", foot[0]), axis(state, "top.slide", top[2])]
        forces = [state.normal["foot"], state.normal["top"], -state.tension["rod"]]
        return [*places, rate(state, "foot.slide"), rate(state, "top.slide"), *forces]

    reference = (rolling.Ladder(masses, friction, long).phase, [angle, -0.02 / long])
    agree(builder.finish(), reference, TWO, columns, {"lift": "lift"})


@pytest.mark.parametrize("slope", [8.0, 12.0])
def test_hexagonal_prism_tips_down_an_incline(agree: Agreement, slope: float) -> None:
    """A solid prism with I = 5/12 ma² (IPhO 1998) keeps 11/17 of its angular velocity at each landing."""
    side, beta, mass, turn = 0.2, radians(slope), 1.7, 5.0
    record = agree(*prism(side, beta, mass, turn), {"land": "land"})
    after = [later for (_, name), later in zip(record.events, record.events[1:], strict=False) if name == "land"]
    assert len(after) >= 2
    assert rolling.hexagonal_prism(side, beta, 5.0 / 12.0, mass).after("land", 0.0, np.array([1.0, 17.0]))[1][1] == (
        pytest.approx(11.0)
    )


def prism(side: float, beta: float, mass: float, turn: float) -> tuple[object, ...]:
    """Build a hexagonal prism that tips over its lower front edge at first; its edges may touch the incline."""
    down, out = np.array([cos(beta), 0.0, -sin(beta)]), np.array([sin(beta), 0.0, cos(beta)])
    tip = beta - pi / 6.0
    edge = 0.5 * side * down
    center = edge + side * np.array([sin(tip), 0.0, cos(tip)])
    builder = Builder()
    velocity = side * turn * np.array([cos(tip), 0.0, -sin(tip)])
    room = builder.room()
    body = room.body("prism", mass, at=tuple(center), inertia=about_y(5.0 / 12.0 * mass * side**2))
    body.slide(X, velocity[0], name="x").slide(Z, velocity[2], name="z").hinge(Y, turn)
    below = tuple(-center)
    for number in range(6):
        angle = tip + pi + number * pi / 3.0
        arm = side * np.array([sin(angle), 0.0, cos(angle)])
        body.stand(f"edge{number}", tuple(arm), tuple(down), tuple(out), on=below)

    def columns(state: State) -> list[Array]:
        places = [axis(state, "prism.x", center[0]), axis(state, "prism.z", center[2]), axis(state, "prism.hinge")]
        return [*places, *(rate(state, f"prism.{name}") for name in ("x", "z", "hinge"))]

    reference = (rolling.hexagonal_prism(side, beta, 5.0 / 12.0, mass), [tip, turn])
    return builder.finish(), reference, np.linspace(0.0, 1.2, 49), columns


def test_loop_the_loop_lifts_where_weight_and_centripetal_force_balance() -> None:
    """Launched at the bottom with v² = kgR, the block leaves at cos θ = −(k − 2)/3 from straight down."""
    from sim2reason.simulation.engines.exact.engine import motion

    radius, k = 0.9, 3.7
    speed = sqrt(k * rolling.G * radius)
    builder = Builder()
    block = builder.room().body("block", 0.3, center=(0.0, 0.0, -radius))
    block.swing(Y, Z, radius, speed=-speed / radius, guided=False)
    found = motion(builder.finish(), 2.0)
    angle = -found.state(np.array([found.end])).q[0, 0]
    assert found.cut == "lift"
    assert cos(angle) == pytest.approx(-(k - 2.0) / 3.0, rel=1e-9)


def test_two_free_particles_and_a_rod_turn_about_their_centre(agree: Agreement) -> None:
    """Without gravity the centre of mass moves uniformly and the rod rotates uniformly."""
    m1, m2, long, turn = 1.0, 3.0, 0.8, 4.0
    r1, r2 = long * m2 / (m1 + m2), long * m1 / (m1 + m2)
    builder = Builder((0.0, 0.0, 0.0))
    room = builder.room()
    plane_body(room, "one", m1, (r1, 0.0, 0.0), (0.3, r1 * turn))
    plane_body(room, "two", m2, (-r2, 0.0, 0.0), (0.3, -r2 * turn))
    room.rod("rod", "one.hook", "two.hook")
    from lagrangian.follow import Phase

    def observe(t: float, _: Array) -> list[float]:
        pull = m1 * r1 * turn**2
        return [0.3 * t + r1 * cos(turn * t), r1 * sin(turn * t), 0.3 * t - r2 * cos(turn * t), pull]

    def columns(state: State) -> list[Array]:
        one = [axis(state, "one.x", r1), axis(state, "one.z")]
        return [*one, axis(state, "two.x", -r2), state.tension["rod"]]

    agree(builder.finish(), (Phase(lambda _, y: y, observe), [0.0]), TWO, columns)
