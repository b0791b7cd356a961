"""Tests of rejection sampling: responses kept, problems asked again, and the resulting corpus."""

import json
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import pytest
from pydantic import PrivateAttr

import sim2reason
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.generate import generate
from sim2reason.errors import DatasetError, EvaluationError, PolicyError, TrainingError
from sim2reason.evaluation.policies import Completion, Policy, SampleRequest
from sim2reason.evaluation.policy_pass import solvable
from sim2reason.training.corpora import build_corpus
from sim2reason.training.corpora.solutions import sample_solutions


class Teacher(Policy):
    """Policy whose samples of a problem are right, wrong, right with equal words, right with thinking, and so on.

    A later sample is right and cut off. Every fourth problem is never solved.
    """

    answers: dict[str, float]
    stops_after: int = 10**9
    _asked: list[tuple[str, int]] = PrivateAttr(default_factory=list)

    operational = Policy.operational | {"stops_after"}

    def complete(self, requests: Sequence[SampleRequest]) -> Sequence[Completion]:
        """Return the responses by the numbers of their samples."""
        if len(self._asked) >= self.stops_after:
            raise PolicyError("no more today")
        self._asked.extend((request.id, request.sample) for request in requests)
        return [self._said(request) for request in requests]

    def _said(self, request: SampleRequest) -> Completion:
        box = rf"\boxed{{{self.answers[request.id]!r}}}"
        if sorted(self.answers).index(request.id) % 4 == 3:
            return Completion(text=r"\boxed{-1}", finish="stop")
        return [
            Completion(text=f"It is {box}", finish="stop"),
            Completion(text=r"\boxed{-1}", finish="stop"),
            Completion(text=f" It  is {box}\n", finish="stop"),
            Completion(text=box, thinking="Let me see.", finish="stop"),
            Completion(text=f"{box}, and so on and", finish="length"),
            Completion(text=f"So {box}"),
            Completion(text="", finish="overflow"),
            Completion(text="Dunno.", finish="stop"),
            Completion(text=f"Thus {box}", finish="refused"),
        ][request.sample % 9]


@pytest.fixture
def dataset(tmp_path: Path) -> Dataset:
    split = {"train": 0.5, "test": 0.5}
    return generate(
        tmp_path / "problems", items=12, recipe="pulley", maker="fake_makers:steady", workers=1, split=split
    )


@pytest.fixture
def teacher(dataset: Dataset) -> Teacher:
    return Teacher(name="teacher", answers={item.id: item.answer.value for item in dataset})


def solutions(out: Path) -> list[dict[str, object]]:
    return [json.loads(line) for line in (out / "solutions.jsonl").read_text("utf-8").splitlines()]


def test_right_responses_are_kept_whole_and_once(dataset: Dataset, teacher: Teacher, tmp_path: Path) -> None:
    out = tmp_path / "solutions"
    found = sample_solutions(dataset.path, out, teacher, k=9, keep=2)
    assert (found.items, found.solved, found.kept) == (12, 9, 18)
    assert found.left_out == {
        "beyond keep": 9,
        "duplicate": 9,
        "overflow": 9,
        "refused": 9,
        "truncated": 9,
        "unreadable": 9,
        "wrong": 9 + 3 * 9,
    }
    assert found.kept + sum(found.left_out.values()) == 12 * 9
    rows = solutions(out)
    assert len(rows) == 18
    assert [row["id"] for row in rows[::2]] == [item.id for item in dataset if item.id in {row["id"] for row in rows}]
    assert {row["sample"] for row in rows} == {0, 3}
    held = {item.id: item for item in dataset}
    for row in rows:
        item = held[str(row["id"])]
        assert row["prompt"] == item.prompt
        assert sim2reason.grade(item, row["completion"]).reward == 1.0
    assert all(str(row["completion"]).startswith("<think>Let me see.</think>") for row in rows if row["sample"] == 3)
    assert json.loads((out / "sampled.json").read_text())["kept"] == 18


