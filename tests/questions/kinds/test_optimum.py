"""Tests of questions for an extreme over a design: closed forms, both engines, and the text."""

from collections import Counter
from dataclasses import replace
from math import atan, degrees, hypot, pi, sqrt

import numpy as np
import pytest

from motions import orbit
from plain_scenes import arm
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import KINDS, MODES, Query, SimulatedScene, Target, Words
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.kinds.optimum import OptimumQuery
from sim2reason.questions.moments.bounces import Landed
from sim2reason.questions.phrasing import PeriodQuery, sentence
from sim2reason.questions.prompt import parse_prompt, words_of
from sim2reason.questions.query import targets
from sim2reason.questions.sentences import parse_question
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.solutions import solve
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from sim2reason.text.prose.description import describe
from worked import asked

KIND = KINDS["optimum"]
G = 9.8
SPEED, HEIGHT = 8.0, 3.0
RANGE = Target("displacement", "throw.ball")


def thrown(angle: float = 25.0) -> Scene:
    entity = Projectile(ball=Ball(mass=0.5), height=HEIGHT, speed=SPEED, angle=angle)
    return Scene(entities=(Named(name="throw", entity=entity),))


def told(scene: Scene) -> tuple[SimulatedScene, Words]:
    return simulate_scene(scene).study, words_of(describe(scene))


def farthest(*, place: bool) -> OptimumQuery:
    path = "throw.angle"
    return OptimumQuery("optimum", RANGE, Landed("throw.ball"), Query("event"), path, "deg", asks_place=place)


@pytest.mark.parametrize("angle", [25.0, 60.0])
def test_the_angle_of_greatest_range_from_a_height(angle: float) -> None:
    """The best angle is tan θ = v/√(v² + 2 g h), at any angle of the scene."""
    study, _ = told(thrown(angle))
    far = sqrt(SPEED**2 + 2.0 * G * HEIGHT)
    assert KIND.answer(farthest(place=True), study) == pytest.approx(degrees(atan(SPEED / far)), rel=1e-7)
    assert KIND.answer(farthest(place=False), study) == pytest.approx(hypot(SPEED * far / G, HEIGHT), rel=1e-9)


def test_the_distance_of_the_axle_for_the_least_period() -> None:
    """T = 2π √((2 r²/5 + d²)/g d) of a sphere is least at d = r √(2/5)."""
    study, words = told(arm())
    drawn = (KINDS["period"].draw(study, words, {}, np.random.default_rng(seed)) for seed in range(20))
    inner = next(held for held in drawn if isinstance(held, PeriodQuery) and held.small and held.measure == "period")
    query = OptimumQuery("optimum", None, None, inner, "arm.pieces.0.distance", "m", greatest=False)
    best = 0.2 * sqrt(0.4)
    assert KIND.answer(replace(query, about=0.13), study) == pytest.approx(best, rel=1e-7)
    extreme = replace(query, asks_place=False, about=0.13)
    assert KIND.answer(extreme, study) == pytest.approx(2.0 * pi * sqrt(2.0 * best / G), rel=1e-9)


def test_an_extreme_of_the_other_sort_is_none() -> None:
    study, _ = told(thrown())
    assert KIND.answer(replace(farthest(place=True), greatest=False), study) is None


def test_both_engines_vouch_for_it_and_nothing_is_beyond_it() -> None:
    study, _ = told(thrown())
    query = farthest(place=True)
    about = KIND.answer(query, study)
    assert about is not None
    known = KIND.with_likely_answer(query, about)
    assert not KIND.doubt(known, study, None)
    assert KIND.doubt(replace(known, greatest=False, about=0.0), study, None)


@pytest.mark.parametrize("place", [True, False])
def test_the_greatest_range_is_solved_in_a_few_lines(place: bool) -> None:
    setting = asked(thrown(), farthest(place=place))
    found = solve(setting)
    assert found.strategy == "greatest range"
    answer = KIND.answer(farthest(place=place), setting.study)
    assert answer is not None
    assert not faults(found, answer, 1e-7), found.text
    assert not read(found.text).broken


def test_it_is_drawn_reads_back_and_passes_the_filters() -> None:
    search = QuestionSearch(thrown(), 1, "easy")
    refused = Counter[str]()
    found = next(
        found
        for seed in range(12)
        if (found := search.ask(MODES["numeric"], np.random.default_rng(seed), refused, "optimum", 4)) is not None
    )
    assert isinstance(found.question.query, OptimumQuery)
    parsed = parse_prompt(found.prompt)
    assert isinstance(parsed.query, OptimumQuery)
    assert parsed.query.asks_place == found.question.query.asks_place
    assert parsed.answer == pytest.approx(found.question.answer, rel=1e-5)


def test_every_sentence_leads_back() -> None:
    study, words = told(thrown())
    offered, seen = targets(words), set[Query]()
    for seed in range(10):
        query = KIND.draw(study, words, offered, np.random.default_rng(seed))
        if query is None or query in seen:
            continue
        seen.add(query)
        shapes = KIND.shapes(query, words, offered.get(query.target) if query.target is not None else None)
        assert len(set(shapes)) >= 3
        assert {parse_question(sentence(shape), study, words) for shape in shapes} == {query}
    assert seen


def test_a_motion_that_is_not_its_scenes_offers_none() -> None:
    study, words = orbit().told()
    assert KIND.draw(study, words, targets(words), np.random.default_rng(1)) is None
