"""Tests of springs against closed forms: struck, damped, with friction, in chains, at angles, one-sided."""

from collections.abc import Callable
from itertools import pairwise
from math import acos, cos, cosh, exp, hypot, pi, sin, sinh, sqrt

import numpy as np
import pytest

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import ZERO, Elastic, X, Y, Z
from sim2reason.simulation.engines.exact import motion, simulate

Agree = Callable[..., None]
SEEDS = range(4)
G = 9.8


def row(masses: list[float], gap: float, speeds: list[float]) -> Builder:
    """Build carts at equal distances on a smooth line, with a hook each."""
    builder = Builder(gravity=ZERO)
    room = builder.room()
    for i, (mass, speed) in enumerate(zip(masses, speeds, strict=True)):
        room.body(f"{i}", mass, at=(i * gap, 0.0, 0.0)).slide(X, speed).site(f"hook{i}")
    return builder


@pytest.mark.parametrize("seed", SEEDS)
def test_a_struck_spring_block(seed: int, agree: Agree) -> None:
    """With one of two carts struck, x₂ − x₁ oscillates with ω² = k/µ, 1/µ = 1/m₁ + 1/m₂, about a uniform drift.

    The reduced mass of the two-body problem, any textbook of mechanics.
    """
    m1, m2, k, v = np.random.default_rng(seed).uniform((0.2, 0.2, 20.0, 0.5), (3.0, 3.0, 200.0, 3.0))
    builder = row([m1, m2], 2.0, [v, 0.0])
    builder.room().spring("spring", "hook0", "hook1", stiffness=k)
    omega = sqrt(k * (1.0 / m1 + 1.0 / m2))
    times = np.linspace(0.0, 3.0 * 2.0 * pi / omega, 61)
    state = simulate(builder.finish(), times).state
    drift = m1 * v / (m1 + m2)
    agree(state.q[:, 0], drift * times + m2 / (m1 + m2) * v / omega * np.sin(omega * times))
    agree(state.q[:, 1], drift * times - m1 / (m1 + m2) * v / omega * np.sin(omega * times))
    agree(state.v[:, 0], drift + m2 / (m1 + m2) * v * np.cos(omega * times))


@pytest.mark.parametrize("seed", SEEDS)
def test_normal_modes_of_a_chain(seed: int, agree: Agree) -> None:
    """For n carts and n + 1 springs between walls, the eigenvectors of M^(−½) K M^(−½) solve M ẍ = −K x."""
    rng = np.random.default_rng(seed)
    n = 3 + seed
    masses, k, speeds = rng.uniform(0.3, 3.0, n), rng.uniform(20.0, 200.0, n + 1), rng.uniform(-1.0, 1.0, n)
    builder = row(list(masses), 2.0, list(speeds))
    room = builder.room()
    room.site("left", at=(-2.0, 0.0, 0.0))
    room.site("right", at=(2.0 * n, 0.0, 0.0))
    stops = ["left", *(f"hook{i}" for i in range(n)), "right"]
    for i, ends in enumerate(pairwise(stops)):
        room.spring(f"spring{i}", *ends, stiffness=k[i])
    stiff = np.diag(k[:-1] + k[1:]) - np.diag(k[1:-1], 1) - np.diag(k[1:-1], -1)
    root = np.sqrt(masses)
    squares, modes = np.linalg.eigh(stiff / np.outer(root, root))
    omega, times = np.sqrt(squares), np.linspace(0.0, 4.0, 81)
    amplitudes = modes.T @ (root * speeds) / omega
    expected = (np.sin(np.outer(times, omega)) * amplitudes) @ modes.T / root
    state = simulate(builder.finish(), times).state
    agree(state.q, expected)
    agree(state.tension["spring0"], k[0] * expected[:, 0])


@pytest.mark.parametrize("ratio", [0.05, 0.6, 1.7])
def test_a_damped_oscillator(ratio: float, agree: Agree) -> None:
    """The equation is m ẍ + b ẋ + k x = 0 from x₀ at rest, with ζ = b/(2√(km)) below and above one."""
    m, k, x0 = 0.7, 90.0, 0.3
    omega = sqrt(k / m)
    builder = Builder(gravity=ZERO)
    room = builder.room()
    room.body("cart", m, at=(1.0 + x0, 0.0, 0.0)).slide(X).site("hook")
    room.site("wall")
    room.spring("spring", "wall", "hook", stiffness=k, length=1.0, damping=2.0 * ratio * sqrt(k * m))
    times = np.linspace(0.0, 1.5, 61)
    decay, own = ratio * omega, omega * sqrt(abs(1.0 - ratio**2))
    swing = (cos, sin) if ratio < 1.0 else (cosh, sinh)
    x = [x0 * exp(-decay * t) * (swing[0](own * t) + decay / own * swing[1](own * t)) for t in times]
    v = [-x0 * exp(-decay * t) * omega**2 / own * swing[1](own * t) for t in times]
    state = simulate(builder.finish(), times).state
    agree(state.q[:, 0] + x0, x)
    agree(state.v[:, 0], v)
    agree(state.tension["spring"], k * np.array(x) + 2.0 * ratio * sqrt(k * m) * np.array(v))


