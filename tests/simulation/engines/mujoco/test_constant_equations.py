"""Tests of motions with constant accelerations between events, and of general checks."""

from math import sqrt

import numpy as np
import pytest

import machines
import motions
from sim2reason.errors import SceneError, SimulationError
from sim2reason.scenes.dsl.builder import Builder, Frame
from sim2reason.scenes.dsl.mechanism import X, Z
from sim2reason.simulation.certify import compare
from sim2reason.simulation.engines.exact import simulate as exactly
from sim2reason.simulation.engines.mujoco import model, simulate
from sim2reason.simulation.engines.mujoco.engine import EventDrivenLoop

G = 9.8
TIMES = np.linspace(0.0, 2.0, 101)


def sprung(room: Frame) -> None:
    """Add a distant block on a spring, which makes the mechanism's equations of motion non-constant."""
    room.site("wall", (50.0, 0.0, 0.0))
    room.body("sprung", 1.0, at=(49.0, 0.0, 0.0)).slide(X).site("sprung.hook")
    room.spring("spring", "wall", "sprung.hook", stiffness=3.0, length=0.9)


@pytest.mark.parametrize("name", machines.SAMPLES)
def test_one_step_leads_from_event_to_event(name: str) -> None:
    motion = EventDrivenLoop(machines.SAMPLES[name](), TIMES)
    while motion.advance():
        pass
    assert all(len(interval.knots) <= 2 for interval in motion.record.intervals)
    assert motion.steps <= len(motion.record.intervals)


@pytest.mark.parametrize("overshoot", [1e-6, 1e-3, 0.1])
def test_a_short_contact_in_a_long_flight_is_found(overshoot: float) -> None:
    """A ball thrown up at v meets a shelf just below its greatest height after (v − √(v² − 2gh))/g."""
    speed = 6.0
    height = speed**2 / (2.0 * G) - overshoot
    builder = Builder()
    room = builder.room()
    ball = room.body("ball", 1.0).slide(Z, speed=speed)
    room.collide(ball, room.body("shelf", 1.0, at=(0.0, 0.0, height + 0.1)), 0.1, 0.5)
    trace = simulate(builder.finish(), np.linspace(0.0, 5.0, 51))
    hits = [event.time for event in trace.events if event.kind == "collision"]
    assert hits == pytest.approx([(speed - sqrt(2.0 * G * overshoot)) / G], abs=1e-9)


def test_bodies_whose_centres_would_coincide_later_meet() -> None:
    """The collision is at 1 − 0.2 = 0.8 s; without it the centres would coincide halfway through the step."""
    builder = Builder()
    room = builder.room()
    runner = room.body("runner", 1.0).rest(X, Z, speed=1.0)
    room.collide(runner, room.body("post", 1.0, at=(1.0, 0.0, 0.0)).rest(X, Z), 0.2, 1.0)
    trace = simulate(builder.finish(), TIMES)
    assert [event.time for event in trace.events] == pytest.approx([0.8], abs=1e-12)
    assert trace.state.v[-1] == pytest.approx([0.0, 1.0], abs=1e-12)


def test_of_several_events_in_one_step_the_first_comes_first() -> None:
    """Three pucks at 1 m/s in separate lanes start 2, 0.5 and 1 m from fixed posts."""
    builder = Builder()
    room = builder.room()
    for number, start in enumerate((2.0, 0.5, 1.0)):
        runner = room.body(f"runner{number}", 1.0, at=(-start, float(number), 0.0)).slide(X, speed=1.0)
        room.collide(runner, room.body(f"post{number}", 1.0, at=(0.1, float(number), 0.0)), 0.1, 1.0)
    trace = simulate(builder.finish(), np.linspace(0.0, 20.0, 51))
    hits = [(event.subjects[0], event.time) for event in trace.events]
    assert [name for name, _ in hits] == ["runner1", "runner2", "runner0"]
    assert [time for _, time in hits] == pytest.approx([0.5, 1.0, 2.0], abs=1e-9)


def test_equations_that_change_in_spite_of_their_structure_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """The forces at the end are compared, since the exact engine's code decides on constancy too."""
    monkeypatch.setattr(model, "changing", lambda _: "")
    with pytest.raises(SimulationError, match="a force changes between two events"):
        simulate(motions.orbit(0.5).mechanism, TIMES)


def test_a_massless_pulley_leaves_no_drift_where_equations_change() -> None:
    """The pulley's substitute mass must not make a string drift, as it did by 1e-5 m/s beside a mass of 1 kg."""
    builder = Builder()
    room = builder.room()
    pulley = room.body("pulley", 0.0, at=(0.1, 0.0, -2.0)).slide(Z).site("axle")
    rim = pulley.pulley("rim", radius=0.1)
    room.site("nail")
    top = room.pulley("top", (0.3, 0.0, 0.0), radius=0.1)
    room.body("load", 3.0, at=(0.1, 0.0, -3.0)).slide(Z).site("load.hook")
    room.body("weight", 1.0, at=(0.4, 0.0, -2.0)).slide(Z).site("weight.hook")
    room.string("rope", "nail", rim, top, "weight.hook")
    room.string("hanger", "axle", "load.hook")
    sprung(room)
    mechanism = builder.finish()
    certificate = compare(exactly(mechanism, TIMES), simulate(mechanism, TIMES))
    assert certificate.stable_until > 1.0
    assert max(certificate.agreement.values()) <= 1e-7


@pytest.mark.parametrize("changes", [False, True])
def test_a_motion_that_an_impact_ends_as_it_begins_is_recorded(*, changes: bool) -> None:
    """A ball strikes a block from below and lifts it off its floor, which ends the motion."""
    builder = Builder()
    room = builder.room()
    block = room.body("block", 1.0).rest(X, Z)
    ball = room.body("ball", 1.0, at=(-0.3, 0.0, -0.4)).slide(X, 3.0, name="x").slide(Z, 4.0, name="z")
    room.collide(ball, block, 0.5, 0.5)
    if changes:
        sprung(room)
    trace = simulate(builder.finish(), TIMES)
    assert [(event.time, event.kind) for event in trace.events] == [(0.0, "collision"), (0.0, "lift")]
    assert (trace.cut, trace.stable_until) == ("lift", 0.0)
    assert trace.state.v.shape == (len(TIMES), len(trace.mechanism.coordinates))


def test_overlap_and_coincidence_are_refused_where_equations_change() -> None:
    builder = Builder()
    room = builder.room()
    a, b = room.body("a", 1.0).slide(X), room.body("b", 1.0, at=(0.1, 0.0, 0.0)).slide(X)
    room.collide(a, b, 0.5, 1.0)
    sprung(room)
    with pytest.raises(SceneError, match="overlaps"):
        simulate(builder.finish(), TIMES)
    builder = Builder()
    room = builder.room()
    room.site("nail").body("a", 1.0).slide(X).site("hook")
    room.string("s", "nail", "hook")
    sprung(room)
    with pytest.raises(SceneError, match="coincide"):
        simulate(builder.finish(), TIMES)


def test_simultaneous_events_come_in_the_order_of_kinds() -> None:
    """Both engines record the collision before the slack string that it causes."""
    mechanism = machines.carts(0.5, 0.0, 0.3)
    kinds = [[event.kind for event in run(mechanism, TIMES).events] for run in (exactly, simulate)]
    assert kinds[0][:2] == kinds[1][:2] == ["collision", "slack"]
