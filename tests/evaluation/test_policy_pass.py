"""Tests of the solvable filter: cached and resumed pass rates of a policy, and the dataset of kept problems."""

import json
from collections.abc import Sequence
from pathlib import Path

import pytest
from pydantic import PrivateAttr

from sim2reason.datasets.dataset import Dataset, verify
from sim2reason.datasets.generate import generate
from sim2reason.errors import DatasetError, EvaluationError, PolicyError
from sim2reason.evaluation.policies import Completion, Policy, SampleRequest
from sim2reason.evaluation.policy_pass import solvable


class Sometimes(Policy):
    """Policy that solves problem n, in the order of ids, in its first n mod 5 tries."""

    answers: dict[str, float]
    stops_after: int = 10**9
    _asked: list[str] = PrivateAttr(default_factory=list)

    operational = Policy.operational | {"stops_after"}

    def complete(self, requests: Sequence[SampleRequest]) -> Sequence[Completion]:
        """Return right or wrong answers, depending on the number of the sample."""
        if len(self._asked) >= self.stops_after:
            raise PolicyError("no more today")
        self._asked.extend(request.id for request in requests)
        return [self._said(request) for request in requests]

    def _said(self, request: SampleRequest) -> Completion:
        right = request.sample < sorted(self.answers).index(request.id) % 5
        return Completion(text=rf"\boxed{{{self.answers[request.id] if right else -1.0!r}}}", finish="stop")


@pytest.fixture
def dataset(tmp_path: Path) -> Dataset:
    split = {"train": 0.5, "test": 0.5}
    return generate(
        tmp_path / "problems", items=20, recipe="pulley", maker="fake_makers:steady", workers=1, split=split
    )


@pytest.fixture
def policy(dataset: Dataset) -> Sometimes:
    return Sometimes(name="sometimes", answers={item.id: item.answer.value for item in dataset})


def test_what_is_solved_sometimes_is_kept(dataset: Dataset, policy: Sometimes, tmp_path: Path) -> None:
    out = tmp_path / "solvable"
    found = solvable(dataset.path, out, policy, k=4)
    assert found.items == 20
    assert found.rates == {"0": 4, "1": 4, "2": 4, "3": 4, "4": 4}
    assert found.kept == 12
    kept = Dataset(out / "problems")
    assert len(kept) == len(list(kept)) == 12
    assert {item.id for item in kept} < {item.id for item in dataset}
    assert all(kept.item(item.id) == item for item in kept)
    assert verify(out / "problems").faults == ()
    assert kept.manifest.rejected["pulley"]["solvable"] == 8
    assert "strictly between 0.1 and 0.9" in (out / "problems/README.md").read_text("utf-8")
    rates = [json.loads(line) for line in (out / "pass_rates.jsonl").read_text("utf-8").splitlines()]
    assert [rate["id"] for rate in rates] == [item.id for item in dataset]
    assert sum(rate["kept"] for rate in rates) == 12
    gone = next(rate["id"] for rate in rates if not rate["kept"])
    with pytest.raises(DatasetError, match="holds no problem"):
        kept.item(gone)


def test_other_bounds_ask_nothing_and_more_tries_ask_for_the_rest(
    dataset: Dataset, policy: Sometimes, tmp_path: Path
) -> None:
    out = tmp_path / "solvable"
    solvable(dataset.path, out, policy, k=2)
    assert len(policy._asked) == 40
    assert solvable(dataset.path, out, policy, k=2, between=(0.4, 0.6)).kept == 4
    assert len(policy._asked) == 40
    assert solvable(dataset.path, out, policy, k=4).kept == 12
    assert len(policy._asked) == 80
    assert len(Dataset(out / "problems")) == 12


def test_a_pass_that_was_broken_off_goes_on(dataset: Dataset, policy: Sometimes, tmp_path: Path) -> None:
    out = tmp_path / "solvable"
    with pytest.raises(PolicyError, match="no more today"):
        solvable(dataset.path, out, policy.model_copy(update={"stops_after": 13}), k=2)
    assert not (out / "solvable.json").exists()
    again = Sometimes(name="sometimes", answers=policy.answers)
    found = solvable(dataset.path, out, again, k=2)
    assert len(again._asked) == 40 - 13
    assert found == solvable(dataset.path, tmp_path / "at-once", policy, k=2).model_copy(
        update={"samples": found.samples}
    )


def test_a_pass_without_an_answer_is_replaced(dataset: Dataset, policy: Sometimes, tmp_path: Path) -> None:
    out = tmp_path / "solvable"
    with pytest.raises(PolicyError, match="no more today"):
        solvable(dataset.path, out, policy.model_copy(update={"stops_after": 0}), k=1)
    assert solvable(dataset.path, out, policy.model_copy(update={"name": "other"}), k=1, seed=1).items == 20


def test_another_policy_seed_or_dataset_is_refused(dataset: Dataset, policy: Sometimes, tmp_path: Path) -> None:
    out = tmp_path / "solvable"
    solvable(dataset.path, out, policy, k=1)
    with pytest.raises(EvaluationError, match="another seed"):
        solvable(dataset.path, out, policy, k=1, seed=1)
    with pytest.raises(EvaluationError, match="another policy"):
        solvable(dataset.path, out, policy.model_copy(update={"name": "other"}), k=1)
    with pytest.raises(EvaluationError, match="is no pass of a policy"):
        solvable(dataset.path, dataset.path, policy, k=1)
    for between in ((0.9, 0.1), (-1.0, 0.5), (float("nan"), 1.0)):
        with pytest.raises(EvaluationError, match="give bounds"):
            solvable(dataset.path, tmp_path / "new", policy, between=between)
    assert not (tmp_path / "new").exists()
