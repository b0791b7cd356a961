"""Tests of springs at angles and in chains: closed forms, texts, files, agreement of both engines."""

from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

from sim2reason.scenes.dsl.entity import Entity
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import State
from sim2reason.scenes.entities.spring_blocks import SpringBlock
from sim2reason.scenes.entities.spring_chains import SpringMassChain
from sim2reason.simulation.engines.exact import simulate
from told import certified, check_told, check_whole, drawn, scene_of

CLOSE = 1e-9
G = 9.8
KINDS: list[type[Entity]] = [SpringBlock, SpringMassChain]


def moved(scene: Scene, times: np.ndarray) -> State:
    return simulate(scene.mechanism, times).state


def block(springs: list[tuple[float, float, float, float]], mass: float = 0.5, **more: object) -> Scene:
    """Build a block on springs, each given by stiffness, natural length and fixed end."""
    told = tuple({"stiffness": k, "length": free, "x": x, "y": y} for k, free, x, y in springs)
    return scene_of(SpringBlock.model_validate({"block": {"mass": mass}, "springs": told, **more}))


def chain(masses: list[float], stiffness: list[float], **more: object) -> Scene:
    carts, springs = tuple({"mass": m} for m in masses), tuple({"stiffness": k} for k in stiffness)
    return scene_of(SpringMassChain.model_validate({"track": {}, "carts": carts, "springs": springs, **more}))


@pytest.mark.parametrize("angle", [0.0, 0.3, 2.0])
def test_a_block_between_two_springs_in_line(angle: float) -> None:
    """The block oscillates along the springs with ω² = (k₁ + k₂)/m about the point of equilibrium."""
    way = np.array([cos(angle), sin(angle)])
    (x1, y1), (x2, y2) = np.round(-0.8 * way, 12), np.round(0.9 * way, 12)
    springs = [(90.0, 0.6, float(x1), float(y1)), (60.0, 0.5, float(x2), float(y2))]
    balance = (-90.0 * (0.8 - 0.6) + 60.0 * (0.9 - 0.5)) / 150.0
    start = 0.1 * way
    scene = block(springs, x=float(start[0]), y=float(start[1]))
    omega, times = sqrt(150.0 / 0.5), np.linspace(0.0, 1.0, 51)
    along = balance + (0.1 - balance) * np.cos(omega * times)
    assert moved(scene, times).q + start == pytest.approx(np.outer(along, way), abs=CLOSE)


def test_energy_that_a_dashpot_takes() -> None:
    """The power is d/dt(½mv² + Σ½k(ℓ − ℓ₀)²) = −b Σ (dℓ/dt)².

    The integral is taken by Simpson's rule over 4,000 intervals.
    """
    springs = [(90.0, 0.6, -0.8, 0.1), (60.0, 0.5, 0.9, -0.3)]
    scene = block(springs, damping=1.3, x=0.1, y=0.2, launch={"x": 0.7, "y": -0.4})
    state = moved(scene, np.linspace(0.0, 1.0, 4001))
    apart = (np.array([0.1, 0.2]) + state.q)[:, None, :] - np.array([(x, y) for _, _, x, y in springs])
    length = np.linalg.norm(apart, axis=2)
    rate = (apart * state.v[:, None, :]).sum(axis=2) / length
    stored = 0.5 * ((length - [0.6, 0.5]) ** 2 @ np.array([90.0, 60.0]))
    energy = 0.25 * (state.v**2).sum(axis=1) + stored
    power = 1.3 * (rate**2).sum(axis=1)
    weights = np.ones(4001)
    weights[1:-1:2], weights[2:-1:2] = 4.0, 2.0
    lost = weights @ power / 4000.0 / 3.0
    assert energy[0] - energy[-1] == pytest.approx(lost, rel=1e-8)


def test_a_turned_table_gives_the_turned_motion() -> None:
    """A smooth horizontal table is isotropic."""
    ends, c, s = [(-0.8, 0.1), (0.9, -0.3), (0.2, 0.7)], cos(0.7), sin(0.7)
    turn = np.array([[c, -s], [s, c]])
    first = block([(90.0, 0.6, x, y) for x, y in ends], x=0.1, y=0.2)
    turned = [turn @ end for end in (*ends, (0.1, 0.2))]
    x, y = (float(part) for part in turned.pop())
    second = block([(90.0, 0.6, float(a), float(b)) for a, b in turned], x=x, y=y)
    times = np.linspace(0.0, 2.0, 41)
    assert moved(second, times).q == pytest.approx(moved(first, times).q @ turn.T, abs=1e-8)


def exact_chain(
    masses: list[float], matrix: np.ndarray, damping: np.ndarray, start: tuple[np.ndarray, np.ndarray], t: float
) -> np.ndarray:
    """Return positions and velocities that solve M ẍ = −K x − B ẋ, by the eigenvalues of its first-order matrix."""
    n = len(masses)
    first = np.zeros((2 * n, 2 * n))
    first[:n, n:] = np.eye(n)
    first[n:] = np.hstack([-matrix, -damping]) / np.array(masses)[:, None]
    values, vectors = np.linalg.eig(first)
    begin = np.linalg.solve(vectors, np.concatenate(start).astype(complex))
    return (vectors @ (begin * np.exp(values * t))).real


