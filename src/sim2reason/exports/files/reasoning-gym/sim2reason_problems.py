"""Physics problems as a dataset of Reasoning Gym, registered as ``sim2reason`` when this file is imported."""

import json
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any

from reasoning_gym.factory import ProceduralDataset, register_dataset

from sim2reason.rewards import boxed, score

DATA = Path(__file__).resolve().parent / "data"


@dataclass
class ProblemsConfig:
    """Which problems, in which order, and how many; beyond their number they come again."""

    split: str = "train"
    seed: int = 0
    size: int = 500

    @property
    def path(self) -> Path:
        """The file of the split."""
        return DATA / f"{self.split}.jsonl"

    def validate(self) -> None:
        """Refuse what is not there."""
        if not self.path.is_file():
            raise ValueError(f"{self.path}: there is no such split")
        if self.size < 1:
            raise ValueError("size must be positive")


class Problems(ProceduralDataset):
    """Problems in an order that the seed draws."""

    def __init__(self, config: ProblemsConfig) -> None:
        """Read all problems of the split."""
        super().__init__(config=config, seed=config.seed, size=config.size)
        self.rows = [json.loads(line) for line in config.path.read_text(encoding="utf-8").splitlines()]
        Random(config.seed).shuffle(self.rows)

    def __getitem__(self, idx: int) -> dict[str, Any]:
        """A problem with its answer and what it is graded by."""
        row = self.rows[idx % len(self.rows)]
        return row | {"metadata": {"source_dataset": "sim2reason", "source_index": idx, **row["metadata"]}}

    def score_answer(self, answer: str | None, entry: dict[str, Any]) -> float:
        """1 or 0, for an answer in a box or without one."""
        return score(entry["metadata"]["ground_truth"], boxed(answer or "")).reward


register_dataset("sim2reason", Problems, ProblemsConfig)
