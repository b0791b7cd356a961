"""Tests of collisions against Newton's law of impact, alone and with strings and rough floors."""

from collections.abc import Callable, Iterable
from math import cos, hypot, pi, radians, sin, sqrt, tan

import numpy as np
import pytest

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.builder import Builder, Frame
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism, X, Y, Z
from sim2reason.scenes.dsl.vectors import Vector, scale
from sim2reason.simulation.engines.exact import motion, simulate
from sim2reason.simulation.trace import Event

G = 9.8
RESTITUTIONS = (1.0, 0.5, 0.0)
SEEDS = range(5)


def kinds(events: Iterable[Event]) -> list[str]:
    return [event.kind for event in events]


@pytest.mark.parametrize("e", RESTITUTIONS)
@pytest.mark.parametrize("seed", SEEDS)
def test_one_dimension(seed: int, e: float, agree: Callable[..., None]) -> None:
    """The velocity is v1⁺ = (m1 v1 + m2 v2 − e m2 (v1 − v2))/(m1 + m2), by momentum and u⁺ = −e u⁻."""
    rng = np.random.default_rng(seed)
    m1, m2, v1, v2, gap = rng.uniform((0.2, 0.2, 1.0, -2.0, 0.1), (5.0, 5.0, 4.0, 0.5, 2.0))
    builder = Builder()
    room = builder.room()
    a = room.body("A", m1).rest(X, Z, speed=v1)
    b = room.body("B", m2, at=(gap + 0.3, 0.0, 0.0)).rest(X, Z, speed=v2)
    room.collide(a, b, 0.3, e)
    t = gap / (v1 - v2)
    after1 = (m1 * v1 + m2 * v2 - e * m2 * (v1 - v2)) / (m1 + m2)
    after2 = (m1 * v1 + m2 * v2 + e * m1 * (v1 - v2)) / (m1 + m2)
    trace = simulate(builder.finish(), np.array([0.0, t + 1.0]))
    assert [(event.kind, event.subjects) for event in trace.events] == [("collision", ("A", "B"))]
    agree(trace.events[0].time, t)
    agree(trace.state.v[1], [after1, after2])
    agree(trace.state.q[1], [v1 * t + after1, v2 * t + after2])
    assert trace.cut == ""


@pytest.mark.parametrize("e", RESTITUTIONS)
@pytest.mark.parametrize("tilt", [0.0, 0.4])
@pytest.mark.parametrize("seed", SEEDS)
def test_oblique(seed: int, tilt: float, e: float, agree: Callable[..., None]) -> None:
    """The impulse along the line of centres n is J = −(1 + e) u·n/(1/m1 + 1/m2), also on a tilted table.

    The time solves |d + u t| = 2r, since relative motion is uniform.
    """
    rng = np.random.default_rng(seed)
    m1, m2, offset = rng.uniform((0.2, 0.2, -0.15), (5.0, 5.0, 0.15))
    u = np.array([rng.uniform(1.0, 3.0), rng.uniform(-0.1, 0.1)])
    v2 = rng.uniform(-1.0, 1.0, 2)
    v1, d, reach = v2 + u, np.array([2.0, offset]), 0.4
    builder = Builder(gravity=(0.0, -G * sin(tilt), -G * cos(tilt)))
    room = builder.room()
    a = room.body("A", m1).slide(X, v1[0], name="x").slide(Y, v1[1], name="y")
    b = room.body("B", m2, at=(2.0, offset, 0.0)).slide(X, v2[0], name="x").slide(Y, v2[1], name="y")
    room.collide(a, b, reach, e)
    along = d @ u
    t = (along - sqrt(along**2 - (u @ u) * (d @ d - reach**2))) / (u @ u)
    n = (d - u * t) / reach
    impulse = (1.0 + e) * (u @ n) / (1.0 / m1 + 1.0 / m2)
    trace = simulate(builder.finish(), np.array([0.0, t + 0.5]))
    (hit,) = [event.time for event in trace.events if event.kind == "collision"]
    agree(hit, t)
    state = trace.sample(np.array([hit, t + 0.5]))
    g = np.array([0.0, -G * sin(tilt)])
    after1, after2 = v1 - impulse / m1 * n, v2 + impulse / m2 * n
    agree(state.v[0], [*(after1 + g * t), *(after2 + g * t)])
    agree(state.v[1], [*(after1 + g * (t + 0.5)), *(after2 + g * (t + 0.5))])
    fall = g * (t + 0.5) ** 2 / 2.0
    agree(state.q[1], [*(v1 * t + after1 * 0.5 + fall), *(v2 * t + after2 * 0.5 + fall)])
    assert trace.cut == ""


