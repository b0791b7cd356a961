"""Tasks from the problems beside this file, or from endless fresh problems, and their reward."""

import json
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import verifiers.v1 as vf

from sim2reason import iterable
from sim2reason.rewards import boxed, score

DATA = Path(__file__).resolve().parent / "data"


class ProblemData(vf.TaskData):
    """A problem with an answer that is graded as correct, and the ground truth for grading."""

    answer: str
    ground_truth: str
    mode: str
    kind: str
    recipe: str
    difficulty: str


class Problem(vf.Task[ProblemData]):
    """A problem that is solved in one reply."""

    @property
    def key(self) -> str:
        """Return the item's id, which does not depend on the problem's position in a split."""
        return self.data.id or self.hash

    @vf.reward(weight=1.0)
    async def accuracy(self, trace: vf.Trace) -> float:
        """1 for the right answer in a box, else 0."""
        return score(self.data.ground_truth, trace.last_reply).reward

    async def validate(self, runtime: vf.Runtime) -> bool:
        """Return whether the right answer passes, which `vf-validate` asks."""
        del runtime
        return score(self.data.ground_truth, boxed(self.data.answer)).reward == 1.0


class Sim2ReasonConfig(vf.TasksetConfig):
    """Settings of the taskset: a `split`, or `fresh` problems, which are drawn by the other settings."""

    split: str = "train"
    fresh: bool = False
    seed: int = 0
    recipe: str = "all"
    difficulty: str = "all"
    mode: str = "numeric"


class Sim2ReasonTaskset(vf.Taskset[Problem, Sim2ReasonConfig]):
    """All problems of a split, or endless fresh problems."""

    def __init__(self, config: Sim2ReasonConfig) -> None:
        """Store the settings, and mark a taskset of fresh problems as infinite."""
        super().__init__(config)
        self.INFINITE = config.fresh

    def load(self) -> Iterator[Problem]:
        """Return an iterator over the tasks, a task for each row."""
        return (Problem(ProblemData.model_validate(row), self.config.task) for row in self._rows())

    def _rows(self) -> Iterable[dict[str, Any]]:
        which = self.config
        if which.fresh:
            order = {"recipe": which.recipe, "difficulty": which.difficulty, "mode": which.mode, "seed": which.seed}
            return iterable("verifiers", **order)
        lines = (DATA / f"{which.split}.jsonl").read_text(encoding="utf-8").splitlines()
        return map(json.loads, lines)
