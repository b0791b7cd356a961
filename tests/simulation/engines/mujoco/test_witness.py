"""Tests of the MuJoCo engine against the exact one, and of its reasons for ending a motion."""

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import machines
from plain_scenes import drawn_shell
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Z
from sim2reason.scenes.dsl.structure import changing
from sim2reason.scenes.dsl.vectors import scale
from sim2reason.simulation.certify import compare
from sim2reason.simulation.engines.exact import simulate as exactly
from sim2reason.simulation.engines.mujoco import simulate

TIMES = np.linspace(0.0, 2.0, 101)
DISAGREE = ("engines disagree", "no witness")


def told(mechanism: Mechanism) -> list[tuple[str, tuple[str, ...]]]:
    return [(event.kind, event.subjects) for event in simulate(mechanism, TIMES).events]


@pytest.mark.parametrize("name", machines.SAMPLES)
def test_engines_agree_far_below_the_tolerance(name: str) -> None:
    mechanism = machines.SAMPLES[name]()
    recorded, witness = exactly(mechanism, TIMES), simulate(mechanism, TIMES)
    certificate = compare(recorded, witness)
    assert certificate.reason == recorded.cut
    assert certificate.stable_until == pytest.approx(recorded.stable_until, abs=1e-6)
    assert max(certificate.agreement.values()) <= 1e-7
    turns = [event for event in recorded.events if event.kind == "turn"]
    seen = [event for event in witness.events if event.kind == "turn"]
    assert [turn.subjects for turn in turns] == [turn.subjects for turn in seen]
    assert [turn.time for turn in turns] == pytest.approx([turn.time for turn in seen], abs=1e-7)


@settings(max_examples=150, derandomize=True)
@given(seed=st.integers(0, 10**6))
def test_engines_agree_on_random_trains(seed: int) -> None:
    """All samples agree up to the certified end."""
    mechanism = machines.train(np.random.default_rng(seed))
    try:
        recorded = exactly(mechanism, TIMES)
    except SimulationError:
        return
    certificate = compare(recorded, simulate(mechanism, TIMES))
    assert not any(text in certificate.reason for text in DISAGREE), certificate.reason
    assert max(certificate.agreement.values(), default=0.0) <= 1e-5


def test_a_string_keeps_its_direction_until_its_ends_meet() -> None:
    """An axle is pulled to a pulley; close to it, the ends' positions no longer give the string's direction."""
    mechanism = drawn_shell().mechanism
    recorded, witness = exactly(mechanism, TIMES), simulate(mechanism, TIMES)
    assert recorded.cut == witness.cut == "reach"
    end = np.array([0.0, witness.stable_until])
    forces, known = witness.sample(end), recorded.sample(end)
    assert forces.a[-1] == pytest.approx(known.a[-1], rel=1e-9)
    assert max(compare(recorded, witness).agreement.values()) <= 1e-9


def test_events_are_named_as_the_exact_engine_names_them() -> None:
    assert told(machines.tied_incline(2.0, 4.0)) == [("reach", ("hook", "edge"))]
    assert told(machines.stack(force=1.0, speed=2.0)) == [("stick", ("upper",)), ("stick", ("lower",))]
    limited = Builder()
    limited.room().body("block", 1.0).slide(Z, limits=(-0.5, 0.5))
    assert told(limited.finish()) == [("limit", ("block.slide",))]


def test_a_massless_body_that_nothing_holds_ends_the_motion() -> None:
    builder = Builder()
    builder.room().body("light").slide(Z)
    trace = simulate(builder.finish(), TIMES)
    assert [(event.time, event.kind, event.subjects) for event in trace.events] == [
        (0.0, "indeterminate", ("light.slide",))
    ]
    assert (trace.cut, trace.stable_until) == ("indeterminate", 0.0)


def test_forces_that_are_not_determined_are_nan() -> None:
    """A rough block is tied to a wall and pulled by a force less than the limit of friction."""
    builder = Builder()
    room = builder.room()
    room.site("wall", (-1.0, 0.0, 0.0)).site("hand", (1.0, 0.0, 0.0))
    room.body("block", 1.0).rest(X, Z, 0.5).site("hook")
    room.string("tie", "wall", "hook")
    room.pull("pull", "hook", "hand", force=2.0)
    state = simulate(builder.finish(), TIMES).state
    assert np.isnan(state.tension["tie"]).all()
    assert np.isnan(state.friction["block"]).all()
    assert state.normal["block"] == pytest.approx(9.8, rel=1e-9)
    assert state.tension["pull"] == pytest.approx(2.0)
    assert np.abs(state.q).max() <= 1e-6