def test_equal_balls_part_at_a_right_angle(agree: Callable[..., None]) -> None:
    """For one ball at rest and e = 1, conservation of energy and momentum gives v1·v2 = 0."""
    builder = Builder(gravity=ZERO)
    room = builder.room()
    a = room.body("A", 1.0).slide(X, 2.0, name="x").slide(Y, name="y")
    b = room.body("B", 1.0, at=(1.0, 0.1, 0.0)).slide(X, name="x").slide(Y, name="y")
    room.collide(a, b, 0.2, 1.0)
    x1, y1, x2, y2 = motion(builder.finish(), 2.0).segments[-1].v
    agree(x1 * x2 + y1 * y2, 0.0, 4.0)
    agree(x1 + x2, 2.0)


@pytest.mark.parametrize(("power", "hits"), [(0, 3), (1, 31), (2, 314)])
def test_galperin_counts_the_digits_of_pi(power: int, hits: int) -> None:
    """Balls of masses 1 and 100^k and a wall have floor(π·10^k) elastic collisions.

    G. Galperin, Playing pool with π (2003).
    """
    builder = Builder()
    room = builder.room()
    speed = 0.1**power
    wall = room.body("wall", 1.0)
    small = room.body("small", 1.0, at=(1.0, 0.0, 0.0)).rest(X, Z)
    large = room.body("large", 100.0**power, at=(2.0, 0.0, 0.0)).rest(X, Z, speed=-speed)
    room.collide(wall, small, 0.1, 1.0)
    room.collide(small, large, 0.1, 1.0)
    found = motion(builder.finish(), 100.0 / speed)
    assert kinds(found.events).count("collision") == hits == int(pi * 10**power)
    assert found.cut == ""


def bouncing(e: float, height: float = 1.0) -> Builder:
    builder = Builder()
    room = builder.room()
    ball = room.body("ball", 0.3, at=(0.0, 0.0, height + 0.1)).slide(Z)
    room.collide(room.body("floor"), ball, 0.1, e)
    return builder


def test_bounces_until_they_crowd(agree: Callable[..., None]) -> None:
    """The k-th bounce is at t1 + (2 v1/g) e (1 − e^(k−1))/(1 − e) with t1 = √(2h/g) and v1 = g t1.

    The first interval 2 v1 e^k/g below 5 ms ends the motion at the hit before it.
    """
    e, t1 = 0.5, sqrt(2.0 / G)
    found = motion(bouncing(e).finish(), 5.0)
    times = [event.time for event in found.events if event.kind == "collision"]
    expected = [t1 + 2.0 * t1 * e * (1.0 - e**k) / (1.0 - e) for k in range(len(times))]
    agree(times, expected)
    assert (found.cut, found.events[-1].kind, found.end) == ("crowd", "crowd", times[-1])
    last = len(times)
    assert 2.0 * t1 * e**last < 5e-3 < 2.0 * t1 * e ** (last - 1)
    assert found.segments[-1].start == found.end


def test_at_the_top_of_a_bounce_the_speed_passes_zero(agree: Callable[..., None]) -> None:
    """The ball is at the top halfway between two bounces, at t1 + e v1/g."""
    found = motion(bouncing(0.8).finish(), 1.0)
    t1 = sqrt(2.0 / G)
    turn = next(event for event in found.events if event.kind == "turn")
    agree(turn.time, t1 + 0.8 * t1)
    assert turn.subjects == ("ball.slide",)


