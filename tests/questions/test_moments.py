"""Tests of moments against closed forms."""

from dataclasses import replace
from math import cos, inf, nan, pi, radians, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plain_scenes import G, arm, atwood, ramp, row, squeezed, table
from sim2reason.questions import KINDS, Moment, SimulatedScene
from sim2reason.questions.moments.contacts import Collided
from sim2reason.questions.moments.crossings import crossings, first_crossing, jumps, rises_from_zero
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.extrema import SpringTurn
from sim2reason.questions.moments.strings import MostStretched, NaturalLength
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import LowestPoint, Stopped
from sim2reason.questions.prompt import parse_prompt, words_of
from sim2reason.questions.query import targets
from sim2reason.questions.words import format_number, numbers_in_text, round_number, rounded_as_written, two_digits
from sim2reason.scenes.bodies.round_bodies import Hoop
from sim2reason.scenes.bodies.simple_machines import Incline
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.mechanism import ZERO, X
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.rolling import NoSlipping, Rolling, RollingEntity, Rough, Sliding, Spinning
from sim2reason.scenes.files import load
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.simulation.quantities.subjects.interactions import pair
from sim2reason.simulation.scenes import simulate
from sim2reason.simulation.trace import ENGINES
from sim2reason.text.prose.description import describe

BLOCK = "ramp.blocks.0"
PUCKS = "table.pucks.0 & table.pucks.1"


FALL = simulate(ramp(angle=30.0))  # a motion whose clock is asked


@given(st.floats(0.05, 0.999), st.floats(1.05, 3.0))
def test_the_first_of_two_crossings_is_found(share: float, later: float) -> None:
    root = 2.0 * share
    found = first_crossing(FALL, lambda state: (state.times - root) * (later * 2.0 - state.times))
    assert found == pytest.approx(root, rel=1e-12)


def test_a_parabola_that_only_touches_on_its_way_back_is_met_on_its_way_there() -> None:
    found = first_crossing(FALL, lambda state: 1.0 - (state.times - 1.0) ** 2 - 0.75)
    assert found == pytest.approx(0.5, rel=1e-12)


@given(st.floats(0.1, 1.9), st.floats(1e-9, 1e-2))
def test_a_pair_of_crossings_between_two_samples_is_seen(middle: float, apart: float) -> None:
    found = list(crossings(FALL, lambda state: apart**2 - (state.times - middle) ** 2))
    assert found == [pytest.approx(middle - apart, rel=1e-9)] or apart < 1e-3


def test_what_is_never_reached_is_none() -> None:
    assert first_crossing(FALL, lambda state: state.times - 3.0) is None
    assert first_crossing(FALL, lambda state: np.full_like(state.times, -1.0)) is None


def test_what_begins_at_zero_must_fall_below_it_first() -> None:
    assert first_crossing(FALL, lambda state: state.times) is None
    assert rises_from_zero(FALL, lambda state: state.times)
    assert not rises_from_zero(FALL, lambda state: state.times * (state.times - 1.0))
    found = first_crossing(FALL, lambda state: state.times * (state.times - 1.0))
    assert found == pytest.approx(1.0, rel=1e-12)


def test_a_block_that_slides_down_is_somewhere_at_the_textbook_time() -> None:
    trace = simulate(ramp(angle=30.0, friction=0.2))
    a = G * (sin(radians(30)) - 0.2 * cos(radians(30)))
    assert Moved(BLOCK, 0.5).time(trace) == pytest.approx(sqrt(2.0 * 0.5 / a), rel=1e-10)
    assert Moved(BLOCK, 1e3).time(trace) is None


def test_where_a_block_comes_only_after_it_has_turned_back_it_has_not_moved_however_long_the_motion() -> None:
    """A block sent up a slope at 6 m/s stops after 3.7 m and slides back; a long motion has few samples there."""
    scene, moment = ramp(angle=30.0, speed=6.0), Moved(BLOCK, 30.0)
    for duration in (8.0, 256.0):
        trace = simulate(scene, duration)
        assert moment.time(trace) is None
        assert moment.comes_later(trace)
        assert not Moved(BLOCK, 1.0).comes_later(trace)
        assert Moved(BLOCK, 1.0).time(trace) is not None


