"""Tests of rare parts in both engines, against closed forms: struts, winches, sticking, redundant rods."""

from math import pi, sqrt

import numpy as np
import pytest

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.fields import Profile, Push
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism, X, Z
from sim2reason.simulation.trace import ENGINES, Trace

G = 9.8
TIMES = np.linspace(0.0, 2.0, 101)
ENGINE = pytest.mark.parametrize("engine", ["exact", "mujoco"])
CLOSE = {"exact": 1e-9, "mujoco": 1e-6}


def when(trace: Trace, kind: str, number: int = 0) -> float:
    """Return the time of an event."""
    return [event.time for event in trace.events if event.kind == kind][number]


def dots(
    places: dict[str, tuple[float, float]], velocities: dict[str, tuple[float, float]], gravity: float = G
) -> Builder:
    """Build particles of 1 kg, free in the plane, each with a hook named after it."""
    builder = Builder((0.0, 0.0, -gravity))
    for name, (x, z) in places.items():
        vx, vz = velocities.get(name, (0.0, 0.0))
        body = builder.room().body(f"body {name}", 1.0, at=(x, 0.0, z))
        body.slide(X, vx, name="x").slide(Z, vz, name="z").site(name)
    return builder


# ---- struts


@ENGINE
def test_a_rocket_waits_on_its_pad_until_it_is_light_enough(engine: str) -> None:
    """The rocket leaves when uṁ = (m₀ − ṁt)g; then v = u ln(m₁/m) − gτ, m₁ its mass as it leaves (Tsiolkovsky)."""
    mass, rate, exhaust = 2.0, 0.5, 30.0
    builder = Builder()
    room = builder.room().site("pad", (0.0, 0.0, -1.0))
    room.body("rocket", mass).slide(Z).site("nozzle").burn(rate, exhaust, 3.0, Z)
    room.prop("strut", "pad", "nozzle")
    trace = ENGINES[engine](builder.finish(), TIMES)
    leaves = (mass - exhaust * rate / G) / rate
    assert when(trace, "leave") == pytest.approx(leaves, rel=CLOSE[engine])
    after = 2.0 - leaves
    light = mass - rate * leaves
    wanted = exhaust * np.log(light / (light - rate * after)) - G * after
    assert trace.state.v[-1, 0] == pytest.approx(wanted, rel=1e3 * CLOSE[engine])
    assert trace.state.tension["strut"][0] == pytest.approx(mass * G - exhaust * rate, rel=CLOSE[engine])


@ENGINE
def test_a_body_that_is_pulled_ever_harder_leaves_its_strut(engine: str) -> None:
    """With F = kt, the body rises from t = mg/k on, by k τ³/6m."""
    builder = Builder()
    room = builder.room().site("floor", (0.0, 0.0, -1.0))
    body = room.body("block", 2.0).slide(Z).site("foot")
    body.force("pull", Push(Z, Profile(0.0, rate=20.0)))
    room.prop("strut", "floor", "foot")
    trace = ENGINES[engine](builder.finish(), TIMES)
    leaves = 2.0 * G / 20.0
    assert when(trace, "leave") == pytest.approx(leaves, rel=CLOSE[engine])
    assert trace.state.q[-1, 0] == pytest.approx(20.0 * (2.0 - leaves) ** 3 / 12.0, rel=1e2 * CLOSE[engine])


@ENGINE
def test_a_winch_draws_its_slack_in_and_then_the_load(engine: str) -> None:
    """The rope with slack s and speed r is taut at s/r; then the load rises with r under tension mg."""
    builder = Builder()
    room = builder.room().site("floor", (0.0, 0.0, -1.0)).site("drum", (0.0, 0.0, 4.0))
    room.body("load", 3.0).slide(Z).site("eye")
    room.prop("strut", "floor", "eye")
    room.string("rope", "drum", "eye", slack=0.2, reel=0.5)
    trace = ENGINES[engine](builder.finish(), TIMES)
    assert when(trace, "taut") == pytest.approx(0.4, rel=CLOSE[engine])
    assert when(trace, "leave") == pytest.approx(0.4, rel=CLOSE[engine])
    assert trace.state.q[-1, 0] == pytest.approx(0.5 * 1.6, rel=CLOSE[engine])
    assert trace.state.tension["rope"][-1] == pytest.approx(3.0 * G, rel=CLOSE[engine])


# ---- what sticks, and what happens at once


