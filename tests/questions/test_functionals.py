"""Tests of extremes, sums and counts in all kinds of motion, by textbook formulas and both engines."""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from math import acos, atan, ceil, cos, cosh, degrees, exp, floor, pi, radians, sin, sinh, sqrt
from pathlib import Path

import numpy as np
import pytest

import motions
from plain_scenes import atwood, ramp, squeezed, swing, table
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import KINDS, MODES, Moment, Question, SimulatedScene, Words
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.paths import AreaSwept
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.angles import Orbited
from sim2reason.questions.moments.bounces import Bounced
from sim2reason.questions.moments.contacts import Collided, LastCollision, StoppedSlipping
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.strings import WentTaut
from sim2reason.questions.moments.times import AtTime, WholeMotion
from sim2reason.questions.moments.turning_points import Halted, Stopped
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.prompt import parse_prompt, words_of
from sim2reason.questions.recurrence import first_return
from sim2reason.questions.sentences import parse_question
from sim2reason.scenes.bodies.space import HeavyPlanet, Star
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.fields import Resistance
from sim2reason.scenes.dsl.mechanism import ZERO, X, Z
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.space import SolarSystem
from sim2reason.scenes.files import load
from sim2reason.simulation.certify import certify
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.quantities.subjects.bodies import WHOLE_SCENE
from sim2reason.simulation.quantities.subjects.interactions import Pairs, members
from sim2reason.text.prose.description import describe

G = 9.8
RISE, AHEAD = 5.0 * sin(radians(40.0)), 5.0 * cos(radians(40.0))
FALL = sqrt(RISE**2 + 2.0 * G)  # the speed downwards at the ground of the ball that is thrown
RATE = sqrt(20.0 / 0.5)  # of the block on a spring
SPEED = sqrt(2.0 * G * 0.8 * 0.5)  # at the lowest point of what is let go from 60° on 0.8 m
TABLE = "table.pucks.0 & table.pucks.1"
SKY = "sky.planet & sky.star"
SLOPE, ROUGH = radians(30.0), 0.2  # of a ramp

Made = Callable[[], tuple[SimulatedScene, Words]]


def told(scene: Scene) -> Made:
    """Return a function that simulates a scene, and returns its words too."""
    return lambda: (simulate_scene(scene).study, words_of(describe(scene)))


def stored(name: str, until: float) -> Made:
    """Return a function that simulates a stored scene up to a time, s, and returns its words too."""
    scene = load(Path(__file__).parents[1] / "data" / "ordinary_scenes" / f"{name}.yaml")
    return lambda: (simulate_scene(scene, until).study, words_of(describe(scene)))


def dashpot() -> motions.Motion:
    """Build `spring_block` with a dashpot of 2 N s/m beside the spring."""
    builder = Builder()
    room = builder.room("bench")
    room.site("wall", at=(-0.8, 0.0, 0.0))
    room.body("block", 0.5).rest(X, Z).site("hook")
    room.spring("spring", "bench.wall", "bench.hook", stiffness=20.0, length=0.6, damping=2.0)
    return motions.Motion(builder.finish(), {"bench.block": "the block", "bench.spring": "the spring"}, 2.0)


def kicked(speed: float = 1.5) -> motions.Motion:
    """Build `spring_block` with a relaxed spring and an initial velocity."""
    builder = Builder()
    room = builder.room("bench")
    room.site("wall", at=(-0.6, 0.0, 0.0))
    room.body("block", 0.5).rest(X, Z, speed=speed).site("hook")
    room.spring("spring", "bench.wall", "bench.hook", stiffness=20.0, length=0.6)
    return motions.Motion(builder.finish(), {"bench.block": "the block", "bench.spring": "the spring"}, 2.0)


def dragged(linear: float = 0.3) -> motions.Motion:
    """Build a bead of 0.1 kg at 2 m/s in a medium."""
    builder = Builder(gravity=ZERO)
    bead = builder.room("lab").body("bead", 0.1).slide(X, 2.0, name="x").slide(Z, name="y")
    bead.force("medium", Resistance(linear=linear))
    return motions.Motion(builder.finish(), {"lab.bead": "the bead"}, 1.5)