def test_what_a_collision_sends_back_is_spoken_of_by_its_distance_from_its_start() -> None:
    """A cart of 0.1 kg at 1 m/s rebounds from one of 1 kg after 1 m, at 9/11 m/s: 1.5 m behind at 73/18 s."""
    scene = squeezed(heavy=0.1)
    moment, words = Moved("track.gliders.0", 1.5), words_of(describe(scene))
    assert moment.time(simulate(scene)) == pytest.approx(73.0 / 18.0, rel=1e-9)
    assert moment.phrases(words)[0] == "when cart A is first 1.5 m from its starting point"
    clause = moment.clause(words)
    assert clause is not None
    assert clause.statement == "cart A is first 1.5 m from its starting point"
    assert moment.told(words, "$d$") == "cart A is the distance $d$ from its starting point"
    behind = replace(moment, towards=-1).told(replace(words, symbolic=True), "$d$")
    assert behind == "cart A is the distance $d$ to the left of its starting point"


def test_symbols_do_not_say_whether_a_body_turns_back_before_it_has_moved_so_far() -> None:
    """A block launched uphill may turn back first, so path and distance differ; one released on a slope can't."""
    for scene, symbolic, statement in (
        (ramp(angle=30.0, speed=3.0), True, "the block is first 0.50 m from its starting point"),
        (ramp(angle=30.0, speed=3.0), False, "the block has moved 0.50 m"),
        (ramp(angle=30.0), True, "the block has moved 0.50 m"),
    ):
        clause = Moved(BLOCK, 0.5).clause(replace(words_of(describe(scene)), symbolic=symbolic))
        assert clause is not None
        assert clause.statement == statement
    assert Moved(BLOCK, 0.5).told(words_of(describe(ramp(angle=30.0))), "$d$") == "the block has moved $d$"


def test_what_a_collision_sends_back_turns_at_once() -> None:
    """A cart of 0.1 kg at 1 m/s rebounds from one of 1 kg after 1 s, at 9/11 m/s."""
    trace = simulate(squeezed(heavy=0.1))
    assert jumps(trace, lambda state: -state.v[:, 0])[0] == pytest.approx(1.0)
    assert 1.0 not in jumps(trace, lambda state: state.v[:, 0])
    assert not jumps(FALL, lambda state: state.times - 1.0)


@pytest.mark.parametrize("blow", [None, 2.0])
def test_a_spring_that_a_blow_turns_has_no_first_greatest_length(blow: float | None) -> None:
    """B and C separate until π/2 √(μ/k) = 0.157 s, unless A strikes B at 0.1 s and the spring shortens at once."""
    builder = Builder(gravity=ZERO)
    room = builder.room()
    a = room.body("a", 5.0, at=(-0.1 * (blow or 0.0), 0.0, 0.0)).slide(X, blow or 0.0)
    b = room.body("b", 2.0).slide(X).site("eye")
    room.body("c", 2.0, at=(1.0, 0.0, 0.0)).slide(X, 1.0).site("hook")
    room.spring("spring", "eye", "hook", stiffness=100.0)
    if blow is not None:
        builder.room().bump(a, b, X, 0.0, 1.0)
    trace = ENGINES["exact"](builder.finish(), np.linspace(0.0, 0.3, 5))
    turn = MostStretched("spring")
    if blow is None:
        assert turn.time(trace) == turn.first().time(trace) == pytest.approx(pi / 20.0)
    else:
        assert turn.time(trace) is None
        first = turn.first().time(trace)
        assert first is not None
        assert first < pi / 20.0
        assert first in [event.time for event in trace.events if event.kind == "collision"]


