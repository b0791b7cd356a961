"""Tests that MuJoCo's warnings are reported, and never written to the working directory."""

from pathlib import Path

import numpy as np
import pytest

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import X
from sim2reason.simulation.engines import mujoco as engine
from sim2reason.simulation.engines.mujoco import engine as loop
from sim2reason.simulation.engines.mujoco.specification import collect_warnings, mujoco


def warn() -> None:
    """Make MuJoCo take a step with a NaN position."""
    spec = mujoco.MjSpec()
    body = spec.worldbody.add_body(mass=1.0, inertia=(1.0, 1.0, 1.0), explicitinertial=True)
    body.add_joint(type=mujoco.mjtJoint.mjJNT_SLIDE)
    model = spec.compile()
    data = mujoco.MjData(model)
    data.qpos[:] = np.nan
    mujoco.mj_step(model, data)


def test_warnings_are_kept_and_no_file_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with collect_warnings() as said:
        warn()
    assert len(said) == 1
    assert "QPOS" in said[0]
    assert not list(tmp_path.iterdir())


def test_whoever_listened_before_listens_again() -> None:
    heard: list[str] = []
    mujoco.set_mju_user_warning(heard.append)
    try:
        with collect_warnings() as said:
            warn()
        warn()
    finally:
        mujoco.set_mju_user_warning(None)
    assert len(said) == len(heard) == 1


def test_a_warning_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    def warned(*_: object) -> None:
        warn()

    monkeypatch.setattr(loop, "run", warned)
    builder = Builder()
    room = builder.room().site("wall", (-1.0, 0.0, 0.0))
    room.body("block", 1.0).slide(X).site("hook")
    room.spring("spring", "wall", "hook", stiffness=1.0)
    with pytest.raises(SimulationError, match="MuJoCo warns"):
        engine.simulate(builder.finish(), np.linspace(0.0, 1.0, 3))