def towed() -> motions.Motion:
    """Build a block of 1 kg at 3 m/s on a smooth floor, on a slack string to one of 2 kg at rest."""
    builder = Builder()
    room = builder.room("floor")
    room.body("a", 2.0).rest(X, Z).site("a.hook")
    room.body("b", 1.0, at=(0.5, 0.0, 0.0)).rest(X, Z, speed=3.0).site("b.hook")
    room.string("rope", "floor.a.hook", "floor.b.hook", slack=0.6)
    mentions = {"floor.a": "block A", "floor.b": "block B"}
    return motions.Motion(builder.finish(), mentions, 1.0)


def passing() -> motions.Motion:
    """Build a planet at the end of the minor axis of its ellipse, a = 1 and e = 0.5, before both apsides."""
    builder = Builder(gravity=ZERO)
    room = builder.room("sky")
    star = room.body("star", 1.0, at=(0.5, 0.0, 0.0))
    planet = room.body("planet", 1e-3, at=(0.0, 0.0, sqrt(0.75))).slide(X, -2.0 * pi, name="x").slide(Z, name="y")
    planet.attract(star, 4.0 * pi**2)  # at the end of the minor axis r = a and v² = GM/a
    return motions.Motion(builder.finish(), {"sky.star": "the star", "sky.planet": "the planet"}, 1.2)


def cradle(angle: float = 50.0, speed: float = 0.0) -> motions.Motion:
    """Build a block of 0.4 kg that slides in a smooth round bowl of 1 m, from an angle beside its lowest point."""
    builder = Builder()
    away = radians(angle)
    place = (sin(away), 0.0, -cos(away))
    block = builder.room("hill").body("block", 0.4, center=place)
    block.swing((0.0, 1.0, 0.0), tuple(-part for part in place), 1.0, speed=speed, guided=False)
    return motions.Motion(builder.finish(), {"hill.block": "the block", "hill.surface": "the bowl"}, 3.0)


def overturned(speed: float) -> motions.Motion:
    """Build a bob of 0.5 kg on a light rod of 1 m that leaves its lowest point with a speed, m/s."""
    builder = Builder()
    rod = builder.room("swing").body("hanger").hinge((0.0, 1.0, 0.0), speed)
    rod.body("bob", 0.5, at=(0.0, 0.0, -1.0))
    return motions.Motion(builder.finish(), {"swing.bob": "the bob", "swing.hanger": "the rod"}, 2.0)


def damped_energy(time: float) -> float:
    """Return the energy of `dashpot`: x = A e^{−γt}(cos wt + (γ/w) sin wt), γ = b/2m, w² = k/m − γ²."""
    gamma = 2.0 / (2.0 * 0.5)
    w = sqrt(20.0 / 0.5 - gamma**2)
    x = 0.2 * exp(-gamma * time) * (cos(w * time) + gamma / w * sin(w * time))
    v = -0.2 * exp(-gamma * time) * (gamma**2 + w**2) / w * sin(w * time)
    return 0.5 * 20.0 * x**2 + 0.5 * 0.5 * v**2


def harmonic_path(time: float) -> float:
    """Return the path of `spring_block`: 2A per half period, and A(1 − cos φ) in the current one."""
    halves = floor(RATE * time / pi)
    return 0.2 * (2 * halves + 1.0 - cos(RATE * time - pi * halves))


def driven(time: float) -> float:
    """Return the position of `driven_charge`: ẍ = 10 + 20 x from x = 0 at 0.5 m/s."""
    rate = sqrt(20.0)
    return 0.5 * (cosh(rate * time) - 1.0) + 0.5 / rate * sinh(rate * time)


def mean(a: float, b: float) -> float:
    """Return the arithmetic-geometric mean; a pendulum released at θ₀ has the period 2π/ω/M(1, cos(θ₀/2))."""
    while a - b > 1e-16:
        a, b = 0.5 * (a + b), sqrt(a * b)
    return a


ROUND = 2.0 * pi / sqrt(1.5 * G / 1.2) / mean(1.0, cos(radians(30.0)))  # of the rod that is let go from 60°


@dataclass(frozen=True)
class Case:
    """Functional of a subject up to a moment of a motion, with its value by a formula."""

    made: Made
    name: str
    subject: str
    moment: Moment
    expected: float

    @property
    def query(self) -> StretchQuery:
        """Return the query for the functional."""
        return StretchQuery(FUNCTIONALS[self.name].kind, None, self.moment, self.name, self.subject)


