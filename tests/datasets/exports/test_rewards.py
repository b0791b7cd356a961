"""Tests of the ground truths in rows, and of trainers' signatures, for every export: all use one grader."""

import json
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from sim2reason import rewards
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.exports import EXPORTS, RowPosition
from sim2reason.datasets.grade import grade
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item

TARGETS = [name for name in EXPORTS if name != "multiple-choice"]


@pytest.fixture(scope="module")
def items(problems: Path) -> list[Item]:
    return list(Dataset(problems))


def ground_truth(row: object) -> str:
    """Return the ground truth, at any level of a row."""
    if isinstance(row, dict):
        for key, value in row.items():
            if key == "ground_truth":
                return value
            if found := ground_truth(value):
                return found
    return ""


@pytest.mark.parametrize("to", TARGETS)
def test_right_answers_pass_and_distractors_do_not(items: list[Item], to: str) -> None:
    wrong = 0
    for number, item in enumerate(items):
        held = ground_truth(EXPORTS[to].row(item, RowPosition("train", number)))
        assert rewards.compute_score("sim2reason", rewards.boxed(rewards.answered(item)), held) == 1.0
        for distractor in item.distractors:
            wrong += 1
            assert rewards.compute_score("sim2reason", rf"\boxed{{{distractor.value:.6g}}}", held, {}, more=1) == 0.0
    assert wrong > len(items)


def test_a_ground_truth_grades_as_its_item_does(items: list[Item]) -> None:
    for item in items:
        for said in (r"\boxed{9.8}", r"\boxed{m g}", "nothing", None, [{"role": "assistant", "content": r"\boxed{1}"}]):
            assert rewards.score(rewards.ground_truth(item), said) == grade(item, said)


def test_a_ground_truth_says_all_that_matters_though_defaults_may_change(items: list[Item]) -> None:
    for item in items:
        assert {"value", "unit", "sign", "tolerance"} <= json.loads(rewards.ground_truth(item)).keys()
        assert "\n" not in rewards.ground_truth(item)


def test_trl_gets_a_reward_for_each_completion_and_none_for_rows_of_others(items: list[Item]) -> None:
    item = items[0]
    right = rewards.boxed(rewards.answered(item))
    found = rewards.accuracy(
        ["p"] * 4,
        [right, [{"role": "assistant", "content": right}], "no", right],
        ground_truth=[rewards.ground_truth(item)] * 3 + [None],
        trainer_state=object(),
    )
    assert found == [1.0, 1.0, 0.0, None]


def test_a_row_of_a_generated_dataset_is_graded_by_its_answer(items: list[Item]) -> None:
    item = items[0]
    row = item.model_dump(mode="json")
    worked = [{"strategy": "a", "text": "b"}, None]
    said = [rewards.boxed(rewards.answered(item)), r"\boxed{1e9}"]
    assert rewards.accuracy(["p"] * 2, said, solution=worked, answer=[row["answer"]] * 2) == [1.0, 0.0]
    assert rewards.partial_accuracy(["p"] * 2, said, answer=[row["answer"]] * 2) == [1.0, 0.0]


def test_rows_of_other_data_with_columns_of_their_own_get_none(items: list[Item]) -> None:
    item = items[0]
    right = rewards.boxed(rewards.answered(item))
    others: list[object] = [rewards.ground_truth(item), "So $x = 2$.", r"\boxed{2}", '{"value": 1}', 2, {"a": 1}]
    assert rewards.accuracy(["p"] * 6, [right] * 6, ground_truth=others, answer=["2"] * 6) == [1.0, *[None] * 5]


def test_a_batch_without_any_answer_of_ours_is_told() -> None:
    with pytest.warns(UserWarning, match="give the column ground_truth of sim2reason export"):
        assert rewards.accuracy(["p"], [r"\boxed{1}"], text=["a"]) == [None]


def test_settings_of_a_reward_are_given_once(items: list[Item]) -> None:
    item = items[0]
    cut_off, held = f"We get {rewards.boxed(rewards.answered(item))}, but", rewards.ground_truth(item)
    reward = rewards.accuracy_with(thinking_opened=True)
    assert reward.__name__ == "accuracy"
    assert reward(["p"] * 2, [cut_off, f"a</think>{cut_off}"], ground_truth=[held] * 2) == [0.0, 1.0]
    assert rewards.accuracy(["p"], [cut_off], ground_truth=[held]) == [1.0]
    assert rewards.compute_score("sim2reason", cut_off, held, thinking_opened=True) == 0.0


@pytest.mark.parametrize("text", ["", "{}", "9.8", '{"value": 1}', '{"value": NaN, "unit": ""}', "x" * 500])
def test_what_is_no_ground_truth_is_told_in_one_short_line(text: str) -> None:
    with pytest.raises(DatasetError, match="is no ground truth of sim2reason; give the column") as error:
        rewards.score(text, r"\boxed{1}")
    assert "\n" not in str(error.value)
    assert len(str(error.value)) < 200


def test_threads_get_the_same(items: list[Item]) -> None:
    jobs = [(rewards.ground_truth(item), rewards.boxed(rewards.answered(item))) for item in items] * 5
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(lambda job: rewards.compute_score("", job[1], job[0]), jobs))
    assert found == [1.0] * len(jobs)