def test_a_block_sent_uphill_turns_and_is_first_there_on_its_way_up() -> None:
    trace = simulate(ramp(angle=30.0, speed=3.0))
    a, v = G * sin(radians(30)), 3.0
    assert Stopped(BLOCK).time(trace) == pytest.approx(v / a, rel=1e-10)
    assert Moved(BLOCK, 0.5).time(trace) == pytest.approx((v - sqrt(v * v - 2.0 * a * 0.5)) / a, rel=1e-10)


def test_a_block_that_stays_never_stops() -> None:
    assert Stopped(BLOCK).time(simulate(ramp(angle=10.0, friction=0.6))) is None
    assert Stopped("one.system.blocks.0").time(simulate(atwood())) is None


def test_pucks_meet_when_the_gap_is_closed_and_sides_differ() -> None:
    trace = simulate(table(speed=2.0))
    before, after = Collided(PUCKS, after=False), Collided(PUCKS, after=True)
    assert before.time(trace) == after.time(trace) == pytest.approx(0.8 / 2.0, rel=1e-12)
    assert before.evaluation_time(0.4) < 0.4 == after.evaluation_time(0.4)
    assert Collided("table.pucks.0 & nobody", after=True).time(trace) is None


def test_times_are_those_that_are_said() -> None:
    trace = simulate(ramp())
    assert AtTime(0.5).time(trace) == 0.5
    assert AtTime(50.0).time(trace) is None
    assert AtStart().time(trace) == 0.0


@given(st.floats(0.01, 900.0))
def test_spoken_numbers_have_two_digits_and_are_what_is_said(value: float) -> None:
    said = two_digits(value)
    assert float(said) == rounded_as_written(value) == pytest.approx(value, rel=0.05)
    assert "e" not in said
    assert rounded_as_written(rounded_as_written(value)) == rounded_as_written(value)


@given(st.floats(0.01, 900.0), st.floats(1.0, 3.0))
def test_a_round_number_is_the_nearest_between_its_bounds(value: float, factor: float) -> None:
    """Adjacent round numbers differ by a factor of at most 1.4, so that wide bounds always contain one."""
    found, bounds = round_number(value, value / factor, value * factor), (value / factor, value * factor)
    if factor > 1.4:
        assert bounds[0] <= found <= bounds[1]
        assert max(found / value, value / found) <= 1.4**0.5 * (1.0 + 1e-9)
    if not bounds[0] <= found <= bounds[1]:
        assert found == rounded_as_written(value)


@pytest.mark.parametrize(
    ("value", "least", "most", "found"), [(0.44, 0.2, 1.0, 0.4), (17.0, 10.0, 20.0, 15.0), (6.4, 6.1, 6.9, 6.4)]
)
def test_round_numbers(value: float, least: float, most: float, found: float) -> None:
    assert round_number(value, least, most) == found


@pytest.mark.parametrize(("value", "said"), [(0.5, "0.50"), (0.996, "1.0"), (12.4, "12"), (0.05, "0.050")])
def test_two_digits(value: float, said: str) -> None:
    assert two_digits(value) == said


@pytest.mark.parametrize("value", [nan, inf])
def test_what_is_no_number_is_not_said(value: float) -> None:
    with pytest.raises((ValueError, OverflowError)):
        two_digits(value)


@pytest.mark.parametrize("released", [True, False])
def test_every_moment_has_three_phrases_in_the_words_of_the_text(released: bool) -> None:
    told: list[tuple[Moment, Scene]] = [(moment, ramp()) for moment in (AtStart(), AtTime(0.5), Moved(BLOCK, 0.5))]
    for moment, scene in [*told, (Stopped(BLOCK), ramp()), (Collided(PUCKS, after=True), table())]:
        words = replace(words_of(describe(scene)), released=released)
        phrases = moment.phrases(words)
        assert len(set(phrases)) >= 3
        assert all(words.mentions[name].split()[-1] in phrase for name in moment.subjects for phrase in phrases)
        if isinstance(moment, AtStart | AtTime):
            assert all(("t =" in phrase) != released for phrase in phrases)