DOWN = G * (sin(SLOPE) - ROUGH * cos(SLOPE))  # of a block that slides down the ramp
UP = G * (sin(SLOPE) + ROUGH * cos(SLOPE))
PULL = 2.0 * 3.0 * 2.0 / 5.0 * G  # the tension of Atwood's machine
FREE = motions.light_rod().told
X4 = driven(0.4)
LANDS = Bounced("field.ball", after=False)
OVER = 3.0 - 2.0 * cos(radians(50.0))  # mg(3 − 2 cos θ₀) in the bowl
CIRCLE = 4.4 * 2.9 / (2.3 * 0.55)  # m: the radius of the circle of a bead that leaves the origin
SWUNG = 6.8 * G * (1.0 + 2.0 * 0.24**2 / (0.4 * 0.18**2 + 0.24**2))  # mg + mω²d, a sphere on an arm from level
EXTREMES: Sequence[Case] = (
    Case(FREE, "greatest speed", "swing.bob", WholeMotion(), SPEED),
    Case(FREE, "greatest angular speed", "swing.hanger", Stopped("swing.bob"), SPEED / 0.8),
    Case(FREE, "greatest rod force", "swing.hanger", WholeMotion(), 0.5 * G * 2.0),  # mg(3 − 2 cos θ₀)
    Case(stored("swung_sphere", 2.0), "greatest axle force", "arm.arm", WholeMotion(), SWUNG),
    Case(FREE, "greatest kinetic energy", "swing.bob", WholeMotion(), 0.25 * SPEED**2),
    Case(told(swing()), "greatest tension", "swing.hanger", WholeMotion(), 0.5 * G * 2.0),
    Case(told(swing()), "greatest speed", "swing.bob", Stopped("swing.bob"), SPEED),
    Case(kicked().told, "greatest extension", "bench.spring", WholeMotion(), 1.5 * sqrt(0.5 / 20.0)),  # v√(m/k)
    Case(kicked().told, "greatest compression", "bench.spring", WholeMotion(), 1.5 * sqrt(0.5 / 20.0)),
    Case(kicked().told, "greatest spring energy", "bench.spring", WholeMotion(), 0.25 * 1.5**2),
    Case(kicked().told, "greatest spring force", "bench.spring", WholeMotion(), 1.5 * sqrt(0.5 * 20.0)),
    Case(motions.spring_block().told, "amplitude", "bench.block", WholeMotion(), 0.2),
    Case(kicked().told, "greatest acceleration", "bench.block", WholeMotion(), 1.5 * RATE),
    Case(motions.spring_block().told, "greatest displacement", "bench.block", WholeMotion(), 0.4),
    Case(
        motions.thrown_ball().told, "greatest height", "field.ball", Bounced("field.ball", after=False), RISE**2 / 2 / G
    ),
    Case(motions.thrown_ball().told, "least speed", "field.ball", LANDS, AHEAD),
    Case(passing().told, "greatest distance", SKY, WholeMotion(), 1.5),
    Case(passing().told, "least distance", SKY, WholeMotion(), 0.5),
    Case(passing().told, "least speed", "sky.planet", WholeMotion(), 2.0 * pi * sqrt(0.5 / 1.5)),  # v² = GM(2/r − 1/a)
    Case(cradle().told, "greatest normal force", "hill.block", WholeMotion(), 0.4 * G * OVER),
    Case(lambda: cradle(0.0, 2.0).told(), "least normal force", "hill.block", WholeMotion(), 0.4 * (G - 0.5 * 2.0**2)),
    Case(motions.string_pendulum(6.0).told, "least tension", "swing.hanger", WholeMotion(), 0.5 * G),  # mg(k − 5)
    Case(
        stored("origin_circle", 21.8),
        "greatest x coordinate",
        "fields.particle",
        AtTime(21.0),
        CIRCLE * (sin(radians(199.0)) + 1.0),
    ),
    Case(
        stored("origin_circle", 21.8),
        "least x coordinate",
        "fields.particle",
        AtTime(21.0),
        CIRCLE * (sin(radians(199.0)) - 1.0),
    ),
    Case(
        stored("origin_circle", 21.8),
        "greatest y coordinate",
        "fields.particle",
        AtTime(21.0),
        CIRCLE * (1.0 - cos(radians(199.0))),
    ),
    Case(
        stored("origin_circle", 21.8),
        "least y coordinate",
        "fields.particle",
        AtTime(21.0),
        -CIRCLE * (1.0 + cos(radians(199.0))),
    ),
    Case(
        stored("origin_circle", 21.8),
        "greatest distance from the origin",
        "fields.particle",
        AtTime(21.0),
        2.0 * CIRCLE,
    ),
    Case(
        stored("origin_circle", 21.8),
        "greatest distance from the x axis",
        "fields.particle",
        AtTime(21.0),
        CIRCLE * (1.0 - cos(radians(199.0))),
    ),
    Case(
        stored("origin_circle", 21.8),
        "greatest distance from the y axis",
        "fields.particle",
        AtTime(21.0),
        CIRCLE * (1.0 - sin(radians(199.0))),
    ),
    Case(stored("dull_carts", 0.5), "least distance from the origin", "track.gliders.0", AtTime(0.1), 1.44 - 0.118),
    Case(
        stored("arm_on_pulled_trolley", 0.75),
        "least deflection",
        "rigid_pendulum.arm",
        AtTime(0.7),
        2.0 * degrees(atan(66.0 / (9.0 * G))) - 50.0,  # as far beyond the equilibrium under a steady acceleration
    ),
    Case(
        stored("far_swung_trolley", 2.0),
        "greatest rod pull",
        "light_rod_pendulum.bob",
        AtTime(1.0),
        1.6 * G * (1.0 + 2.0 * (1.0 - cos(radians(68.0))) * (1.0 + 1.6 / 1.5)),  # at the bottom, m(g + w²/ℓ)
    ),
    Case(
        stored("nudged_rod", 3.0),
        "greatest angular acceleration",
        "pendulum.hanger",
        AtTime(1.0),
        G / 2.0 * sin(acos(1.0 - 1.1**2 / (4.0 * G))),
    ),
    Case(motions.string_pendulum(1.5).told, "greatest deflection", "swing.hanger", WholeMotion(), degrees(acos(0.25))),
)
SUMS: Sequence[Case] = (
    Case(
        told(ramp(friction=ROUGH)),
        "energy dissipated by friction",
        "ramp.blocks.0",
        Moved("ramp.blocks.0", 0.9),
        ROUGH * 2.0 * G * cos(SLOPE) * 0.9,
    ),
    Case(  # of ½mv² a ball that begins to roll keeps 5/7
        motions.rolling_ball().told,
        "energy dissipated by friction",
        "lane.ball",
        StoppedSlipping("lane.ball"),
        2.0 / 7.0 * 0.5 * 2.0 * 9.0,
    ),
    Case(  # ½µu² with the reduced mass 0.75 kg
        motions.slab().told,
        "energy dissipated by friction",
        "bench.block",
        StoppedSlipping("bench.block"),
        0.5 * 0.75 * 4.0,
    ),
    Case(  # up v²/2a, and down again
        told(ramp(friction=ROUGH, speed=2.0)),
        "distance travelled",
        "ramp.blocks.0",
        AtTime(1.2),
        4.0 / (2.0 * UP) + 0.5 * DOWN * (1.2 - 2.0 / UP) ** 2,
    ),
    Case(motions.rubbed_spring().told, "distance travelled", "bench.block", Halted("bench.block"), 0.816),
    Case(  # ½k(A² − a²), of what is left
        motions.rubbed_spring().told,
        "energy dissipated by friction",
        "bench.block",
        Halted("bench.block"),
        10.0 * (0.2**2 - 0.004**2),
    ),
    Case(motions.spring_block().told, "distance travelled", "bench.block", AtTime(1.7), harmonic_path(1.7)),
    Case(dashpot().told, "energy dissipated by a dashpot", "bench.spring", AtTime(0.6), 0.4 - damped_energy(0.6)),
    Case(dragged().told, "energy lost to drag", "lab.bead", AtTime(0.4), 0.2 * (1.0 - exp(-2.0 * 0.3 * 0.4 / 0.1))),
    Case(told(table()), "impulse of a collision", TABLE, Collided(TABLE), 2.0 / 3.0 * 1.5 * 2.0),  # µ(1 + e)u
    Case(told(table()), "energy lost in a collision", TABLE, Collided(TABLE), 0.5 * 2.0 / 3.0 * 0.75 * 4.0),
    Case(  # ½µ(1 − e²)u²
        motions.thrown_ball().told,
        "impulse of an impact",
        "field.ball",
        Bounced("field.ball"),
        0.2 * 1.8 * FALL,  # m(1 + e)v
    ),
    Case(
        motions.thrown_ball().told,
        "total impulse of impacts",
        "field.ball",
        Bounced("field.ball", 2),
        0.2 * 1.8 * FALL * 1.8,
    ),
    Case(
        motions.thrown_ball().told,
        "energy lost in collisions",
        WHOLE_SCENE,
        Bounced("field.ball", 2),
        0.1 * FALL**2 * (1.0 - 0.8**4),
    ),
    Case(
        motions.thrown_ball().told,
        "impulse of the net force",
        "field.ball",
        Bounced("field.ball"),
        0.2 * (0.8 * FALL - RISE),
    ),
    Case(motions.two_strings().told, "work of a hand", "crane.pull", AtTime(0.9), 30.0 * 0.5 * (10.0 - G) * 0.81),
    Case(told(atwood()), "impulse of a tension", "tendon_1", AtTime(0.7), PULL * 0.7),
    Case(told(atwood()), "work of a tension", "other.system.blocks.0", AtTime(0.7), PULL * 0.5 * G / 5.0 * 0.49),
    Case(towed().told, "energy lost in a jerk", "floor.rope", WentTaut("floor.rope"), 0.5 * 2.0 / 3.0 * 9.0),  # ½µu²
    Case(
        motions.driven_charge().told,
        "work of an electric field",
        "lab.charge",
        AtTime(0.4),
        driven(0.4) + driven(0.4) ** 2,
    ),
    Case(motions.orbit().told, "area swept", SKY, Orbited(SKY, 180), pi * sqrt(0.75) / 2.0),
    Case(
        lambda: overturned(2.0).told(),
        "total angle",
        "swing.hanger",
        Stopped("swing.bob"),
        degrees(acos(1.0 - 2.0 / G)),
    ),
)
COUNTS: Sequence[Case] = (
    Case(told(squeezed()), "number of collisions", WHOLE_SCENE, LastCollision(), ceil(pi / atan(0.5)) - 1),
    Case(motions.thrown_ball().told, "number of bounces", "field.ball", AtTime(2.4), 2),
    Case(motions.spring_block().told, "number of reversals", "bench.block", AtTime(1.8), floor(1.8 * RATE / pi)),
)
CASES = (*EXTREMES, *SUMS, *COUNTS)
EVERY = pytest.mark.parametrize("case", CASES, ids=[f"{case.name}, {case.subject or 'all'}" for case in CASES])