@pytest.mark.parametrize("ends", ["left", "right", "both"])
@pytest.mark.parametrize("tilt", [0.0, 25.0])
@pytest.mark.parametrize("damping", [None, 1.7])
def test_a_chain_between_walls(ends: str, tilt: float, damping: float | None) -> None:
    """The chain is prestrained, struck and damped; a slope only shifts its equilibrium to x₀ = −K⁻¹ M g sin θ."""
    masses, stiffness = [0.5, 1.2, 0.8], [60.0, 110.0, 45.0, 80.0]
    used = {"left": stiffness[:3], "right": stiffness[1:], "both": stiffness}[ends]
    strain = {"spring": 1, "way": "compressed", "by": 0.12}
    blow = {"cart": 2, "toward": "left", "speed": 0.9}
    scene = chain(masses, used, ends=ends, damping=damping, strain=strain, blow=blow, track={"angle": tilt})
    k = np.array(stiffness) * [ends != "right", 1.0, 1.0, ends != "left"]

    def joined(part: np.ndarray) -> np.ndarray:
        return np.diag(part[:-1] + part[1:]) - np.diag(part[1:-1], 1) - np.diag(part[1:-1], -1)

    matrix, rub = joined(k), joined((damping or 0.0) * (k > 0.0))
    pulls = np.zeros(4)
    pulls[1 + (ends == "right")] = -0.12 * used[1]
    force = np.diff(pulls) - np.array(masses) * G * sin(radians(tilt))
    settled = np.linalg.solve(matrix, force)
    start = (-settled, np.array([0.0, 0.0, -0.9]))
    times = np.linspace(0.0, 2.0, 21)
    state = moved(scene, times)
    for t, q, v in zip(times, state.q, state.v, strict=True):
        assert [*(q - settled), *v] == pytest.approx(list(exact_chain(masses, matrix, rub, start, t)), abs=CLOSE)


def test_a_free_chain_keeps_its_momentum() -> None:
    """Two equal carts on a spring exchange velocities after half a period π√(m/2k), so Σ m v is constant."""
    scene = chain([0.7, 0.7], [90.0], blow={"cart": 0, "toward": "right", "speed": 1.4})
    state = moved(scene, np.array([0.0, pi * sqrt(0.7 / 180.0)]))
    assert state.v[1] == pytest.approx([0.0, 1.4], abs=CLOSE)


def test_a_rough_chain_stops_for_good() -> None:
    """A cart released where k d > µ m g swings for π√(m/k), by 2µmg/k less than without friction."""
    strain = {"by": 0.3}
    scene = chain([2.0], [80.0], ends="left", strain=strain, track={"friction": 0.25})
    half = pi * sqrt(2.0 / 80.0)
    state = moved(scene, np.array([0.0, half]))
    assert state.q[1, 0] == pytest.approx(-2.0 * (0.3 - 0.25 * 2.0 * G / 80.0), abs=CLOSE)


@pytest.mark.parametrize("count", [10, pytest.param(50, marks=pytest.mark.slow)])
@pytest.mark.parametrize("kind", KINDS)
def test_texts_and_files_lead_back(kind: type[Entity], count: int) -> None:
    for seed, scene in enumerate(drawn(kind, count)):
        check_told(scene, seed)


@pytest.mark.slow  # testing/test_entities cuts the sentences of every entity
@pytest.mark.parametrize("kind", KINDS)
def test_no_sentence_can_be_left_out(kind: type[Entity]) -> None:
    for seed, scene in enumerate(drawn(kind, 8, seed=1)):
        check_whole(scene, seed)


@pytest.mark.parametrize("kind", KINDS)
def test_both_engines_agree(kind: type[Entity]) -> None:
    assert sum(certified(scene) for scene in drawn(kind, 10, seed=2)) >= 9


@pytest.mark.parametrize(
    ("kind", "told", "says"),
    [
        (SpringBlock, {"x": 0.3, "y": 0.0}, "its fixed end is where the block starts"),
        (SpringMassChain, {"ends": "free", "springs": ({"stiffness": 50.0},)}, "demands 0, not 1"),
        (SpringMassChain, {"springs": ({"stiffness": 50.0},)}, "no spring is ever strained"),
    ],
)
def test_what_can_not_be_is_refused(kind: type[Entity], told: dict[str, object], says: str) -> None:
    usual: dict[str, object] = {"carts": ({"mass": 1.0},), "track": {}, "ends": "left"}
    if kind is SpringBlock:
        spring = {"stiffness": 50.0, "length": 0.2, "x": 0.3, "y": 0.0}
        usual = {"block": {"mass": 1.0}, "springs": (spring,), "y": 0.0}
    with pytest.raises(ValueError, match=says):
        kind.model_validate({**usual, **told})
