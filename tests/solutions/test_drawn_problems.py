"""Tests of properties that all worked solutions share, over sampled problems of the covered recipes."""

import random
import re
from dataclasses import replace

import pytest

from sim2reason.questions.difficulty import ELEMENTARY
from sim2reason.solutions import STRATEGIES, ProblemContext, Solution, solve, solve_with
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import WORDS, faults, words
from worked import ANSWERED, problems

COVERED = ("pulley", "incline", "hybrid", "box", "projectile")
DIFFICULTIES = ("easy", "medium", "hard")
COUNT = [2, pytest.param(6, marks=pytest.mark.slow)]  # problems of a cell


@pytest.mark.parametrize("count", COUNT)
@pytest.mark.parametrize("recipe", COVERED)
@pytest.mark.parametrize("difficulty", DIFFICULTIES)
def test_every_problem_of_a_covered_recipe_is_solved_without_a_fault(recipe: str, difficulty: str, count: int) -> None:
    unsolved = list[str]()
    for setting in problems(recipe, difficulty, count):
        solution = solve(setting)
        if solution.answer is None:
            unsolved.append(solution.reason)
            continue
        assert setting.answer is not None
        assert not faults(solution, setting.answer), solution.text
    assert len(unsolved) <= 1, unsolved
    assert all("integration: " in reason for reason in unsolved), unsolved


@pytest.mark.parametrize("count", [1, pytest.param(4, marks=pytest.mark.slow)])
@pytest.mark.parametrize(
    ("recipe", "difficulty"), [("orbital", "easy"), ("orbital", "medium"), ("electromagnetic", "easy")]
)
def test_what_a_strategy_covers_of_the_curved_recipes(recipe: str, difficulty: str, count: int) -> None:
    for kinds in (ANSWERED, ("extremum", "period")):
        for setting in problems(recipe, difficulty, count, kinds=kinds):
            solution = solve(setting)
            assert solution.answer is not None, solution.reason
            assert setting.answer is not None
            assert not faults(solution, setting.answer), solution.text
            if solution.needs <= ELEMENTARY:  # by default recipes label nothing else easy or medium
                assert words(solution.text) <= WORDS[difficulty]


@pytest.mark.parametrize("count", COUNT)
@pytest.mark.parametrize("recipe", ["pendulum", "rotation", "rolling", "electromagnetic", "orbital"])
def test_a_curved_motion_is_solved_without_a_fault_or_says_why_not(recipe: str, count: int) -> None:
    solved = 0
    for difficulty in ("medium", "hard"):
        for setting in problems(recipe, difficulty, count, kinds=("start", "event", "extremum")):
            solution = solve(setting)
            if solution.answer is None:
                assert solution.reason
                continue
            assert setting.answer is not None
            assert not faults(solution, setting.answer), solution.text
            reading = read(solution.text)
            assert not reading.unread
            assert not reading.broken, reading.broken
            solved += 1
    assert solved >= 2 * count // 3


@pytest.mark.parametrize("count", COUNT)
@pytest.mark.parametrize("difficulty", DIFFICULTIES)
def test_a_collision_is_solved_without_a_fault_or_says_why_not(difficulty: str, count: int) -> None:
    for setting in problems("collision", difficulty, count):
        solution = solve(setting)
        if solution.answer is None:
            assert "accelerations change as it moves" in solution.reason  # a spring
        else:
            assert setting.answer is not None
            found = [
                fault for fault in faults(solution, setting.answer) if not (asks_a_pair(setting) and "superf" in fault)
            ]
            assert not found, solution.text


def asks_a_pair(setting: ProblemContext) -> bool:
    """Return whether the question is about a distance or relative speed, which needs no momentum."""
    return setting.query.target is not None and setting.query.target.quantity in ("distance", "relative speed")


@pytest.mark.parametrize("count", [1, pytest.param(3, marks=pytest.mark.slow)])
@pytest.mark.parametrize("difficulty", DIFFICULTIES)
def test_the_text_alone_says_equalities_that_hold_and_is_no_longer_than_it_may(difficulty: str, count: int) -> None:
    for recipe in COVERED:
        for setting in problems(recipe, difficulty, count):
            text = solve(setting).text
            if not text:  # no strategy states all that is needed
                continue
            reading = read(text)
            assert reading.equalities
            assert not reading.unread
            assert not reading.broken, reading.broken
            assert words(text) <= WORDS[difficulty], text


def test_planted_faults_are_found_in_the_text_alone() -> None:
    caught = planted = 0
    rng = random.Random(5)
    for recipe in COVERED:
        for setting in problems(recipe, "medium", 6):
            text = solve(setting).text
            for fault in faulty(text, rng):
                reading = read(fault)
                planted += 1
                caught += bool(reading.broken or reading.unread)
    assert planted >= 50
    assert caught >= 0.95 * planted


def faulty(text: str, rng: random.Random) -> list[str]:
    """Return copies of a text, one with a number 7 % larger and one with a reversed sign."""
    numbers = list(re.finditer(r"\d+\.\d{2,}", text))
    signs = list(re.finditer(r" [+-] (?=[^$]*\$)", text))
    found: list[str] = []
    if numbers:
        held = rng.choice(numbers)
        places = len(held[0].split(".")[1])
        found.append(f"{text[: held.start()]}{1.07 * float(held[0]):.{places}f}{text[held.end() :]}")
    if signs:
        held = rng.choice(signs)
        found.append(text[: held.start()] + (" - " if "+" in held[0] else " + ") + text[held.end() :])
    return found


@pytest.mark.parametrize("count", [3, pytest.param(8, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("recipe", "difficulty"), [("pulley", "hard"), ("hybrid", "easy"), ("box", "medium")])
def test_strategies_check_each_other(recipe: str, difficulty: str, count: int) -> None:
    """All derivations of a problem agree to 1e-9 and have no faults; most problems have two."""
    both = several = 0
    for setting in problems(recipe, difficulty, count):
        held = [solve_with(strategy, setting) for strategy in STRATEGIES.values() if not strategy.integrates]
        found: list[Solution] = [solution for solution in held if solution.answer is not None]
        several, both = several + 1, both + (len(found) > 1)
        assert setting.answer is not None
        for solution in found:
            assert solution.answer == pytest.approx(found[0].answer, rel=1e-9)
            assert not faults(solution, setting.answer), solution.text
    assert 2 * both >= several


@pytest.mark.parametrize("recipe", ["springs", "pendulum", "orbital"])
def test_what_no_strategy_covers_says_so(recipe: str) -> None:
    for setting in problems(recipe, "easy", 2):
        solution = solve(setting)
        if solution.answer is None:
            assert solution.reason
            assert not solution.text


def test_a_kind_that_no_strategy_answers_says_so() -> None:
    setting = next(iter(problems("pulley", "easy", 4)))
    other = replace(setting, query=replace(setting.query, kind="guess"))
    assert solve(other).reason == "no strategy applies: none has a way to the kind guess"