@cache
def known(case: Case) -> tuple[SimulatedScene, Words]:
    return case.made()


@EVERY
def test_it_is_what_the_formula_says(case: Case) -> None:
    study, _ = known(case)
    assert KINDS[case.query.kind].answer(case.query, study) == pytest.approx(case.expected, rel=1e-8)


def test_every_functional_is_tried() -> None:
    assert {case.name for case in CASES} == set(FUNCTIONALS)


@EVERY
def test_both_engines_vouch_for_it_and_for_nothing_that_they_part_on(case: Case) -> None:
    study, _ = known(case)
    certificate = certify(study.mechanism, study.trace.state.times)[1]
    question = Question("numeric", case.query, "?", case.expected, FUNCTIONALS[case.name].unit)
    found = Candidate(study, question, "", certificate=certificate)
    reason = FILTERS["agreement"].reason
    assert not reason(found)
    assert reason(replace(found, certificate=None))
    for channel in FUNCTIONALS[case.name].channels(study.mechanism, case.subject):
        parted = replace(certificate, until={**certificate.until, channel: 0.0})
        assert "disagree" in reason(replace(found, certificate=parted)), channel


@EVERY
def test_every_sentence_is_parsed_back(case: Case) -> None:
    study, words = known(case)
    kind = KINDS[case.query.kind]
    shapes = [sentence(shape) for shape in kind.shapes(case.query, words, None)]
    assert len(set(shapes)) >= 3
    assert {parse_question(shape, study, words) for shape in shapes} == {case.query}


