"""Tests that a change of the MuJoCo model's units of mass and time leaves the motion unchanged."""

import numpy as np
import pytest

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import loads
from sim2reason.simulation.engines import mujoco
from sim2reason.simulation.scenes import simulate

SCENES = {
    "string, torque": "BlocksOnSteppedPulley, parameters: {pulley: {outer: 0.3, inner: 0.1, inertia: 0.2}, "
    "outer_block: {mass: 2.0}, inner_block: {mass: 3.0}}",
    "spring": "SpringOnWedge, parameters: {wedge: {mass: 3.0, angle: 30.0, friction: 0.2}, block: {mass: 2.0}, "
    "spring: {stiffness: 100.0, length: 0.5}, start: 0.8}",
    "attraction": "SolarSystem, parameters: {star: {mass: 1.0}, planets: "
    "[{kind: planet, x: 1.0, y: 0.0, vx: 0.0, vy: 6.0}]}",
    "burn": "RocketEntity, parameters: {rocket: {mass: 2.97e6, dry: 8.1e5}, exhaust: 2.58, rate: 13300.0, "
    "place: {kind: level_ground}}",
}


def of(kind: str) -> Scene:
    """Return a scene with one entity."""
    return loads(f"scene: {{entities: [{{name: it, type: {SCENES[kind]}}}]}}")


@pytest.mark.parametrize("kind", SCENES)
def test_a_motion_is_the_same_in_other_units(kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Coordinates, velocities, accelerations, forces and events are the same."""
    held = of(kind)
    plain = simulate(held, engine="mujoco")

    def always(_: Mechanism) -> bool:
        return True

    monkeypatch.setattr(mujoco, "is_tiny", always)
    other = simulate(held, engine="mujoco")
    assert other.mechanism == plain.mechanism
    assert other.state.times == pytest.approx(plain.state.times)
    for name in ("q", "v", "a"):
        wanted = getattr(plain.state, name)
        assert getattr(other.state, name) == pytest.approx(wanted, abs=1e-6 * np.abs(wanted).max())
    for name in ("tension", "normal", "friction"):
        wanted, found = getattr(plain.state, name), getattr(other.state, name)
        assert found.keys() == wanted.keys()
        for subject in wanted:
            assert found[subject] == pytest.approx(wanted[subject], rel=1e-6, abs=1e-6)
    assert [e.kind for e in other.events] == [e.kind for e in plain.events]
    assert [e.time for e in other.events] == pytest.approx([e.time for e in plain.events], rel=1e-6)


def test_ordinary_motions_keep_their_units() -> None:
    """Units change only for bodies that MuJoCo would regard as massless."""
    assert not any(mujoco.is_tiny(of(kind).mechanism) for kind in SCENES)
