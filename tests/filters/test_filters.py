"""Each filter drops what it should and keeps what it should."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

from plain_scenes import G, atwood, ramp, table
from sim2reason.dsl.scene import Scene
from sim2reason.filters import FILTERS, Candidate, precision, sift
from sim2reason.filters.precision import patterns, shiftable
from sim2reason.questions import KINDS, Moment, Query, Question, Study, Target
from sim2reason.questions.moments.at_start import AtStart
from sim2reason.questions.moments.at_time import AtTime
from sim2reason.questions.moments.collided import Collided
from sim2reason.questions.moments.moved import Moved
from sim2reason.questions.moments.stopped import Stopped
from sim2reason.recipes import RECIPES
from sim2reason.simulation.certify import witnessed
from sim2reason.simulation.channels import Channel, channels

BLOCK, OTHER = "one.system.blocks.0", "other.system.blocks.0"
LEFT, RIGHT = "table.pucks.0", "table.pucks.1"
BOTH = "table.pucks.0 & table.pucks.1"


def candidate(scene: Scene, moment: Moment, target: Target | None, answer: float | None = None) -> Candidate:
    """A question about a scene with its true answer, or another one."""
    study = Study.of(scene, np.linspace(0.0, 2.0, 41))
    query = Query(moment.kind if target else "time_to_event", target, moment)
    found = KINDS[query.kind].answer(query, study) if answer is None else answer
    assert found is not None
    unit = KINDS[query.kind].measured(query).unit
    return Candidate(study, Question("numeric", query, "?", found, unit), "a b c")


def reason(name: str, found: Candidate) -> str:
    return FILTERS[name].reason(found)


def test_nothing_is_told_from_zero_or_from_the_text() -> None:
    speed = Target("velocity", "ramp.blocks.0")
    assert not reason("degenerate", candidate(ramp(), AtTime(0.5), speed))
    assert "zero" in reason("degenerate", candidate(ramp(), AtTime(0.5), speed, 1e-4))
    assert "zero" in reason("degenerate", candidate(ramp(angle=10.0, friction=0.7), AtTime(0.5), speed))
    assert "stated" in reason("degenerate", candidate(ramp(speed=3.0), AtStart(), speed))
    assert "stated" in reason("degenerate", candidate(table(), AtTime(0.1), Target("velocity", LEFT)))
    assert not reason("degenerate", candidate(table(), AtTime(0.9), Target("velocity", LEFT), -0.3))


def test_what_a_hit_has_not_changed_yet_is_no_question() -> None:
    slow = table(speed=1.37)
    momentum = Target("momentum", LEFT)
    assert "changes" in reason("degenerate", candidate(slow, Collided(BOTH, after=False), momentum, 1.37))
    assert not reason("degenerate", candidate(table(speed=2.0), Collided(BOTH, after=True), momentum, 0.4))


def test_a_distance_that_the_question_states_is_no_answer() -> None:
    same = candidate(atwood(), Moved(BLOCK, 0.83), Target("displacement", OTHER))
    assert "stated" in reason("degenerate", same)
    assert not reason("degenerate", candidate(atwood(), Moved(BLOCK, 0.83), Target("velocity", OTHER)))


def test_a_small_share_of_the_largest_value_is_nothing() -> None:
    found = candidate(atwood(), AtTime(1.0), Target("velocity", BLOCK))
    largest = found.question.answer
    assert not reason("degenerate", replace(found, question=replace(found.question, answer=0.05 * largest)))
    assert reason("degenerate", replace(found, question=replace(found.question, answer=0.005 * largest)))


def test_what_only_one_engine_vouches_for_goes() -> None:
    tension = Target("tension", "tendon_1")
    found = candidate(atwood(), AtTime(0.5), tension)
    assert reason("agreement", found), "no witness was heard"
    certificate = witnessed(found.study.trace)[1]
    assert not reason("agreement", replace(found, certificate=certificate))
    parted = replace(certificate, until={**certificate.until, Channel("tendon_1", "tension"): 0.4})
    assert "disagree" in reason("agreement", replace(found, certificate=parted))
    ended = replace(certificate, stable_until=0.4, reason="the engines part")
    assert reason("agreement", replace(found, certificate=ended)) == "the engines part"


def test_a_distance_that_only_one_engine_sees_covered_goes() -> None:
    found = candidate(atwood(), Moved(BLOCK, 0.5), None)
    certificate = witnessed(found.study.trace)[1]
    assert not reason("agreement", replace(found, certificate=certificate))
    parted = replace(certificate, until={**certificate.until, Channel(BLOCK, "displacement"): 0.1})
    assert "displacement" in reason("agreement", replace(found, certificate=parted))


@pytest.mark.parametrize("after", [True, False])
def test_what_happens_at_an_event_is_vouched_for_beyond_it(after: bool) -> None:
    found = candidate(table(), Collided(BOTH, after=after), Target("velocity", LEFT), 1.0)
    certificate = witnessed(found.study.trace)[1]
    assert not reason("agreement", replace(found, certificate=certificate))
    until = {**certificate.until, Channel(LEFT, "velocity"): 0.39}  # they meet at 0.40 s
    assert reason("agreement", replace(found, certificate=replace(certificate, until=until)))


def test_precision_keeps_what_follows_from_the_digits() -> None:
    assert not reason("precision", candidate(atwood(), AtTime(1.0), Target("velocity", BLOCK)))
    assert not reason("precision", candidate(ramp(friction=0.2), AtTime(1.0), Target("velocity", "ramp.blocks.0")))


def test_precision_drops_a_small_difference_of_large_numbers() -> None:
    nearly = candidate(atwood(5.0, 4.9), AtTime(1.0), Target("velocity", BLOCK))
    assert "condition number" in reason("precision", nearly)


def test_precision_drops_what_hangs_on_the_order_of_events() -> None:
    limit = ramp(angle=30.0, friction=0.577, speed=1.0)  # tan 30° = 0.57735: it just slides back, or just does not
    assert reason("precision", candidate(limit, AtTime(1.9), Target("velocity", "ramp.blocks.0"), 1.0))


def test_only_numbers_that_are_said_are_shifted() -> None:
    paths = {p.path for p in atwood().parameters if shiftable(atwood(), p)}
    assert paths == {f"{BLOCK}.mass", f"{OTHER}.mass", "world.gravity"}
    assert "ramp.plane.friction" not in {p.path for p in ramp().parameters if shiftable(ramp(), p)}
    assert "ramp.plane.friction" in {p.path for p in ramp(friction=0.2).parameters if shiftable(ramp(friction=0.2), p)}


def test_too_many_words_go() -> None:
    found = candidate(ramp(), AtTime(0.5), Target("velocity", "ramp.blocks.0"))
    assert not reason("length", replace(found, prompt="word " * 200))
    assert "words" in reason("length", replace(found, prompt="word " * 300))


def test_the_witness_is_heard_last_and_the_first_verdict_stands() -> None:
    speed = Target("velocity", "ramp.blocks.0")
    assert sift(candidate(ramp(), AtTime(0.5), speed), witnessed=False).keep
    still = candidate(ramp(angle=10.0, friction=0.7), AtTime(0.5), speed)
    assert sift(replace(still, prompt="word " * 900), witnessed=False).filter == "degenerate"
    unheard = sift(candidate(ramp(), AtTime(0.5), speed), witnessed=True)
    assert (unheard.keep, unheard.filter) == (False, "agreement")


def test_a_body_that_stops_is_vouched_for() -> None:
    found = candidate(ramp(angle=20.0, friction=0.6, speed=2.0), Stopped("ramp.blocks.0"), None)
    assert found.question.answer == pytest.approx(2.0 / (G * (np.sin(np.pi / 9) + 0.6 * np.cos(np.pi / 9))), rel=1e-9)
    assert not reason("agreement", replace(found, certificate=witnessed(found.study.trace)[1]))


@pytest.mark.parametrize("count", [1, 2, 3])
def test_a_few_numbers_are_shifted_one_by_one(count: int) -> None:
    assert (np.array(patterns(count)) == np.eye(count)).all()


@pytest.mark.parametrize(("count", "least"), [(4, 0.6), (7, 0.5), (16, 0.25), (24, 0.19)])
def test_shifts_of_all_numbers_measure_their_changes(count: int, least: float) -> None:
    """Of one number that counts nothing is lost, of two that cancel each other three shifts see a share at least."""
    shifts = np.array(patterns(count))
    assert shifts.shape == (precision.ALL, count)
    singles = np.eye(count)
    pairs = [(one + side * other) / 2.0**0.5 for one, other in combinations(singles, 2) for side in (1.0, -1.0)]
    for times in (precision.FIRST, precision.ALL):
        of_one, of_two = (np.mean((np.array(each) @ shifts[:times].T) ** 2, axis=1) ** 0.5 for each in (singles, pairs))
        assert of_one == pytest.approx(1.0)
        assert (of_two > (least if times == precision.FIRST else 0.33)).all()


@pytest.mark.parametrize("seed", range(3))
def test_precision_of_many_numbers_is_about_that_of_each_by_itself(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The condition number of a speed that hangs on more than a few numbers, found in both ways."""
    scene = RECIPES["springs"]("hard", np.random.default_rng(seed))
    subject = next(c.subject for c, q in channels(scene.mechanism) if c.quantity == "velocity")
    found = candidate(scene, AtTime(0.3), Target("velocity", subject))
    assert sum(shiftable(scene, parameter) for parameter in scene.parameters) > precision.FEW
    monkeypatch.setattr(precision, "WORST", 1e-9)
    conditions = list[float]()
    for few in (precision.FEW, 100):
        monkeypatch.setattr(precision, "FEW", few)
        patterns.cache_clear()
        conditions.append(float(reason("precision", found).rpartition(" ")[2]))
    patterns.cache_clear()
    assert conditions[0] == pytest.approx(conditions[1], rel=0.6)
