"""Tests of solutions in the form that problems ask for: other units, symbols, and few sentences."""

from dataclasses import replace
from functools import cache
from math import pi

import numpy as np
import pytest

from plain_scenes import atwood, row
from sim2reason.datasets.grade import grade
from sim2reason.generation.certified import worked_solution
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.make import build_item
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.request import Request
from sim2reason.questions import MODES, Query, Question, StatedResult, Target
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.questions.spoken_units import CGS, SI
from sim2reason.scenes.bodies.charges import ChargedBead, Launched
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.scenes.entities.fields import UniformMagnetic
from sim2reason.scenes.entities.particles import EmEntity
from sim2reason.solutions import ProblemContext, Solution, solve, solve_prompt
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.algebra.fractions import CrossElimination, SymbolicEquation
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.solution import convert_answer
from sim2reason.solutions.writing.arrangement import merge_steps
from sim2reason.solutions.writing.notation import latex, unit_of
from sim2reason.solutions.writing.steps import SolutionBuilder
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from worked import asked

BEAD = "fields.particle"
made = cache(lambda request: ItemSearch(request).find())


def tension() -> Solution:
    return solve(asked(atwood(), "What is the tension in the string just after release?"))


def test_the_answer_is_converted_in_its_last_line() -> None:
    """1 N is 10⁵ dyn."""
    plain = tension()
    told = convert_answer(CGS, plain, "N")
    assert told.text.startswith("Given, in SI units: $")
    assert r"= 23.520\ \text{N} \approx \boxed{2.35 \times 10^{6}}\ \text{dyn}$." in told.text
    assert not read(told.text).broken
    assert not read(told.text).unread
    assert read(told.text.replace("2.35", "2.53")).broken
    assert read(told.text.replace("23.520\\ \\text{N} \\approx", "25.320\\ \\text{N} \\approx")).broken
    assert convert_answer(SI, plain, "N") == plain


def test_an_unknown_with_a_prefix_ends_in_the_unit_of_the_text() -> None:
    """q = 2πm/(TB) = 5.0 µC, with T = 4.0 s given."""
    start, magnetic = Launched(speed=2.0, angle=0.0), UniformMagnetic(strength=2.0 * pi / 10.0, way="positive z")
    fields = EmEntity(magnetic=magnetic, particle=ChargedBead(mass=2.0, charge=5.0, sign="positive"), start=start)
    setting = asked(Scene(entities=(Named(name="fields", entity=fields),)), PeriodQuery("period", of=(BEAD,)))
    solution = solve(replace(setting, unknown=f"{BEAD}.charge", stated=StatedResult("4.0", "s")))
    assert solution.answer == pytest.approx(5.0)
    assert not faults(solution, 5.0)
    assert r"= 5.0000\ \text{µC}$." in solution.text
    assert r"\boxed{5.00}\ \text{µC}$." in solution.text
    assert not read(solution.text).broken


@pytest.mark.parametrize("unit", ["N", "uN s", "mg m/s", "m/s^2", "1/s", "1/s^2", "kg m/s", "deg", ""])
def test_a_unit_is_read_back_from_its_latex(unit: str) -> None:
    assert unit_of(f"1.00{latex(unit)}") == unit


@pytest.mark.parametrize(("recipe", "index"), [("hybrid", 0), ("pendulum", 0)])
def test_a_solution_in_symbols_holds_at_every_binding_and_is_graded_right(recipe: str, index: int) -> None:
    request = Request(recipe, "easy", "symbolic", 0, index)
    item, solution = build_item(request, made(request)), worked_solution(request, made(request))
    assert item.answer.formula is not None
    assert solution.formula == item.answer.formula.latex
    assert grade(item, solution.text).reward == 1.0
    for point in item.answer.formula.points:
        text = read(solution.text, point)
        assert not text.unread
        assert not text.broken, solution.text


