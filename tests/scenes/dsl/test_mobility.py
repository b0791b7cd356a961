"""Tests of the search for bodies of a mechanism that cannot move."""

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import X, Z
from sim2reason.scenes.dsl.structure import is_weightless, stuck_bodies


def _hanging(mass: float = 1.0) -> Builder:
    """Return a builder of a load that hangs by a string from the axle of a movable pulley."""
    builder = Builder()
    room = builder.room().site("hook", (0.0, 0.0, 2.0))
    carrier = room.body("carrier").slide(Z).site("axle")
    load = room.body("load", mass, at=(0.0, 0.0, -1.0)).slide(Z).site("eye")
    room.string("cord", "axle", "eye")
    assert (carrier.own_name, load.own_name) == ("carrier", "load")
    return builder


def test_a_body_tied_to_a_hook_is_stuck_along_the_string_alone() -> None:
    builder = _hanging()
    assert stuck_bodies(builder.finish()) == ()
    builder.room().string("s", "hook", "axle")
    assert stuck_bodies(builder.finish()) == ("carrier", "load")


def test_a_body_that_can_swing_is_not_stuck() -> None:
    builder = Builder()
    room = builder.room().site("hook", (0.0, 0.0, 1.0))
    room.body("bob", 1.0).slide(X, name="across").slide(Z, name="rise").site("eye")
    room.string("s", "hook", "eye")
    assert stuck_bodies(builder.finish()) == ()


def test_what_a_moving_body_carries_moves() -> None:
    """A wedge that is free to slide carries a block whose string would keep it still."""
    builder = Builder()
    wedge = builder.room().body("wedge", 1.0).rest(X, Z)
    wedge.body("block", 1.0, at=(0.0, 0.0, 1.0)).slide(Z, name="rise").site("eye")
    wedge.site("hook", (0.0, 0.0, 2.0))
    builder.room().string("s", "hook", "eye")
    assert stuck_bodies(builder.finish()) == ()


def test_a_light_pulley_that_carries_nothing_moves_for_nothing() -> None:
    assert not is_weightless(_hanging().finish())
    assert is_weightless(_hanging(mass=0.0).finish())
    builder = Builder()
    builder.room().body("carrier").slide(Z)
    assert is_weightless(builder.finish())


def test_a_wheel_has_inertia() -> None:
    builder = Builder()
    builder.room().pulley("wheel", mass=2.0)
    assert not is_weightless(builder.finish())