@pytest.mark.parametrize(
    ("made", "name", "subject", "moment"),
    [
        (FREE, "greatest deflection", "swing.hanger", WholeMotion()),  # it starts there
        (FREE, "least speed", "swing.bob", WholeMotion()),
        (told(atwood()), "greatest tension", "tendon_1", AtTime(0.7)),  # it is constant
        (told(atwood()), "greatest speed", "one.system.blocks.0", AtTime(0.7)),  # it ends there
        (told(squeezed()), "greatest speed", "track.gliders.1", AtTime(2.3)),  # it jumps, and is constant between
        (motions.thrown_ball().told, "greatest speed", "field.ball", AtTime(1.5)),  # it is, just before a bounce
        (motions.thrown_ball().told, "least speed", "field.ball", AtTime(0.1)),  # still to come
        (towed().told, "impulse of a tension", "floor.rope", AtTime(0.9)),  # that of a jerk is none of a tension
        (motions.rocket().told, "greatest speed", "pad.rocket", WholeMotion()),  # which never returns
        (dashpot().told, "greatest compression", "bench.spring", WholeMotion()),
        (told(atwood()), "amplitude", "one.system.blocks.0", AtTime(0.7)),  # it never turns back
    ],
)
def test_what_no_smooth_top_decides_has_no_answer(made: Made, name: str, subject: str, moment: Moment) -> None:
    query = StretchQuery(FUNCTIONALS[name].kind, None, moment, name, subject)
    assert KINDS[query.kind].answer(query, made()[0]) is None


