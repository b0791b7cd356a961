"""Tests of the less common methods of a builder's frames."""

from math import inf

import pytest

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.fields import Central, Profile, Push
from sim2reason.scenes.dsl.mechanism import (
    Attraction,
    CollisionPair,
    Elastic,
    Inextensible,
    MassEjection,
    PlaneContact,
    Prop,
    Rigid,
    SurfaceContact,
    X,
    Y,
    Z,
)
from sim2reason.scenes.dsl.vectors import HalfSpace


@pytest.fixture
def builder() -> Builder:
    made = Builder()
    made.room().site("nail", (0.0, 0.0, 2.0))
    return made


def test_swing_lays_a_body_on_a_round_face(builder: Builder) -> None:
    builder.room("e", (1.0, 0.0, 0.0)).body("b", 1.0, center=(0.0, 0.0, -0.5)).swing(
        Y, (0.0, 0.0, 2.0), 0.5, friction=0.3, speed=2.0, guided=True
    )
    found = builder.finish()
    assert found.faces == (SurfaceContact("e.b", Z, (("e.b.hinge", 0.5),), 0.3, turning=True, guided=True),)
    assert [(c.name, c.kind, c.axis, c.speed) for c in found.coordinates] == [("e.b.hinge", "hinge", Y, 2.0)]


@pytest.mark.parametrize(("spin", "wanted"), [(None, 4.0), (1.5, 1.5)])
def test_roll_slides_and_turns_and_rolls_by_default(builder: Builder, spin: float | None, wanted: float) -> None:
    builder.room().body("b", 1.0).roll((2.0, 0.0, 0.0), Z, 0.25, speed=1.0, spin=spin)
    found = builder.finish()
    assert [(c.kind, c.axis, c.speed) for c in found.coordinates] == [("slide", X, 1.0), ("hinge", Y, wanted)]
    assert found.faces == (SurfaceContact("b", Z, (("b.slide", 1.0), ("b.hinge", -0.25)), inf),)


def test_lines_know_their_laws(builder: Builder) -> None:
    room = builder.room("e")
    room.body("b", 1.0).slide(X, name="x").slide(Z, name="z").site("hook", (0.0, 0.0, 1.0))
    room.prop("strut", "nail", "e.hook")
    room.rod("rod", "nail", "e.hook")
    room.string("rope", "nail", "e.hook", slack=0.2, reel=0.5)
    room.spring("coil", "nail", "e.hook", stiffness=3.0, damping=0.1)
    room.spring("long", "nail", "e.hook", stiffness=3.0, length=4.0)
    found = {line.name: line.law for line in builder.finish().lines}
    assert found == {
        "e.strut": Prop(),
        "e.rod": Rigid(),
        "e.rope": Inextensible(0.2, 0.5),
        "e.coil": Elastic(3.0, 1.0, 0.1),
        "e.long": Elastic(3.0, 4.0),
    }


def test_a_foot_stands_where_it_is_or_on_a_plane_that_is_given(builder: Builder) -> None:
    body = builder.room("e", (0.0, 0.0, 3.0)).body("b", 1.0, at=(1.0, 0.0, 0.5)).slide(X)
    body.stand("heel", (0.2, 0.0, -0.5), X, Z)
    body.stand("toe", (0.4, 0.0, -0.3), X, Z, on=(0.0, 0.0, -1.0))
    found = builder.finish().feet
    assert found == (PlaneContact("e.heel", "e.heel", Z, X, 3.0), PlaneContact("e.toe", "e.toe", Z, X, 2.5))


def test_forces_count_places_from_their_entity(builder: Builder) -> None:
    body = builder.room("e", (1.0, 0.0, 0.0)).body("b", 2.0, at=(5.0, 0.0, 0.0)).slide(X)
    body.force("c", Central((1.0, 0.0, 0.0), 3.0))
    body.force("p", Push(X, Profile(2.0, slope=1.0)), HalfSpace(X, 0.5))
    central, push = builder.finish().forces
    assert (central.name, central.body) == ("e.c", "e.b")
    assert central.law == Central((2.0, 0.0, 0.0), 3.0)
    assert push.law == Push(X, Profile(1.0, slope=1.0))
    assert push.region == HalfSpace(X, 1.5)


def test_bodies_meet_attract_and_burn(builder: Builder) -> None:
    room = builder.room("", (0.0, 0.0, 1.0))
    a, b = (room.body(name, 1.0, at=(x, 0.0, 1.0)).slide(X) for name, x in (("a", 0.0), ("b", 1.0)))
    room.collide(a, b, 0.2, 0.5, sticks=True)
    room.bump(room, b, (0.0, 0.0, 3.0), 0.1, 0.9)
    a.attract(b, 6.0)
    b.burn(0.1, 20.0, 3.0, (2.0, 0.0, 0.0))
    found = builder.finish()
    assert found.meetings[0] == CollisionPair("a", "b", 0.2, 0.5, None, True)
    assert found.meetings[1].names == ("b",)
    assert found.meetings[1].normal == Z
    assert found.attractions == (Attraction("a", "b", 6.0),)
    assert found.burns == (MassEjection("b", 0.1, 20.0, 3.0, X),)


def test_the_room_does_nothing_by_itself(builder: Builder) -> None:
    with pytest.raises(ValueError, match="the room itself"):
        builder.room().slide(X)
    with pytest.raises(ValueError, match="zero vector"):
        builder.room().body("b", 1.0).slide((0.0, 0.0, 0.0))
