"""What runs of GSPO tell, read back."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class LearnedGroup:
    """What a step learned from one prompt, on one process."""

    step: int
    rank: int
    number: int
    completions: list[list[int]]
    advantages: list[float]


def lines(path: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in path.read_text().splitlines()]


def learned(out: Path, generations: int) -> Iterator[LearnedGroup]:
    """All groups; each is of one prompt."""
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


def without_times(record: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in record.items() if name != "seconds"}