@ENGINE
def test_what_sticks_to_a_block_on_a_spring_swings_with_it(engine: str) -> None:
    """Momentum is shared, then ω = √(k/(m + M)): the spring is longest a quarter of a period later."""
    builder = Builder()
    room = builder.room().site("wall", (3.0, 0.0, 0.0))
    clay = room.body("clay", 0.5, at=(-1.0, 0.0, 0.0)).rest(X, Z, 0.0, 2.0)
    block = room.body("block", 1.5).rest(X, Z).site("hook")
    room.spring("spring", "wall", "hook", stiffness=18.0)
    room.collide(clay, block, 0.2, 0.0, sticks=True)
    trace = ENGINES[engine](builder.finish(), TIMES)
    omega, hit = sqrt(18.0 / 2.0), 0.8 / 2.0
    assert when(trace, "collision") == pytest.approx(hit, rel=CLOSE[engine])
    wanted = np.where(hit < TIMES, 0.5 / omega * np.sin(omega * (TIMES - hit)), 0.0)
    assert trace.state.q[:, 1] == pytest.approx(wanted, abs=10.0 * CLOSE[engine])
    assert np.ptp((trace.state.q[:, 1] - trace.state.q[:, 0])[hit < TIMES]) <= CLOSE[engine]


@ENGINE
def test_two_events_at_one_instant_are_both_seen(engine: str) -> None:
    """Two balls of equal acceleration, dropped from the same height, bounce at the same times."""
    builder = Builder()
    room = builder.room()
    for number in range(2):
        ball = room.body(f"ball{number}", 1.0 + number, at=(3.0 * number, 0.0, 1.1)).slide(Z)
        ball.force("push", Push(Z, Profile(0.0, rate=1.0 + number)))  # the same acceleration t for both
        room.bump(room, ball, Z, 0.1, 0.6)
    trace = ENGINES[engine](builder.finish(), TIMES)
    hits = [event for event in trace.events if event.kind == "collision"]
    assert [hit.subjects for hit in hits[:2]] == [("ball0",), ("ball1",)]
    assert hits[0].time == pytest.approx(hits[1].time, abs=1e-9)
    fall = hits[0].time
    assert 0.5 * G * fall**2 - fall**3 / 6.0 == pytest.approx(1.0, rel=1e2 * CLOSE[engine])
    assert trace.state.q[:, 0] == pytest.approx(trace.state.q[:, 1], abs=1e-6)


# ---- held twice


def pendulum(second: str, **law: float) -> Mechanism:
    """Build a bob on a rod, and on another line between the same points."""
    builder = dots({"bob": (0.6, 0.2)}, {})
    room = builder.room().site("nail", (0.0, 0.0, 1.0))
    room.rod("rod", "nail", "bob")
    if second:
        getattr(room, second)("other", "nail", "bob", **law)
    return builder.finish()


@ENGINE
@pytest.mark.parametrize("second", ["string", "rod", "prop"])
def test_what_shares_its_load_with_a_rod_does_not_change_the_motion(engine: str, second: str) -> None:
    alone, both = (ENGINES[engine](pendulum(name), TIMES) for name in ("", second))
    assert both.state.q == pytest.approx(alone.state.q, abs=CLOSE[engine])
    if engine == "exact":  # who bears how much is open
        assert np.isnan(both.state.tension["rod"]).all()
        assert np.isnan(both.state.tension["other"]).all()


@ENGINE
def test_a_slack_string_beside_a_rod_bears_nothing(engine: str) -> None:
    trace = ENGINES[engine](pendulum("string", slack=0.1), TIMES)
    assert not trace.state.tension["other"].any()
    assert np.isfinite(trace.state.tension["rod"]).all()


@ENGINE
@pytest.mark.parametrize("slack", [0.0, 0.1])
def test_a_winch_against_a_rod_is_refused(engine: str, slack: float) -> None:
    with pytest.raises(SimulationError, match="no forces are consistent"):
        ENGINES[engine](pendulum("string", slack=slack, reel=0.5), TIMES)


@ENGINE
def test_two_winches_against_each_other_are_refused(engine: str) -> None:
    builder = dots({"p": (0.0, 0.0)}, {})
    room = builder.room().site("left", (-1.0, 0.0, 0.0)).site("right", (1.0, 0.0, 0.0))
    room.string("one", "left", "p", reel=0.2)
    room.string("other", "right", "p", reel=0.2)
    with pytest.raises(SimulationError, match="no forces are consistent"):
        ENGINES[engine](builder.finish(), TIMES)


