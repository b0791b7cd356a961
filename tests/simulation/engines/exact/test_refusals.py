"""Tests of what the exact engine refuses, and of the events that end a motion."""

from dataclasses import replace
from math import cos, radians, sin, tan

import numpy as np
import pytest

from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.scenes.dsl.builder import Builder, Frame
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Coordinate, Inextensible, Line, Mechanism, RigidBody, Site, X, Y, Z
from sim2reason.scenes.dsl.structure import changing
from sim2reason.simulation.engines.exact import engine, motion, simulate
from sim2reason.simulation.trace import ENGINES

G = 9.8


def test_it_is_registered() -> None:
    assert ENGINES["exact"] is simulate


def test_a_string_whose_ends_coincide() -> None:
    builder = Builder()
    room = builder.room()
    room.site("nail")
    room.body("A", 1.0).slide(Z).site("A.hook")
    room.string("s", "A.hook", "nail")
    with pytest.raises(SceneError, match=r"s: sites A\.hook and nail coincide"):
        motion(builder.finish(), 1.0)


def wheel(**changes: object) -> RigidBody:
    hinge = Coordinate("wheel.hinge", "wheel", "hinge", "hinge", Y)
    return replace(RigidBody("wheel", None, (0.0, 0.0, 0.0), 1.0, (0.0, 0.0, 0.0), DISC, (hinge,)), **changes)


DISC = (0.05, 0.1, 0.05, 0.0, 0.0, 0.0)
ABOUT_X = Coordinate("wheel.x", "wheel", "x", "hinge", X)
ALONG_X = Coordinate("load.x", "load", "x", "slide", X)


@pytest.mark.parametrize(
    ("mechanism", "reason"),
    [
        (Mechanism((wheel(center=(0.1, 0.0, 0.0)),)), "wheel swings"),
        (Mechanism((wheel(), RigidBody("load", "wheel", (0.0, 0.0, -1.0), 1.0))), "load swings"),
        (
            Mechanism((wheel(), RigidBody("load", "wheel", (0.0, 0.0, 0.0), 1.0, coordinates=(ALONG_X,)))),
            "load moves on a turning body",
        ),
        (Mechanism((wheel(coordinates=(*wheel().coordinates, ABOUT_X)),)), "wheel turns about several axes"),
        (Mechanism((wheel(),)), ""),
    ],
)
def test_what_turns_with_a_body_off_its_axis_changes_the_equations(mechanism: Mechanism, reason: str) -> None:
    assert changing(mechanism, initial_frames(mechanism)) == reason


def test_a_point_on_the_axle_is_fine() -> None:
    load = RigidBody("load", "wheel", (0.0, 2.0, 0.0), 1.0)
    found = motion(Mechanism((wheel(), load), (Site("hub", "wheel", Y),)), 1.0)
    assert found.segments[0].a == [0.0]


def test_a_rough_contact_in_two_directions() -> None:
    builder = Builder()
    builder.room().body("A", 1.0).rest(X, Z, 0.2).slide(Y, name="y")
    with pytest.raises(UnsupportedError, match="A: a rough contact"):
        motion(builder.finish(), 1.0)


def test_a_body_that_slides_off_its_face() -> None:
    builder = Builder()
    builder.room().body("A", 1.0).rest(X, (sin(0.1), 0.0, cos(0.1)))
    with pytest.raises(UnsupportedError, match="A: it slides off the face"):
        motion(builder.finish(), 1.0)


def test_bodies_that_overlap() -> None:
    builder = Builder()
    room = builder.room()
    room.collide(room.body("A", 1.0).slide(X), room.body("B", 1.0, at=(0.1, 0.0, 0.0)), 0.2, 1.0)
    with pytest.raises(SceneError, match="A: it overlaps B"):
        motion(builder.finish(), 1.0)


def pulled_wedge(force: float) -> Builder:
    """Build a smooth wedge that is pulled away under its block."""
    theta = radians(40.0)
    builder = Builder()
    room = builder.room()
    wedge = room.body("W", 2.0).rest(X, Z)
    wedge.body("A", 1.0).rest((cos(theta), 0.0, sin(theta)), (-sin(theta), 0.0, cos(theta)))
    wedge.site("eye")
    room.site("hand", at=(90.0, 0.0, 0.0)).pull("F", "eye", "hand", force=force)
    return builder


