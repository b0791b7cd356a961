"""Tests of the MuJoCo engine against textbook formulas; its tolerance is 1e-6, its error about 1e-8."""

from math import cos, radians, sin, sqrt

import numpy as np
import pytest

import machines
import motions
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.engines.mujoco import simulate
from sim2reason.simulation.trace import Trace

G = 9.8
CLOSE = 1e-6
TIMES = np.linspace(0.0, 0.6, 61)


def run(mechanism: Mechanism, times: np.ndarray = TIMES) -> Trace:
    trace = simulate(mechanism, times)
    assert np.isfinite(trace.state.q).all()
    return trace


def speed(trace: Trace, coordinate: str) -> np.ndarray:
    return trace.state.v[:, number(trace, coordinate)]


def number(trace: Trace, coordinate: str) -> int:
    return [c.name for c in trace.mechanism.coordinates].index(coordinate)


def steady(trace: Trace, coordinate: str, a: float) -> None:
    """Assert constant acceleration from rest until the end of the valid motion."""
    held = trace.state.times <= trace.stable_until
    times, i = trace.state.times[held], number(trace, coordinate)
    assert trace.state.a[held, i] == pytest.approx(a, rel=CLOSE, abs=CLOSE)
    assert trace.state.v[held, i] == pytest.approx(a * times, rel=CLOSE, abs=CLOSE)
    assert trace.state.q[held, i] == pytest.approx(a * times**2 / 2, rel=CLOSE, abs=CLOSE)


@pytest.mark.parametrize("pulley", [0.0, 0.4, 3.0])
@pytest.mark.parametrize(("m1", "m2"), [(2.0, 3.0), (5.0, 4.9), (0.5, 9.0)])
def test_atwood(m1: float, m2: float, pulley: float) -> None:
    trace = run(machines.atwood(m1, m2, pulley))
    a = (m2 - m1) * G / (m1 + m2 + pulley / 2)
    steady(trace, "left.slide", a)
    steady(trace, "right.slide", -a)
    tensions = [trace.state.tension[name][0] for name in trace.state.tension]
    assert tensions[0] == pytest.approx(m1 * (G + a), rel=CLOSE)
    assert tensions[-1] == pytest.approx(m2 * (G - a), rel=CLOSE)


def test_the_first_acceleration_is_right() -> None:
    """The accelerations are ± g/5; plain MuJoCo is off by 44 %."""
    assert run(machines.atwood()).state.a[0] == pytest.approx([G / 5, -G / 5], rel=1e-9)


@pytest.mark.parametrize("pulley", [0.0, 0.7])
def test_movable_pulley(pulley: float) -> None:
    m, w = 3.0, 1.0
    trace = run(machines.movable(m, w, pulley))
    a = (2 * w - m - pulley) * G / (4 * w + m + pulley)  # of the load, upwards
    steady(trace, "load.slide", a)
    steady(trace, "weight.slide", -2 * a)
    assert trace.state.tension["rope"][0] == pytest.approx(w * (G - 2 * a), rel=CLOSE)
    assert trace.state.tension["hanger"][0] == pytest.approx(m * (G + a), rel=CLOSE)


def test_nested_atwood() -> None:
    """With massless pulleys the inner pair acts like the mass 4 m1 m2/(m1 + m2)."""
    lone, m1, m2 = 4.0, 1.0, 2.0
    trace = run(machines.nested(lone, m1, m2))
    pair = 4 * m1 * m2 / (m1 + m2)
    a = (pair - lone) * G / (pair + lone)
    steady(trace, "lone.slide", a)
    tension = lone * (G + a)
    assert trace.state.tension["upper"][0] == pytest.approx(tension, rel=CLOSE)
    steady(trace, "left.slide", tension / (2 * m1) - G)
    steady(trace, "right.slide", tension / (2 * m2) - G)


def test_a_block_too_rough_to_slide_sticks_for_ever() -> None:
    trace = run(machines.incline(friction=0.7), np.linspace(0.0, 5.0, 51))
    assert np.abs(trace.state.q).max() <= 1e-9
    assert trace.state.friction["block"] == pytest.approx(2.0 * G * 0.5, rel=CLOSE)
    assert trace.state.normal["block"] == pytest.approx(2.0 * G * cos(radians(30.0)), rel=CLOSE)
    assert trace.events == ()


