"""Tests of beads and springs in a ring: normal modes, conserved quantities, texts, both engines, figures."""

from math import pi, sqrt

import numpy as np
import pytest

from sim2reason.figures.drawing import drawing
from sim2reason.figures.shapes import Arc
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import State
from sim2reason.scenes.entities.spring_chains import SpringMassRing
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.text.prose.description import describe
from told import certified, check_told, check_whole, drawn, scene_of

CLOSE = 1e-9
RADIUS = 1.2
TIMES = np.linspace(0.0, 2.0, 41)


def ring(masses: list[float], stiffness: list[float], radius: float = RADIUS, **more: object) -> Scene:
    beads, springs = tuple({"mass": m} for m in masses), tuple({"stiffness": k} for k in stiffness)
    return scene_of(SpringMassRing.model_validate({"radius": radius, "beads": beads, "springs": springs, **more}))


def moved(scene: Scene, times: np.ndarray = TIMES) -> State:
    return simulate(scene.mechanism, times).state


def wave(count: int, stiffness: float, mass: float) -> np.ndarray:
    """Return (1/N) Σ cos ω_j t cos(2πjn/N) by time and n, the response to a unit at n = 0 on a ring of N.

    On such a ring m q_n″ = k (q_{n+1} − 2 q_n + q_{n−1}), which q_n = cos(ωt) cos(2πjn/N) solves if
    ω_j = 2 √(k/m) sin(πj/N); the sum of all j is 1 at n = 0 and 0 elsewhere.
    """
    j, n = np.arange(count), np.arange(count)
    omega = 2.0 * sqrt(stiffness / mass) * np.sin(pi * j / count)
    return np.cos(np.outer(TIMES, omega)) @ np.cos(2.0 * pi * np.outer(j, n) / count) / count


@pytest.mark.parametrize("count", range(2, 7))
@pytest.mark.parametrize(("way", "sign"), [("stretched", 1.0), ("compressed", -1.0)])
def test_the_modes_of_a_ring_of_equal_beads(count: int, way: str, sign: float) -> None:
    """Extensions s_n = u_{n+1} − u_n satisfy the equation of `wave`, since m u_n″ = k (s_n − s_{n−1})."""
    k, m, d = 70.0, 0.6, 0.12
    state = moved(ring([m] * count, [k] * count, strain={"spring": 0, "way": way, "by": d}))
    found = np.array([QUANTITIES["extension"].evaluate(state, f"it.springs.{n}") for n in range(count)]).T
    assert found == pytest.approx(sign * d * wave(count, k, m), abs=CLOSE)


@pytest.mark.parametrize(("toward", "sign"), [("anticlockwise", 1.0), ("clockwise", -1.0)])
def test_a_bead_that_is_struck(toward: str, sign: float) -> None:
    """With all springs relaxed, the velocities satisfy the equation of `wave`; anticlockwise is positive."""
    count, k, m, speed = 5, 70.0, 0.6, 0.8
    state = moved(ring([m] * count, [k] * count, tap={"bead": 0, "toward": toward, "speed": speed}))
    assert state.v * RADIUS == pytest.approx(sign * speed * wave(count, k, m), abs=CLOSE)


def test_a_single_mode_has_its_own_frequency() -> None:
    """Two beads of different masses on two springs have ω² = (k₁ + k₂)(1/m₁ + 1/m₂), by the reduced mass."""
    (m1, m2), (k1, k2), d = (0.5, 1.1), (60.0, 90.0), 0.15
    state = moved(ring([m1, m2], [k1, k2], strain={"by": d}))
    omega, balance = sqrt((k1 + k2) * (1.0 / m1 + 1.0 / m2)), -k1 * d / (k1 + k2)
    apart = RADIUS * (state.q[:, 1] - state.q[:, 0])
    assert apart == pytest.approx(balance * (1.0 - np.cos(omega * TIMES)), abs=CLOSE)


def test_a_damped_ring() -> None:
    """Two beads with equal springs and dashpots satisfy µ s″ + 2b s′ + 2k (s − s₀) = 0, underdamped."""
    (m1, m2), k, b, d = (0.5, 1.1), 75.0, 0.9, 0.15
    state = moved(ring([m1, m2], [k, k], damping=b, strain={"by": d}))
    mu = m1 * m2 / (m1 + m2)
    gamma = b / mu
    omega = sqrt(2.0 * k / mu - gamma**2)
    decay = np.exp(-gamma * TIMES) * (np.cos(omega * TIMES) + gamma / omega * np.sin(omega * TIMES))
    apart = RADIUS * (state.q[:, 1] - state.q[:, 0])
    assert apart == pytest.approx(-0.5 * d * (1.0 - decay), abs=CLOSE)


