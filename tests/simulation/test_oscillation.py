"""Tests of small oscillations against closed forms, and against simulations at a small amplitude."""

from collections.abc import Callable
from math import cos, pi, sin, sqrt

import numpy as np
import pytest

from resting import RESTFUL, rests
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.fields import Magnetic, Profile, Resistance
from sim2reason.scenes.dsl.mechanism import GRAVITY, ZERO, Mechanism, X, Y, Z
from sim2reason.scenes.dsl.state import displace
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.equilibrium import equilibrium, neighbour
from sim2reason.simulation.oscillation import oscillations

G = GRAVITY
SEEDS = range(4)
Made = tuple[Mechanism, list[float]]  # with the angular frequencies, rad/s, the slowest first


def numbers(seed: int, count: int) -> list[float]:
    """Return random positive numbers of order one."""
    return np.random.default_rng(seed).uniform(0.5, 2.0, count).tolist()


def hung(seed: int) -> Made:
    """Build a load on a spring, with ω² = k/m for any g."""
    m, k, x = numbers(seed, 3)
    builder = Builder()
    room = builder.room().site("nail")
    room.body("load", m, at=(0.0, 0.0, -x)).slide(Z, limits=(-100.0, 0.9 * x)).site("hook")
    room.spring("spring", "nail", "hook", stiffness=40.0 * k, length=0.8 * x)
    return builder.finish(), [sqrt(40.0 * k / m)]


def in_series(seed: int) -> Made:
    """Build two springs in series with a massless clasp between, with ω² = k₁k₂/(k₁ + k₂)/m."""
    m, k1, k2, x = numbers(seed, 4)
    builder = Builder(gravity=ZERO)
    room = builder.room().site("wall")
    room.body("clasp", at=(1.0, 0.0, 0.0)).slide(X).site("middle")
    room.body("block", m, at=(2.0 + 0.1 * x, 0.0, 0.0)).slide(X).site("hook")
    room.spring("one", "wall", "middle", stiffness=30.0 * k1, length=1.0)
    room.spring("two", "middle", "hook", stiffness=30.0 * k2, length=1.0)
    return builder.finish(), [sqrt(30.0 * k1 * k2 / (k1 + k2) / m)]


def side_by_side(seed: int) -> Made:
    """Build a bead between two stretched springs: along them ω² = (k₁ + k₂)/m, across them ω² = 2T/(ℓm)."""
    m, k, stretch = numbers(seed, 3)
    k, long = 50.0 * k, 1.0 + 0.2 * stretch
    builder = Builder(gravity=ZERO)
    room = builder.room().site("left", (-long, 0.0, 0.0)).site("right", (long, 0.0, 0.0))
    room.body("bead", m, at=(0.07, 0.0, 0.03)).slide(X, name="x").slide(Z, name="y").site("ring")
    room.spring("one", "left", "ring", stiffness=k, length=1.0)
    room.spring("two", "ring", "right", stiffness=k, length=1.0)
    return builder.finish(), sorted([sqrt(2.0 * k / m), sqrt(2.0 * k * (long - 1.0) / long / m)])


def two_carts(seed: int) -> Made:
    """Build two free carts on a spring, with ω² = k (m₁ + m₂)/(m₁m₂)."""
    m1, m2, k = numbers(seed, 3)
    builder = Builder(gravity=ZERO)
    room = builder.room()
    for name, mass, x in (("a", m1, 0.0), ("b", m2, 1.3)):
        room.body(name, mass, at=(x, 0.0, 0.0)).slide(X, 0.7).site(f"{name}.hook")
    room.spring("spring", "a.hook", "b.hook", stiffness=60.0 * k, length=1.0)
    return builder.finish(), [sqrt(60.0 * k * (m1 + m2) / (m1 * m2))]


def beam(seed: int) -> Made:
    """Build a uniform rod about a point at d from its middle, with ω² = mgd/(mℓ²/12 + md²)."""
    m, long, share, angle = numbers(seed, 4)
    d, away = 0.2 * share * long, 0.7 * angle
    builder = Builder()
    inertia = m * long**2 / 12.0
    rod = builder.room().body(
        "rod", m, center=(d * sin(away), 0.0, -d * cos(away)), inertia=(0.0, inertia, 0.0, 0.0, 0.0, 0.0)
    )
    rod.hinge(Y)
    return builder.finish(), [sqrt(m * G * d / (inertia + m * d**2))]


