"""Tests of initial velocities: both engines refuse those that violate a constraint."""

from math import inf

import numpy as np
import pytest

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Z
from sim2reason.scenes.dsl.state import check_initial_speeds
from sim2reason.simulation.trace import ENGINES

TIMES = np.linspace(0.0, 0.5, 6)


def dumbbell(speed: float, other: float) -> Mechanism:
    """Build two balls joined by a rod along x."""
    builder = Builder()
    room = builder.room()
    for name, x, v in (("a", 0.0, speed), ("b", 1.0, other)):
        room.body(name, 1.0, at=(x, 0.0, 0.0)).slide(X, v, name="x").slide(Z, v, name="z").site(f"{name}.eye")
    room.rod("rod", "a.eye", "b.eye")
    return builder.finish()


def ball(speed: float, spin: float | None) -> Mechanism:
    builder = Builder()
    body = builder.room().body("ball", 1.0, inertia=(0.1, 0.1, 0.1, 0.0, 0.0, 0.0))
    body.roll(X, Z, 0.5, inf, speed, spin)
    return builder.finish()


def foot(speed: float, rise: float, height: float = 0.0) -> Mechanism:
    builder = Builder()
    body = builder.room().body("block", 1.0).slide(X, speed, name="x").slide(Z, rise, name="z")
    body.stand("heel", (0.0, 0.0, 0.0), X, Z, (0.0, 0.0, -height))
    return builder.finish()


REFUSED = (
    (dumbbell(0.0, 0.5), "rod"),
    (dumbbell(1.0, -1.0), "rod"),
    (ball(1.0, 3.0), "ball"),
    (ball(0.0, 1e-3), "ball"),
    (foot(0.3, 0.0), "heel"),
)


@pytest.mark.parametrize("engine", ["exact", "mujoco"])
@pytest.mark.parametrize(("mechanism", "place"), REFUSED)
def test_it_is_refused_by_name(mechanism: Mechanism, place: str, engine: str) -> None:
    with pytest.raises(SceneError) as caught:
        ENGINES[engine](mechanism, TIMES)
    assert caught.value.place == place
    assert "begin" in caught.value.problem
    assert caught.value.remedy


@pytest.mark.parametrize(
    "mechanism",
    [dumbbell(0.7, 0.7), ball(1.0, None), ball(1.0, 2.0), foot(0.0, 0.0), foot(0.3, 1.0), foot(0.3, 0.0, 0.1)],
)
def test_what_can_go_on_so_may_begin(mechanism: Mechanism) -> None:
    check_initial_speeds(mechanism)


def test_the_rod_of_a_dumbbell_that_flies_keeps_its_length() -> None:
    builder = Builder()
    room = builder.room()
    for name, x, rise in (("a", 0.0, 0.0), ("b", 1.0, 2.0)):
        room.body(name, 1.0, at=(x, 0.0, 0.0)).slide(X, name="x").slide(Z, rise, name="z").site(f"{name}.eye")
    room.rod("rod", "a.eye", "b.eye")
    trace = ENGINES["exact"](builder.finish(), TIMES)
    q = trace.state.q
    assert np.hypot(1.0 + q[:, 2] - q[:, 0], q[:, 3] - q[:, 1]) == pytest.approx(1.0, abs=1e-10)