@pytest.mark.parametrize("friction", [0.0, 0.2, 0.5])
def test_a_block_slides_down(friction: float) -> None:
    trace = run(machines.incline(friction=friction))
    steady(trace, "block.slide", -G * (0.5 - friction * cos(radians(30.0))))


@pytest.mark.parametrize(("friction", "kind"), [(0.3, "slip"), (0.9, "stick")])
def test_a_block_thrown_up_stops_and_turns_or_stays(friction: float, kind: str) -> None:
    v, along, across = 3.0, G * 0.5, G * cos(radians(30.0))
    trace = run(machines.incline(friction=friction, speed=v), np.linspace(0.0, 2.0, 201))
    (event,) = trace.events
    rise, stop = along + friction * across, v / (along + friction * across)
    assert (event.kind, event.subjects) == (kind, ("block",))
    assert event.time == pytest.approx(stop, rel=1e-9)
    back = max(along - friction * across, 0.0) if kind == "slip" else 0.0
    end = v**2 / (2 * rise) - back * (2.0 - stop) ** 2 / 2
    assert trace.state.q[-1, 0] == pytest.approx(end, rel=CLOSE)


def test_block_on_a_rough_incline_tied_to_a_weight() -> None:
    m, w, friction, slope = 2.0, 2.5, 0.3, radians(30.0)
    trace = run(machines.tied_incline(m, w, 30.0, friction))
    a = G * (w - m * sin(slope) - friction * m * cos(slope)) / (m + w)
    steady(trace, "block.slide", a)
    assert trace.state.tension["rope"][0] == pytest.approx(w * (G - a), rel=CLOSE)
    assert trace.state.friction["block"][0] == pytest.approx(-friction * m * G * cos(slope), rel=CLOSE)


def test_block_on_a_movable_wedge() -> None:
    M, m, slope = 5.0, 2.0, radians(35.0)
    trace = run(machines.wedge(M, m, 35.0))
    A = m * G * sin(slope) * cos(slope) / (M + m * sin(slope) ** 2)
    steady(trace, "wedge.slide", A)
    steady(trace, "block.slide", -(M + m) * G * sin(slope) / (M + m * sin(slope) ** 2))
    N = M * m * G * cos(slope) / (M + m * sin(slope) ** 2)
    assert trace.state.normal["block"][0] == pytest.approx(N, rel=CLOSE)
    assert trace.state.normal["wedge"][0] == pytest.approx(M * G + N * cos(slope), rel=CLOSE)


def test_movable_wedge_with_a_string_over_its_top() -> None:
    """Horizontal momentum is conserved, which leaves one equation along the string, relative to the wedge."""
    M, m, w, slope = 5.0, 2.0, 1.5, radians(35.0)
    trace = run(machines.wedge(M, m, 35.0, weight=w))
    drive, total = (w - m * sin(slope)) * G, M + m + w
    b = drive / (m + w - (m * cos(slope)) ** 2 / total)  # of the block up the face
    steady(trace, "block.slide", b)
    steady(trace, "weight.slide", -b)
    steady(trace, "wedge.slide", -m * cos(slope) * b / total)
    assert trace.state.tension["rope"][0] == pytest.approx(w * (G - b), rel=CLOSE)


def test_prism_with_two_blocks_on_smooth_faces() -> None:
    m1, m2, M, a1, a2 = 2.0, 1.5, 4.0, radians(30.0), radians(50.0)
    trace = run(machines.prism(m1, m2, M))
    pull = m1 * cos(a1) + m2 * cos(a2)
    b = (m2 * sin(a2) - m1 * sin(a1)) * G / (m1 + m2 - pull**2 / (m1 + m2 + M))  # of the left block, up
    steady(trace, "left.slide", b)
    steady(trace, "right.slide", -b)
    steady(trace, "prism.slide", -pull * b / (m1 + m2 + M))


def test_stacked_blocks_slide_on_each_other() -> None:
    trace = run(machines.stack(1.0, 3.0, 0.4, 0.1, 20.0))
    upper = 0.4 * G
    lower = (20.0 - 0.4 * G - 0.1 * 4.0 * G) / 3.0
    steady(trace, "lower.slide", lower)
    steady(trace, "upper.slide", upper - lower)