@pytest.mark.parametrize("damping", [None, 0.7])
def test_what_is_kept_and_what_is_lost(damping: float | None) -> None:
    """Σ m v along the ring is constant; ½Σmv² + ½Σks² decreases by b Σ∫(ds/dt)² dt.

    The integral is taken by Simpson's rule over 4,000 intervals.
    """
    masses, stiffness = np.array([0.5, 0.9, 0.3, 1.4]), np.array([60.0, 110.0, 45.0, 80.0])
    strain, tap = {"spring": 2, "by": 0.2}, {"bead": 1, "toward": "clockwise", "speed": 0.9}
    scene = ring([*masses], [*stiffness], damping=damping, strain=strain, tap=tap)
    state = moved(scene, np.linspace(0.0, 1.0, 4001))
    speeds = RADIUS * state.v
    assert speeds @ masses == pytest.approx(np.full(4001, -0.9 * 0.9), abs=CLOSE)
    springs = [f"it.springs.{n}" for n in range(4)]
    extension = np.array([QUANTITIES["extension"].evaluate(state, name) for name in springs]).T
    rate = np.array([QUANTITIES["extension rate"].evaluate(state, name) for name in springs]).T
    assert rate == pytest.approx(np.roll(speeds, -1, axis=1) - speeds, abs=CLOSE)
    energy = 0.5 * (speeds**2 @ masses + extension**2 @ stiffness)
    weights = np.ones(4001)
    weights[1:-1:2], weights[2:-1:2] = 4.0, 2.0
    lost = weights @ ((damping or 0.0) * rate**2).sum(axis=1) / 4000.0 / 3.0
    assert energy[0] - energy[-1] == pytest.approx(lost, rel=1e-8, abs=CLOSE)


def test_the_ring_bends_the_paths() -> None:
    """The acceleration has the components R θ″ and v²/R; a turn by θ is a displacement of 2R sin(θ/2)."""
    state = moved(ring([0.5, 0.5, 0.5], [60.0] * 3, tap={"bead": 0, "toward": "clockwise", "speed": 1.5}))
    acceleration = np.linalg.norm(QUANTITIES["acceleration"].evaluate(state, "it.beads.0"), axis=1)
    parts = RADIUS * state.a[:, 0], RADIUS * state.v[:, 0] ** 2
    assert acceleration == pytest.approx(np.hypot(*parts), abs=CLOSE)
    far = np.linalg.norm(QUANTITIES["displacement"].evaluate(state, "it.beads.0"), axis=1)
    assert far == pytest.approx(2.0 * RADIUS * abs(np.sin(0.5 * state.q[:, 0])), abs=CLOSE)


def test_lengths_are_those_along_the_ring() -> None:
    scene = ring([0.5, 0.5, 0.5], [60.0] * 3, strain={"spring": 1, "by": 0.2})
    lengths = [QUANTITIES["spring length"].evaluate(moved(scene), f"it.springs.{n}") for n in range(3)]
    assert np.sum(lengths, axis=0) == pytest.approx(2.0 * pi * RADIUS, abs=CLOSE)


@pytest.mark.parametrize("count", [10, pytest.param(50, marks=pytest.mark.slow)])
def test_texts_and_files_lead_back(count: int) -> None:
    for seed, scene in enumerate(drawn(SpringMassRing, count)):
        check_told(scene, seed)


@pytest.mark.slow  # testing/test_entities cuts the sentences of every entity
def test_no_sentence_can_be_left_out() -> None:
    for seed, scene in enumerate(drawn(SpringMassRing, 8, seed=1)):
        check_whole(scene, seed)


def test_both_engines_agree() -> None:
    assert all(certified(scene) for scene in drawn(SpringMassRing, 10, seed=2))


def test_the_drawing_is_one_circle_with_its_beads_and_springs() -> None:
    for seed, scene in enumerate(drawn(SpringMassRing, 6, seed=3)):
        description, count = describe(scene, seed), len(scene.entity("it").beads)  # type: ignore[attr-defined]
        shown = drawing(scene, description)
        rings = [shape for shape in shown.shapes if isinstance(shape, Arc) and shape.weight == "thin"]
        assert len(rings) == 1
        balls = [shape for shape in shown.shapes if isinstance(shape, Arc) and shape.fill == "ball"]
        assert [abs(ball.center - rings[0].center) for ball in balls] == pytest.approx(
            [rings[0].radius] * count, rel=1e-6
        )
        assert len({label.text for label in shown.labels if label.name}) == 2 * count


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ({}, "no spring is ever strained"),
        ({"strain": {"by": 0.1}, "radius": 0.05}, "beads may meet"),
        ({"tap": {"bead": 2, "toward": "clockwise", "speed": 1.0}}, "no member 2"),
        ({"springs": ({"stiffness": 50.0},) * 3}, "demands 2, not 3"),
    ],
)
def test_what_can_not_be_is_refused(more: dict[str, object], says: str) -> None:
    usual: dict[str, object] = {"radius": 1.0, "beads": ({"mass": 1.0},) * 2, "springs": ({"stiffness": 50.0},) * 2}
    with pytest.raises(ValueError, match=says):
        SpringMassRing.model_validate({**usual, **more})