def test_nothing_is_asked_twice_whatever_changes(dataset: Dataset, teacher: Teacher, tmp_path: Path) -> None:
    out = tmp_path / "solutions"
    assert sample_solutions(dataset.path, out, teacher, k=1, split="train").kept > 0
    half = len(teacher._asked)
    assert half == len(list(dataset.items("train")))
    first = sample_solutions(dataset.path, out, teacher, k=4)
    assert first.kept == 9 * 2
    assert sample_solutions(dataset.path, out, teacher, k=4, keep=1).kept == 9
    assert sample_solutions(dataset.path, out, teacher, k=4) == first
    assert solvable(dataset.path, out, teacher, k=4, between=(0.0, 1.0)).kept == 9
    assert len(teacher._asked) == len(set(teacher._asked)) == 12 * 4
    assert sample_solutions(dataset.path, out, teacher, k=4) == first


def test_a_pass_that_was_broken_off_goes_on(dataset: Dataset, teacher: Teacher, tmp_path: Path) -> None:
    out = tmp_path / "solutions"
    with pytest.raises(PolicyError, match="no more today"):
        sample_solutions(dataset.path, out, teacher.model_copy(update={"stops_after": 13}), k=6)
    assert not (out / "sampled.json").exists()
    with (out / "samples.jsonl").open("ab") as journal:
        journal.write(b'{"id": "torn')
    again = Teacher(name="teacher", answers=teacher.answers)
    found = sample_solutions(dataset.path, out, again, k=6)
    assert len(again._asked) == 12 * 6 - 13
    assert found == sample_solutions(dataset.path, tmp_path / "at-once", teacher, k=6)
    assert solutions(out) == solutions(tmp_path / "at-once")


def test_a_constant_policy_solves_what_its_answer_fits(dataset: Dataset, tmp_path: Path) -> None:
    item = next(iter(dataset))
    policy = {"kind": "constant", "name": "one", "text": rf"\boxed{{{item.answer.value!r}}}"}
    found = sample_solutions(dataset.path, tmp_path / "solutions", policy, k=3)
    right = [each for each in dataset if sim2reason.grade(each, policy["text"]).reward == 1.0]
    assert found.kept == found.solved == len(right) >= 1
    assert found.left_out.get("duplicate", 0) == 2 * len(right)


def test_what_makes_no_sense_is_refused(dataset: Dataset, teacher: Teacher, tmp_path: Path) -> None:
    for numbers in ({"k": 0}, {"k": 10**6}, {"keep": 0}, {"keep": 10**6}):
        with pytest.raises(EvaluationError, match="give numbers from 1 to 4096"):
            sample_solutions(dataset.path, tmp_path / "new", teacher, **numbers)
    with pytest.raises(DatasetError, match="has no split 'dev'"):
        sample_solutions(dataset.path, tmp_path / "new", teacher, split="dev")
    assert not (tmp_path / "new").exists()
    with pytest.raises(EvaluationError, match="is no pass of a policy"):
        sample_solutions(dataset.path, dataset.path, teacher, k=1)
    sample_solutions(dataset.path, tmp_path / "held", teacher, k=1)
    with pytest.raises(EvaluationError, match="another seed"):
        sample_solutions(dataset.path, tmp_path / "held", teacher, k=1, seed=1)


def test_a_corpus_reads_what_is_kept_and_believes_nothing_else(
    dataset: Dataset, teacher: Teacher, tmp_path: Path
) -> None:
    out = tmp_path / "solutions"
    corpus = build_corpus({"kind": "sampled", "folder": str(out)})
    with pytest.raises(TrainingError, match=r"no sampled\.json here"):
        list(corpus.rows(Counter()))
    found = sample_solutions(dataset.path, out, teacher, k=4)
    rows = list(corpus.rows(Counter()))
    assert [(row.prompt, row.completion) for row in rows] == [
        (row["prompt"], row["completion"]) for row in solutions(out)
    ]
    assert len(rows) == found.kept
    with (out / "solutions.jsonl").open("a") as file:
        file.write('{"prompt": "a", "completion": "b"}\n')
    with pytest.raises(TrainingError, match="changed or missing"):
        list(corpus.rows(Counter()))
    (out / "sampled.json").write_text("{}")
    with pytest.raises(TrainingError, match="damaged"):
        list(corpus.rows(Counter()))
