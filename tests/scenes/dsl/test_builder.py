"""Tests of the builder of mechanisms: its methods, gluing, names and the splitting of strings."""

import pytest

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import ConstantTension, X, Z
from sim2reason.scenes.dsl.vectors import unit


def atwood(mass: float, glued: tuple[str, ...] = ()) -> Builder:
    """Return a builder of two blocks over a pulley with mass."""
    builder = Builder(glued=glued)
    room = builder.room("a")
    pulley = room.pulley("pulley", mass=mass)
    for name, x in (("left", -pulley.radius), ("right", pulley.radius)):
        room.body(name, 1.0, at=(x, 0.0, -1.0)).slide(Z).site(f"{name}_hook")
    room.string("rope", "a.left_hook", pulley, "a.right_hook")
    return builder


def test_a_light_pulley_leaves_a_string_whole() -> None:
    (string,) = atwood(0.0).finish().strings
    assert string.through == ("a.left_hook", "a.pulley.left", "a.pulley.right", "a.right_hook")
    assert string.wheels == ()


def test_a_massive_pulley_cuts_a_string_and_turns_with_both_parts() -> None:
    mechanism = atwood(2.0).finish()
    first, second = mechanism.strings
    assert (first.name, second.name, first.whole) == ("a.rope/1", "a.rope/2", "a.rope")
    assert first.wheels[0].radius == -second.wheels[0].radius > 0.0
    wheel = mechanism.body["a.pulley"]
    assert wheel.inertia[1] == pytest.approx(0.5 * 2.0 * 0.05**2)  # a uniform disc


def test_under_a_pulley_the_wheel_turns_the_other_way() -> None:
    """The radius of a wheel that hangs in a loop of string is negative."""
    builder = Builder()
    room = builder.room()
    pulley = room.body("carrier").slide(Z).pulley("pulley", mass=1.0, faces=Z)
    room.site("hook", at=(-0.05, 0.0, 1.0)).site("other", at=(0.05, 0.0, 1.0))
    room.string("rope", "hook", pulley, "other")
    assert builder.finish().strings[0].wheels[0].radius < 0.0


def test_gluing_is_honoured_for_bodies_and_wheels() -> None:
    mechanism = atwood(2.0, glued=("a.left", "a.pulley")).finish()
    assert [c.name for c in mechanism.coordinates] == ["a.right.slide"]
    assert [string.name for string in mechanism.strings] == ["a.rope"]


def test_a_body_that_rests_has_a_contact_and_stands_on_its_parent() -> None:
    builder = Builder()
    wedge = builder.room("w").body("wedge", 3.0, at=(1.0, 0.0, 0.0)).rest(X, Z)
    wedge.body("block", 1.0, at=(0.0, 0.0, 0.5)).rest(unit((1.0, 0.0, 1.0)), unit((-1.0, 0.0, 1.0)), 0.3).site("hook")
    mechanism = builder.finish()
    assert mechanism.body["w.block"].parent == "w.wedge"
    assert mechanism.contacts["w.block"].friction == 0.3
    assert builder.position("w.hook") == (1.0, 0.0, 0.5)
    assert builder.carrier("w.hook") == "w.block"


def test_a_hand_pulls_the_last_part_of_a_string() -> None:
    builder = Builder()
    room = builder.room()
    room.body("block", 1.0, at=(-0.05, 0.0, -1.0)).slide(Z).site("hook")
    room.hand("hand", 5.0)
    room.pull("rope", "hook", room.pulley("pulley", mass=1.0), "hand", force=5.0)
    mechanism = builder.finish()
    assert [string.name for string in mechanism.strings] == ["rope/1"]
    assert [(pull.name, pull.law) for pull in mechanism.pulls] == [("rope/2", ConstantTension(5.0))]


def test_mistakes_are_named() -> None:
    builder = atwood(0.0)
    room = builder.room("a")
    with pytest.raises(SceneError, match="two things have this name"):
        room.body("left", 1.0)
    with pytest.raises(ValueError, match="no site is called"):
        room.string("other", "a.left_hook", "a.nowhere")
    with pytest.raises(ValueError, match="two ends"):
        room.string("other", "a.left_hook")
    with pytest.raises(ValueError, match="zero vector"):
        room.body("stone", 1.0).slide((0.0, 0.0, 0.0))
    with pytest.raises(ValueError, match="neither moves nor collides"):
        room.slide(X)
