"""Tests of comparisons of two answers: closed forms, unsuitable questions, and the text."""

from collections import Counter
from dataclasses import replace
from itertools import islice
from math import cos, radians, sin

import numpy as np
import pytest

from motions import orbit
from plain_scenes import G, atwood, half_atwood, ramp
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import KINDS, MODES, Query, SimulatedScene, Target, Words
from sim2reason.questions.kinds.comparison import ComparisonQuery
from sim2reason.questions.kinds.nested import without_target_and_moment
from sim2reason.questions.moments.times import AllAlong, AtTime
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import targets
from sim2reason.questions.sentences import parse_question
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.certify import certify_trace
from sim2reason.simulation.scenes import simulate
from sim2reason.text.prose.description import describe

KIND = KINDS["comparison"]


def told(scene: Scene) -> tuple[SimulatedScene, Words]:
    return SimulatedScene(scene, simulate(scene)), words_of(describe(scene))


def comparing(inner: Query, path: str, factor: float = 2.0) -> ComparisonQuery:
    return ComparisonQuery("comparison", inner.target, inner.moment, without_target_and_moment(inner), path, factor)


def answer(query: ComparisonQuery, scene: Scene) -> float:
    found = KIND.answer(query, told(scene)[0])
    assert found is not None
    return found


def moving(scene: Scene) -> str:
    return next(body.name for body in scene.mechanism.bodies if body.coordinates)


def test_the_acceleration_of_an_atwood_machine_with_its_heavier_mass_doubled() -> None:
    """a = g (M − m)/(M + m), M = 3 kg and m = 2 kg, becomes g (2 M − m)/(2 M + m)."""
    scene = atwood(3.0, 2.0)
    inner = Query("start", Target("acceleration", moving(scene)), AllAlong())
    path = next(p.path for p in scene.parameters if p.value == 3.0 and p.measure.name == "mass")
    assert answer(comparing(inner, path), scene) == pytest.approx((4.0 / 8.0) / (1.0 / 5.0), rel=1e-9)
    difference = replace(comparing(inner, path), ratio=False)
    assert answer(difference, scene) == pytest.approx(G * (0.5 - 0.2), rel=1e-9)
    assert answer(replace(difference, grows=False), scene) == pytest.approx(-G * (0.5 - 0.2), rel=1e-9)


def test_the_way_up_a_rough_slope_with_its_friction_halved() -> None:
    """The distance is v²/2g(sin θ + µ cos θ)."""
    scene = ramp(angle=30.0, friction=0.4, speed=2.0)
    inner = Query("event", Target("displacement", moving(scene)), Stopped(moving(scene)))
    path = next(p.path for p in scene.parameters if p.measure.name == "friction")
    whole, half = (sin(radians(30.0)) + mu * cos(radians(30.0)) for mu in (0.4, 0.2))
    assert answer(comparing(inner, path, 0.5), scene) == pytest.approx(whole / half, rel=1e-9)


def test_what_is_proportional_is_not_compared() -> None:
    """The speed of a block on a smooth slope, after a time or a distance, is proportional in all but the angle."""
    study, words = told(ramp())
    offered = targets(words)
    drawn = [KIND.draw(study, words, offered, np.random.default_rng(seed)) for seed in range(40)]
    found = [query for query in drawn if isinstance(query, ComparisonQuery)]
    assert {query.path.rpartition(".")[2] for query in found} <= {"angle"}


def test_both_motions_are_vouched_for_and_the_second_one_may_be_refused() -> None:
    study, words = told(half_atwood())
    offered = targets(words)
    queries = (KIND.draw(study, words, offered, np.random.default_rng(seed)) for seed in range(40))
    query = next(query for query in queries if isinstance(query, ComparisonQuery) and query.inner.kind == "event")
    seen, certificate = certify_trace(study.trace)
    assert not KIND.doubt(query, SimulatedScene(study.scene, seen), certificate)
    nowhere = replace(query, factor=1e9)
    assert KIND.doubt(nowhere, SimulatedScene(study.scene, seen), certificate)


def test_every_sentence_is_unambiguous_and_leads_back() -> None:
    study, words = told(half_atwood())
    offered = targets(words)
    queries = (KIND.draw(study, words, offered, np.random.default_rng(seed)) for seed in range(60))
    found = list(islice((query for query in queries if query is not None), 12))
    assert {query.ratio for query in found if isinstance(query, ComparisonQuery)} == {True, False}
    for query in found:
        noun = offered[query.target] if query.target is not None else None
        shapes = KIND.shapes(query, words, noun)
        assert len(set(shapes)) >= 3
        assert {parse_question(sentence(shape), study, words) for shape in shapes} == {query}


def test_a_motion_that_is_not_its_scenes_offers_none() -> None:
    study, words = orbit().told()
    assert KIND.draw(study, words, targets(words), np.random.default_rng(1)) is None


def test_at_a_stated_time_both_cases_are_looked_at_then() -> None:
    scene = atwood(3.0, 2.0)
    study, _ = told(scene)
    path = next(p.path for p in scene.parameters if p.value == 2.0 and p.measure.name == "mass")
    query = comparing(Query("state", Target("velocity", moving(scene)), AtTime(0.5)), path, 0.5)
    assert KIND.time(query, study) == 0.5
    assert KIND.answer(query, study) == pytest.approx((2.0 / 4.0) / (1.0 / 5.0), rel=1e-9)


def test_search_finds_comparisons_that_pass_the_filters() -> None:
    search = QuestionSearch(half_atwood(), 1)
    found = search.ask(MODES["numeric"], np.random.default_rng(3), Counter(), "comparison", 8)
    assert found is not None
    assert found.question.query.kind == "comparison"


def test_an_instant_is_not_compared() -> None:
    """Half of the inner questions of this scene are about instants."""
    study, words = told(half_atwood())
    drawn = [KIND.draw(study, words, targets(words), np.random.default_rng(seed)) for seed in range(40)]
    compared = [query for query in drawn if query is not None]
    assert compared
    assert not any(isinstance(query.moment, AtTime) for query in compared)
