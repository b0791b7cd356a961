"""Tests of strings that are slack, snap taut, run out or leave a massless pulley unloaded."""

from collections.abc import Callable
from math import cos, radians, sin, sqrt

import numpy as np
import pytest

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import X, Z
from sim2reason.simulation.engines.exact import motion, simulate

G = 9.8


def loads(m1: float, m2: float, slack: float = 0.0, depth: float = 30.0) -> Builder:
    builder = Builder()
    room = builder.room()
    pulley = room.pulley("P", radius=0.1)
    room.body("A", m1, at=(-0.1, 0.0, -depth)).slide(Z).site("A.hook", at=(0.0, 0.0, 0.0))
    room.body("B", m2, at=(0.1, 0.0, -depth)).slide(Z).site("B.hook")
    room.string("s", "A.hook", pulley, "B.hook", slack=slack)
    return builder


@pytest.mark.parametrize(("m1", "m2"), [(1.0, 3.0), (5.0, 0.7), (2.0, 2.0)])
def test_a_slack_string_snaps_taut(m1: float, m2: float, agree: Callable[..., None]) -> None:
    """Both loads fall freely for d = g t² = slack, and after the jerk v1 = v (m2 − m1)/(m1 + m2) upwards.

    The impulse along the string is the same on both: m1 v1 − m2 v2 is kept, and v1 = −v2 after it, with v = g t.
    """
    slack = 0.8
    t = sqrt(slack / G)
    trace = simulate(loads(m1, m2, slack).finish(), np.array([0.0, t / 2.0, t, t + 0.3]))
    taut = next(event for event in trace.events if event.kind == "taut")
    agree(taut.time, t)
    assert taut.subjects == ("s",)
    v, a = G * t * (m2 - m1) / (m1 + m2), G * (m2 - m1) / (m1 + m2)
    agree(trace.state.v[:, 0], [0.0, -G * t / 2.0, v, v + 0.3 * a], G * t)
    agree(trace.state.v[:, 1], [0.0, -G * t / 2.0, -v, -v - 0.3 * a], G * t)
    tension = 2.0 * m1 * m2 * G / (m1 + m2)
    agree(trace.state.tension["s"], [0.0, 0.0, tension, tension])


def test_kinetic_energy_lost_to_the_jerk(agree: Callable[..., None]) -> None:
    """The loss is ½ µ u², with the reduced mass µ and the string's rate u (Carnot)."""
    m1, m2 = 1.5, 2.5
    found = motion(loads(m1, m2, 0.5).finish(), 1.0)
    before, after = found.segments[0], found.segments[1]
    fall = before.a[0] * after.start
    lost = 0.5 * (m1 + m2) * fall**2 - 0.5 * (m1 * after.v[0] ** 2 + m2 * after.v[1] ** 2)
    agree(lost, 0.5 * m1 * m2 / (m1 + m2) * (2.0 * fall) ** 2)


def test_a_block_outruns_its_string_and_is_caught_again(agree: Callable[..., None]) -> None:
    """A block thrown up a smooth slope has a slack string until v t = ½ (g + g sin θ) t².

    A load hangs from the string over a pulley at the top.
    """
    theta, speed, m1, m2 = radians(30.0), 5.0, 2.0, 1.0
    builder = Builder()
    room = builder.room()
    uphill, outward = (cos(theta), 0.0, sin(theta)), (-sin(theta), 0.0, cos(theta))
    room.site("left").site("right", at=(0.1, 0.0, 0.0))
    start = (-30.0 * uphill[0], 0.0, -30.0 * uphill[2])
    room.body("A", m1, at=start).rest(uphill, outward, speed=speed).site("A.hook", at=(0.0, 0.0, 0.0))
    room.body("B", m2, at=(0.1, 0.0, -10.0)).slide(Z).site("B.hook")
    builder.add_site("a", "A", start)
    room.string("s", "a", "left", "right", "B.hook")
    t = 2.0 * speed / (G + G * sin(theta))
    u1, u2 = speed - G * sin(theta) * t, -G * t
    after = (m1 * u1 - m2 * u2) / (m1 + m2)  # of A uphill: B moves down as fast
    trace = simulate(builder.finish(), np.array([0.0, t + 0.1]))
    (taut,) = [event.time for event in trace.events if event.kind == "taut"]
    agree(taut, t)
    agree(trace.sample(np.array([0.0, taut])).v, [[speed, 0.0], [after, -after]])