def test_an_inelastic_ball_is_pressed_on_the_floor() -> None:
    """With e = 0 the next bounce is at the same time."""
    found = motion(bouncing(0.0).finish(), 3.0)
    assert kinds(found.events) == ["collision", "crowd"]
    assert found.cut == "crowd"


def test_a_ball_between_two_others_is_hit_from_both_sides_at_once(agree: Callable[..., None]) -> None:
    """The middle ball stays at rest by symmetry, and the outer ones rebound as from a wall, with −e v."""
    builder = Builder()
    room = builder.room()
    left = room.body("L", 1.0, at=(-1.0, 0.0, 0.0)).rest(X, Z, speed=1.0)
    middle = room.body("M", 2.0).rest(X, Z)
    right = room.body("R", 1.0, at=(1.0, 0.0, 0.0)).rest(X, Z, speed=-1.0)
    room.collide(left, middle, 0.2, 0.6)
    room.collide(middle, right, 0.2, 0.6)
    found = motion(builder.finish(), 2.0)
    assert kinds(found.events) == ["collision", "collision"]
    agree(found.segments[-1].v, [-0.6, 0.0, 0.6])


def struck(e: float, m1: float, m2: float, ball: float) -> tuple[Builder, Frame]:
    """Build a block on a smooth table tied to a hanging load, and a ball that comes from the pulley's side."""
    builder = Builder()
    room = builder.room()
    pulley = room.pulley("P", at=(30.0, 0.0, 0.0))
    block = room.body("A", m1).rest(X, Z).site("A.hook", at=(0.0, 0.0, 0.0))
    room.body("B", m2, at=(30.05, 0.0, -30.0)).slide(Z).site("B.hook")
    striker = room.body("S", ball, at=(3.0, 0.0, 0.0)).rest(X, Z, speed=-2.0)
    room.string("s", "A.hook", pulley, "B.hook")
    room.collide(block, striker, 0.5, e)
    return builder, room


@pytest.mark.parametrize("e", RESTITUTIONS)
@pytest.mark.parametrize("seed", SEEDS)
def test_a_block_on_a_taut_string_is_struck(seed: int, e: float, agree: Callable[..., None]) -> None:
    """The taut string couples block and load, so the ball collides with a mass m1 + m2.

    Before it, both move with a = m2 g/(m1 + m2); the gap closes when 2.5 = 2t + a t²/2.
    """
    m1, m2, ball = np.random.default_rng(seed).uniform((0.5, 0.2, 0.2), (4.0, 1.0, 4.0))
    builder, _ = struck(e, m1, m2, ball)
    a = m2 * G / (m1 + m2)
    t = (sqrt(4.0 + 5.0 * a) - 2.0) / a
    u1, u2, m = a * t, -2.0, m1 + m2
    after = (m * u1 + ball * u2 - e * ball * (u1 - u2)) / (m + ball)
    ball_after = (m * u1 + ball * u2 + e * m * (u1 - u2)) / (m + ball)
    trace = simulate(builder.finish(), np.array([0.0, t + 1e-6]))
    agree(trace.events[0].time, t)
    assert trace.events[0].kind == "collision"
    if trace.cut:  # e = 0: the string goes on to press the block against the ball
        assert (e, trace.cut) == (0.0, "crowd")
        return
    agree(trace.state.v[1], [after + a * 1e-6, -after - a * 1e-6, ball_after])
    agree(trace.state.tension["s"], np.full(2, m1 * a))