def test_a_symbol_of_what_a_text_does_not_tell_is_free_for_its_question() -> None:
    """A relaxed spring is strained by d = 0, which the text omits, so d may denote the cart's displacement."""
    search = QuestionSearch(row((2.0,), (50.0,), "left", speed=1.5), 0)
    query = Query("event", Target("velocity", "row.carts.0"), Moved("row.carts.0", 0.05))
    plain, symbolic = Question("symbolic", query, "", 1.0, "m/s"), MODES["symbolic"]
    question = symbolic.completed(plain, search.study, search.words, np.random.default_rng(0))
    assert question is not None
    text = symbolic.described(question, search.description)
    solution = solve(ProblemContext.from_query(question, search.study, search.words, text))
    assert "d" in solution.values
    assert not solution.text.startswith("Given")
    assert not read(solution.text, {"d": 0.05, "m": 2.0, "k": 50.0, "v": 1.5}).broken


def test_a_prompt_in_other_units_with_an_unknown_is_solved() -> None:
    request = Request("incline", "easy", "reverse", 0, 5, units="cgs")
    item = build_item(request, made(request))
    solution, _ = solve_prompt(item.prompt)
    assert solution.answer is not None, solution.reason
    factor = (
        1.0 if item.answer.unit == "deg" else parse_unit(item.answer.unit).factor
    )  # solutions speak of degrees, too
    expected = item.answer.value * factor
    assert solution.answer == pytest.approx(expected, rel=5e-3)  # the result said is rounded
    assert r"\frac{s}{1}" not in solution.text


def test_like_sentences_that_rest_on_the_same_become_one() -> None:
    book = SolutionBuilder()
    book.set_value("a", 2.0)
    first = book.add_step("speed", "So the speed is", Symbol("u"), Number(3.0) * Symbol("a"))
    book.add_step("after", "After it,", Symbol("x"), 2.0 * first)
    book.add_step("other", "Elsewhere,", Symbol("z"), 5.0 * first)
    book.add_step("after", "After it,", Symbol("y"), 4.0 * first)
    book.add_step("after", "After it,", Symbol("w"), 4.0 * Symbol("z"))
    texts = [step.text for step in merge_steps(book.steps)]
    assert texts == [
        "So the speed is $u = 3 a = 6.0000$.".replace("3 a", "3\\,a"),
        "After it, $x = 2\\,u = 12.000$ and $y = 4\\,u = 24.000$.",
        "Elsewhere, $z = 5\\,u = 30.000$.",
        "After it, $w = 4\\,z = 120.00$.",
    ]


def test_unknowns_are_eliminated_crosswise() -> None:
    """M x + m y = F, m x + n y = G: x = (n F − m G)/(M n − m²)."""
    values = {"M": 5.0, "m": 2.0, "n": 3.0, "F": 7.0, "G": 4.0}
    book = SolutionBuilder(called={})
    for name, value in values.items():
        book.set_value(name, value)
    M, m, n, F, G = (Polynomial.from_expression(Symbol(name)) for name in values)
    equations = [SymbolicEquation("(P)", {"x": M, "y": m}, F), SymbolicEquation("(Q)", {"x": m, "y": n}, G)]
    CrossElimination(book, {"x": "", "y": ""}, book.begin_step).reduce(equations, ["x", "y"])
    x = (3.0 * 7.0 - 2.0 * 4.0) / (5.0 * 3.0 - 4.0)
    assert book.values["x"] == pytest.approx(x, rel=1e-12)
    assert book.values["y"] == pytest.approx((7.0 - 5.0 * x) / 2.0, rel=1e-12)
    text = "\n".join(step.text for step in book.steps)
    assert not any(part.isdigit() for part in text.replace("^{2}", "").replace("(1)", ""))


def test_no_sentence_joins_one_that_stands_before_its_names_are_introduced() -> None:
    """For two blocks in two stages, the accelerations of the second stage stay out of the sentence on the first."""
    book = SolutionBuilder()
    book.set_value("g", 9.8)
    for name in ("a", "b"):
        step = book.begin_step("names")
        step.add_text(f"Let ${name}$ be the acceleration.")
        step.close()
        book.add_step("law", "Along the slope,", Symbol(name), 0.5 * Symbol("g"))
    texts = [step.text for step in merge_steps(book.steps)]
    assert texts == [
        "Let $a$ be the acceleration.",
        r"Along the slope, $a = \tfrac{1}{2} g = 4.9000$.",
        "Let $b$ be the acceleration.",
        r"Along the slope, $b = \tfrac{1}{2} g = 4.9000$.",
    ]