@pytest.mark.parametrize(("start", "swings"), [(0.55, 3), (0.95, 5), (0.15, 1), (0.07, 0)])
def test_a_rough_spring_block(start: float, swings: int, agree: Agree) -> None:
    """Each half swing lasts π√(m/k) and is shorter by 2µmg/k; the block stops at the first with |x| ≤ µmg/k.

    A. P. French, Vibrations and Waves: Coulomb damping.
    """
    m, k, mu = 0.5, 40.0, 0.8
    bound = mu * m * G / k  # 0.098 m
    builder = Builder()
    room = builder.room()
    room.body("block", m, at=(2.0 + start, 0.0, 0.0)).rest(X, Z, mu).site("hook")
    room.site("wall")
    room.spring("spring", "wall", "hook", stiffness=k, length=2.0)
    half = pi * sqrt(m / k)
    places = [start]
    while abs(places[-1]) > bound:
        places.append(-(abs(places[-1]) - 2.0 * bound) * (1.0 if places[-1] > 0.0 else -1.0))
    assert len(places) == swings + 1
    trace = simulate(builder.finish(), half * np.arange(swings + 2))
    agree(trace.state.q[:, 0] + start, [*places, places[-1]])
    assert trace.state.v[-1, 0] == 0.0
    sticks = [event.time for event in trace.events if event.kind == "stick"]
    agree([0.0, *sticks], [0.0, half * swings] if swings else [0.0])


def held(ends: list[tuple[float, float]], k: list[float], free: list[float], start: tuple[float, float]) -> Builder:
    """Build a puck of 0.6 kg on a smooth table, held by springs to fixed points."""
    builder = Builder(gravity=ZERO)
    room = builder.room()
    room.body("puck", 0.6, at=(*start, 0.0)).slide(X, name="x").slide(Y, name="y").site("hook")
    for i, end in enumerate(ends):
        room.site(f"nail{i}", at=(*end, 0.0))
        room.spring(f"spring{i}", f"nail{i}", "hook", stiffness=k[i], length=free[i])
    return builder