def test_a_load_that_is_struck_upwards_lets_the_string_go_slack(agree: Callable[..., None]) -> None:
    """A ball strikes one of two balanced loads m upwards with e = 1: it leaves with u, the other load stays.

    Both fall with g till the string, −u t + g t² longer, is straight at t = u/g. Then the struck load rests and
    the other falls with u; the jerk leaves both with u/2.
    """
    m, ball, speed = 2.0, 1.0, 6.0
    builder = Builder()
    room = builder.room()
    pulley = room.pulley("P", radius=0.5)
    a = room.body("A", m, at=(-0.5, 0.0, -40.0)).slide(Z).site("A.hook", at=(0.0, 0.0, 0.0))
    room.body("B", m, at=(0.5, 0.0, -40.0)).slide(Z).site("B.hook")
    striker = room.body("S", ball, at=(-0.5, 0.0, -41.0)).slide(Z, speed)
    room.string("s", "A.hook", pulley, "B.hook")
    room.collide(striker, a, 0.2, 1.0)
    t = (speed - sqrt(speed**2 - 1.6 * G)) / G
    u = 2.0 * ball * (speed - G * t) / (ball + m)
    trace = simulate(builder.finish(), np.array([0.0, t, t + 0.5 * u / G, t + u / G, t + u / G + 0.1]))
    changes = [event for event in trace.events if event.kind != "turn"]
    assert kinds(changes) == ["collision", "slack", "taut"]
    agree([event.time for event in changes], [t, t, t + u / G])
    agree(trace.state.v[:, 0], [0.0, u, u / 2.0, u / 2.0, u / 2.0], u)
    agree(trace.state.v[:, 1], [0.0, 0.0, -u / 2.0, -u / 2.0, -u / 2.0], u)
    agree(trace.state.tension["s"], [m * G, 0.0, 0.0, m * G, m * G])
    agree(trace.state.q[4, :2], [u**2 / (2.0 * G) + 0.05 * u, -(u**2) / (2.0 * G) - 0.05 * u], u)


@pytest.mark.parametrize(("mu", "stops"), [(0.1, False), (0.6, True)])
def test_a_ball_falls_on_a_sliding_block(mu: float, stops: bool, agree: Callable[..., None]) -> None:
    """The floor's reaction to J = (1 + e) m v brakes the block by µJ, at most to rest.

    The block starts so far back that it is under the ball when that arrives.
    """
    e, ball, block, drop, speed = 0.5, 0.5, 2.0, 1.0, 3.0
    t = sqrt(2.0 * drop / G)
    back = speed * t - mu * G * t**2 / 2.0
    builder = Builder()
    room = builder.room()
    a = room.body("A", block, at=(-back, 0.0, 0.0)).rest(X, Z, mu, speed)
    b = room.body("B", ball, at=(0.0, 0.0, drop + 0.3)).slide(Z)
    room.collide(a, b, 0.3, e)
    found = motion(builder.finish(), t + 0.01)
    before = speed - mu * G * t
    after = before - mu * (1.0 + e) * ball * G * t / block
    assert (after < 0.0) == stops
    assert kinds(found.events) == (["collision", "stick"] if stops else ["collision"])
    agree(found.events[0].time, t)
    agree(found.segments[-1].v, [max(0.0, after), e * G * t])


@pytest.mark.parametrize("e", RESTITUTIONS)
def test_a_ball_falls_on_a_movable_wedge(e: float, agree: Callable[..., None]) -> None:
    """The ball hits the wedge along the face's normal, and the wedge can only move sideways.

    Along the normal n = (−sin θ, cos θ) the ball's speed of approach is v cos θ; the effective masses are m and
    M/sin² θ. The ball moves freely in the plane, the floor's impulse keeps the wedge down.
    """
    theta, wedge, m, drop = radians(30.0), 3.0, 1.2, 0.8
    n = np.array([-sin(theta), cos(theta)])
    builder = Builder()
    room = builder.room()
    w = room.body("W", wedge).rest(X, Z)
    start = (0.5 * n[0], 0.0, 0.5 * n[1] + drop)
    b = room.body("B", m, at=start).slide(X, name="x").slide(Z, name="z")
    room.collide(w, b, 0.5, e)
    v = sqrt(2.0 * G * drop)
    impulse = (1.0 + e) * v * cos(theta) / (1.0 / m + sin(theta) ** 2 / wedge)
    found = motion(builder.finish(), 0.5)
    agree(found.events[0].time, v / G)
    after = next(segment for segment in found.segments if segment.start > 0.0)
    agree(after.v, [impulse * sin(theta) / wedge, impulse * n[0] / m, -v + impulse * n[1] / m])