def test_two_of_a_kind_are_a_pair() -> None:
    assert pair("puck A", "puck B") == "pucks A and B"
    assert pair("the block", "the wedge") == "the block and the wedge"
    assert pair("block A", "prism W") == "block A and prism W"


@given(st.floats(0.01, 900.0), st.sampled_from(["s", "m", "m/s", "m/s^2", "J"]))
def test_numbers_are_found_again_by_their_unit_alone(value: float, unit: str) -> None:
    text = f"What is it when A is at {format_number(value, unit)}?"
    assert numbers_in_text(text, unit) == [pytest.approx(value, rel=1e-12)]
    assert not any(numbers_in_text(text, other) for other in ("s", "m", "m/s", "m/s^2", "J") if other != unit)


ROCKS = (
    "A slider (mass $M$) slides freely along a straight horizontal rail. A straight light arm can turn in a vertical "
    "plane about a horizontal axle. Rigidly attached to the arm is a small ball of mass $m$, a distance $d$ from the "
    "axle. Initially the part of the arm from the axle to the ball points at an angle $\\theta$ to the right of the "
    "downward vertical. "
    "The arm is attached to the slider by a frictionless axle. A light string tied to the slider runs along "
    "the rail to the left and is pulled at its far end by a hand with a constant force of $F_1$. A second light "
    "string tied to the slider runs along the rail to the right and is pulled at its far end by a hand with a "
    "constant force of $F_2$. Until "
    "t = 0 everything is held at rest. Take g = 9.8 m/s². Numerical values: $M$ = 5.6 kg, $m$ = 5.5 kg, $d$ = 0.50 m, "
    "$\\theta$ = 13°, $F_1$ = PULL N and $F_2$ = 37 N. Calculate the greatest angular speed of the arm from "
    "release until the ball first passes through the lowest point of its path. State the answer in rad/s to "
    "three significant figures, inside \\boxed{}."
)


@pytest.mark.parametrize(("left", "passes"), [("57", False), ("38", True)])
def test_an_arm_that_rocks_to_one_side_does_not_pass_through_its_lowest_point(left: str, *, passes: bool) -> None:
    """A cart with acceleration a holds its arm at tan θ = a/g: 10.4° at 57 N, from which 13° hardly differs."""
    asked = parse_prompt(ROCKS.replace("PULL", left), np.random.default_rng(1))
    moment = asked.query.moment
    assert isinstance(moment, LowestPoint)
    assert asked.study.time(moment) is not None
    assert moment.comes(asked.study) is passes


def test_a_light_arm_on_a_carriage_is_nobody_whose_speed_is_asked() -> None:
    """An arm that turns has no centre of mass, and each of its points has another speed."""
    asked = parse_prompt(ROCKS.replace("PULL", "57"), np.random.default_rng(1))
    called = Bodies().phrases(asked.study.mechanism, asked.reading.mentions)
    assert {said.split()[-1] for said in called.values()} == {"slider", "ball"}


def test_what_friction_holds_from_the_start_never_comes_to_rest() -> None:
    """The extra pull of the spring, at most 155 N/m · 0.07 m = 11 N, is less than 0.49 · 4.4 kg · g."""
    scene = row((4.4, 3.9), (82.0, 155.0, 113.0), "both", speed=0.98, friction=0.49)
    trace = simulate(scene)
    assert Stopped("row.carts.0").time(trace) is None
    assert Stopped("row.carts.1").time(trace) is not None


@pytest.mark.parametrize(
    ("grip", "start", "told"),
    [
        (NoSlipping(), None, "hoop first comes to rest again"),
        (NoSlipping(), Rolling(way="up the slope", speed=2.0), "hoop first comes to rest"),
        (Rough(friction=0.15), Sliding(way="up the slope", speed=2.0), "centre of the hoop first comes to rest"),
        (
            Rough(friction=0.9),
            Spinning(way="up the slope", spin=9.0),
            "centre of the hoop first comes to rest again",
        ),
    ],
)
def test_of_what_may_spin_on_the_centre_comes_to_rest(
    grip: NoSlipping | Rough, start: Rolling | Sliding | Spinning | None, told: str
) -> None:
    entity = RollingEntity(plane=Incline(angle=20.0), body=Hoop(mass=2.0, radius=0.1), grip=grip, start=start)
    scene = Scene(entities=(Named(name="roller", entity=entity),))
    assert Stopped("roller.body").phrases(words_of(describe(scene)))[0] == f"when the {told}"


