"""The problems beside this file, and their reward."""

from collections.abc import Iterator
from pathlib import Path

import verifiers.v1 as vf

from sim2reason.rewards import boxed, score

DATA = Path(__file__).resolve().parent / "data"


class ProblemData(vf.TaskData):
    """A problem, an answer that passes, and what answers are graded by."""

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
        """The item's id, wherever the problem stands in a split."""
        return self.data.id or self.hash

    @vf.reward(weight=1.0)
    async def accuracy(self, trace: vf.Trace) -> float:
        """1 for the right answer in a box, else 0."""
        return score(self.data.ground_truth, trace.last_reply).reward

    async def validate(self, runtime: vf.Runtime) -> bool:
        """Whether the right answer passes, which `vf-validate` asks."""
        del runtime
        return score(self.data.ground_truth, boxed(self.data.answer)).reward == 1.0


class Sim2ReasonConfig(vf.TasksetConfig):
    """Which problems."""

    split: str = "train"


class Sim2ReasonTaskset(vf.Taskset[Problem, Sim2ReasonConfig]):
    """All problems of a split."""

    def load(self) -> Iterator[Problem]:
        """One task a line."""
        with (DATA / f"{self.config.split}.jsonl").open(encoding="utf-8") as lines:
            for line in lines:
                yield Problem(ProblemData.model_validate_json(line), self.config.task)
