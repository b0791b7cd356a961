"""Tests of rigid bodies in space against Euler's equations (`tests/support/lagrangian/bodies.py`)."""

from math import cos, radians, sin

import numpy as np

from agreement import Agreement, axis, rate
from lagrangian import bodies
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import ZERO, Y, Z
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import Tensor

TWO = np.linspace(0.0, 2.0, 41)


def turned(moments: tuple[float, float, float], tilt: float) -> Tensor:
    """Return the inertia tensor with given principal moments, its third axis tilted from z towards x."""
    c, s = cos(tilt), sin(tilt)
    turn = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    t = turn @ np.diag(moments) @ turn.T
    return (t[0, 0], t[1, 1], t[2, 2], t[0, 1], t[0, 2], t[1, 2])


def test_heavy_top(agree: Agreement) -> None:
    """A top on three hinges at its tip, the last along its own axis, precesses and nutates at 40° to the vertical."""
    mass, long, moments, tilt, precession, spin = 0.8, 0.15, (0.004, 0.004, 0.0015), radians(40), 1.0, 90.0
    way = (sin(tilt), 0.0, cos(tilt))
    builder = Builder()
    top = builder.room().body("top", mass, center=tuple(long * part for part in way), inertia=turned(moments, tilt))
    top.hinge(Z, precession, name="turn").hinge(Y, name="nod").hinge(way, spin, name="spin")

    def columns(state: State) -> list[Array]:
        starts = (("turn", 0.0), ("nod", tilt), ("spin", 0.0))
        return [*(axis(state, f"top.{n}", at) for n, at in starts), *(rate(state, f"top.{n}") for n, _ in starts)]

    across = moments[0] + mass * long**2
    phase = bodies.heavy_top(across, moments[2], mass * 9.8 * long)
    start = bodies.top_start(across, moments[2], tilt, precession, spin)
    agree(builder.finish(), (phase, start), TWO, columns, substeps=6)


def test_body_that_tumbles_about_its_middle_axis(agree: Agreement) -> None:
    """Torque-free rotation about the axis of the intermediate moment is unstable (the tennis racket theorem)."""
    moments, tilt = (0.5, 0.9, 1.3), radians(70)
    rates = {"turn": 3.0, "nod": 0.4, "spin": 0.2}
    way = (sin(tilt), 0.0, cos(tilt))
    builder = Builder(ZERO)
    body = builder.room().body("body", 2.0, inertia=turned(moments, tilt))
    body.hinge(Z, rates["turn"], name="turn").hinge(Y, rates["nod"], name="nod").hinge(way, rates["spin"], name="spin")
    own = np.array([[cos(tilt), 0.0, sin(tilt)], [0.0, 1.0, 0.0], [-sin(tilt), 0.0, cos(tilt)]])  # its axes at first

    def columns(state: State) -> list[Array]:
        frame = state.frames["body"]
        axes = [state.vector(frame.turned(tuple(own[:, k]))) for k in range(3)]
        spin = state.vector(frame.turning.velocity)
        return [*(axes[k][:, row] for row in range(3) for k in range(3)), *spin.T]

    spin = np.array([0.0, rates["nod"], rates["turn"]]) + rates["spin"] * np.array(way)
    start = [*(own.T @ spin), *own.ravel()]
    agree(builder.finish(), (bodies.free_body(moments), start), np.linspace(0.0, 4.0, 41), columns, substeps=3)
