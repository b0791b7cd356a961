"""Tests that both engines agree on jerks and collisions in quick succession or against strong friction."""

import numpy as np
import pytest

import machines
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Z
from sim2reason.simulation.certify import certify
from sim2reason.simulation.engines.exact import simulate as exactly
from sim2reason.simulation.engines.mujoco import simulate as witnessed
from sim2reason.simulation.trace import Engine

TIMES = np.linspace(0.0, 0.05, 51)
ENGINES = pytest.mark.parametrize("engine", [exactly, witnessed])


def knocked(delay: float) -> Mechanism:
    """Build a tied cart of 1 kg, pulled by 400 N, jerked at √(2·0.02/400) = 10 ms and struck `delay` later.

    The striker, 0.5 kg at −1.2 m/s and e = 1, gives it 2·0.5/1.5·(−1.2) = −0.8 m/s and rebounds at 0.4 m/s. So the
    string is taut again 2·0.8/400 = 4 ms later.
    """
    builder = Builder()
    room = builder.room()
    cart = room.body("cart", 1.0).rest(X, Z).site("tail").site("ring")
    room.site("nail", (-1.0, 0.0, 0.0)).site("hand", (9.0, 0.0, 0.0))
    room.string("tie", "nail", "tail", slack=0.02)
    room.pull("pull", "ring", "hand", force=400.0)
    start = 0.02 + 0.2 + 1.2 * (0.01 + delay)
    room.collide(cart, room.body("striker", 0.5, at=(start, 0.0, 0.0)).rest(X, Z, speed=-1.2), 0.2, 1.0)
    return builder.finish()


@ENGINES
def test_a_jerk_within_five_milliseconds_of_the_last_ends_the_motion_there(engine: Engine) -> None:
    trace = engine(knocked(0.5e-3), TIMES)
    assert [(event.kind, event.subjects) for event in trace.events] == [("taut", ("tie",)), ("crowd", ("tie",))]
    assert (trace.cut, trace.stable_until) == ("crowd", pytest.approx(0.01, abs=1e-9))


@ENGINES
def test_a_later_jerk_is_one_of_two(engine: Engine) -> None:
    trace = engine(knocked(2e-3), TIMES)
    told = [(event.kind, event.subjects) for event in trace.events if event.kind != "turn"]
    tie = ("tie",)
    assert told == [("taut", tie), ("collision", ("cart", "striker")), ("slack", tie), ("taut", tie)]
    assert [event.time for event in trace.events if event.kind == "taut"] == pytest.approx([0.01, 0.016], abs=1e-8)
    assert trace.cut == ""


def test_two_strings_that_jerk_by_turns_without_end() -> None:
    """A jerk of one string slackens the other, which gravity soon straightens, ever smaller and sooner.

    The jerks accumulate at an instant that neither engine can pass, as they get as small as rounding errors. Both
    end at the jerk before the first that follows within 5 ms.
    """
    mechanism = machines.train(np.random.default_rng(666))
    trace, certificate = certify(mechanism, np.linspace(0.0, 2.0, 201))
    assert (trace.cut, certificate.reason) == ("crowd", "crowd")
    last = [event.time for event in trace.events if event.kind == "taut"]
    assert trace.stable_until == last[-1] < 0.2700
    assert max(certificate.agreement.values()) <= 1e-7


@ENGINES
def test_carts_that_meet_part_whatever_friction_could_hold(engine: Engine) -> None:
    """Two rough carts that collide at u, the first with a slope and cargo, separate at −e·u.

    Both at rest is no solution, as 0 is not −e·u, although there are friction impulses that would hold both.
    """
    mechanism = machines.train(np.random.default_rng(13098))
    trace = engine(mechanism, np.linspace(0.0, 0.2, 21))
    (hit,) = (event.time for event in trace.events if event.kind == "collision")
    before, after = (trace.sample(np.array([hit + shift])).v[0] for shift in (-1e-7, 1e-7))
    (pair,) = mechanism.meetings
    names = [coordinate.name for coordinate in mechanism.coordinates]
    a, b = names.index("cart0.slide"), names.index("cart1.slide")
    assert after[b] - after[a] == pytest.approx(-pair.restitution * (before[b] - before[a]), abs=1e-5)
    assert after[a] < -1.0 < 1.0 < after[b]
