"""Tests of items with options: the letter is right in any unit, and the question reads back without options."""

from collections import Counter
from functools import cache
from itertools import pairwise
from pathlib import Path

import pytest

from sim2reason import rewards
from sim2reason.datasets.exports import EXPORTS, RowPosition
from sim2reason.datasets.grade import grade
from sim2reason.datasets.items import item
from sim2reason.datasets.store import read, write
from sim2reason.generation.item import Answer, Distractor, Item
from sim2reason.generation.options import OPTION_RTOL, REQUIRED_DISTRACTORS, item_options, options, values
from sim2reason.grading import Outcome
from sim2reason.questions.prompt_formats import LETTERS, ChoicePrompt, parse_choice
from sim2reason.scenes.dsl.measures import join_unit

CELLS = [("pulley", "easy", 0), ("rotation", "medium", 0), ("hybrid", "hard", 1)]


@cache
def made(recipe: str, difficulty: str, index: int, units: str = "SI") -> Item:
    return item(recipe, difficulty, "choice", seed=5, index=index, units=units, solutions=True)


@pytest.mark.parametrize("units", ["SI", "cgs", "mixed"])
@pytest.mark.parametrize("cell", CELLS)
def test_one_letter_is_right_and_its_number_too(cell: tuple[str, str, int], units: str) -> None:
    told = made(*cell, units)
    letters = LETTERS[: len(told.answer.options)]
    assert len(letters) > REQUIRED_DISTRACTORS
    assert told.answer.options[letters.index(told.answer.letter)] == told.answer.value
    for letter, value in zip(letters, told.answer.options, strict=True):
        right = float(letter == told.answer.letter)
        assert grade(told, rewards.boxed(letter)).reward == right
        assert grade(told, rewards.boxed(f"{value:.4g}")).reward == right
        assert grade(told, rewards.boxed(rf"{letter}. {value:.4g}")).reward == right
    assert grade(told, rewards.boxed("".join(letters))).outcome == Outcome.UNREADABLE
    assert grade(told, rewards.boxed(rewards.answered(told))).reward == 1.0
    assert len(ChoicePrompt.read(told.prompt).options) == len(letters)
    if told.solution is not None:
        assert grade(told, told.solution.text).reward == 1.0


@pytest.mark.parametrize("cell", CELLS)
def test_options_are_wrong_ideas_with_reasons_and_a_tenth_apart(cell: tuple[str, str, int]) -> None:
    told = made(*cell)
    chosen = item_options(told)
    assert chosen is not None
    assert values(told.answer, chosen) == list(told.answer.options)
    assert all(wrong is None or (wrong.reason and wrong.simplification) for wrong in chosen)
    ordered = sorted(told.answer.options)
    assert all(b - a > OPTION_RTOL * max(abs(a), abs(b)) for a, b in pairwise(ordered))


@pytest.mark.parametrize("cell", CELLS)
def test_it_reads_back_as_the_question_without_options(cell: tuple[str, str, int]) -> None:
    told = made(*cell)
    parsed = parse_choice(told.prompt, told.answer.unit)
    assert parsed.query.kind == told.kind
    assert parsed.answer == pytest.approx(told.answer.value, rel=1e-6)


def test_they_travel_through_files_and_exports(tmp_path: Path) -> None:
    items = [made(*cell) for cell in CELLS]
    write(tmp_path / "shard.parquet", items)
    assert read(tmp_path / "shard.parquet") == items
    for told in items:
        row = EXPORTS["multiple-choice"].row(told, RowPosition("train", 0))
        assert row is not None
        assert (row["answer"], row["prompt"][0]["content"]) == (told.answer.letter, told.prompt)
        assert [not reason for reason in row["reasons"]].index(True) == LETTERS.index(told.answer.letter)
        assert rewards.score(rewards.ground_truth(told), rewards.boxed(told.answer.letter)).reward == 1.0
        assert join_unit(row["choices"][row["label"]].split()[0], told.answer.unit) == row["choices"][row["label"]]


def test_too_few_or_too_close_wrong_answers_make_no_choice() -> None:
    wrong = [Distractor(value=value, simplification="x", reason="X.") for value in (1.0, 1.05, 2.0, 2.1, 3.0, -1.0)]
    answer = Answer(value=1.5, unit="N")
    assert options(answer, wrong[:4], "name") is None, "two pairs that are too close to each other"
    assert options(answer, wrong, "name") is not None
    assert options(answer.model_copy(update={"value": 2.05}), wrong[:3], "name") is None


def test_a_guess_is_right_as_often_at_each_place() -> None:
    """Among 1000 items each of five places has the right answer 200 times; five standard deviations are 63."""
    wrong = [Distractor(value=value, simplification="x", reason="X.") for value in (1.0, 2.0, 3.0, 4.0)]
    found = [options(Answer(value=1.5, unit="N"), wrong, f"item-{n}") for n in range(1000)]
    places = Counter(chosen.index(None) for chosen in found if chosen is not None)
    assert sorted(places) == [0, 1, 2, 3, 4]
    assert all(137 < count < 263 for count in places.values())