def test_small_oscillations_of_springs_at_angles() -> None:
    """Periods follow from the Hessian Σ k(n nᵀ + (1 − ℓ₀/ℓ)(1 − n nᵀ)) at the point of equilibrium.

    The motion starts 1 µm away along one normal mode, so that terms of higher order are a millionth of it.
    """
    ends, k, free = [(-0.7, -0.1), (0.5, 0.6), (0.4, -0.8)], [60.0, 90.0, 130.0], [0.4, 0.5, 0.3]
    place = np.zeros(2)

    def at(place: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        force, hessian = np.zeros(2), np.zeros((2, 2))
        for end, stiffness, length in zip(ends, k, free, strict=True):
            apart = place - np.array(end)
            distance = hypot(*apart)
            n = apart / distance
            force -= stiffness * (distance - length) * n
            hessian += stiffness * (np.outer(n, n) + (1.0 - length / distance) * (np.eye(2) - np.outer(n, n)))
        return force, hessian

    for _ in range(30):
        force, hessian = at(place)
        place = place + np.linalg.solve(hessian, force)
    squares, modes = np.linalg.eigh(at(place)[1] / 0.6)
    for square, mode in zip(squares, modes.T, strict=True):
        start = place + 1e-6 * mode
        found = motion(held(ends, k, free, (start[0], start[1])).finish(), 3.0 * pi / sqrt(square))
        turns = [event.time for event in found.events if event.kind == "turn" and event.subjects == ("puck.x",)]
        assert turns[0] == pytest.approx(pi / sqrt(square), rel=1e-5)


@pytest.mark.parametrize("seed", SEEDS)
def test_energy_of_springs_at_angles(seed: int, agree: Agree) -> None:
    """The energy ½mv² + Σ ½k(ℓ − ℓ₀)² is constant."""
    rng = np.random.default_rng(seed)
    ends, k, free = rng.uniform(-0.9, 0.9, (3, 2)), rng.uniform(20.0, 200.0, 3), rng.uniform(0.2, 0.9, 3)
    start = rng.uniform(-0.2, 0.2, 2)
    builder = held([(a, b) for a, b in ends], list(k), list(free), (start[0], start[1]))
    state = simulate(builder.finish(), np.linspace(0.0, 3.0, 301)).state
    lengths = np.hypot(*(start + state.q)[:, None, :].transpose(2, 0, 1) - ends.T[:, None, :])
    energy = 0.3 * (state.v**2).sum(axis=1) + 0.5 * ((lengths - free) ** 2 @ k)
    agree(energy, energy[0] * np.ones(301))


def test_one_spring_swings_round_its_nail(agree: Agree) -> None:
    """Angular momentum about the nail and energy are constant, and determine the speed at any distance."""
    builder = Builder(gravity=ZERO)
    room = builder.room()
    room.body("puck", 0.6, at=(0.5, 0.0, 0.0)).slide(X, 0.4, name="x").slide(Y, 1.3, name="y").site("hook")
    room.site("nail")
    room.spring("spring", "nail", "hook", stiffness=50.0, length=0.4)
    state = simulate(builder.finish(), np.linspace(0.0, 4.0, 81)).state
    x, y = state.q[:, 0] + 0.5, state.q[:, 1]
    agree(x * state.v[:, 1] - y * state.v[:, 0], np.full(81, 0.5 * 1.3))
    energy = 0.3 * (0.4**2 + 1.3**2) + 25.0 * 0.1**2
    distance = np.hypot(x, y)
    agree((state.v**2).sum(axis=1), (energy - 25.0 * (distance - 0.4) ** 2) / 0.3)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_buffer_is_left_after_half_a_period(seed: int, agree: Agree) -> None:
    """A cart hits a light spring on the front of another: contact lasts π√(µ/k), with velocities as for e = 1.

    The compression v√(µ/k) sin(ωt) is zero again at ωt = π, and never less afterwards.
    """
    m1, m2, k, v = np.random.default_rng(seed).uniform((0.2, 0.2, 20.0, 0.5), (3.0, 3.0, 200.0, 3.0))
    builder = row([m1, m2], 2.0, [v, 0.0])
    builder.room().buffer("buffer", "hook0", "hook1", stiffness=k, length=0.8)
    touch, mu = 1.2 / v, m1 * m2 / (m1 + m2)
    apart = touch + pi * sqrt(mu / k)
    trace = simulate(builder.finish(), np.array([0.0, 0.5 * (touch + apart), apart + 1.0]))
    agree([event.time for event in trace.events if event.subjects == ("buffer",)], [touch, apart])
    agree(trace.state.v[-1], [(m1 - m2) / (m1 + m2) * v, 2.0 * m1 / (m1 + m2) * v])
    agree(trace.state.tension["buffer"], [0.0, -v * sqrt(mu * k), 0.0])
    assert trace.cut == ""


def test_an_elastic_cord_pulls_and_goes_slack(agree: Agree) -> None:
    """A free puck reaches the cord's length, swings for π√(m/k), and returns with its initial speed."""
    m, k, v = 0.4, 30.0, 1.5
    builder = row([m], 1.0, [v])
    builder.room().site("nail", at=(-0.2, 0.0, 0.0))
    builder.add_line("cord", ("nail", "hook0"), Elastic(k, 1.0, acts="pulls"))
    taut = 0.8 / v
    slack = taut + pi * sqrt(m / k)
    trace = simulate(builder.finish(), np.array([0.0, taut + 0.5 * pi * sqrt(m / k), slack + 0.2]))
    agree([event.time for event in trace.events if event.kind in ("taut", "slack")], [taut, slack])
    agree(trace.state.q[:, 0], [0.0, 0.8 + v * sqrt(m / k), 0.8 - 0.2 * v])
    agree(trace.state.tension["cord"], [0.0, v * sqrt(m * k), 0.0])


@pytest.mark.parametrize("seed", SEEDS)
def test_points_that_pass_through_each_other_end_the_motion(seed: int, agree: Agree) -> None:
    """A spring stretched by more than its length pulls its ends together: ℓ₀ + d cos(ωt) = 0, within 1 nm.

    The distance itself only touches zero between two steps of the integrator, and grows again.
    """
    m, k, free, more = np.random.default_rng(seed).uniform((0.3, 20.0, 0.3, 1.1), (3.0, 200.0, 0.9, 3.0))
    stretch = free * more
    builder = Builder(gravity=ZERO)
    room = builder.room()
    room.body("cart", m, at=(free + stretch, 0.0, 0.0)).slide(X).site("hook")
    room.site("wall")
    room.spring("spring", "wall", "hook", stiffness=k, length=free)
    found = motion(builder.finish(), 5.0 * 2.0 * pi * sqrt(m / k))
    assert found.cut == "reach"
    agree(found.events[-1].time, acos((1e-9 - free) / stretch) * sqrt(m / k))
