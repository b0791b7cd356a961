"""Tests of the gradients of constraint rows, and of the values of event functions."""

import numpy as np
import pytest

import machines
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.engine import EventDrivenLoop
from sim2reason.simulation.engines.mujoco.margins import ActingModel

STEP = 1e-6  # m or rad, for central differences
TIMES = np.linspace(0.0, 1.0, 11)


@pytest.mark.parametrize("name", machines.SAMPLES)
def test_gradients_of_rows_are_those_of_their_lengths(name: str) -> None:
    motion = EventDrivenLoop(machines.SAMPLES[name](), TIMES)
    rows = motion.model.rows()

    def spare(q: Array) -> list[float]:
        motion.model.set_state(0.0, q, motion.v, motion.switches)
        return [row.spare for row in motion.model.rows()]

    for joint, step in enumerate(STEP * np.eye(motion.model.size)):
        for before, after, row in zip(spare(motion.q - step), spare(motion.q + step), rows, strict=True):
            if row.kind != "hold":  # its length is that of the foot that it follows
                assert abs(after - before) / (2.0 * STEP) == pytest.approx(abs(row.gradient[joint]), abs=1e-6)


@pytest.mark.parametrize("name", machines.SAMPLES)
def test_each_event_function_has_one_value(name: str) -> None:
    motion = EventDrivenLoop(machines.SAMPLES[name](), TIMES)
    motion.model.set_state(0.0, motion.q, motion.v, motion.switches)
    acting = ActingModel(motion.model, motion.record, motion.switches, motion.settle())
    values = acting.margins()
    assert len(values) == len(acting.events)
    if not acting.constant:
        assert acting.distances() == acting.distances_among(values)