def test_stacked_blocks_stay_together() -> None:
    trace = run(machines.stack(1.0, 3.0, 0.4, 0.1, 8.0), np.linspace(0.0, 5.0, 51))
    a = (8.0 - 0.4 * G) / 4.0
    steady(trace, "lower.slide", a)
    steady(trace, "upper.slide", 0.0)
    assert trace.state.friction["upper"] == pytest.approx(a, rel=CLOSE)


def test_a_slack_string_snaps_taut_without_bounce() -> None:
    """The left load, thrown up, loosens the string by z_left + z_right = v t − g t², until t = v/g."""
    m1, m2, v = 3.0, 2.0, 2.0
    trace = run(machines.atwood(m1, m2, speed=v))
    kinds = [event.kind for event in trace.events if event.kind != "turn"]
    assert kinds == ["taut"]
    taut = next(event.time for event in trace.events if event.kind == "taut")
    assert taut == pytest.approx(v / G, rel=1e-9)
    left, right = v - G * taut, -G * taut
    shared = (m1 * left - m2 * right) / (m1 + m2)
    assert trace.sample(np.array([taut])).v[0] == pytest.approx([shared, -shared], rel=CLOSE)


def test_a_start_with_slack() -> None:
    """Both loads fall until g t² = 0.3 m, the slack; then equal masses bring each other to rest."""
    trace = run(machines.atwood(2.0, 2.0, slack=0.3))
    assert [event.kind for event in trace.events] == ["taut"]
    assert trace.events[0].time == pytest.approx(sqrt(0.3 / G), rel=1e-9)
    assert trace.state.v[-1] == pytest.approx([0.0, 0.0], abs=1e-8)
    assert trace.state.tension["rope"][[0, -1]] == pytest.approx([0.0, 2.0 * G], rel=CLOSE)


@pytest.mark.parametrize("e", [1.0, 0.5, 0.0])
@pytest.mark.parametrize("offset", [0.0, 0.05, -0.19])
def test_collision(e: float, offset: float) -> None:
    """The impulse is −(1 + e) v·n/(1/m1 + 1/m2) along the line of centres."""
    m1, m2, v, distance = 1.0, 2.0, 2.0, 0.2
    trace = run(machines.discs(e, v, offset, m1, m2))
    (event,) = [event for event in trace.events if event.kind != "turn"]
    along = sqrt(distance**2 - offset**2)
    assert (event.kind, event.subjects) == ("collision", ("first", "second"))
    assert event.time == pytest.approx((1.0 - along) / v, rel=1e-9)
    normal = np.array([along, offset]) / distance
    impulse = (1 + e) * v * normal[0] / (1 / m1 + 1 / m2)
    after = np.concatenate([np.array([v, 0.0]) - impulse * normal / m1, impulse * normal / m2])
    assert trace.state.v[-1] == pytest.approx(after, rel=1e-8, abs=1e-8)


def test_a_collision_pulls_at_a_string() -> None:
    """The second cart is tied to a weight; its string goes slack, so the carts collide as if free."""
    trace = run(machines.carts(0.5, 0.0, 0.3), np.linspace(0.0, 0.3, 31))
    kinds = [event.kind for event in trace.events]
    assert kinds == ["collision", "slack"]
    before = trace.sample(np.array([trace.events[0].time - 1e-9])).v[0]
    after = trace.sample(np.array([trace.events[0].time])).v[0]
    shared = (2.0 * before[0] + before[1]) / 3.0
    assert after[:2] == pytest.approx(
        [shared - 0.5 * (before[0] - before[1]) / 3, shared + (before[0] - before[1]) / 3]
    )
    assert after[2] == pytest.approx(before[2], rel=1e-6)


@pytest.mark.parametrize("eccentricity", [0.9, 0.98, 0.998])
def test_a_comet_comes_back_after_a_period(eccentricity: float) -> None:
    """The comet passes its star at as little as a thousandth of its initial distance, and returns."""
    trace = run(motions.orbit(-eccentricity).mechanism, np.linspace(0.0, 1.0, 41))
    fast = trace.state.v[0, 1]
    assert trace.state.q[-1] == pytest.approx(np.zeros(2), abs=1e-7)
    assert trace.state.v[-1] == pytest.approx([0.0, fast], abs=1e-6)
