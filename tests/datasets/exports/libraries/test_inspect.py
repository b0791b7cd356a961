"""Tests that Inspect runs the task with a model of given replies, and scores it."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sim2reason.generation.item import Item

inspect_ai = pytest.importorskip("inspect_ai", reason="make test-exports")


def scores(split: str, say: Callable[[str], str], logs: Path) -> dict[str, str]:
    """Return the score by id of a model that replies to each prompt by `say`; the task is in the current folder."""
    from inspect_ai.model import ModelOutput, ModelUsage, get_model

    def output(messages: list, *_: object) -> ModelOutput:
        said = ModelOutput.from_content("mockllm/model", say(messages[-1].text))
        said.usage = ModelUsage()  # else Inspect counts tokens by a table that it would have to download
        return said

    (log,) = inspect_ai.eval(
        "task.py",
        task_args={"split": split},
        model=get_model("mockllm/model", custom_outputs=output),
        log_dir=str(logs),
        display="none",
    )
    assert log.status == "success", log.error
    return {sample.id: sample.scores["physics"].value for sample in log.samples}


def test_right_answers_are_correct_and_distractors_are_not(
    exported: Callable[[str], Path],
    items: dict[str, Item],
    right: Callable[[Item], str],
    wrong: Callable[[Item], Iterator[str]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(exported("inspect"))
    by_prompt = {item.prompt: item for item in items.values()}
    found: dict[str, str] = {}
    for split in ("train", "test"):
        found |= scores(split, lambda prompt: right(by_prompt[prompt]), tmp_path / "logs")
    assert found == dict.fromkeys(items, "C")
    for number in range(max(len(item.distractors) for item in items.values())):
        said = {p: [*wrong(item)][number] if len(item.distractors) > number else "" for p, item in by_prompt.items()}
        for split in ("train", "test"):
            assert set(scores(split, said.__getitem__, tmp_path / "logs").values()) == {"I"}


def test_the_page_is_true(follow: Callable[[str], None]) -> None:
    follow("inspect")