@ENGINE
def test_a_square_with_both_diagonals_turns_as_one(engine: str) -> None:
    """Six rods, one more than needed, hold a square that turns at ω about a freely falling centre."""
    places = {"a": (0.0, 0.0), "b": (1.0, 0.0), "c": (1.0, 1.0), "d": (0.0, 1.0)}
    builder = dots(places, {name: (2.0 * (z - 0.5), -2.0 * (x - 0.5)) for name, (x, z) in places.items()})
    for one, other in ("ab", "bc", "cd", "da", "ac", "bd"):
        builder.room().rod(f"{one}{other}", one, other)
    trace = ENGINES[engine](builder.finish(), TIMES)
    angle = 2.0 * TIMES
    for number, (x, z) in enumerate(places.values()):
        turned = (
            0.5 + (x - 0.5) * np.cos(angle) + (z - 0.5) * np.sin(angle),
            0.5 - (x - 0.5) * np.sin(angle) + (z - 0.5) * np.cos(angle) - 0.5 * G * TIMES**2,
        )
        for axis, (wanted, start) in enumerate(zip(turned, (x, z), strict=True)):
            assert trace.state.q[:, 2 * number + axis] == pytest.approx(wanted - start, abs=20.0 * CLOSE[engine])


@ENGINE
def test_a_truss_bears_its_load_at_rest(engine: str) -> None:
    """Both rods carry T = mg/(2 sin 45°); with a third, forces are undetermined and the rest unchanged."""
    builder = dots({"p": (0.0, 0.0)}, {})
    room = builder.room().site("left", (-1.0, 0.0, 1.0)).site("right", (1.0, 0.0, 1.0)).site("top", (0.0, 0.0, 1.0))
    room.rod("one", "left", "p")
    room.rod("other", "right", "p")
    trace = ENGINES[engine](builder.finish(), TIMES)
    assert trace.state.tension["one"] == pytest.approx(G / sqrt(2.0), rel=CLOSE[engine])
    room.rod("third", "top", "p")
    again = ENGINES[engine](builder.finish(), TIMES)
    assert np.abs(again.state.q).max() <= CLOSE[engine]


@ENGINE
@pytest.mark.parametrize("verb", ["rod", "string"])
def test_a_ball_on_a_straight_line_between_two_nails_can_not_fall(engine: str, verb: str) -> None:
    """The ball has no freedom to move, and no finite force can hold it."""
    builder = dots({"p": (0.0, 0.0)}, {})
    room = builder.room().site("left", (-1.0, 0.0, 0.0)).site("right", (1.0, 0.0, 0.0))
    getattr(room, verb)("one", "left", "p")
    getattr(room, verb)("other", "right", "p")
    with pytest.raises(SimulationError, match="contradict each other"):
        ENGINES[engine](builder.finish(), TIMES)


# ---- faces that turn


@ENGINE
def test_a_block_leaves_a_dome_where_its_cosine_is_two_thirds(engine: str) -> None:
    """With mg cos θ = mv²/R and v² = 2gR(cos θ₀ − cos θ) from rest near the top, cos θ = ⅔ cos θ₀."""
    builder = Builder()
    start, radius = 0.1, 1.0
    way = (np.sin(start), 0.0, np.cos(start))
    dome = builder.room().body("block", 0.7, center=tuple(radius * part for part in way))
    dome.swing((0.0, 1.0, 0.0), way, radius, guided=False)
    trace = ENGINES[engine](builder.finish(), np.linspace(0.0, 3.0, 101))
    assert trace.cut == "lift"
    angle = start + float(trace.sample(np.array([trace.stable_until - 1e-12])).q[0, 0])
    assert np.cos(angle) == pytest.approx(2.0 / 3.0 * np.cos(start), rel=10.0 * CLOSE[engine])


@ENGINE
def test_a_block_comes_to_rest_in_a_rough_bowl(engine: str) -> None:
    """Without gravity N = mRω², so ω decreases as ω₀/(1 + µω₀t) and the angle grows as ln(1 + µω₀t)/µ."""
    builder = Builder(ZERO)
    bowl = builder.room().body("block", 0.7, center=(0.0, 0.0, -0.5))
    bowl.swing((0.0, 1.0, 0.0), Z, 0.5, friction=0.4, speed=3.0, guided=False)
    trace = ENGINES[engine](builder.finish(), TIMES)
    assert trace.state.q[:, 0] == pytest.approx(np.log(1.0 + 1.2 * TIMES) / 0.4, abs=10.0 * CLOSE[engine])
    assert trace.state.q[-1, 0] < pi
