"""Tests of solutions of questions that compare two bodies: both answers in one text, then the comparison."""

from collections import Counter
from functools import cache

import pytest

from sim2reason.datasets.items import item
from sim2reason.generation.item import Item
from sim2reason.questions import KINDS
from sim2reason.questions.prompt_formats import parse_choice
from sim2reason.solutions import Solution, solve
from sim2reason.solutions.data import as_data
from sim2reason.solutions.solve import setting_of
from sim2reason.solutions.verification import verification_fault

CELLS = [
    ("hybrid", "hard", "which_first"),
    ("collision", "medium", "which_first"),
    ("collision", "medium", "which_greater"),
    ("pulley", "medium", "which_greater"),
    ("incline", "medium", "which_greater"),
]


@cache
def made(recipe: str, difficulty: str, kind: str) -> Item:
    only = {name: float(name == kind) for name in KINDS}
    return item(recipe, difficulty, "choice", seed=1, weights=only, solutions=True)


@cache
def solved(recipe: str, difficulty: str, kind: str) -> Solution:
    told = made(recipe, difficulty, kind)
    return solve(setting_of(parse_choice(told.prompt, told.answer.unit)))


@pytest.mark.parametrize("cell", CELLS)
def test_it_says_which_before_the_number_and_the_letter(cell: tuple[str, str, str]) -> None:
    told = made(*cell)
    assert told.solution is not None, told.unsolved
    *_, concluded, answer, letter = told.solution.text.split("\n\n")
    name = told.answer.texts[told.answer.options.index(told.answer.value)].partition(",")[0]
    assert concluded.startswith("Since $")
    assert f"$, {name} " in concluded
    assert answer.startswith("Answer: ")
    assert letter == rf"That is option $\boxed{{\text{{{told.answer.letter}}}}}$."


@pytest.mark.parametrize("cell", CELLS)
def test_its_data_lead_to_the_number(cell: tuple[str, str, str]) -> None:
    told, found = made(*cell), solved(*cell)
    assert found.answer == pytest.approx(told.answer.value, rel=1e-6), found.reason
    assert verification_fault(as_data(found), setting_of(parse_choice(told.prompt, told.answer.unit))) == ""
    *_, last = found.steps
    assert [relation.role for relation in last.relations] == ["exceeds", "law"]
    assert len(last.needs) == 2


@pytest.mark.parametrize("cell", CELLS)
def test_nothing_is_found_twice_and_no_part_is_spoken_of(cell: tuple[str, str, str]) -> None:
    found = solved(*cell)
    names = Counter(name for step in found.steps for name in step.gives if name in found.values)
    assert names
    assert max(names.values()) == 1
    assert "part (" not in found.text
    assert all(need < step.id for step in found.steps for need in step.needs)
