"""Tests that both engines agree on the contacts that separate and the strings that stay taut without tension."""

from math import cos, radians, sin

import numpy as np
import pytest

import machines
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Z
from sim2reason.simulation.engines.exact import simulate as exactly
from sim2reason.simulation.engines.mujoco import simulate as witnessed
from sim2reason.simulation.trace import Engine

G = 9.8
TIMES = np.linspace(0.0, 1.0, 51)
ENGINES = pytest.mark.parametrize("engine", [exactly, witnessed])


def told(engine: Engine, mechanism: Mechanism, kinds: tuple[str, ...] = ("lift",)) -> list[tuple[str, ...]]:
    return [event.subjects for event in engine(mechanism, TIMES).events if event.kind in kinds]


def drawn_wedges(count: int, force: float) -> Mechanism:
    """Build tied smooth wedges of 2 kg, each with a block of 1 kg on its 40° face, pulled by one force."""
    uphill, out = machines.face(40.0)
    builder = Builder()
    room = builder.room()
    for number in range(count):
        wedge = room.body(f"wedge{number}", 2.0, at=(3.0 * number, 0.0, 0.0)).rest(X, Z)
        wedge.site(f"back{number}").site(f"front{number}")
        wedge.body(f"block{number}", 1.0).rest(uphill, out)
        if number:
            room.string(f"link{number}", f"front{number - 1}", f"back{number}")
    room.site("hand", (90.0, 0.0, 0.0))
    room.pull("pull", f"front{count - 1}", "hand", force=force)
    return builder.finish()


@ENGINES
def test_a_block_lifts_off_a_wedge_that_stays_on_the_floor(engine: Engine) -> None:
    """Without its block the wedge has F/M, and its face separates from the falling block by F/M sin θ − g cos θ.

    With F = 2 kg · 500 m/s² that is 314 m/s² > 0, so the block is off; the floor carries Mg = 20 N > 0, so the wedge
    is not. A block fixed to the face would give N₁ = Mg + N₂ cos θ < 0, although the wedge does not lift.
    """
    assert 500.0 * sin(radians(40.0)) - G * cos(radians(40.0)) > 0.0
    assert told(engine, drawn_wedges(1, 1000.0)) == [("block0",)]


@ENGINES
def test_all_that_lift_are_named_in_order(engine: Engine) -> None:
    """Two tied wedges have F/2M each, and both blocks lift as above."""
    assert told(engine, drawn_wedges(2, 2000.0)) == [("block0",), ("block1",)]


@ENGINES
def test_a_jerk_lifts_the_block_and_not_the_cart(engine: Engine) -> None:
    """A wedge of M = 2 kg at rest is jerked to u by a body of m = 3 kg at 4 m/s on a string.

    Without its block u = 3·4/(3 + 2) = 2.4 m/s, and the face has left the block, still at rest, with u sin θ > 0;
    the impulse of the floor is 0, as nothing moves up or down. So block off, N = 0, z = 0: complementary.
    """
    uphill, out = machines.face(35.0)
    builder = Builder()
    room = builder.room()
    wedge = room.body("wedge", 2.0).rest(X, Z).site("hook")
    wedge.body("block", 1.0).rest(uphill, out, 0.9)
    room.body("runner", 3.0, at=(2.0, 0.0, 0.0)).rest(X, Z, speed=4.0).site("tail")
    room.string("link", "hook", "tail", slack=0.2)
    assert told(engine, builder.finish(), ("taut", "lift")) == [("link",), ("block",)]


@ENGINES
def test_a_tray_struck_from_below_carries_its_load_up(engine: Engine) -> None:
    """The tray leaves the table, and the load stays pressed on the tray."""
    builder = Builder()
    room = builder.room()
    tray = room.body("tray", 1.0).rest(X, Z)
    tray.body("load", 2.0, at=(0.0, 0.0, 0.1)).rest(X, Z, 0.3)
    room.collide(room.body("ball", 1.0, at=(0.0, 0.0, -1.0)).slide(Z, 6.0), tray, 0.2, 0.5)
    assert told(engine, builder.finish()) == [("tray",)]


@ENGINES
def test_a_string_under_no_tension_is_taut_while_its_ends_keep_their_distance(engine: Engine) -> None:
    """A rough cart jerks two smooth tied carts and is then braked, f = µmg, while they keep their speed.

    So the first link is slack right after its jerk, and the tension of the second is 0 = m·0; but its ends
    never approach each other: it has not gone slack.
    """
    builder = Builder()
    room = builder.room()
    for number, (mass, friction, speed) in enumerate(((7.0, 0.3, -2.0), (2.0, 0.0, 0.0), (5.0, 0.0, 0.0))):
        cart = room.body(f"cart{number}", mass, at=(2.0 * number, 0.0, 0.0)).rest(X, Z, friction, speed=speed)
        cart.site(f"back{number}").site(f"front{number}")
        if number:
            room.string(f"link{number}", f"front{number - 1}", f"back{number}", slack=0.2 if number == 1 else 0.0)
    mechanism = builder.finish()
    assert [e.subjects for e in engine(mechanism, TIMES[:20]).events if e.kind in ("taut", "slack")][:1] == [("link1",)]
    assert ("link2",) not in told(engine, mechanism, ("slack", "taut"))


@ENGINES
def test_a_massless_part_that_is_drawn_and_held_by_nothing(engine: Engine) -> None:
    """The equation F = 0·a has no solution, whatever the friction."""
    builder = Builder()
    room = builder.room()
    room.body("ring").slide(X).site("eye")
    room.site("hand", (5.0, 0.0, 0.0)).pull("pull", "eye", "hand", force=3.0)
    trace = engine(builder.finish(), TIMES)
    assert [(event.kind, event.subjects) for event in trace.events] == [("indeterminate", ("ring.slide",))]
    assert (trace.cut, trace.stable_until) == ("indeterminate", 0.0)
