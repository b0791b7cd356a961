"""Tests of items with several parts: connected parts, parsing, grading, solutions, and files."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from sim2reason import rewards
from sim2reason.datasets.duplicates import marks, variant
from sim2reason.datasets.exports.export import split_parts
from sim2reason.datasets.grade import grade
from sim2reason.datasets.items import item
from sim2reason.datasets.store import read, write
from sim2reason.generation.certified import CertifiedQuestion
from sim2reason.generation.filters import FILTERS
from sim2reason.generation.item import Item
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.part_search import NUMBERS, is_new
from sim2reason.generation.request import Request
from sim2reason.generation.splits import problem
from sim2reason.grading import Outcome
from sim2reason.questions import Query, Question
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.prompt_formats import PartPrompt, parse_parts
from sim2reason.questions.query import Target

CELLS = [
    ("pulley", "easy", 0),
    ("orbital", "medium", 0),
    ("projectile", "hard", 1),
    ("rotation", "medium", 1),
    ("rocket", "easy", 0),
    ("box", "medium", 0),
]


@cache
def made(recipe: str, difficulty: str, index: int) -> Item:
    return item(recipe, difficulty, "multipart", seed=5, index=index, solutions=True)


@cache
def found(recipe: str, difficulty: str, index: int) -> CertifiedQuestion:
    certified = ItemSearch(Request(recipe, difficulty, "multipart", 5, index)).find()
    assert certified is not None
    return certified


@pytest.mark.parametrize("cell", CELLS)
def test_parts_lead_to_each_other_and_each_passes_every_filter(cell: tuple[str, str, int]) -> None:
    told = made(*cell)
    assert 2 <= len(told.parts) <= max(NUMBERS["hard"])
    assert len(told.parts) == len(told.answer.parts)
    assert told.answer.value == told.answer.parts[-1].value
    linked = {number for part in told.parts for number in part.uses}
    assert all(part.uses or number in linked for number, part in enumerate(told.parts))
    assert all(number < place for place, part in enumerate(told.parts) for number in part.uses)
    for part in found(*cell).parts:
        candidate = part.certified.candidate
        assert not [name for name, each in FILTERS.items() if not each.needs_witness and each.reason(candidate)]
        assert part.certified.certificate.engines


@pytest.mark.parametrize("cell", CELLS)
def test_each_part_is_read_back_and_has_the_answer_that_the_text_leads_to(cell: tuple[str, str, int]) -> None:
    told = made(*cell)
    parsed = parse_parts(told.prompt)
    assert [each.answer for each in parsed] == pytest.approx([part.value for part in told.answer.parts], rel=1e-6)
    assert [each.query.kind for each in parsed] == [part.kind for part in told.parts]


@pytest.mark.parametrize("cell", CELLS)
def test_answers_and_solutions_are_right_and_no_part_alone_is(cell: tuple[str, str, int]) -> None:
    told = made(*cell)
    assert grade(told, rewards.boxed(rewards.answered(told))).reward == 1.0
    assert grade(told, rewards.boxed(f"{told.answer.value:.6g}")).outcome == Outcome.UNREADABLE
    if told.solution is not None:
        assert grade(told, told.solution.text).reward == 1.0
        assert told.solution.text.count("boxed") == 1
        assert all(needed < n for n, step in enumerate(told.solution.steps) for needed in step.needs)
    for number, answer in enumerate(told.answer.parts):
        wrong = [*told.answer.parts]
        wrong[number] = answer.model_copy(update={"value": 1.2 * answer.value})
        said = rewards.boxed(
            rewards.answered(told.model_copy(update={"answer": told.answer.model_copy(update={"parts": tuple(wrong)})}))
        )
        assert grade(told, said).reward == 0.0
        assert grade(told, said, partial=True).reward == pytest.approx(1 - 1 / len(wrong))


def test_later_solutions_start_from_earlier_results() -> None:
    told = made("box", "medium", 0)
    assert told.solution is not None
    assert "From part (a), $a_M" in told.solution.text
    recalled = [step for step in told.solution.steps if step.kind == "earlier part"]
    assert recalled
    assert all("(a)" not in step.text.removeprefix("From part (a)") for step in recalled)


@pytest.mark.parametrize("cell", CELLS)
def test_separate_parts_give_the_answers_before_them(cell: tuple[str, str, int]) -> None:
    told = made(*cell)
    single = split_parts(told)
    assert [each.id for each in single] == [f"{told.id}-{label}" for label in "abcd"[: len(single)]]
    for number, each in enumerate(single):
        assert each.prompt.count("Answer: ") == number
        assert not each.parts
        assert grade(each, rewards.boxed(rewards.answered(each))).reward == 1.0
        if each.solution is not None:
            assert grade(each, each.solution.text).reward == 1.0
    assert split_parts(single[0]) == (single[0],)


def test_they_travel_through_files(tmp_path: Path) -> None:
    items = [made(*cell) for cell in CELLS]
    write(tmp_path / "shard.parquet", items)
    assert read(tmp_path / "shard.parquet") == items
    assert all(
        rewards.score(rewards.ground_truth(each), rewards.boxed(rewards.answered(each))).reward for each in items
    )


@pytest.mark.parametrize("units", ["cgs", "mixed"])
def test_units_of_all_parts_change_with_the_text(units: str) -> None:
    plain = made("pulley", "easy", 0)
    told = item("pulley", "easy", "multipart", seed=5, index=0, units=units, solutions=True)
    assert told.prompt != plain.prompt
    parsed = parse_parts(told.prompt)
    assert [each.answer for each in parsed] == pytest.approx([part.value for part in told.answer.parts], rel=1e-6)
    assert [part.text for part in told.parts] == list(PartPrompt.read(told.prompt).questions)
    if told.solution is not None:
        assert grade(told, told.solution.text).reward == 1.0


def test_the_order_of_parts_makes_no_other_problem() -> None:
    told = made("projectile", "hard", 1)
    other = told.model_copy(
        update={
            "parts": told.parts[::-1],
            "answer": told.answer.model_copy(update={"parts": told.answer.parts[::-1]}),
        }
    )
    assert problem(other) == problem(told)
    assert variant(other) == variant(told)
    changed = told.parts[0].model_copy(update={"asked": told.parts[0].asked.model_copy(update={"subject": "other"})})
    assert problem(told.model_copy(update={"parts": (changed, *told.parts[1:])})) != problem(told)
    assert len(marks([(0, told), (1, other)], scenes=False).table) == 2


def test_the_same_request_gives_the_same_item() -> None:
    assert item("pulley", "easy", "multipart", seed=5, index=0, solutions=True) == made("pulley", "easy", 0)


def question(answer: float, unit: str, *, time: float | None = None) -> Question:
    moment = AtTime(time) if time is not None else None
    return Question("multipart", Query("state", Target("speed", "x"), moment), "", answer, unit)


def test_answers_that_follow_from_each_other_at_once_are_not_new() -> None:
    study = found("projectile", "hard", 1).study
    mass = next(p.value for p in study.scene.parameters if p.path.endswith("mass"))
    speed = 3.7
    asked = question(speed, "m/s")
    for value, unit in [
        (1.02 * speed, "m/s"),
        (2.0 * speed, "m"),
        (mass * speed, "kg m/s"),
        (0.5 * mass * speed**2, "J"),
        (1.0 / speed, "Hz"),
        (2.0 * np.pi / speed, "rad/s"),
    ]:
        assert not is_new(question(value, unit), asked, study), (value, unit)
        assert not is_new(asked, question(value, unit), study), (value, unit)
    assert is_new(question(1.2345 * speed, "m/s"), asked, study)
    force = question(3.7, "N")
    assert not is_new(question(3.7 * 0.46, "J", time=0.46), force, study), "a force times a stated distance"
    assert not is_new(question(5.0, "m", time=1.0), question(7.3, "J", time=2.0), study), "two stated times"
    assert not is_new(question(1.01, "s"), question(7.3, "J", time=1.0), study), "the text tells the time"