def on_a_string(seed: int) -> Made:
    """Build a bob in the plane on a string, with ω² = g/ℓ."""
    m, long, angle = numbers(seed, 3)
    away = 0.7 * angle
    builder = Builder()
    room = builder.room().site("nail")
    bob = room.body("bob", m, at=(long * sin(away), 0.0, -long * cos(away)))
    bob.slide(X, name="x").slide(Z, name="y").site("hook")
    room.string("string", "nail", "hook")
    return builder.finish(), [sqrt(G / long)]


def on_a_cart(seed: int) -> Made:
    """Build a pendulum whose suspension slides freely, with ω² = (1 + m/M) g/ℓ."""
    m, heavy, long, angle = numbers(seed, 4)
    away = 0.5 * angle
    builder = Builder()
    cart = builder.room().body("cart", heavy).rest(X, Z)
    cart.body("rod").hinge(Y).body("bob", m, at=(long * sin(away), 0.0, -long * cos(away)))
    return builder.finish(), [sqrt((1.0 + m / heavy) * G / long)]


def over_a_disc(seed: int) -> Made:
    """Build a block on a spring and a string over a disc to a load, with ω² = k/(m₁ + m₂ + M/2)."""
    m1, m2, disc, k = numbers(seed, 4)
    builder = Builder()
    room = builder.room().site("wall", at=(-1.0, 0.0, 0.0))
    wheel = room.pulley("wheel", at=(2.0, 0.0, 0.0), mass=disc, radius=0.1)
    room.body("block", m1).rest(X, Z).site("hook").site("eye")
    room.body("load", m2, at=(2.1, 0.0, -1.5)).slide(Z).site("clasp")
    room.spring("spring", "wall", "eye", stiffness=80.0 * k, length=0.9)
    room.string("string", "hook", wheel, "clasp")
    return builder.finish(), [sqrt(80.0 * k / (m1 + m2 + disc / 2.0))]


def below_a_movable_pulley(seed: int) -> Made:
    """Build a load on a light pulley whose string's end moves twice as far, at a spring: ω² = 4k/m."""
    m, k = numbers(seed, 2)
    builder = Builder()
    room = builder.room().site("nail", (-0.1, 0.0, 0.0)).site("beam", (0.1, 0.0, 0.0))
    room.body("load", m, at=(0.0, 0.0, -2.0)).slide(Z).site("left", (-0.1, 0.0, 0.0)).site("right", (0.1, 0.0, 0.0))
    room.body("clasp", at=(0.1, 0.0, -1.0)).slide(Z).site("end").site("start")
    room.spring("spring", "beam", "start", stiffness=90.0 * k, length=0.8)
    room.string("string", "nail", "left", "right", "end")
    return builder.finish(), [sqrt(4.0 * 90.0 * k / m)]


def rocking(seed: int) -> Made:
    """Build a rolling cylinder with its centre of mass d from its axis, with ω² = mgd/(I + m(R − d)²)."""
    m, inertia, share, angle = numbers(seed, 4)
    radius, d, away = 0.3, 0.1 * share, 0.8 * angle
    builder = Builder()
    body = builder.room().body(
        "roller",
        m,
        center=(d * sin(away), 0.0, -d * cos(away)),
        inertia=(0.0, 0.01 * inertia, 0.0, 0.0, 0.0, 0.0),
    )
    body.roll(X, Z, radius)
    return builder.finish(), [sqrt(m * G * d / (0.01 * inertia + m * (radius - d) ** 2))]


def on_a_wedge(seed: int) -> Made:
    """Build a block on a spring along the face of a sliding wedge: ω² = k (M + m)/(m (M + m sin²θ))."""
    m, heavy, k, angle = numbers(seed, 4)
    slope = 0.5 * angle
    up, out = (cos(slope), 0.0, sin(slope)), (-sin(slope), 0.0, cos(slope))
    builder = Builder()
    wedge = builder.room().body("wedge", heavy).rest(X, Z).site("stop")
    wedge.body("block", m, at=(up[0], 0.0, up[2])).rest(up, out).site("eye")
    wedge.spring("spring", "stop", "eye", stiffness=70.0 * k, length=1.0)
    return builder.finish(), [sqrt(70.0 * k * (heavy + m) / (m * (heavy + m * sin(slope) ** 2)))]


