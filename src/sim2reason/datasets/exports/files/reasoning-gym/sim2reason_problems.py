"""Physics problems as two datasets of Reasoning Gym, which are registered when this file is imported.

``sim2reason`` has the problems beside this file, ``sim2reason_fresh`` draws others when they are asked for.
"""

import json
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any

from reasoning_gym.factory import ProceduralDataset, register_dataset

from sim2reason import iterable
from sim2reason.rewards import boxed, score

DATA = Path(__file__).resolve().parent / "data"


@dataclass
class ProblemsConfig:
    """Settings of stored problems: their split, order and number; a larger number repeats them."""

    split: str = "train"
    seed: int = 0
    size: int = 500

    @property
    def path(self) -> Path:
        """Return the path of the file with the problems of the split."""
        return DATA / f"{self.split}.jsonl"

    def validate(self) -> None:
        """Raise ValueError if the split does not exist or the size is not positive."""
        if not self.path.is_file():
            raise ValueError(f"{self.path}: there is no such split")
        if self.size < 1:
            raise ValueError("size must be positive")


@dataclass
class FreshConfig:
    """Settings of problems that are drawn on request; another seed gives other problems."""

    seed: int = 0
    size: int = 500
    recipe: str = "all"
    difficulty: str = "all"
    mode: str = "numeric"

    def validate(self) -> None:
        """Raise ValueError if the size is not positive; names are checked when problems are drawn."""
        if self.size < 1:
            raise ValueError("size must be positive")


class Graded(ProceduralDataset):
    """Base class of both datasets, which grades answers to their rows."""

    def score_answer(self, answer: str | None, entry: dict[str, Any]) -> float:
        """Return the reward of 1 or 0 for an answer, with or without a box."""
        return score(entry["metadata"]["ground_truth"], boxed(answer or "")).reward

    def told(self, row: dict[str, Any], idx: int) -> dict[str, Any]:
        """Return a row with its source dataset and its index in the metadata."""
        return row | {"metadata": {"source_dataset": "sim2reason", "source_index": idx, **row["metadata"]}}


class Problems(Graded):
    """Problems in an order that the seed draws."""

    def __init__(self, config: ProblemsConfig) -> None:
        """Read all problems of the split."""
        super().__init__(config=config, seed=config.seed, size=config.size)
        self.rows = [json.loads(line) for line in config.path.read_text(encoding="utf-8").splitlines()]
        Random(config.seed).shuffle(self.rows)

    def __getitem__(self, idx: int) -> dict[str, Any]:
        """Return a problem with its answer and its ground truth."""
        return self.told(self.rows[idx % len(self.rows)], idx)


class FreshProblems(Graded):
    """Problems that are drawn on request; the same seed and index give the same problem."""

    def __init__(self, config: FreshConfig) -> None:
        """Prepare the rows without drawing a problem."""
        super().__init__(config=config, seed=config.seed, size=config.size)
        order = {"recipe": config.recipe, "difficulty": config.difficulty, "mode": config.mode, "seed": config.seed}
        self.rows = iterable("reasoning-gym", **order)

    def __getitem__(self, idx: int) -> dict[str, Any]:
        """Return the problem at an index with its answer and its ground truth."""
        return self.told(self.rows[idx], idx)


register_dataset("sim2reason", Problems, ProblemsConfig)
register_dataset("sim2reason_fresh", FreshProblems, FreshConfig)
