"""Tests of questions that give a limit and ask for another number, against statics and energy conservation."""

from math import asin, cos, degrees, radians, sin

import numpy as np
import pytest

from plain_scenes import half_atwood
from sim2reason.errors import TextError
from sim2reason.generation.make import make
from sim2reason.generation.modes.problem_formula import likely_answers
from sim2reason.generation.modes.reverse import why_undetermined
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.request import Request
from sim2reason.questions import MODES, Question
from sim2reason.questions.dependence import AnswerFunction
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.outcomes import OUTCOMES
from sim2reason.questions.prompt import parse_prompt, prompt
from sim2reason.questions.study import COARSE_STEP_ERROR
from sim2reason.scenes.bodies.oscillators import Ball, LightRod
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum
from sim2reason.text.prose.description import describe
from sim2reason.text.prose.voices import symbolic_at

REVERSE = MODES["reverse"]
HANGING, SLOPING, ANGLE = "other.system.blocks.0.mass", "ramp.blocks.0.mass", "ramp.plane.angle"
FORM = r"Give your answer in N, to three significant figures, inside \boxed{}."
HEAVIEST = ThresholdQuery(
    "threshold", None, None, OUTCOMES["rises"]("ramp.blocks.0"), HANGING, "kg", greatest=True, happens=False
)


def pendulum(angle: float) -> Scene:
    entity = Pendulum(bob=Ball(mass=0.5), hanger=LightRod(length=1.2), angle=angle, speed=2.0)
    return Scene(entities=(Named(name="p", entity=entity),))


def asked(scene: Scene, outcome: str, parameter: str) -> list[Question]:
    """Return questions that give the limit of one number."""
    search = QuestionSearch(scene, 0)
    drawn = (REVERSE.ask(search.study, search.words, "threshold", np.random.default_rng(seed)) for seed in range(60))
    held = [(q, q.query) for q in drawn if q is not None and q.query.hides == parameter]
    wanted = OUTCOMES[outcome]
    return [q for q, query in held if isinstance(query, ThresholdQuery) and isinstance(query.outcome, wanted)]


def test_a_slope_follows_from_the_heaviest_that_its_block_holds() -> None:
    """m_B g = m_A g sin θ at the limit determines either of the other numbers."""
    found = asked(half_atwood(), "rises", HANGING)
    assert {question.unknown for question in found} == {SLOPING, ANGLE}
    for question in found:
        assert question.given is not None
        given = question.given.value
        expected = given / sin(radians(30.0)) if question.unknown == SLOPING else degrees(asin(given / 2.0))
        assert question.answer == pytest.approx(expected, rel=1e-6)


def test_an_angle_follows_from_the_speed_that_goes_right_round() -> None:
    """½ v² = g ℓ (1 + cos θ) at the limit."""
    found = [question for question in asked(pendulum(60.0), "goes_round", "p.speed") if question.unknown == "p.angle"]
    assert found
    for question in found:
        assert question.given is not None
        assert cos(radians(question.answer)) == pytest.approx(question.given.value**2 / (2.0 * 9.8 * 1.2) - 1.0)


@pytest.mark.parametrize("error", [COARSE_STEP_ERROR, 0.0])
def test_a_formula_only_says_where_to_look(error: float) -> None:
    """With a correct formula two motions are enough; with a wrong one the limit is found as well."""
    search = QuestionSearch(half_atwood(), 0)
    likely = likely_answers(HEAVIEST, search.study, search.words, SLOPING)
    assert likely is not None
    assert likely(5.0) == pytest.approx(2.5)
    wrong = AnswerFunction(HEAVIEST, search.study, SLOPING, error or 1e-8, likely=lambda value: 1.1 * likely(value))
    right = AnswerFunction(HEAVIEST, search.study, SLOPING, error or 1e-8, likely=likely)
    for dependence in (right, wrong):
        assert dependence(5.0) == pytest.approx(2.5, rel=1e-5 if error else 1e-8)


def test_two_slopes_that_hold_as_much_are_told_apart_from_one() -> None:
    """The sine repeats beyond a right angle only, so the limit determines the angle within its range."""
    scene = half_atwood()
    search = QuestionSearch(scene, 0)
    question = next(q for q in asked(scene, "rises", HANGING) if q.unknown == ANGLE)
    assert why_undetermined(question, REVERSE.study(question, search.study), search.words) == ""


def test_a_prompt_leaves_two_numbers_open() -> None:
    """The text states neither number, but determines the one that is asked for."""
    scene = half_atwood()
    question = next(q for q in asked(scene, "rises", HANGING) if q.unknown == ANGLE)
    description = describe(scene)
    told = REVERSE.described(question, description)
    text = prompt(told, question, np.random.default_rng(0))
    assert "3 kg" not in text
    assert "30°" not in text
    read = parse_prompt(text)
    assert read.query.kind == "threshold"
    assert {path.rpartition(".")[2] for path in read.reading.unknown} == {"mass", "angle"}
    assert read.answer == pytest.approx(question.answer, rel=1e-4)


def test_two_open_numbers_need_a_question_about_a_limit() -> None:
    """Any other question would lack the second number."""
    told = describe(half_atwood()).voiced(symbolic_at(HANGING, ANGLE))
    with pytest.raises(TextError, match="it does not tell"):
        parse_prompt(f"{told.text} What is the tension in the string? {FORM}")


@pytest.mark.parametrize(("recipe", "index"), [("pulley", 1), ("box", 5), ("hybrid", 3)])
def test_items_say_whose_limit_they_give(recipe: str, index: int) -> None:
    """The limit's number does not affect which problems are variants, and the solution ends in the answer."""
    weights = (("threshold", 1e6),)
    item = make(Request(recipe, "medium", "reverse", 5, index, weights=weights, solutions=True)).item
    assert item is not None
    assert item.kind == "threshold"
    assert item.asked.limit_of not in (None, item.asked.unknown)
    assert item.solution is not None
    assert item.solution.strategy == "limiting case"
    assert f"{item.answer.value:.3g}" in item.solution.text
