"""Tests of positions, gradients, velocities and biases in a tree of bodies, against finite differences."""

import math

import numpy as np
import pytest

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Y, Z

UPHILL = (0.8, 0.0, 0.6)
H = 1e-4


@pytest.fixture
def cart() -> Mechanism:
    """Return a cart with a block that slides on its sloping top, and two arms hinged one to the other on it."""
    builder = Builder()
    room = builder.room("r", at=(1.0, 0.0, 0.0))
    room.site("nail", at=(0.0, 0.0, 5.0))
    wagon = room.body("cart", 2.0, at=(1.0, 0.0, 0.0)).rest(X, Z)
    block = wagon.body("block", 1.0, at=(0.0, 0.5, 0.0)).rest(UPHILL, (-0.6, 0.0, 0.8)).slide(Y, name="aside")
    block.pulley("wheel", at=(0.0, 0.0, 1.0), mass=0.5)
    arm = block.body("arm", 0.3, at=(0.1, 0.0, 0.2), center=(0.0, 0.1, -0.4)).hinge((0.6, 0.8, 0.0))
    arm.body("bob", 0.2, at=(0.0, 0.1, -0.7), center=(0.3, 0.0, 0.0)).hinge(X).slide(Z).site("tip", at=(0.0, 0.2, 0.1))
    return builder.finish()


def walk(mechanism: Mechanism, q: np.ndarray, v: np.ndarray) -> Frames:
    return Frames(mechanism, list(map(float, q)), list(map(float, v)), math)


def test_a_chain_of_slides(cart: Mechanism) -> None:
    point = initial_frames(cart).center("r.block")
    assert dict(point.gradient) == {0: X, 1: UPHILL, 2: Y}
    assert point.place == (2.0, 0.5, 0.0)
    assert dict(point.lift) == {0: Z, 1: (-0.6, 0.0, 0.8)}
    assert dict(initial_frames(cart)["r.wheel"].turning.gradient) == {3: Y}


@pytest.mark.parametrize("seed", range(5))
def test_places_velocities_and_biases_agree_with_differences(cart: Mechanism, seed: int) -> None:
    """At q̈ = 0 a point moves by H·velocity + ½H²·bias; central differences of its position confirm both."""
    rng = np.random.default_rng(seed)
    n = len(cart.coordinates)
    q, v = rng.normal(size=n), rng.normal(size=n)
    now, before, after = walk(cart, q, v), walk(cart, q - H * v, v), walk(cart, q + H * v, v)
    for read in (lambda f: f.center("r.bob"), lambda f: f.center("r.arm"), lambda f: f.site("r.tip")):
        place, old, new = (np.array(read(frames).place) for frames in (now, before, after))
        assert np.array(read(now).velocity) == pytest.approx((new - old) / (2.0 * H), abs=1e-6)
        assert np.array(read(now).bias) == pytest.approx((new - 2.0 * place + old) / H**2, abs=1e-5)


@pytest.mark.parametrize("seed", range(5))
def test_gradients_agree_with_differences(cart: Mechanism, seed: int) -> None:
    rng = np.random.default_rng(seed)
    n = len(cart.coordinates)
    q, rest = rng.normal(size=n), np.zeros(n)
    point = walk(cart, q, rest).site("r.tip")
    for number in range(n):
        step = H * np.eye(n)[number]
        up, down = (np.array(walk(cart, q + way * step, rest).site("r.tip").place) for way in (1.0, -1.0))
        assert np.array(point.gradient.get(number, (0.0, 0.0, 0.0))) == pytest.approx((up - down) / (2.0 * H), abs=1e-6)


def test_arrays_give_what_floats_give(cart: Mechanism) -> None:
    rng = np.random.default_rng(3)
    q, v = rng.normal(size=(2, 7, len(cart.coordinates)))
    together = Frames(cart, list(q.T), list(v.T), np).site("r.tip")
    for number in range(7):
        alone = walk(cart, q[number], v[number]).site("r.tip")
        for vector, each in (
            (together.place, alone.place),
            (together.velocity, alone.velocity),
            (together.bias, alone.bias),
        ):
            assert [np.broadcast_to(part, 7)[number] for part in vector] == pytest.approx(each, rel=1e-14)


def test_a_frame_turns_vectors_there_and_back(cart: Mechanism) -> None:
    rng = np.random.default_rng(4)
    frame = walk(cart, rng.normal(size=len(cart.coordinates)), np.zeros(len(cart.coordinates)))["r.bob"]
    vector = (0.3, -1.2, 0.5)
    assert frame.to_body_axes(frame.turned(vector)) == pytest.approx(vector)
    assert math.hypot(*frame.turned(vector)) == pytest.approx(math.hypot(*vector))
