"""Tests of the dependence of an answer on the moment, against motions in closed form."""

import numpy as np
import pytest

from plain_scenes import arm, atwood, ramp, table
from sim2reason.questions import KINDS, Moment, SimulatedScene, Target
from sim2reason.questions.choices import depends_on_moment, is_constant
from sim2reason.questions.moments.contacts import Collided
from sim2reason.questions.moments.times import AllAlong, AtStart, AtTime
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import targets
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.text.prose.description import describe

LEFT, RIGHT = "table.pucks.0", "table.pucks.1"
BLOCK = "ramp.blocks.0"
TENSION = Target("tension", "tendon_1")


def study(scene: Scene) -> SimulatedScene:
    return SimulatedScene.of(scene, np.linspace(0.0, 2.0, 41))


def matters(scene: Scene, moment: Moment, target: Target) -> bool:
    seen = study(scene)
    time = seen.time(moment)
    assert time is not None
    return depends_on_moment(moment, seen.trace, time, lambda times: target.values(seen.trace.sample(times)))


def test_velocities_of_free_pucks_hang_on_which_collision_has_been_alone() -> None:
    """Between collisions no force acts, so that the last collision determines the velocity."""
    assert not matters(table(), AtTime(0.9), Target("velocity", LEFT))
    assert matters(table(), Collided(f"{LEFT} & {RIGHT}", after=True), Target("velocity", LEFT))
    assert matters(table(), AtTime(0.9), Target("displacement", RIGHT))


@pytest.mark.parametrize(("when", "hangs"), [(0.15, True), (0.9, False)])
def test_a_value_that_has_settled_may_be_asked_for_at_any_time(when: float, hangs: bool) -> None:
    """1 − e^(−t/τ) differs from its limit by more than 5 % only until 3τ."""
    trace = study(atwood()).trace
    assert depends_on_moment(AtTime(when), trace, when, lambda times: 1.0 - np.exp(-times / 0.04)) is hangs


def test_constant_forces_last() -> None:
    """In an Atwood machine a = g (M − m)/(M + m) and T = 2 M m g/(M + m) are constant."""
    trace = study(atwood()).trace
    assert is_constant(TENSION, trace)
    assert not is_constant(Target("velocity", "one.system.blocks.0"), trace)
    assert not matters(atwood(), AtTime(0.5), TENSION)
    assert matters(atwood(), AtTime(0.5), Target("velocity", "one.system.blocks.0"))


def test_what_rubs_and_did_not_begin_at_rest_may_stop() -> None:
    """A block decelerates up a slope at g (sin θ + μ cos θ), and accelerates down at g (sin θ − μ cos θ)."""
    assert is_constant(Target("net force", BLOCK), study(ramp(friction=0.2)).trace)
    assert not is_constant(Target("net force", BLOCK), study(ramp(friction=0.2, speed=2.0)).trace)
    before = SimulatedScene.of(ramp(angle=10.0, friction=0.2, speed=2.0), np.linspace(0.0, 0.3, 7))
    assert before.trace.events == ()
    assert not is_constant(Target("net force", BLOCK), before.trace), "0.55 s after the start it stops for good"


@pytest.mark.parametrize(("scene", "moment"), [(atwood(), AllAlong), (arm(), AtStart)])
def test_a_start_is_named_where_it_matters(scene: Scene, moment: type[Moment]) -> None:
    words, seen = words_of(describe(scene)), study(scene)
    drawn = (KINDS["start"].draw(seen, words, targets(words), np.random.default_rng(seed)) for seed in range(6))
    asked = [query for query in drawn if query is not None and query.target is not None]
    assert {type(query.moment) for query in asked if is_constant(query.target, seen.trace) == (moment is AllAlong)} == {
        moment
    }
