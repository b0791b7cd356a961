"""Tests of inclines and movable wedges, smooth and rough, against Newton's second law."""

from collections.abc import Callable
from math import cos, hypot, radians, sin, sqrt, tan

import numpy as np
import pytest

from sim2reason.scenes.dsl.builder import Builder, Frame
from sim2reason.scenes.dsl.mechanism import X, Z
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.simulation.engines.exact import simulate

G = 9.8
SEEDS = range(6)


def face(angle: float) -> tuple[Vector, Vector]:
    """Return the uphill direction, to the right, and the outward normal of a face."""
    return (cos(angle), 0.0, sin(angle)), (-sin(angle), 0.0, cos(angle))


def incline(mass: float, angle: float, friction: float, speed: float = 0.0) -> Builder:
    builder = Builder()
    uphill, outward = face(angle)
    builder.room().body("A", mass).rest(uphill, outward, friction, speed)
    return builder


@pytest.mark.parametrize("angle", [5.0, 20.0, 35.0])
def test_a_block_sticks_below_the_angle_of_friction(angle: float, agree: Callable[..., None]) -> None:
    """The friction at rest is f = m g sin θ ≤ µ N = µ m g cos θ, that is tan θ ≤ µ."""
    theta, mu, m = radians(angle), tan(radians(36.0)), 1.7
    state = simulate(incline(m, theta, mu).finish(), np.linspace(0.0, 2.0, 5)).state
    assert not state.q.any()
    assert not state.a.any()
    agree(state.friction["A"], m * G * sin(theta) + 0.0 * state.times)
    agree(state.normal["A"], m * G * cos(theta) + 0.0 * state.times)


@pytest.mark.parametrize("angle", [20.0, 37.0, 60.0])
def test_a_block_slides_above_the_angle_of_friction(angle: float, agree: Callable[..., None]) -> None:
    """The acceleration down the slope is a = g (sin θ − µ cos θ)."""
    theta, mu, m = radians(angle), 0.3, 2.2
    trace = simulate(incline(m, theta, mu).finish(), np.linspace(0.0, 2.0, 5))
    a = -G * (sin(theta) - mu * cos(theta))
    agree(trace.state.a[:, 0], np.full(5, a))
    agree(trace.state.q[:, 0], a * trace.state.times**2 / 2.0)
    agree(trace.state.friction["A"], np.full(5, mu * m * G * cos(theta)))
    assert trace.events == ()


@pytest.mark.parametrize(("mu", "kind"), [(0.8, "stick"), (0.2, "slip")])
def test_a_block_thrown_uphill_stops_and_stays_or_slides_back(mu: float, kind: str, agree: Callable[..., None]) -> None:
    """The block decelerates by a = g (sin θ + µ cos θ), stops after v²/2a, and stays if tan θ ≤ µ."""
    theta, speed = radians(30.0), 4.0
    up = G * (sin(theta) + mu * cos(theta))
    down = max(0.0, G * (sin(theta) - mu * cos(theta)))
    stop = speed / up
    trace = simulate(incline(3.0, theta, mu, speed).finish(), np.array([0.0, stop / 2.0, 2.0]))
    (event,) = trace.events
    assert (event.kind, event.subjects) == (kind, ("A",))
    agree(event.time, stop)
    agree(trace.state.v[1, 0], speed / 2.0)
    agree(trace.state.a[:, 0], [-up, -up, -down])
    agree(trace.state.v[2, 0], -down * (2.0 - stop), 1.0)
    agree(trace.state.q[2, 0], speed**2 / (2.0 * up) - down * (2.0 - stop) ** 2 / 2.0)


def two_sided(m1: float, m2: float, angles: tuple[float, float], mu: tuple[float, float]) -> Builder:
    """Build two blocks on the faces of a fixed wedge, joined over a pulley at its top."""
    builder = Builder()
    room = builder.room()
    top = room.pulley("P", radius=0.1)
    for name, mass, side, angle, friction in (("A", m1, -1, angles[0], mu[0]), ("B", m2, 1, angles[1], mu[1])):
        uphill, outward = (-side * cos(angle), 0.0, sin(angle)), (side * sin(angle), 0.0, cos(angle))
        rim = side * 0.1
        at = (rim - 20.0 * uphill[0], 0.0, -20.0 * uphill[2])
        room.body(name, mass, at=at).rest(uphill, outward, friction).site(f"{name}.hook", at=(0.0, 0.0, 0.0))
    room.string("s", "A.hook", top, "B.hook")
    return builder