def test_a_block_lifts_off_a_wedge_that_is_drawn_away() -> None:
    """The normal force vanishes when the wedge's acceleration F/M reaches g cot θ."""
    critical = 2.0 * G / tan(radians(40.0))
    assert motion(pulled_wedge(0.999 * critical).finish(), 1.0).cut == ""
    found = motion(pulled_wedge(1.001 * critical).finish(), 1.0)
    assert (found.cut, found.end) == ("lift", 0.0)
    assert found.events[-1].subjects == ("A",)
    assert found.segments[0].normal[1] == 0.0


def test_a_blow_can_lift_a_block() -> None:
    """A ball strikes from below a block that lies on a table."""
    builder = Builder()
    room = builder.room()
    block = room.body("A", 1.0).rest(X, Z)
    room.collide(room.body("B", 1.0, at=(0.0, 0.0, -1.0)).slide(Z, 6.0), block, 0.2, 1.0)
    found = motion(builder.finish(), 1.0)
    assert [event.kind for event in found.events] == ["collision", "lift"]
    assert found.cut == "lift"


def test_a_block_that_starts_at_its_limit_and_is_driven_into_it() -> None:
    builder = Builder()
    builder.room().body("A", 1.0).slide(Z, limits=(0.0, 1.0))
    found = motion(builder.finish(), 1.0)
    assert (found.cut, found.end) == ("limit", 0.0)


def test_a_block_that_starts_at_its_limit_and_leaves_it() -> None:
    builder = Builder()
    builder.room().body("A", 1.0).slide(Z, 2.0, limits=(0.0, 10.0))
    found = motion(builder.finish(), 1.0)
    assert (found.cut, found.end) == ("limit", pytest.approx(4.0 / G))


def test_more_events_than_the_budget(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engine, "SEGMENTS", 10)
    builder = Builder(gravity=(0.0, 0.0, 0.0))
    room = builder.room()
    ball = room.body("ball", 1.0).slide(X, 5.0)
    for name, x in (("left", -1.0), ("right", 1.0)):
        room.collide(ball, room.body(name, at=(x, 0.0, 0.0)), 0.1, 1.0)
    with pytest.raises(SimulationError, match="more than 10 events"):
        motion(builder.finish(), 100.0)


def test_after_the_end_the_last_segment_goes_on() -> None:
    builder = Builder()
    builder.room().body("A", 1.0).slide(Z, limits=(-1.0, 1.0))
    trace = simulate(builder.finish(), np.array([0.0, 1.0, 2.0]))
    assert trace.cut == "limit"
    assert trace.state.q[:, 0] == pytest.approx([0.0, -G / 2.0, -2.0 * G])


def test_an_empty_mechanism_and_one_that_can_not_move() -> None:
    assert simulate(Mechanism(()), np.array([0.0, 1.0])).state.q.shape == (2, 0)
    builder = Builder()
    room: Frame = builder.room()
    room.site("nail", at=(0.0, 0.0, 1.0))
    room.body("A", 1.0).site("A.hook")
    room.string("s", "A.hook", "nail")
    found = motion(builder.finish(), 1.0)
    assert found.segments[0].a == []
    assert np.isnan(found.segments[0].tension).all()


def test_a_slide_without_a_contact_along_it() -> None:
    builder = Builder()
    builder.room().body("A", 1.0).rest(X, Z)
    body = builder.finish().bodies[0]
    with pytest.raises(SceneError, match="A: it rests on a face but has no slide"):
        motion(Mechanism((replace(body, coordinates=()),), faces=builder.finish().faces), 1.0)


def test_numpy_numbers_come_out_plain() -> None:
    """A direction computed with NumPy would otherwise put NumPy scalars into events."""
    axis = tuple(np.array([0.0, 0.0, 1.0]))
    body = RigidBody(
        "A",
        None,
        (0.0, 0.0, 0.0),
        np.float64(1.0),
        coordinates=(Coordinate("A.z", "A", "z", "slide", axis, np.float64(3.0)),),
    )
    (event,) = motion(Mechanism((body,), sites=(Site("x", "A", axis),)), 1.0).events
    assert type(event.time) is float


def test_pulls_and_strings_share_runs() -> None:
    """Two lines through the same sites cause one event when these meet."""
    sites = (Site("eye", "A", (0.0, 0.0, 0.0)), Site("top", None, (0.0, 0.0, 1.0)))
    body = RigidBody("A", None, (0.0, 0.0, 0.0), 1.0, coordinates=(Coordinate("A.z", "A", "z", "slide", Z, 20.0),))
    lines = tuple(Line(name, name, ("eye", "top"), (), Inextensible(0.5)) for name in ("s", "t"))
    found = motion(Mechanism((body,), sites, lines), 1.0)
    assert [(event.kind, event.subjects) for event in found.events] == [("reach", ("eye", "top"))]
