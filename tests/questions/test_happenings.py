"""Tests of moments in all kinds of motion, by textbook formulas, and of the agreement of both engines."""

from collections.abc import Callable
from math import acos, acosh, asin, cos, pi, radians, sin, sqrt
from pathlib import Path

import numpy as np
import pytest

import motions
from plain_scenes import ramp, table
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.generation.item_search import sample
from sim2reason.questions import KINDS, MOMENTS, Moment, Query, Question, SimulatedScene, Words
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.moments.angles import Deflected, Orbited, TurnedThrough
from sim2reason.questions.moments.bounces import Bounced, Landed, StayedBelow, TopAfterBounce
from sim2reason.questions.moments.contacts import (
    BeganToSlip,
    Collided,
    EdgeLanded,
    LastCollision,
    LeftFace,
    LiftedOff,
    StoppedSlipping,
)
from sim2reason.questions.moments.distances import Away, Closest, Farthest, Moved, Returned
from sim2reason.questions.moments.fields import AcrossField, EnteredRegion, LeftRegion, VelocityReturned, VelocityTurned
from sim2reason.questions.moments.strings import MostCompressed, MostStretched, NaturalLength, WentSlack, WentTaut
from sim2reason.questions.moments.times import AtTime, BurnedOut
from sim2reason.questions.moments.turning_points import Fastest, Halted, HighestPoint, LowestPoint, Stopped
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import targets
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Z
from sim2reason.scenes.dsl.model import replace_validated
from sim2reason.scenes.files import load
from sim2reason.simulation.certify import Certificate, certify
from sim2reason.simulation.engines.exact import simulate as exact
from sim2reason.simulation.scenes import simulate
from sim2reason.text.prose.description import describe

G = 9.8
ROD_RATE = sqrt(1.5 * G / 1.2)  # of small swings of a uniform rod of 1.2 m
BOB_RATE = sqrt(G / 0.8)
OMEGA = sqrt(20.0 / 0.5)
SLACK = acos(-0.5)  # cos θ = −(k − 2)/3 with v₀² = kgℓ, k = 3.5
FLIGHT = 4.0 * sqrt(0.5 * G) * sin(SLACK) / G  # until it is taut again: 4 v_z/g, with v² = gℓ(k − 2)/3
RISE, AHEAD = 5.0 * sin(radians(40.0)), 5.0 * cos(radians(40.0))
FALL = sqrt(RISE**2 + 2.0 * G)  # the speed downwards at the ground


def integral(function: Callable[[np.ndarray], np.ndarray], end: float) -> float:
    """Integrate a smooth function from zero, by 60 Gauss-Legendre points."""
    points, weights = np.polynomial.legendre.leggauss(60)
    return float(0.5 * end * weights @ function(0.5 * end * (points + 1.0)))


def elliptic(angle: float, parameter: float) -> float:
    """Return the elliptic integral F(φ | m)."""
    return integral(lambda phi: 1.0 / np.sqrt(1.0 - parameter * np.sin(phi) ** 2), angle)


def swing(rate: float, start: float, angle: float) -> float:
    """Return when a pendulum released at `start` first is at `angle`, rad: (K − F(ψ, k))/ω, sin ψ = sin(θ/2)/k."""
    k = sin(start / 2.0)
    return (elliptic(pi / 2.0, k * k) - elliptic(asin(sin(angle / 2.0) / k), k * k)) / rate


def struck(angle: float) -> float:
    """Return when a bob with v₀² = 3.5 gℓ at its lowest point is at an angle: θ′² = (g/ℓ)(k − 2 + 2 cos θ)."""
    return 2.0 / sqrt(3.5 * G) * elliptic(angle / 2.0, 4.0 / 3.5)


def slid(angle: float) -> float:
    """Return when a body is at an angle on a dome of 1 m, from 10°.

    θ′² = 4g (sin²(θ/2) − s₀²), sin(θ/2) = s₀ cosh u.
    """
    first = sin(radians(5.0))
    end = acosh(sin(angle / 2.0) / first)
    return integral(lambda u: 1.0 / np.sqrt(G * (1.0 - (first * np.cosh(u)) ** 2)), end)


def thrown(distance: float) -> float:
    """Return when a ball first is at a distance from its start: the least root of x² + z² = d²."""
    roots = np.roots([G**2 / 4.0, -RISE * G, RISE**2 + AHEAD**2, 0.0, -(distance**2)])
    return float(min(root.real for root in roots if abs(root.imag) < 1e-9 and root.real > 0.0))


