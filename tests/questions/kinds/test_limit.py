"""Tests of questions for a limit: closed forms, both engines, solutions, and the text."""

from collections import Counter
from dataclasses import replace
from math import isclose, radians, sin

import numpy as np
import pytest

from motions import orbit
from plain_scenes import G, atwood, half_atwood
from sim2reason.generation.item_search import sample
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import KINDS, MODES, Query, SimulatedScene, Target, Words
from sim2reason.questions.kinds.limit import LimitQuery
from sim2reason.questions.moments.times import AllAlong
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import targets
from sim2reason.questions.sentences import parse_question
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.certify import certify_trace
from sim2reason.simulation.scenes import simulate
from sim2reason.solutions import solve
from sim2reason.solutions.closed_forms import closed_form
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from sim2reason.text.prose.description import describe
from worked import asked

KIND = KINDS["limit"]


def told(scene: Scene) -> tuple[SimulatedScene, Words]:
    return SimulatedScene(scene, simulate(scene)), words_of(describe(scene))


def of_mass(scene: Scene, target: Target, mass: float) -> LimitQuery:
    path = next(p.path for p in scene.parameters if p.value == mass and p.measure.name == "mass")
    return LimitQuery("limit", target, AllAlong(), Query("start"), path)


def moving(scene: Scene) -> str:
    return next(body.name for body in scene.mechanism.bodies if body.coordinates)


def string(scene: Scene) -> str:
    return scene.mechanism.strings[0].name


def test_an_atwood_machine_whose_heavier_mass_grows_falls_freely() -> None:
    """The limits for large M are a = g (M − m)/(M + m) → g and T = 2 M m g/(M + m) → 2 m g; for m → 0, a → g."""
    scene = atwood(3.0, 2.0)
    study, _ = told(scene)
    acceleration, tension = Target("acceleration", moving(scene)), Target("tension", string(scene))
    assert KIND.answer(of_mass(scene, acceleration, 3.0), study) == pytest.approx(G, rel=1e-9)
    assert KIND.answer(of_mass(scene, tension, 3.0), study) == pytest.approx(4.0 * G, rel=1e-9)
    small = replace(of_mass(scene, acceleration, 2.0), large=False)
    assert KIND.answer(small, study) == pytest.approx(G, rel=1e-9)


def test_the_tension_beside_a_heavy_load_is_solved_as_a_formula() -> None:
    """T = M m g (1 + sin θ)/(M + m) becomes m g (1 + sin θ)."""
    scene = half_atwood()
    query = of_mass(scene, Target("tension", string(scene)), 3.0)
    setting = asked(scene, query)
    expected = 2.0 * G * (1.0 + sin(radians(30.0)))
    assert KIND.answer(query, setting.study) == pytest.approx(expected, rel=1e-9)
    found = solve(setting)
    assert found.strategy == "limit"
    assert not faults(found, expected, 1e-8)
    assert not read(found.text).broken
    light = next(p for p in scene.parameters if p.value == 2.0 and p.measure.name == "mass")
    form = closed_form(found)
    numbers = {name: found.values[name] for name in form.symbols}
    symbol = setting.lexicon.givens[light.path].symbol
    assert isclose(form.value({**numbers, symbol: 5.0}), 2.5 * expected)


def test_what_vanishes_or_grows_without_bound_has_no_limit() -> None:
    """The tension beside a vanishing mass is zero, and the kinetic energy of a growing mass is unbounded."""
    scene = half_atwood()
    study, words = told(scene)
    for seed in range(20):
        query = KIND.draw(study, words, targets(words), np.random.default_rng(seed))
        answer = KIND.answer(query, study) if query is not None else 1.0
        assert answer is not None
        assert answer > 0.0
    none = replace(of_mass(scene, Target("tension", string(scene)), 2.0), large=False)
    limit = KIND.answer(none, study)
    assert limit is None or abs(limit) < 1e-6


def test_both_engines_vouch_for_it_and_every_sentence_leads_back() -> None:
    study, words = told(half_atwood())
    offered, seen = targets(words), set[Query]()
    for seed in range(30):
        query = KIND.draw(study, words, offered, np.random.default_rng(seed))
        if query is None or query in seen:
            continue
        seen.add(query)
        shapes = KIND.shapes(query, words, offered[query.target] if query.target is not None else None)
        assert len(set(shapes)) >= 3
        assert {parse_question(sentence(shape), study, words) for shape in shapes} == {query}
    trace, certificate = certify_trace(study.trace)
    assert any(not KIND.doubt(query, SimulatedScene(study.scene, trace), certificate) for query in seen)
    query = next(iter(seen))
    assert KIND.doubt(replace(query, large=False), SimulatedScene(study.scene, trace), None)  # type: ignore[call-arg]


@pytest.mark.parametrize("seeds", [6, pytest.param(30, marks=pytest.mark.slow)])
@pytest.mark.parametrize("mode", ["numeric", "symbolic"])
def test_limits_are_drawn_and_solved(mode: str, seeds: int) -> None:
    found = []
    for seed in range(seeds):
        search = QuestionSearch(sample("pulley", seed=seed), seed)
        question = search.ask(MODES[mode], np.random.default_rng(seed), Counter(), "limit", 2)
        found += [question] if question is not None else []
    assert found
    for question in found:
        solution = solve(question.setting)
        assert solution.answer == pytest.approx(question.question.answer, rel=1e-6), solution.reason


def test_a_motion_that_is_not_its_scenes_offers_none() -> None:
    study, words = orbit().told()
    assert KIND.draw(study, words, targets(words), np.random.default_rng(1)) is None