def a_chain(seed: int) -> Made:
    """Build three carts and four springs between walls, with the eigenvalues of M⁻¹K."""
    m, k = np.array(numbers(seed, 3)), 50.0 * np.array(numbers(seed + 9, 4))
    builder = Builder(gravity=ZERO)
    room = builder.room().site("left", (-1.0, 0.0, 0.0)).site("right", (3.1, 0.0, 0.0))
    for number, mass in enumerate(m.tolist()):
        room.body(f"{number}", mass, at=(float(number), 0.0, 0.0)).slide(X).site(f"hook{number}")
    ends = ["left", "hook0", "hook1", "hook2", "right"]
    for number, stiffness in enumerate(k.tolist()):
        room.spring(f"s{number}", ends[number], ends[number + 1], stiffness=stiffness, length=1.0)
    matrix = np.diag(k[:-1] + k[1:]) - np.diag(k[1:-1], 1) - np.diag(k[1:-1], -1)
    return builder.finish(), np.sqrt(np.sort(np.linalg.eigvals(matrix / m[:, None]).real)).tolist()


FORMS: list[Callable[[int], Made]] = [
    hung,
    in_series,
    side_by_side,
    two_carts,
    beam,
    on_a_string,
    on_a_cart,
    over_a_disc,
    below_a_movable_pulley,
    rocking,
    on_a_wedge,
    a_chain,
]


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("form", FORMS)
def test_closed_forms(form: Callable[[int], Made], seed: int) -> None:
    mechanism, expected = form(seed)
    rest = equilibrium(mechanism)
    assert rest is not None
    modes = oscillations(rest)
    assert modes is not None
    assert modes.frequencies.tolist() == pytest.approx(expected, rel=1e-7)
    assert modes.shapes.shape == (len(mechanism.coordinates), len(expected))


@pytest.mark.parametrize("recipe", RESTFUL)
def test_the_motion_itself_at_a_small_amplitude(recipe: str) -> None:
    """Displaced along a mode, a system is at the opposite point after half a period, and back after a whole one."""
    seen = 0
    for rest in rests(recipe):
        modes = oscillations(rest)
        if modes is None:
            continue
        for number, frequency in enumerate(modes.frequencies.tolist()):
            shape = modes.shapes[:, number]
            begun = neighbour(rest, 2e-5 * shape / np.abs(shape).max())
            there = displace(rest.mechanism, begun.tolist(), [0.0] * len(begun))
            state = simulate(there, pi / frequency * np.arange(3.0)).state
            gone, size = state.q + begun - rest.coordinates, np.abs(begun - rest.coordinates).max()
            assert np.allclose(gone, [gone[0], -gone[0], gone[0]], rtol=0.0, atol=2e-3 * size)
            seen += 1
    assert seen


def test_what_dies_away_or_is_turned_aside_is_no_such_oscillation() -> None:
    """Dashpots, media and magnetic fields exert forces that depend on velocity."""
    for damping, law in ((0.3, None), (0.0, Resistance(linear=0.2)), (0.0, Magnetic(Y, Profile(0.4)))):
        builder = Builder()
        room = builder.room().site("nail")
        load = room.body("load", 1.0, at=(0.0, 0.0, -1.1)).slide(Z).site("hook")
        room.spring("spring", "nail", "hook", stiffness=50.0, length=1.0, damping=damping)
        if law is not None:
            load.force("law", law)
        rest = equilibrium(builder.finish())
        assert rest is not None
        assert rest.coordinates[0] == pytest.approx(0.1 - G / 50.0)
        assert oscillations(rest) is None


def test_a_massless_part_that_nothing_holds_has_no_mode() -> None:
    """A free massless clasp moves without any force, so its motion is undetermined."""
    builder = Builder(gravity=ZERO)
    room = builder.room().site("wall")
    room.body("load", 1.0, at=(1.1, 0.0, 0.0)).slide(X).site("hook")
    room.body("clasp", at=(0.0, 0.0, 1.0)).slide(X)
    room.spring("spring", "wall", "hook", stiffness=50.0, length=1.0)
    rest = equilibrium(builder.finish())
    assert rest is not None
    assert rest.free == 1
    assert oscillations(rest) is None
