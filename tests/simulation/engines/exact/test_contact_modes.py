"""Tests of the search for the mode of contacts and strings: sticking, sliding, taut or slack."""

import numpy as np
import pytest

from random_mechanisms import rough
from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import X, Z
from sim2reason.simulation.engines.exact import contact_modes, motion

G = 9.8


@pytest.mark.parametrize("seed", range(40))
def test_trying_all_modes_finds_the_same_motion(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The forces are the same, too, and those that the motion leaves open (NaN) are the same ones."""
    mechanism = rough(seed).finish()
    searched = motion(mechanism, 0.5)
    monkeypatch.setattr(contact_modes, "FLIPS", 0)
    tried = motion(mechanism, 0.5)
    assert [event.kind for event in tried.events] == [event.kind for event in searched.events]
    times = np.linspace(0.0, searched.end, 5)
    assert tried.state(times).q == pytest.approx(searched.state(times).q, abs=1e-9)
    for one, other in zip(tried.segments, searched.segments, strict=True):
        assert one.tension == pytest.approx(other.tension, rel=1e-6, abs=1e-6, nan_ok=True)
        assert one.friction == pytest.approx(other.friction, rel=1e-6, abs=1e-6, nan_ok=True)


def test_no_consistent_mode_is_an_error_not_a_guess(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(contact_modes, "FLIPS", 0)
    monkeypatch.setattr(contact_modes, "MODES", 0)
    mechanism = rough(0).finish()
    names = ", ".join(name for name, contact in mechanism.contacts.items() if contact.friction)
    with pytest.raises(SimulationError, match=f"no forces are consistent .* too strong on {names}$"):
        motion(mechanism, 0.5)


def test_where_friction_has_no_law_the_block_lifts() -> None:
    """No mode with friction has a negative normal force, so the block lifts off."""
    assert motion(rough(1275).finish(), 2.0).cut == "lift"


def tray(floor: float) -> Builder:
    """Return a builder of a massless tray on the floor, with a block that slides on it."""
    builder = Builder()
    frame = builder.room().body("tray", 0.0).rest(X, Z, floor)
    frame.body("A", 2.0).rest(X, Z, 0.3, speed=3.0)
    return builder


def test_a_light_tray_is_held_by_the_floor() -> None:
    """The block's friction µ m g is less than the floor's limit."""
    found = motion(tray(0.4).finish(), 0.5)
    assert found.cut == ""
    assert found.segments[0].a == pytest.approx([0.0, -0.3 * G])
    assert found.segments[0].friction == pytest.approx([-0.6 * G, -0.6 * G])  # the block drags it forward


def test_a_light_tray_on_a_smooth_floor_has_no_acceleration_to_speak_of() -> None:
    """A force on a massless body leaves the motion undetermined."""
    found = motion(tray(0.0).finish(), 0.5)
    assert (found.cut, found.end) == ("indeterminate", 0.0)
    assert found.events[-1].subjects == ("tray.slide", "A.slide")