def kepler(anomaly: float, eccentricity: float = 0.5) -> float:
    """Return the time M = E − e sin E, in periods."""
    return (anomaly - eccentricity * sin(anomaly)) / (2.0 * pi)


def prism() -> motions.Motion:
    """Build a decagonal prism, its edges 0.10 m from its axis, that tips over on a slope of 12° at 5.3 rad/s."""
    scene = load(Path(__file__).parents[1] / "data" / "ordinary_scenes" / "tumbling_prism.yaml")
    return motions.Motion(simulate_scene(scene).study.mechanism, {"roller.prism": "the prism"}, 0.3)


def tumbled() -> float:
    """Return when the axis has turned from 6° before the vertical through an edge to 30° beyond it, by energy."""
    inertia = 0.1**2 * (1.0 + (2.0 + cos(radians(36.0))) / 6.0)
    began = radians(-6.0)

    def slowness(turned: np.ndarray) -> np.ndarray:
        return 1.0 / np.sqrt(5.3**2 + 2.0 * G * 0.1 / inertia * (cos(began) - np.cos(began + turned)))

    return integral(slowness, radians(36.0))


TURNS = 4.1 / 1.5  # rad/s: q B/m in these fields of 1 T


def beads(electric: bool) -> motions.Motion:
    """Build a bead of 1.5 mg with −4.1 µC at 2.7 m/s, 304° from x, in 1 T along z and perhaps 0.76 N/C against x."""
    scene = load(Path(__file__).parents[1] / "data" / "ordinary_scenes" / "crossed_fields.yaml")
    held = scene.entities[0]
    fields = held.entity if electric else replace_validated(held.entity, electric=None)
    made = replace_validated(scene, entities=(replace_validated(held, entity=fields),))
    return motions.Motion(simulate_scene(made).study.mechanism, {"fields.particle": "the bead"}, 3.0)


def crossed() -> motions.Motion:
    return beads(electric=True)


def cyclotron() -> motions.Motion:
    return beads(electric=False)


def across() -> float:
    """Return the first time at which v₀ − u, which turns by Ω t, has no x component, so v_x = 0; u is along y."""
    turned = 2.7 * np.exp(1j * radians(304.0)) - 1j * 0.76  # u = E × B/B²: −E x̂ × B ẑ = E B ŷ
    return float((0.5 * pi - np.angle(turned)) % pi) / TURNS


