"""Tests that a motion ends where two points of a line meet, as the line has no direction there."""

from math import acos, sqrt

import numpy as np
import pytest

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.fields import Profile, Push, Resistance
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Z
from sim2reason.simulation.trace import ENGINES

TIMES = np.linspace(0.0, 2.0, 101)
ENDS = ("exact", "mujoco")


def drawn_through_a_hole(drag: float) -> Mechanism:
    """Build a block at rest on a table, its string through a hole ahead to a hanging weight."""
    builder = Builder()
    room = builder.room().site("hole", (1.0, 0.0, 0.0))
    room.body("block", 2.0).rest(X, Z).site("hook").force("drag", Resistance(drag))
    room.body("weight", 1.0, at=(1.0, 0.0, -1.0)).slide(Z).site("eye")
    room.string("string", "hook", "hole", "eye")
    return builder.finish()


def drawn_by_a_spring() -> Mechanism:
    builder = Builder()
    room = builder.room().site("nail", (1.0, 0.0, 0.0))
    room.body("block", 2.0).rest(X, Z).site("hook")
    room.spring("spring", "nail", "hook", stiffness=50.0, length=0.3)
    return builder.finish()


@pytest.mark.parametrize("engine", ENDS)
def test_a_string_is_used_up_where_its_block_reaches_the_hole(engine: str) -> None:
    """The block must not pass the hole."""
    trace = ENGINES[engine](drawn_through_a_hole(1e-3), TIMES)
    assert trace.cut == "reach"
    assert trace.events[-1].subjects == ("hook", "hole")
    a = 9.8 / 3.0  # without drag, which delays it by less than a thousandth
    assert trace.stable_until == pytest.approx(sqrt(2.0 / a), rel=1e-3)
    assert trace.sample(np.array([trace.stable_until])).q[0, 0] == pytest.approx(1.0, abs=2e-6)


@pytest.mark.parametrize(("engine", "close"), [("exact", 1e-7), ("mujoco", 1e-6)])
def test_a_spring_ends_where_its_block_reaches_the_nail(engine: str, close: float) -> None:
    """The length x = L + (x₀ − L) cos ωt is zero at cos ωt = −L/(x₀ − L), ω = √(k/m)."""
    trace = ENGINES[engine](drawn_by_a_spring(), TIMES)
    assert trace.cut == "reach"
    assert trace.stable_until == pytest.approx(acos(-0.3 / 0.7) / 5.0, abs=close)


@pytest.mark.parametrize("engine", ENDS)
def test_a_weight_that_is_drawn_past_its_hole_aside_goes_on(engine: str) -> None:
    """The string does not accelerate the weight at its nearest point; the motion goes on, and energy is constant."""
    builder = Builder()
    room = builder.room().site("hole", (0.0, 0.0, 0.0))
    block = room.body("block", 2.0, at=(-4.0, 0.0, 0.0)).rest(X, Z, 0.0, -0.5).site("hook")
    block.force("push", Push(X, Profile(-50.0)))
    room.body("weight", 1.0, at=(0.3, 0.0, -0.4)).slide(Z, 0.625).site("eye")
    room.string("string", "hook", "hole", "eye")
    trace = ENGINES[engine](builder.finish(), np.linspace(0.0, 0.4, 41))
    q, v = trace.state.q, trace.state.v
    assert trace.stable_until == 0.4
    assert q[:, 1].max() > 0.4 + 0.05
    assert v[0, 0] < 0.0 < v[:, 0].max()
    energy = v[:, 0] ** 2 + 0.5 * v[:, 1] ** 2 + 50.0 * q[:, 0] + 9.8 * q[:, 1]
    assert energy == pytest.approx(energy[0], abs=1e-4 if engine == "mujoco" else 1e-9)