def test_rough_block_is_jerked_along_by_a_falling_load(agree: Callable[..., None]) -> None:
    """The block sticks while the string is slack, then is jerked to v = m2 √(2 g d)/(m1 + m2).

    A jerk along a level floor has no friction impulse. Then a = g (m2 − µ m1)/(m1 + m2), and the block stops and
    sticks if that is negative.
    """
    m1, m2, mu, slack = 3.0, 0.5, 0.4, 0.6
    builder = Builder()
    room = builder.room()
    pulley = room.pulley("P")
    room.body("A", m1, at=(-30.0, 0.0, 0.0)).rest(X, Z, mu).site("A.hook")
    room.body("B", m2, at=(0.05, 0.0, -20.0)).slide(Z).site("B.hook")
    room.string("s", "A.hook", pulley, "B.hook", slack=slack)
    found = motion(builder.finish(), 3.0)
    assert [event.kind for event in found.events] == ["taut", "slip", "stick"]
    t = sqrt(2.0 * slack / G)
    v = m2 * G * t / (m1 + m2)
    a = G * (m2 - mu * m1) / (m1 + m2)
    agree(found.segments[1].v, [v, -v])
    agree(found.segments[1].a, [a, -a])
    agree(found.events[2].time, t - v / a)
    last = found.segments[-1]
    assert last.v == [0.0, 0.0]
    assert np.isnan([*last.tension, *last.friction]).tolist() == [False, False]  # the load alone settles the tension
    agree(last.tension, [m2 * G])


def circling() -> Builder:
    """Build a ball on a string in fast circles, for which coarse steps cause a drift of 2 µm."""
    builder = Builder(gravity=(0.0, 0.0, -9.572258543531126))
    room = builder.room()
    room.site("peg", at=(0.0, 0.0, 0.0))
    ball = room.body("ball", 0.9795763643248696, at=(0.0, 0.0, -0.6213037494035291))
    ball.slide(X, speed=-13.1916675649595, name="x").slide(Z, name="z").site("ball.hook")
    room.string("s", "peg", "ball.hook")
    return builder


def test_a_string_stays_taut_where_the_equations_are_solved_in_another_order() -> None:
    """The tension is T ≥ m (v²/l − 5 g) > 0."""
    trace = simulate(circling().finish(), np.array([0.0, 6.19223639]), 1e-8)
    assert {event.kind for event in trace.events} == {"turn"}


@pytest.mark.parametrize("time", [1.4, 3.0, 4.8, 5.9])
def test_a_string_stays_taut_while_others_collide(time: float) -> None:
    """Two distant carts collide while the ball circles."""
    builder = circling()
    room = builder.room()
    one = room.body("one", 1.0, at=(50.0, 0.0, 0.0)).slide(X, speed=1.0)
    other = room.body("other", 1.0, at=(50.1 + time, 0.0, 0.0)).slide(X)
    room.collide(one, other, 0.1, 0.5)
    trace = simulate(builder.finish(), np.array([0.0, 6.19223639]), 1e-8)
    (met,) = (event for event in trace.events if event.kind != "turn")
    assert met.kind == "collision"
    assert met.time == pytest.approx(time)