TIMES: list[tuple[Callable[[], motions.Motion], Moment, float]] = [
    (motions.string_pendulum, WentSlack("swing.hanger"), struck(SLACK)),
    (motions.string_pendulum, WentTaut("swing.hanger", after=True), struck(SLACK) + FLIGHT),
    (motions.string_pendulum, Deflected("swing.hanger", 60.0), struck(radians(60.0))),
    (motions.string_pendulum, HighestPoint("swing.bob"), struck(SLACK) + FLIGHT / 4.0),
    (motions.rod_pendulum, LowestPoint("swing.rod"), swing(ROD_RATE, radians(60.0), 0.0)),
    (motions.rod_pendulum, Deflected("swing.rod", 30.0), swing(ROD_RATE, radians(60.0), radians(30.0))),
    (motions.rod_pendulum, Stopped("swing.rod"), 2.0 * swing(ROD_RATE, radians(60.0), 0.0)),
    (motions.rod_pendulum, TurnedThrough("swing.rod", 40.0), swing(ROD_RATE, radians(60.0), radians(20.0))),
    (motions.light_rod, LowestPoint("swing.bob"), swing(BOB_RATE, radians(60.0), 0.0)),
    (motions.light_rod, Deflected("swing.hanger", 30.0), swing(BOB_RATE, radians(60.0), radians(30.0))),
    (motions.rolling_ball, StoppedSlipping("lane.ball"), 2.0 * 3.0 / (7.0 * 0.2 * G)),
    (motions.rolling_ball, Moved("lane.ball", 1.0), (3.0 - sqrt(9.0 - 0.4 * G)) / (0.2 * G)),
    (motions.spring_block, NaturalLength("bench.spring"), pi / 2.0 / OMEGA),
    (motions.spring_block, MostCompressed("bench.spring"), pi / OMEGA),
    (lambda: motions.spring_block(-0.2), MostStretched("bench.spring"), pi / OMEGA),
    (motions.rubbed_spring, Halted("bench.block"), 4.0 * pi / OMEGA),  # 0.2 → 0.151 → 0.102 → 0.053 → 0.004 m
    (motions.spring_block, Moved("bench.block", 0.1), acos(0.5) / OMEGA),
    (motions.orbit, Farthest("sky.planet & sky.star"), 0.5),
    (lambda: motions.orbit(-0.5), Closest("sky.planet & sky.star"), 0.5),
    (motions.orbit, Orbited("sky.planet & sky.star", 90), kepler(acos(0.5))),
    (motions.orbit, Orbited("sky.planet & sky.star", 180), 0.5),
    (motions.orbit, Orbited("sky.planet & sky.star", 360), 1.0),
    (motions.rocket, BurnedOut("pad.rocket"), 6.0),
    (motions.heavy_rocket, LiftedOff("pad.rocket"), (10.0 - 0.5 * 160.0 / G) / 0.5),
    (motions.spring_block, Fastest("bench.block"), pi / (2.0 * OMEGA)),
    (motions.thrown_ball, HighestPoint("field.ball"), RISE / G),
    (motions.rod_pendulum, Stopped("swing.rod", 2), 4.0 * swing(ROD_RATE, radians(60.0), 0.0)),
    (motions.spring_block, Returned("bench.block"), 2.0 * pi / OMEGA),
    (motions.thrown_ball, TopAfterBounce("field.ball"), (RISE + 1.8 * FALL) / G),
    (motions.thrown_ball, TopAfterBounce("field.ball", 2), (RISE + FALL + (1.6 + 0.64) * FALL) / G),
    (motions.thrown_ball, StayedBelow("field.ball", 0.8), (RISE + FALL + 1.6 * FALL) / G),  # tops at 0.98 m, 0.63 m
    (prism, EdgeLanded("roller.prism"), tumbled()),
    (motions.thrown_ball, Bounced("field.ball", after=True), (RISE + FALL) / G),
    (motions.thrown_ball, Bounced("field.ball", 3, after=False), (RISE + FALL + 2.0 * FALL * 0.8 * 1.8) / G),
    (lambda: motions.thrown_ball(None), Landed("field.ball"), (RISE + FALL) / G),
    (motions.thrown_ball, Away("field.ball", 0.5), thrown(0.5)),
    (motions.charge, EnteredRegion("lab.charge"), 0.5),
    (motions.charge, LeftRegion("lab.charge"), 0.5 + pi / 3.0),
    (motions.dome, LeftFace("hill.block"), slid(acos(2.0 / 3.0 * cos(radians(10.0))))),
    (motions.pushed_block, BeganToSlip("bench.block"), 0.4 * G / 3.0),
    (motions.slab, StoppedSlipping("bench.block"), 2.0 / (0.4 * G)),
    (motions.pucks, Collided("table.a & table.b", after=True), 0.42),
    (motions.pucks, LastCollision(), 0.42),
    (cyclotron, VelocityTurned("fields.particle", 60.0), pi / 3.0 / TURNS),
    (crossed, VelocityReturned("fields.particle"), 2.0 * pi / TURNS),
    (crossed, AcrossField("fields.particle"), across()),
]


@pytest.mark.parametrize(("motion", "moment", "expected"), TIMES, ids=[type(each[1]).__name__ for each in TIMES])
def test_it_happens_when_the_formula_says(
    motion: Callable[[], motions.Motion], moment: Moment, expected: float
) -> None:
    trace = motion().told()[0].trace
    assert moment.time(trace) == pytest.approx(expected, rel=1e-8)


def test_every_moment_that_is_no_stated_time_is_tried() -> None:
    assert {type(each[1]) for each in TIMES} == {cls for cls in MOMENTS.values() if cls.kind == "event"}


@pytest.mark.parametrize(("motion", "moment", "expected"), TIMES, ids=[type(each[1]).__name__ for each in TIMES])
def test_both_engines_vouch_for_it(motion: Callable[[], motions.Motion], moment: Moment, expected: float) -> None:
    """The filter accepts a question for the time of the event, and one for some quantity at it."""
    study, words = motion().told()
    certificate = certify(study.mechanism, study.trace.state.times)[1]
    assert not refused(Query("time_to_event", None, moment), study, certificate)
    asked = [target for target in targets(words) if target.subject in moment.subjects and target.quantity != "tension"]
    verdicts = {target: refused(Query("event", target, moment), study, certificate) for target in asked}
    assert not asked or not all(verdicts.values()), verdicts
    assert expected > 0.0