@pytest.mark.parametrize("seed", SEEDS)
def test_blocks_on_both_faces(seed: int, agree: Callable[..., None]) -> None:
    """Block B drags A uphill: (m1 + m2) a = m2 g (sin β − µ2 cos β) − m1 g (sin α + µ1 cos α)."""
    rng = np.random.default_rng(seed)
    m1, m2 = rng.uniform(0.5, 1.0), rng.uniform(4.0, 8.0)
    alpha, beta, mu1, mu2 = rng.uniform((0.2, 0.8, 0.05, 0.05), (0.5, 1.2, 0.3, 0.3))
    net = m2 * G * (sin(beta) - mu2 * cos(beta)) - m1 * G * (sin(alpha) + mu1 * cos(alpha))
    a = net / (m1 + m2)
    state = simulate(two_sided(m1, m2, (alpha, beta), (mu1, mu2)).finish(), np.linspace(0.0, 1.0, 4)).state
    agree(state.a, np.tile([a, -a], (4, 1)))
    agree(state.tension["s"], np.full(4, m1 * (a + G * sin(alpha) + mu1 * G * cos(alpha))))
    agree(state.normal["B"], np.full(4, m2 * G * cos(beta)))


def on_wedge(room: Frame, angle: float, wedge_mass: float, block_mass: float, mu: float = 0.0) -> tuple[Frame, Frame]:
    uphill, outward = face(angle)
    wedge = room.body("W", wedge_mass).rest(along=X, normal=Z)
    block = wedge.body("A", block_mass).rest(uphill, outward, mu)
    return wedge, block


@pytest.mark.parametrize("mu", [0.0, 0.25])
@pytest.mark.parametrize("seed", SEEDS)
def test_a_block_slides_down_a_movable_wedge(seed: int, mu: float, agree: Callable[..., None]) -> None:
    """The normal force and friction accelerate the wedge: M A = N (sin θ − µ cos θ).

    Perpendicular to the face, N − m g cos θ = −m A sin θ; along it, m (A cos θ + s̈) = µN − m g sin θ. The normal
    force on the wedge is M g + N (cos θ + µ sin θ). With µ = 0 the known N = M m g cos θ/(M + m sin² θ).
    """
    rng = np.random.default_rng(seed)
    wedge, m, theta = rng.uniform((0.5, 0.5, 0.4), (9.0, 9.0, 1.2))
    builder = Builder()
    on_wedge(builder.room(), theta, wedge, m, mu)
    push = sin(theta) - mu * cos(theta)
    normal = m * G * cos(theta) / (1.0 + m / wedge * sin(theta) * push)
    a = normal * push / wedge
    s = mu * normal / m - G * sin(theta) - a * cos(theta)
    state = simulate(builder.finish(), np.linspace(0.0, 1.0, 4)).state
    agree(state.a, np.tile([a, s], (4, 1)))
    agree(state.q, np.outer(state.times**2 / 2.0, [a, s]))
    agree(state.normal["A"], np.full(4, normal))
    agree(state.normal["W"], np.full(4, wedge * G + normal * (cos(theta) + mu * sin(theta))))
    if mu == 0.0:
        agree(normal, wedge * m * G * cos(theta) / (wedge + m * sin(theta) ** 2))


@pytest.mark.parametrize("seed", SEEDS)
def test_a_load_pulls_the_wedge_over_a_fixed_pulley(seed: int, agree: Callable[..., None]) -> None:
    """The wedge has (M + C + m sin² θ) A = C g + m g sin θ cos θ.

    Along x: (M + m) A + m cos θ s̈ = T and T = C (g − A); along the face: s̈ + A cos θ = −g sin θ.
    """
    rng = np.random.default_rng(seed)
    wedge, m, load, theta = rng.uniform((1.0, 0.5, 0.5, 0.5), (9.0, 4.0, 2.0, 0.9))
    builder = Builder()
    room = builder.room()
    frame, _ = on_wedge(room, theta, wedge, m)
    frame.site("eye")
    pulley = room.pulley("P", at=(30.0, 0.0, 0.0))
    room.body("C", load, at=(30.05, 0.0, -40.0)).slide(Z).site("C.hook", at=(0.0, 0.0, 0.0))
    room.string("s", "eye", pulley, "C.hook")
    a = G * (load + m * sin(theta) * cos(theta)) / (wedge + load + m * sin(theta) ** 2)
    s = -G * sin(theta) - a * cos(theta)
    trace = simulate(builder.finish(), np.linspace(0.0, 1.0, 4))
    agree(trace.state.a, np.tile([a, s, -a], (4, 1)))
    agree(trace.state.tension["s"], np.full(4, load * (G - a)))
    agree(trace.state.normal["A"], np.full(4, m * (G * cos(theta) - a * sin(theta))))
    assert trace.cut == ""