def test_the_path_to_a_hit_may_bend(agree: Callable[..., None]) -> None:
    """A ball thrown horizontally, x = v t, z = −g t²/2, hits one at rest where |r| = d, a quartic in t."""
    builder = Builder()
    room = builder.room()
    a = room.body("A", 1.0, at=(-1.0, 0.0, 1.0)).slide(X, 3.0, name="x").slide(Z, name="z")
    b = room.body("B", 1.0)
    room.collide(a, b, 0.5, 1.0)
    found = motion(builder.finish(), 1.0)
    t = found.events[0].time
    agree(hypot(-1.0 + 3.0 * t, 1.0 - G * t**2 / 2.0), 0.5)
    sampled = np.linspace(0.0, t, 2000)[:-1]
    assert np.hypot(-1.0 + 3.0 * sampled, 1.0 - G * sampled**2 / 2.0).min() > 0.5
    n = np.array([-1.0 + 3.0 * t, 1.0 - G * t**2 / 2.0]) / 0.5
    u = np.array([3.0, -G * t])
    agree(found.segments[1].v, u - 2.0 * (u @ n) * n)


def test_a_sliding_block_is_struck_back(agree: Callable[..., None]) -> None:
    """A horizontal impulse causes no friction impulse; the block then slides the other way, which is an event."""
    mu, m = 0.2, 1.0
    builder = Builder()
    room = builder.room()
    a = room.body("A", m).rest(X, Z, mu, 1.0)
    b = room.body("B", m, at=(1.0, 0.0, 0.0)).rest(X, Z, 0.0, -3.0)
    room.collide(a, b, 0.2, 1.0)
    found = motion(builder.finish(), 5.0)
    t = found.events[0].time
    agree(4.0 * t - mu * G * t**2 / 2.0, 0.8)
    assert kinds(found.events) == ["collision", "slip", "stick"]
    agree(found.segments[1].v, [-3.0, 1.0 - mu * G * t])
    agree(found.events[2].time, t + 3.0 / (mu * G))


def test_a_resting_block_is_struck_into_motion(agree: Callable[..., None]) -> None:
    """The block slips, decelerates by µg and sticks again after v²/(2µg)."""
    mu = tan(radians(15.0))
    builder = Builder()
    room = builder.room()
    a = room.body("A", 2.0).rest(X, Z, mu)
    b = room.body("B", 1.0, at=(-1.0, 0.0, 0.0)).rest(X, Z, 0.0, 3.0)
    room.collide(b, a, 0.2, 0.5)
    found = motion(builder.finish(), 5.0)
    assert kinds(found.events) == ["collision", "slip", "stick"]
    v = 1.5 * 3.0 / 3.0
    agree(found.segments[1].v, [v, 3.0 - 2.0 * v], v)
    agree(found.segments[2].q[0], v**2 / (2.0 * mu * G))


@pytest.mark.parametrize("axis", [X, Y, Z])
@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("wall", [1.0, 0.0, -1.0])
def test_a_wall_throws_back_wherever_it_is(wall: float, side: float, axis: Vector, agree: Callable[..., None]) -> None:
    """From 0.5 m, at 2 m/s, a ball is at the wall after 0.25 s, and 0.5 e = 0.3 m from it after as long again."""

    def before(away: float) -> Mechanism:
        builder = Builder(gravity=ZERO)
        room = builder.room()
        ball = room.body("A", 1.5, at=scale(wall + away * side, axis)).slide(axis, -2.0 * side)
        room.bump(room, ball, scale(side, axis), side * wall, 0.6)
        return builder.finish()

    found = motion(before(0.5), 0.5)
    assert kinds(found.events) == ["collision"]
    agree(found.events[0].time, 0.25)
    agree(found.segments[-1].v, [1.2 * side])
    agree(simulate(before(0.5), np.array([0.5])).state.q, [[-0.2 * side]])
    with pytest.raises(SceneError, match="overlaps what is fixed"):
        motion(before(-0.001), 0.5)
