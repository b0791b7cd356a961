"""Reading and checks of the logs of GSPO runs."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from gspo_run import HOPELESS


@dataclass(frozen=True)
class LearnedGroup:
    """Completions of one prompt in the batch of a step, on one process."""

    step: int
    rank: int
    number: int
    completions: list[list[int]]
    advantages: list[float]


def lines(path: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in path.read_text().splitlines()]


def learned(out: Path, generations: int) -> Iterator[LearnedGroup]:
    """Yield all groups of completions, each with one prompt."""
    for path in sorted(out.glob("learned-*.jsonl")):
        rank = int(path.stem.rpartition("-")[2])
        for line in lines(path):
            assert len(line["prompts"]) == len(line["completions"]) == len(line["advantages"])
            assert len(line["prompts"]) % generations == 0
            for start in range(0, len(line["prompts"]), generations):
                rows = slice(start, start + generations)
                (prompt,) = set(line["prompts"][rows])
                number = int(prompt.rstrip("?"))
                yield LearnedGroup(line["step"], rank, number, line["completions"][rows], line["advantages"][rows])


def check_groups(out: Path, prompts: int, generations: int, ranks: int) -> None:
    """Assert unequal rewards and right advantages in each group, unique prompts, and equal shares per process."""
    groups = list(learned(out, generations))
    for group in groups:
        rewards = [float(sum(ids) % 2 == 0 and group.number % HOPELESS != 0) for ids in group.completions]
        mean = sum(rewards) / generations
        deviation = (sum((reward - mean) ** 2 for reward in rewards) / (generations - 1)) ** 0.5
        assert deviation > 0
        expected = [(reward - mean) / (deviation + 1e-4) for reward in rewards]
        assert group.advantages == pytest.approx(expected, abs=1e-5)
    assert len({group.number for group in groups}) == len(groups)
    for step in {group.step for group in groups}:
        each = [sum(group.step == step and group.rank == rank for group in groups) for rank in range(ranks)]
        assert each == [prompts // ranks] * ranks


def without_times(record: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in record.items() if name != "seconds"}