def test_what_an_arm_carries_comes_to_rest_again_only_if_the_arm_was_at_rest() -> None:
    for rate, told in ((None, "comes to rest again"), (2.0, "comes to rest")):
        scene = arm(rate=rate)
        (sphere,) = (name for name in scene.bodies if "pieces" in name)
        assert Stopped(sphere).does(words_of(describe(scene))).told == told


def test_a_spring_is_not_asked_about_where_it_is_stretched_or_compressed_the_most() -> None:
    """The extreme of the spring is asked for by that name, and many quantities of the carts are asked for."""
    scene = row((1.0, 2.0), (100.0, 60.0), "left", strain=0.1, speed=0.5)
    seen, words = SimulatedScene(scene, simulate(scene)), words_of(describe(scene))
    drawn = (KINDS["event"].draw(seen, words, targets(words), np.random.default_rng(seed)) for seed in range(60))
    found = [query for query in drawn if query is not None and isinstance(query.moment, SpringTurn)]
    assert found
    for query in found:
        assert query.target is not None
        assert isinstance(query.moment, SpringTurn)
        assert query.target.subject != query.moment.name


def test_who_finds_an_unknown_may_count_from_a_start_that_is_the_greatest_already() -> None:
    """A spring released when stretched first reaches its maximum extension after a period, 2π √(m/k)."""
    scene = row((2.0,), (80.0,), "left", strain=0.1)
    spring = scene.mechanism.lines[0].name
    trace = ENGINES["exact"](scene.mechanism, np.linspace(0.0, 3.0, 61))
    moment = MostStretched(spring)
    assert moment.time(trace) is None
    assert moment.first().time(trace) == pytest.approx(2.0 * pi * sqrt(2.0 / 80.0), rel=1e-9)


@pytest.mark.parametrize(("speed", "rests"), [(1.0, 1.0), (1.00001, None), (1.1, None)])
def test_a_speed_that_only_touches_zero_is_at_rest_then(speed: float, rests: float | None) -> None:
    """In a field that falls to zero and reverses, v = (1 − t)²: the bead stops, and continues in its direction."""
    field = "{kind: growing_electric, strength: 2.0, way: negative x, trend: decreases, growth: 2.0}"
    particle = "{mass: 1.0, charge: 1.0, sign: positive}"
    start = f"{{kind: launched, speed: {speed}, angle: 0}}"
    bead = f"{{particle: {particle}, electric: {field}, start: {start}}}"
    scene = load(f"scene: {{name: bead, entities: [{{name: bead, type: EmEntity, parameters: {bead}}}]}}")
    for duration in (2.0, 64.0):
        found = Stopped("bead.particle").time(SimulatedScene.of(scene, np.linspace(0.0, duration, 11)).trace)
        assert found == (pytest.approx(rests, abs=1e-6) if rests is not None else None)


def test_a_relaxed_spring_has_its_natural_length_again_after_half_a_period() -> None:
    """Two carts on one spring, one of them struck, oscillate with the reduced mass μ: t = π √(μ/k)."""
    scene = row((1.6, 1.1), (79.0,), "free", speed=1.7)
    trace, words = simulate(scene), words_of(describe(scene))
    (moment,) = NaturalLength.parsed("the spring", trace, words)
    assert moment.time(trace) == pytest.approx(pi * sqrt(1.6 * 1.1 / 2.7 / 79.0), rel=1e-9)
    assert "has its natural length again" in moment.phrases(words)[0]
    assert not NaturalLength.found(SimulatedScene(scene, trace), words, np.random.default_rng(0))