def refused(query: Query, study: SimulatedScene, certificate: Certificate) -> str:
    """Return why the agreement of both engines does not cover a question, or an empty string if it does."""
    answer = KINDS[query.kind].answer(query, study)
    assert answer is not None
    question = Question("numeric", query, "?", answer, KINDS[query.kind].measured(query).unit)
    return FILTERS["agreement"].reason(Candidate(study, question, "", certificate=certificate))


# ---- what is not asked


def test_what_begins_at_its_highest_point_does_not_reach_it_for_the_first_time() -> None:
    study, words = motions.rod_pendulum().told()
    assert HighestPoint("swing.rod").time(study.trace) is None
    assert not MostStretched.found(*motions.spring_block().told(), np.random.default_rng(0))
    assert Closest("sky.planet & sky.star").time(motions.orbit().told()[0].trace) is None
    assert LowestPoint.found(study, words, np.random.default_rng(0))


def test_what_others_may_send_up_again_stops_rising() -> None:
    """The text does not say whether a struck puck later rises higher than at its first turning point."""
    words = words_of(describe(table(tilt=20.0)))
    assert "when puck A first stops rising" in HighestPoint("table.pucks.0").phrases(words)
    assert "when puck A first stops falling" in LowestPoint("table.pucks.0").phrases(words)
    _, alone = motions.thrown_ball(None).told()
    assert "when the ball first reaches the highest point of its path" in HighestPoint("field.ball").phrases(alone)


def test_a_top_that_is_lower_than_the_start_is_not_the_highest_point() -> None:
    """A ball that falls from 1 m rebounds to e² of that, so the highest point of its path is the start."""
    builder = Builder()
    room = builder.room("field")
    room.bump(room, room.body("ball", 0.2, at=(0.0, 0.0, 1.0)).slide(Z), Z, 0.0, 0.8)
    trace = exact(builder.finish(), np.linspace(0.0, 1.1, 41))
    assert [event.kind for event in trace.events] == ["collision", "turn"]
    assert HighestPoint("field.ball").time(trace) is None


def drawn(study: SimulatedScene, words: Words, kind: str) -> list[Query]:
    """Return the queries of a kind over many draws."""
    found = (KINDS[kind].draw(study, words, targets(words), np.random.default_rng(seed)) for seed in range(120))
    return [query for query in found if query is not None]


def test_a_force_that_never_changes_is_not_asked_at_a_moment() -> None:
    """On a ramp the acceleration and the normal force are constant from release on."""
    for kind in ("state", "event"):
        asked = {query.target.quantity for query in drawn(*told(), kind) if query.target is not None}
        assert asked
        assert not asked & {"acceleration", "net force", "normal force", "friction force"}


def told() -> tuple[SimulatedScene, Words]:
    """Return the motion of a block that slides down a rough ramp, and its words."""
    scene = ramp(friction=0.2)
    return SimulatedScene(scene, simulate(scene)), words_of(describe(scene))


def test_where_a_force_jumps_at_an_event_it_is_not_asked_there() -> None:
    """Friction drops from µmg to zero when the ball begins to roll, and has neither value at that instant."""
    study, words = motions.rolling_ball().told()
    asked = [query for query in drawn(study, words, "event") if isinstance(query.moment, StoppedSlipping)]
    assert {"velocity", "kinetic energy"} & {query.target.quantity for query in asked if query.target is not None}
    assert not {"friction force", "acceleration", "torque"} & {q.target.quantity for q in asked if q.target is not None}
    assert AtTime(0.5).time(study.trace) == 0.5


@pytest.mark.parametrize(("recipe", "asked"), [("projectile", False), ("electromagnetic", True)])
def test_of_what_is_thrown_no_slant_distance_fixes_a_moment(recipe: str, asked: bool) -> None:
    """Only for a bead in a field, and seldom, the distance from the start defines a moment."""
    scene = sample(recipe, "easy", seed=3)
    words, study = words_of(describe(scene)), SimulatedScene(scene, simulate(scene))
    found = [moment for seed in range(99) for moment in Away.found(study, words, np.random.default_rng(seed))]
    assert bool(found) is asked