def test_a_top_between_two_samples_counts_by_its_own_height() -> None:
    """The first maximum of a damped motion, A e^(−γπ/w), is the greatest, wherever the samples lie."""
    study, _ = dashpot().told()
    w = sqrt(40.0 - 4.0)
    query = StretchQuery("extremum", None, AtTime(1.9), "greatest compression", "bench.spring")
    assert KINDS["extremum"].answer(query, study) == pytest.approx(0.2 * exp(-2.0 * pi / w), rel=1e-9)


@pytest.mark.parametrize(
    ("made", "expected"),
    [
        (motions.orbit, 1.0),
        (passing, 1.0),
        (motions.spring_block, 2.0 * pi / RATE),
        (kicked, 2.0 * pi / RATE),
        (motions.rod_pendulum, ROUND),
        (dashpot, None),
        (dragged, None),
        (motions.rocket, None),
        (motions.thrown_ball, None),
        (motions.pushed_block, None),
    ],
)
def test_a_motion_returns_after_its_period(made: Callable[[], motions.Motion], expected: float | None) -> None:
    found = first_return(made().told()[0].trace)
    assert found == (pytest.approx(expected, rel=1e-8) if expected is not None else None)


def test_what_turns_over_returns_after_a_whole_turn() -> None:
    """T = 4/v₀·ℓ·K(k), k² = 4gℓ/v², for a bob on a light rod with v² = 6gℓ at its lowest point."""
    speed = sqrt(6.0 * G)
    trace = overturned(speed).told()[0].trace
    assert first_return(trace) == pytest.approx(2.0 * pi / speed / mean(1.0, sqrt(1.0 - 4.0 / 6.0)), rel=1e-8)


@pytest.mark.parametrize("heavy", [1.0, 2.0, 4.0, 9.0, 16.0])
def test_collisions_are_counted_by_unfolding(heavy: float) -> None:
    """A wall and two carts with mass ratio M/m have ⌈π/arctan √(m/M)⌉ − 1 elastic collisions in all."""
    study = SimulatedScene.of(squeezed(heavy), np.linspace(0.0, 60.0, 41))
    query = StretchQuery("count", None, LastCollision(), "number of collisions", WHOLE_SCENE)
    assert KINDS["count"].answer(query, study) == ceil(round(pi / atan(1.0 / sqrt(heavy)), 9)) - 1


def test_a_collision_may_follow_as_long_as_anything_approaches() -> None:
    study = SimulatedScene.of(squeezed(9.0), np.linspace(0.0, 2.0, 41))
    assert LastCollision().time(study.trace) is None
    assert LastCollision().time(SimulatedScene.of(table(), np.linspace(0.0, 2.0, 41)).trace) == pytest.approx(0.4)


