"""Tests of pulleys against textbook formulas, each derived in the docstring of its test."""

from collections.abc import Callable

import numpy as np
import pytest

from sim2reason.scenes.dsl.builder import Builder, Frame, Rim
from sim2reason.scenes.dsl.mechanism import X, Z
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.trace import Trace

G = 9.8
SEEDS = range(8)


def masses(seed: int, count: int) -> list[float]:
    return np.random.default_rng(seed).uniform(0.3, 9.0, count).tolist()


def hang(room: Frame, name: str, mass: float, x: float, z: float = -20.0) -> Frame:
    return room.body(name, mass, at=(x, 0.0, z)).slide(Z).site(f"{name}.hook", at=(0.0, 0.0, 0.0))


def run(builder: Builder, duration: float = 0.7) -> Trace:
    trace = simulate(builder.finish(), np.linspace(0.0, duration, 8))
    assert trace.events == ()
    assert trace.stable_until == duration
    return trace


def check(
    agree: Callable[..., None], trace: Trace, accelerations: dict[str, float], tensions: dict[str, float]
) -> None:
    """Assert that all coordinates move from rest with constant acceleration; the sign is ignored for wheels."""
    state, t = trace.state, trace.state.times
    for number, coordinate in enumerate(trace.mechanism.coordinates):
        a = accelerations[coordinate.name]
        sign = np.sign(a * state.a[0, number]) if coordinate.kind == "hinge" else 1.0
        agree(sign * state.a[:, number], a + 0.0 * t, G)
        agree(sign * state.v[:, number], a * t, G * t[-1])
        agree(sign * state.q[:, number], a * t**2 / 2.0, G * t[-1] ** 2)
    for name, tension in tensions.items():
        agree(state.tension[name], tension + 0.0 * t)


@pytest.mark.parametrize("seed", SEEDS)
def test_atwood(seed: int, agree: Callable[..., None]) -> None:
    """The load m has T − m g = m a, so a = (m2 − m1) g/(m1 + m2), T = 2 m1 m2 g/(m1 + m2)."""
    m1, m2 = masses(seed, 2)
    builder = Builder()
    room = builder.room()
    pulley = room.pulley("P")
    hang(room, "A", m1, -0.05)
    hang(room, "B", m2, 0.05)
    room.string("s", "A.hook", pulley, "B.hook")
    a = (m2 - m1) * G / (m1 + m2)
    check(agree, run(builder), {"A.slide": a, "B.slide": -a}, {"s": 2.0 * m1 * m2 * G / (m1 + m2)})


@pytest.mark.parametrize("seed", SEEDS)
def test_atwood_with_a_massive_pulley(seed: int, agree: Callable[..., None]) -> None:
    """The wheel has (T2 − T1) R = I a/R with I = M R²/2, so a = (m2 − m1) g/(m1 + m2 + M/2); T = m (g ± a)."""
    m1, m2, wheel = masses(seed, 3)
    builder = Builder()
    room = builder.room()
    pulley = room.pulley("P", mass=wheel, radius=0.12)
    hang(room, "A", m1, -0.12)
    hang(room, "B", m2, 0.12)
    room.string("s", "A.hook", pulley, "B.hook")
    a = (m2 - m1) * G / (m1 + m2 + wheel / 2.0)
    accelerations = {"A.slide": a, "B.slide": -a, "P.hinge": a / 0.12}
    check(agree, run(builder), accelerations, {"s/1": m1 * (G + a), "s/2": m2 * (G - a)})


def movable(load: float, counterweight: float, wheel: float) -> Builder:
    """Build a load on a movable pulley, its string from the ceiling and over a fixed one to a counterweight."""
    builder = Builder()
    room = builder.room()
    fixed = room.pulley("F")
    room.site("nail", at=(-0.15, 0.0, 0.0))
    carriage = hang(room, "L", load, -0.1, -10.0)
    under = carriage.pulley("W", mass=wheel)
    hang(room, "C", counterweight, 0.05)
    room.string("s", "nail", under, fixed, "C.hook")
    return builder


@pytest.mark.parametrize("seed", SEEDS)
def test_movable_pulley(seed: int, agree: Callable[..., None]) -> None:
    """With 2T − L g = L a and T = C (g − 2a), a = (2C − L) g/(L + 4C)."""
    load, counterweight = masses(seed, 2)
    a = (2.0 * counterweight - load) * G / (load + 4.0 * counterweight)
    trace = run(movable(load, counterweight, 0.0))
    check(agree, trace, {"L.slide": a, "C.slide": -2.0 * a}, {"s": counterweight * (G - 2.0 * a)})


@pytest.mark.parametrize("seed", SEEDS)
def test_movable_pulley_with_mass(seed: int, agree: Callable[..., None]) -> None:
    """The wheel rolls up the fixed part of the string, ω = v/R, so T2 − T1 = I a/R² = W a/2.

    With T1 + T2 − (L + W) g = (L + W) a and T2 = C (g − 2a): a = (2C − L − W) g/(L + W + 4C + W/2).
    """
    load, counterweight, wheel = masses(seed, 3)
    total = load + wheel
    a = (2.0 * counterweight - total) * G / (total + 4.0 * counterweight + wheel / 2.0)
    far = counterweight * (G - 2.0 * a)
    trace = run(movable(load, counterweight, wheel))
    accelerations = {"L.slide": a, "C.slide": -2.0 * a, "W.hinge": a / 0.05}
    check(agree, trace, accelerations, {"s/1": far - wheel * a / 2.0, "s/2": far})