@pytest.mark.parametrize("seed", SEEDS)
def test_a_string_over_a_pulley_on_the_wedge(seed: int, agree: Callable[..., None]) -> None:
    """Lagrange's equations give the displacement x of the wedge and s of m1 uphill, of m2 down its guide.

    (M + m1 + m2) ẍ + m1 cos θ s̈ = 0,  (m1 + m2) s̈ + m1 cos θ ẍ = (m2 − m1 sin θ) g.
    """
    rng = np.random.default_rng(seed)
    wedge, m1, m2, theta = rng.uniform((1.0, 0.5, 0.5, 0.3), (9.0, 4.0, 4.0, 0.9))
    builder = Builder()
    frame, _ = on_wedge(builder.room(), theta, wedge, m1)
    top = (20.0 * cos(theta), 0.0, 20.0 * sin(theta))
    frame.site("left", at=top).site("right", at=(top[0] + 0.1, 0.0, top[2]))
    frame.body("B", m2, at=(top[0] + 0.1, 0.0, top[2] - 10.0)).slide(Z).site("B.hook")
    builder.add_site("A.hook", "A", (0.0, 0.0, 0.0))
    builder.add_site("b", "B", (top[0] + 0.1, 0.0, top[2] - 10.0))
    builder.room().string("s", "A.hook", "left", "right", "b")
    total = wedge + m1 + m2
    s = (m2 - m1 * sin(theta)) * G / (m1 + m2 - (m1 * cos(theta)) ** 2 / total)
    x = -m1 * cos(theta) * s / total
    state = simulate(builder.finish(), np.linspace(0.0, 0.8, 4)).state
    agree(state.a, np.tile([x, s, -s], (4, 1)), G)
    agree(state.tension["s"], np.full(4, m2 * (G - s)))
    agree(state.normal["A"], np.full(4, m1 * (G * cos(theta) - x * sin(theta))))
    agree(state.normal["W"], np.full(4, total * G + m1 * s * sin(theta) - m2 * s))


def test_stacked_blocks_slide_together_until_the_pull_is_too_strong(agree: Callable[..., None]) -> None:
    """Friction accelerates the upper block by at most µ g; on a smooth floor, F ≤ µ (m1 + m2) g."""
    m1, m2, mu = 2.0, 3.0, 0.4
    limit = mu * (m1 + m2) * G
    for force, together in ((0.9 * limit, True), (1.1 * limit, False)):
        builder = Builder()
        room = builder.room()
        lower = room.body("L", m2).rest(along=X, normal=Z)
        lower.body("U", m1).rest(X, Z, mu)
        lower.site("eye")
        room.site("hand", at=(50.0, 0.0, 0.0)).pull("F", "eye", "hand", force=force)
        state = simulate(builder.finish(), np.array([0.0, 1.0])).state
        a = force / (m1 + m2) if together else (force - mu * m1 * G) / m2
        agree(state.a[:, 0], [a, a])
        agree(state.a[:, 1], np.full(2, 0.0 if together else mu * G - a), G)
        agree(state.friction["U"], np.full(2, m1 * a if together else mu * m1 * G))


def test_time_to_slide_down(agree: Callable[..., None]) -> None:
    """The block slides down a length L from rest in t = √(2L/a), where the motion ends."""
    theta, length = radians(40.0), 1.5
    uphill, outward = face(theta)
    builder = Builder()
    builder.room().body("A", 1.0).rest(uphill, outward, 0.1, limits=(-length, 2.0))
    trace = simulate(builder.finish(), np.linspace(0.0, 5.0, 3))
    (event,) = trace.events
    assert (event.kind, event.subjects, trace.cut) == ("limit", ("A.slide",), "limit")
    agree(event.time, sqrt(2.0 * length / (G * (sin(theta) - 0.1 * cos(theta)))))
    assert trace.stable_until == event.time


def test_a_string_that_turns_lifts_the_block_it_hauls(agree: Callable[..., None]) -> None:
    """A load M hauls a block over a rough floor by a string of length s to a pulley, h above the block, at the angle φ.

    s̈ = −a cos φ + v² sin² φ/s, M g − T = −M s̈ and m a = T cos φ − µ (m g − T sin φ). The work of gravity less the
    kinetic energy is what friction takes: ∫ µ N v dt.
    """
    m, load, mu, h, d = 2.0, 3.0, 0.3, 1.0, 3.0
    builder = Builder()
    room = builder.room()
    room.site("pulley", at=(d, 0.0, h))
    room.body("A", m).rest(X, Z, mu).site("A.hook")
    room.body("B", load, at=(d, 0.0, -5.0)).slide(Z).site("B.hook")
    room.string("s", "A.hook", "pulley", "B.hook")
    trace = simulate(builder.finish(), np.linspace(0.0, 0.8, 801))
    assert trace.events == ()
    state, (x, v) = trace.state, (trace.state.q[:, 0], trace.state.v[:, 0])
    s = np.hypot(d - x, h)
    cosine, sine = (d - x) / s, h / s
    lifted, curved = cosine + mu * sine, load * (G + (v * sine) ** 2 / s)
    a = (curved * lifted - mu * m * G) / (m + load * cosine * lifted)
    agree(state.a[:, 0], a)
    agree(state.tension["s"], curved - load * cosine * a)
    agree(state.normal["A"], m * G - state.tension["s"] * sine)
    kinetic = (m * v**2 + load * state.v[:, 1] ** 2) / 2.0
    power = mu * state.normal["A"] * v
    lost = float(np.sum(power[:-2:2] + 4.0 * power[1:-1:2] + power[2::2])) * 1e-3 / 3.0  # Simpson's rule
    agree(kinetic[-1], load * G * (hypot(d, h) - s[-1]) - lost)