def test_what_moves_at_a_constant_velocity_may_be_sent_back_by_a_spring() -> None:
    """Two carts of 1 kg, 0.5 m apart, swap their velocities; a spring that pushes returns the second at 1 m/s.

    It is at the spring after 0.5 s + 1 s, and leaves it after half a period, π √(m/k); 1 s later they collide again.
    """
    builder = Builder(gravity=ZERO)
    room = builder.room()
    room.site("wall", at=(2.0, 0.0, 0.0))
    one, other = room.body("A", 1.0).slide(X, 1.0), room.body("B", 1.0, at=(0.5, 0.0, 0.0)).slide(X).site("B.end")
    room.bump(one, other, X, 0.0, 1.0)
    room.buffer("spring", "wall", "B.end", 50.0, 0.5)
    before, after = (simulate(builder.finish(), np.linspace(0.0, end, 41)) for end in (0.9, 5.0))
    assert LastCollision().time(before) is None
    hits = [event.time for event in after.events if event.kind == "collision"]
    assert hits == pytest.approx([0.5, 2.5 + pi * sqrt(1.0 / 50.0)])


def test_symbols_name_those_who_collide_last_where_several_may() -> None:
    """With mass ratio M/m, ⌈π/arctan √(m/M)⌉ − 1 collisions alternate between the cart and the wall: 3, and 4."""
    for heavy, last in ((1.0, Collided("track.gliders.0 & track.gliders.1", 2)), (1.5, Bounced("track.gliders.1", 2))):
        trace = SimulatedScene.of(squeezed(heavy), np.linspace(0.0, 60.0, 41)).trace
        moment = LastCollision().in_symbols(trace)
        assert moment == last
        assert moment.time(trace) == LastCollision().time(trace)
    lone = SimulatedScene.of(table(), np.linspace(0.0, 2.0, 41)).trace
    assert LastCollision().in_symbols(lone) == LastCollision()


def test_a_count_is_asked_as_a_whole_number_and_read_back() -> None:
    search = QuestionSearch(squeezed(), 3)
    found = [search.ask(MODES["numeric"], np.random.default_rng(n), Counter(), "count") for n in range(6)]
    asked = [certified for certified in found if certified is not None]
    assert asked
    for certified in asked:
        assert "whole number" in certified.prompt
        assert "significant" not in certified.prompt
        assert parse_prompt(certified.prompt).answer == certified.question.answer


@pytest.mark.parametrize(("turns", "worth"), [(True, False), (False, True)])
def test_areas_are_asked_for_where_the_line_turns_in_one_sense(*, turns: bool, worth: bool) -> None:
    """A heavy planet that passes close to another one reverses its sense of revolution about their star."""
    far = HeavyPlanet(mass=0.56, x=-1.14, y=1.97 if turns else 9.0, vx=-3.53, vy=-2.96)
    near = HeavyPlanet(mass=0.44, x=0.57, y=-0.54, vx=5.18, vy=7.13)
    system = SolarSystem(star=Star(mass=1.5), planets=(near, far))
    scene = Scene(entities=(Named(name="system", entity=system),))
    study = SimulatedScene.of(scene, np.linspace(0.0, 0.36, 50))
    pair = next(
        name for name in Pairs().names(study.mechanism) if {"system.star", "system.planets.0"} == {*members(name)}
    )
    assert AreaSwept().worth(study, pair, 0.343) is worth


def test_no_tension_is_the_greatest_where_a_slack_string_becomes_taut_with_a_jerk() -> None:
    """Before the string goes slack, its greatest tension is m (v²/ℓ + 2 g (1 - cos θ) + g), at the lowest point."""
    read = parse_prompt(
        "A light, inextensible string of length 1.2 m joins a small bead (0.42 kg) to a fixed point. Initially the "
        "string is taut and makes an angle of 68° with the downward vertical. At t = 0 the bead starts moving "
        "downwards along its arc at speed 3.0 m/s. Each time the slack string becomes taut, the velocity along it is "
        "lost. The acceleration of free fall is g = 9.8 m/s². Find the greatest tension in the string in the time from "
        "t = 0 to the moment just after it becomes taut again for the first time. State the answer in N to three "
        "significant figures, inside \\boxed{}."
    )
    assert read.answer is None
    slack = next(event.time for event in read.study.trace.events if event.kind == "slack")
    early = replace(read.query, moment=AtTime(round(slack - 0.05, 2)))
    expected = 0.42 * (3.0**2 / 1.2 + 2.0 * 9.8 * (1.0 - cos(radians(68.0))) + 9.8)
    assert KINDS["extremum"].answer(early, read.study) == pytest.approx(expected)