def light_pulley(room: Frame, name: str, x: float, z: float, radius: float) -> tuple[Frame, Rim]:
    frame = hang(room, name, 0.0, x, z)
    return frame, frame.pulley(f"{name}.wheel", radius=radius)


@pytest.mark.parametrize("seed", SEEDS)
def test_double_atwood(seed: int, agree: Callable[..., None]) -> None:
    """A light pulley with m2 and m3 pulls like one mass µ = 4 m2 m3/(m2 + m3), in its frame with g' = g − a.

    In that frame each end of the string carries T/2 = 2 m2 m3 g'/(m2 + m3).
    """
    m1, m2, m3 = masses(seed, 3)
    builder = Builder()
    room = builder.room()
    top = room.pulley("top", radius=0.2)
    hang(room, "A", m1, -0.2)
    _, low = light_pulley(room, "P", 0.2, -10.0, 0.1)
    hang(room, "B", m2, 0.1)
    hang(room, "C", m3, 0.3)
    room.string("upper", "A.hook", top, "P.hook")
    room.string("lower", "B.hook", low, "C.hook")
    mu = 4.0 * m2 * m3 / (m2 + m3)
    fall = (mu - m1) * G / (m1 + mu)  # of the pulley
    relative = (m3 - m2) * (G - fall) / (m2 + m3)
    tension = m1 * (G + fall)
    accelerations = {"A.slide": fall, "P.slide": -fall, "B.slide": relative - fall, "C.slide": -relative - fall}
    check(agree, run(builder), accelerations, {"upper": tension, "lower": tension / 2.0})


@pytest.mark.parametrize("seed", SEEDS)
def test_triple_atwood(seed: int, agree: Callable[..., None]) -> None:
    """The substitution is made twice: the loads of a light pulley count as one mass in the frame of the next."""
    m1, m2, m3, m4 = masses(seed, 4)
    builder = Builder()
    room = builder.room()
    top = room.pulley("top", radius=0.4)
    hang(room, "A", m1, -0.4)
    _, middle = light_pulley(room, "P", 0.4, -10.0, 0.2)
    hang(room, "B", m2, 0.2)
    _, low = light_pulley(room, "Q", 0.6, -15.0, 0.1)
    hang(room, "C", m3, 0.5, -25.0)
    hang(room, "D", m4, 0.7, -25.0)
    room.string("one", "A.hook", top, "P.hook")
    room.string("two", "B.hook", middle, "Q.hook")
    room.string("three", "C.hook", low, "D.hook")
    inner = 4.0 * m3 * m4 / (m3 + m4)
    outer = 4.0 * m2 * inner / (m2 + inner)
    p = (outer - m1) * G / (m1 + outer)  # downward, of P
    q = p + (inner - m2) * (G - p) / (m2 + inner)  # downward, of Q
    b = 2.0 * p - q
    d = q + (m4 - m3) * (G - q) / (m3 + m4)
    c = 2.0 * q - d
    accelerations = {"A": p, "P": -p, "B": -b, "Q": -q, "C": -c, "D": -d}
    tension = m1 * (G + p)
    check(
        agree,
        run(builder),
        {f"{name}.slide": a for name, a in accelerations.items()},
        {"one": tension, "two": tension / 2.0, "three": tension / 4.0},
    )


@pytest.mark.parametrize("seed", SEEDS)
def test_a_hand_pulls_through_a_movable_pulley(seed: int, agree: Callable[..., None]) -> None:
    """A force F at the free end is the tension of both parts of the string, so a = 2F/L − g."""
    load, force = masses(seed, 2)
    builder = Builder()
    room = builder.room()
    fixed = room.pulley("F")
    room.site("nail", at=(-0.15, 0.0, 0.0)).site("hand", at=(0.05, 0.0, -40.0))
    under = hang(room, "L", load, -0.1, -20.0).pulley("W")
    room.pull("s", "nail", under, fixed, "hand", force=force)
    check(agree, run(builder), {"L.slide": 2.0 * force / load - G}, {"s": force})


@pytest.mark.parametrize("seed", SEEDS)
def test_table_pulled_over_its_edge(seed: int, agree: Callable[..., None]) -> None:
    """With m1 on a smooth table, m2 hanging, and a pulley of mass M, a = m2 g/(m1 + m2 + M/2)."""
    m1, m2, wheel = masses(seed, 3)
    builder = Builder()
    room = builder.room()
    pulley = room.pulley("P", mass=wheel)
    room.body("A", m1, at=(-30.0, 0.0, 0.0)).rest(along=X, normal=Z).site("A.hook")
    hang(room, "B", m2, 0.05)
    room.string("s", "A.hook", pulley, "B.hook")
    a = m2 * G / (m1 + m2 + wheel / 2.0)
    trace = run(builder)
    check(agree, trace, {"A.slide": a, "B.slide": -a, "P.hinge": a / 0.05}, {"s/1": m1 * a, "s/2": m2 * (G - a)})
    agree(trace.state.normal["A"], m1 * G + 0.0 * trace.state.times)