def test_an_impact_makes_a_taut_string_slack(agree: Callable[..., None]) -> None:
    """A striker M moving up with w gives a hanging ball m the velocity 2 w/(1 + m/M), upwards."""
    builder = Builder()
    room = builder.room()
    room.site("peg", at=(0.0, 0.0, 0.0))
    ball = room.body("ball", 1.0, at=(0.0, 0.0, -1.0)).slide(X, name="x").slide(Z, name="z")
    ball.site("ball.hook")
    striker = room.body("striker", 3.0, at=(0.0, 0.0, -2.0)).slide(Z, speed=6.0)
    room.string("s", "peg", "ball.hook")
    room.collide(ball, striker, 0.2, 1.0)
    t = (6.0 - sqrt(36.0 - 2.0 * G * 0.8)) / G
    trace = simulate(builder.finish(), np.array([0.0, t + 0.01]), 1e-8)
    kinds = [(event.kind, event.subjects) for event in trace.events if event.kind != "turn"]
    assert kinds == [("collision", ("ball", "striker")), ("slack", ("s",))]
    agree(trace.state.v[-1, 1], 1.5 * (6.0 - G * t) - 0.01 * G, 6.0)


def test_a_load_reaches_its_pulley(agree: Callable[..., None]) -> None:
    """The lighter load rises by h with a in t = √(2h/a); the event names the two sites that meet."""
    found = motion(loads(1.0, 2.0, depth=1.5).finish(), 9.0)
    assert found.cut == "reach"
    assert [(event.kind, event.subjects) for event in found.events] == [("reach", ("A.hook", "P.left"))]
    agree(found.end, sqrt(3.0 / (G / 3.0)))


def test_an_unloaded_pulley_in_a_slack_string_ends_the_motion() -> None:
    """In a double Atwood machine with a light lower pulley, a lower load is struck upwards."""
    builder = Builder()
    room = builder.room()
    top = room.pulley("top", radius=0.2)
    room.body("A", 2.0, at=(-0.2, 0.0, -20.0)).slide(Z).site("A.hook", at=(0.0, 0.0, 0.0))
    carriage = room.body("P", 0.0, at=(0.2, 0.0, -10.0)).slide(Z).site("P.hook")
    low = carriage.pulley("wheel", radius=0.1)
    b = room.body("B", 1.0, at=(0.1, 0.0, -20.0)).slide(Z).site("B.hook")
    room.body("C", 1.0, at=(0.3, 0.0, -20.0)).slide(Z).site("C.hook")
    ball = room.body("S", 1.0, at=(0.1, 0.0, -21.0)).slide(Z, 6.0)
    room.string("upper", "A.hook", top, "P.hook")
    room.string("lower", "B.hook", low, "C.hook")
    room.collide(ball, b, 0.2, 1.0)
    found = motion(builder.finish(), 2.0)
    assert found.cut == "indeterminate"
    assert found.events[-1].subjects == ("P.slide",)
    assert found.events[0].kind == "collision"


def test_a_massive_wheel_goes_on_turning_in_a_slack_string(agree: Callable[..., None]) -> None:
    """One load of an Atwood machine with a heavy wheel is thrown up, so that its part of the string is slack.

    The other part turns the wheel with T = m2 (g − a), a = m2 g/(m2 + M/2).
    """
    m1, m2, wheel, speed = 1.0, 1.0, 2.0, 3.0
    builder = Builder()
    room = builder.room()
    pulley = room.pulley("P", mass=wheel, radius=0.1)
    room.body("A", m1, at=(-0.1, 0.0, -30.0)).slide(Z, speed).site("A.hook", at=(0.0, 0.0, 0.0))
    room.body("B", m2, at=(0.1, 0.0, -30.0)).slide(Z).site("B.hook")
    room.string("s", "A.hook", pulley, "B.hook")
    found = motion(builder.finish(), 0.01)
    a = m2 * G / (m2 + wheel / 2.0)
    agree(found.segments[0].tension, [0.0, m2 * (G - a)])
    agree(found.segments[0].a, [a / 0.1, -G, -a])
    # part 1 is straight again when what the wheel let out and A's rise agree: v t − g t²/2 = a t²/2
    taut = next(event for event in motion(builder.finish(), 1.0).events if event.kind == "taut")
    agree(taut.time, 2.0 * speed / (G + a))
    assert taut.subjects == ("s/1",)
