"""Tests of questions on how the answer to another question depends on a number."""

import re
from collections import Counter
from collections.abc import Iterator
from math import isclose

import numpy as np
import pytest

from plain_scenes import atwood, ramp, row
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.generation.certified import CertifiedQuestion
from sim2reason.generation.item_search import sample
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import MODES, Query, SimulatedScene, Target
from sim2reason.questions.difficulty import ELEMENTARY
from sim2reason.questions.kinds.comparison import ComparisonQuery
from sim2reason.questions.kinds.nested import without_target_and_moment
from sim2reason.questions.moments.times import AllAlong
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import NailedSpring
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.spring_blocks import SpringBlock
from sim2reason.solutions import Solution, solve
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.closed_forms import closed_form
from sim2reason.solutions.derivation import may_have_solution
from sim2reason.solutions.laws.nested import insertion_sentence
from sim2reason.solutions.writing.steps import SolutionBuilder
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import RTOL_BY_KIND, faults
from worked import asked

V, T, S = map(Symbol, ("v", "t", "s"))


def test_a_comparison_puts_the_other_value_into_the_formula() -> None:
    scene = atwood(3.0, 2.0)
    body = next(body.name for body in scene.mechanism.bodies if body.coordinates)
    inner = Query("start", Target("acceleration", body), AllAlong())
    path = next(p.path for p in scene.parameters if p.value == 3.0 and p.measure.name == "mass")
    query = ComparisonQuery("comparison", inner.target, inner.moment, without_target_and_moment(inner), path)
    setting = asked(scene, query)
    found = solve(setting)
    assert found.answer == pytest.approx(2.5, rel=1e-9)
    assert found.strategy == "comparison"
    one, other = (
        next(p.path for p in scene.parameters if p.value == value and p.measure.name == "mass") for value in (3.0, 2.0)
    )
    heavy, light = (setting.lexicon.givens[path].symbol for path in (one, other))
    form = closed_form(found)
    assert {*form.symbols} == {heavy, light}
    assert isclose(form.value({heavy: 5.0, light: 1.0}), (9.0 / 11.0) / (4.0 / 6.0))


def drawn(mode: str, kind: str, recipe: str, count: int) -> Iterator[CertifiedQuestion]:
    for seed in range(count):
        try:
            search = QuestionSearch(sample(recipe, seed=seed), seed)
            found = search.ask(MODES[mode], np.random.default_rng(seed), Counter(), kind, 2)
        except (SceneError, SimulationError, UnsupportedError):
            continue
        if found is not None:
            yield found


FEW = {"pulley": 7, "hybrid": 4, "rolling": 10, "collision": 5, "chain": 4}
"""Scenes of a recipe of which at least one offers a comparison."""


@pytest.mark.parametrize(
    ("recipe", "scenes"), [*FEW.items(), *(pytest.param(recipe, 12, marks=pytest.mark.slow) for recipe in FEW)]
)
def test_drawn_comparisons_are_solved_and_every_relation_holds(recipe: str, scenes: int) -> None:
    count = 0
    for found in drawn("numeric", "comparison", recipe, scenes):
        solution = solve(found.setting)
        assert solution.answer is not None, (found.prompt, solution.reason)
        assert not faults(solution, found.question.answer, RTOL_BY_KIND.get("comparison", 1e-9)), solution.text
        assert not read(solution.text).broken
        count += 1
    assert count


def test_it_is_said_what_is_inserted_before_the_other_value_is_put_in() -> None:
    book = SolutionBuilder()
    for name, value in {"v": 2.0, "t": 3.0}.items():
        book.set_value(name, value)
    for name, formula in {"s": V * T, "w": S * V}.items():
        book.add_step("law", "So", Symbol(name), formula)
    assert (
        insertion_sentence(book, "w", "$w = v^{2} t$") == "Inserting $s$ into the equation for $w$ gives $w = v^{2} t$."
    )
    assert insertion_sentence(book, "s", "$s = v t$") == "In short, $s = v t$."


@pytest.mark.parametrize(
    ("recipe", "scenes"),
    [
        ("rolling", 4),
        ("incline", 1),
        *(pytest.param(recipe, 24, marks=pytest.mark.slow) for recipe in ("pulley", "rolling", "incline")),
    ],
)
def test_drawn_comparisons_in_symbols_are_solved_in_symbols(recipe: str, scenes: int) -> None:
    formulas = list(drawn("symbolic", "comparison", recipe, scenes))
    assert formulas
    for found in formulas:
        solution = solve(found.setting)
        assert solution.answer == pytest.approx(found.question.answer, rel=1e-6)
        assert found.question.formula is not None
        assert solution.formula == found.question.formula.latex


def doubling_the_speed(scene: Scene, verb: str, what: str) -> Solution:
    """Return the solution of a question about a block with twice the initial speed."""
    how = "By what factor" if verb == "multiply" else "By how much"
    return solve(asked(scene, f"{how} would doubling the initial speed, and nothing else, {verb} {what}?"))


def test_another_value_is_multiplied_out_of_powers() -> None:
    scene = ramp(angle=30.0, friction=0.2, speed=3.0)
    found = doubling_the_speed(scene, "multiply", "the speed of the block after it has moved 0.10 m")
    assert found.strategy == "comparison"
    assert r"4\,v^{2}" in found.text
    assert r"\left(2\,v\right)^{2}" not in found.text


def test_the_second_of_two_cases_is_told_after_the_first() -> None:
    """The block turns back before the given time in the first case, but not with twice the speed."""
    scene = ramp(angle=26.0, friction=0.0, speed=2.5)
    way = "the total distance that the block travels between t = 0 and t = 0.89 s"
    found = doubling_the_speed(scene, "increase", way)
    assert found.strategy == "comparison of two cases"
    before, after = found.text.split(r"With $v$ doubled", 1)
    assert "It turns back" in before
    assert "It would turn back only after" in after
    assert "a_1" not in found.text  # the acceleration is that of the first case


def test_what_no_strategy_has_a_way_to_is_known_before_it_is_drawn() -> None:
    """The position of a puck on two springs at a given time needs an integration; the forces at the start do not."""
    springs = tuple(NailedSpring(stiffness=80.0, length=0.4, x=x, y=0.1) for x in (-0.3, 0.5))
    entity = SpringBlock(block=Block(mass=1.5), springs=springs, x=0.2, y=0.6)
    scene = Scene(entities=(Named(name="springs", entity=entity),))
    study = SimulatedScene.of(scene, np.linspace(0.0, 1.0, 5))
    assert not may_have_solution("state", study, ELEMENTARY)
    assert may_have_solution("start", study, ELEMENTARY)


def test_what_the_first_case_rests_on_is_shown_of_the_second_too() -> None:
    """With half the stiffness the initial spring force still exceeds the greatest static friction."""
    scene = row((1.8,), (132.0,), "right", friction=0.32, strain=0.2)
    path = next(p.path for p in scene.parameters if p.measure.name == "stiffness")
    trolley = next(body.name for body in scene.mechanism.bodies if body.mass)
    inner = Query("event", Target("displacement", trolley), Stopped(trolley))
    query = ComparisonQuery(
        "comparison", inner.target, inner.moment, without_target_and_moment(inner), path, 0.5, False, False
    )
    told = solve(asked(scene, query)).text
    assert re.search(
        r"With \$k\$ halved, \$F_\{0,\\text\{new\}\} = [^$]*\$ still exceeds \$f_\{\\text\{max\}\}\$", told
    )
