"""Tests that lm-eval finds the tasks by --include_path, queries a model, and grades its replies."""

import json
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import sim2reason
from sim2reason.datasets.exports.formats import LETTERS
from sim2reason.generation.item import Item

LEAST = 100  # rows
lm_eval = pytest.importorskip("lm_eval", reason="make test-exports")


def result(folder: Path, task: str, say: Callable[[str], str]) -> dict[str, object]:
    """Return lm-eval's result for a model that replies to each prompt, and rates choices, by `say`."""
    from lm_eval.api.model import LM
    from lm_eval.tasks import TaskManager

    class Told(LM):
        def generate_until(self, requests: list, disable_tqdm: bool = False) -> list[str]:
            del disable_tqdm
            return [say(request.args[0]) for request in requests]

        def loglikelihood(self, requests: list, disable_tqdm: bool = False) -> list[tuple[float, bool]]:
            del disable_tqdm
            return [(-float(say(request.args[0]) != request.args[1].strip()), False) for request in requests]

        def loglikelihood_rolling(self, requests: list, disable_tqdm: bool = False) -> list[float]:
            raise NotImplementedError

    manager = TaskManager(include_path=str(folder), include_defaults=False)
    return lm_eval.simple_evaluate(model=Told(), tasks=[task], task_manager=manager, bootstrap_iters=0)


@pytest.mark.parametrize("split", ["train", "test"])
def test_right_answers_pass_and_distractors_do_not(
    real: Path,
    tmp_path: Path,
    items: dict[str, Item],
    right: Callable[[Item], str],
    wrong: Callable[[Item], Iterator[str]],
    split: str,
) -> None:
    done = sim2reason.export(real, tmp_path / "out", to="lm-eval", split=split)
    by_prompt = {item.prompt: item for item in items.values()}
    found = result(done.folder, "sim2reason", lambda prompt: right(by_prompt[prompt]))
    assert found["results"]["sim2reason"]["accuracy,none"] == 1.0
    assert found["n-samples"]["sim2reason"]["effective"] == done.rows[split]
    for number in range(max(len(item.distractors) for item in items.values())):
        said = {p: [*wrong(item)][number] if len(item.distractors) > number else "" for p, item in by_prompt.items()}
        assert result(done.folder, "sim2reason", said.__getitem__)["results"]["sim2reason"]["accuracy,none"] == 0.0


@pytest.fixture(scope="module")
def choices(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Export multiple choice of 1000 problems, most of which are left out for lack of wrong answers."""
    folder = tmp_path_factory.mktemp("choices")
    order = {"items": 1000, "recipe": "pulley", "maker": "fake_makers:with_answers"}
    sim2reason.generate(folder / "problems", workers=1, **order)
    return sim2reason.export(folder / "problems", folder / "out", to="multiple-choice").folder


def test_the_right_letter_passes_and_every_other_does_not(choices: Path) -> None:
    rows = [json.loads(line) for line in (choices / "data/train.jsonl").read_text().splitlines()]
    assert len(rows) >= LEAST
    for number in range(len(LETTERS)):  # the right one first, then the wrong ones, those of short lists again
        letters = dict[str, str]()
        for row in rows:
            held = LETTERS[: len(row["choices"])]
            wrong = held.replace(row["answer"], "")
            letters[row["question"]] = wrong[number % len(wrong)] if number else row["answer"]
        found = result(choices, "sim2reason_choice", lambda prompt, told=letters: told[prompt.partition("\n\nA. ")[0]])
        assert found["results"]["sim2reason_choice"]["acc,none"] == float(number == 0)
        assert found["n-samples"]["sim2reason_choice"]["effective"] == len(rows)


@pytest.mark.parametrize("page", ["lm-eval", "multiple-choice"])
def test_the_page_is_true(follow: Callable[[str], None], page: str) -> None:
    follow(page)