def test_a_block_hit_twice_at_once_is_a_crowd() -> None:
    """A ball bounces between two converging walls, until collisions are too frequent."""
    builder = Builder(gravity=(0.0, 0.0, 0.0))
    room = builder.room()
    ball = room.body("ball", 1.0).slide(X, speed=1.0)
    wall = room.body("wall", 1e3, at=(0.101, 0.0, 0.0))
    heavy = room.body("heavy", 1e3, at=(-0.103, 0.0, 0.0)).slide(X, speed=0.5)
    room.collide(ball, wall, 0.1, 1.0)
    room.collide(ball, heavy, 0.1, 1.0)
    trace = simulate(builder.finish(), TIMES)
    assert trace.cut == "crowd"
    assert [event.kind for event in trace.events] == ["collision", "crowd"]
    assert trace.events[1].subjects == ("ball", "wall")


def test_a_mechanism_that_can_not_start_is_refused() -> None:
    builder = Builder()
    room = builder.room()
    a, b = room.body("a", 1.0).slide(X), room.body("b", 1.0, at=(0.1, 0.0, 0.0)).slide(X)
    room.collide(a, b, 0.5, 1.0)
    with pytest.raises(SceneError, match="overlaps"):
        simulate(builder.finish(), TIMES)
    builder = Builder()
    room = builder.room()
    room.site("nail").body("a", 1.0).slide(X).site("hook")
    room.string("s", "nail", "hook")
    with pytest.raises(SceneError, match="coincide"):
        simulate(builder.finish(), TIMES)


def test_what_the_library_refuses_or_warns_of_is_an_error() -> None:
    mechanism = machines.incline()
    wild = replace(mechanism, bodies=(replace(mechanism.bodies[0], mass=float("inf")),))
    with pytest.raises(SimulationError, match="MuJoCo"):
        simulate(wild, TIMES)


def test_any_name_is_a_name() -> None:
    builder = Builder()
    builder.room().body('a" mass="9', 1.0).slide(Z)
    assert simulate(builder.finish(), TIMES).state.a[0, 0] == pytest.approx(-9.8)


def test_samples_do_not_depend_on_each_other() -> None:
    mechanism = machines.carts()
    many, few = simulate(mechanism, TIMES), simulate(mechanism, np.array([0.0, 0.4, 2.0]))
    assert few.state.q[1] == pytest.approx(many.sample(np.array([0.4])).q[0], abs=1e-12)
    assert simulate(mechanism, TIMES).state.q.tobytes() == many.state.q.tobytes()


def test_the_library_is_loaded_only_when_something_is_simulated() -> None:
    code = "import sys; from sim2reason.simulation.trace import ENGINES; ENGINES['exact']"
    code += "; sys.exit('mujoco' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_structure_with_too_many_supports_stays_put() -> None:
    """Three rough blocks on a slope are tied to each other and to its top; they must not creep."""
    builder = Builder()
    room = builder.room()
    uphill, out = machines.face(25.0)
    room.site("nail")
    hooks = ["nail"]
    for number, mass in enumerate((2.0, 12.0, 5.0), start=1):
        block = room.body(f"block{number}", mass, at=scale(-float(number), uphill))
        block.rest(uphill, out, 0.6).site(f"hook{number}")
        room.string(f"link{number}", hooks[-1], f"hook{number}")
        hooks.append(f"hook{number}")
    trace = simulate(builder.finish(), np.linspace(0.0, 20.0, 21))
    assert trace.events == ()
    assert np.abs(trace.state.q).max() <= 1e-9
    assert all(np.isnan(values).all() for values in trace.state.friction.values())


@pytest.mark.parametrize("difficulty", DIFFICULTIES)
@pytest.mark.parametrize("recipe", sorted(RECIPES))
def test_engines_agree_on_scenes_of_every_recipe(recipe: str, difficulty: Difficulty) -> None:
    for seed in range(3):
        try:
            scene = RECIPES[recipe](difficulty, np.random.default_rng(seed))
            mechanism, times = scene.mechanism, np.linspace(0.0, min(TIMES[-1], scene.horizon), len(TIMES))
            recorded = exactly(mechanism, times)
        except (SceneError, SimulationError, UnsupportedError):
            continue
        certificate = compare(recorded, simulate(mechanism, times))
        assert not any(text in certificate.reason for text in DISAGREE), (seed, certificate.reason)
        close = 1e-4 if changing(mechanism, initial_frames(mechanism)) else 1e-6
        assert max(certificate.agreement.values(), default=0.0) <= close
