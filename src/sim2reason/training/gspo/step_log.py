"""Log of the steps of a run."""

from pathlib import Path

from pydantic import BaseModel, ConfigDict, FiniteFloat

from sim2reason.training.step_lines import StepLines

__all__ = ["StepLog", "StepRecord", "StepSeconds"]

NAME = "log.jsonl"


class _Record(BaseModel):
    """The base of records on disk: frozen, without unknown fields."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class StepSeconds(_Record):
    """The wall time of one step in the first process; `problems` is CPU time of other processes.

    The remainder of `step` is spent on the selection of groups and communication.
    """

    step: FiniteFloat
    generation: FiniteFloat
    reward: FiniteFloat
    drawing: FiniteFloat
    """Of prompts: the stream, and their way to all processes."""
    logprobs: FiniteFloat
    """Log-probabilities under the policy and the reference, before the updates."""
    update: FiniteFloat
    """Forward, backward and optimizer, of all minibatches."""
    problems: FiniteFloat = 0.0
    """CPU time of the processes that made problems meanwhile; in the first step after a start, since that."""


class StepRecord(_Record):
    """The log record of one step; fractions are relative to 1 and include omitted groups."""

    step: int
    updates: int
    """Of the optimizer, since the beginning."""
    rounds: int
    prompts: int
    """Drawn and answered in this step."""
    prompts_consumed: int
    """Read from the stream since the beginning, with those that were too long."""
    groups: int
    """That were learned from: all of unequal rewards."""
    zero_variance: FiniteFloat
    """The share of groups drawn in this step whose rewards were all equal, or that had none."""
    reward: FiniteFloat | None
    pass_rate: FiniteFloat | None
    """The share of rewards of 1 or more."""
    completion_tokens: FiniteFloat | None
    """The mean."""
    truncated: FiniteFloat | None
    """The share of completions that were cut at the greatest length."""
    kl: FiniteFloat | None
    clip_low: FiniteFloat | None
    """The share of completions whose ratio fell below the lower bound while their advantage was negative."""
    clip_high: FiniteFloat | None
    entropy: FiniteFloat | None
    loss: FiniteFloat | None
    """The mean over the minibatches."""
    grad_norm: FiniteFloat | None
    """Before clipping; the mean over the minibatches."""
    learning_rate: FiniteFloat | None
    seconds: StepSeconds


class StepLog:
    """The log file of a run."""

    def __init__(self, folder: Path) -> None:
        """Locate the file in the folder of the run."""
        self._lines = StepLines(folder / NAME)

    def rewind(self, step: int) -> None:
        """Remove from the log all steps after a given one, from which the run continues."""
        self._lines.rewind(step)

    def add(self, record: StepRecord) -> None:
        """Write a step and sync it to disk."""
        self._lines.add(record.model_dump_json())

    def read(self) -> list[StepRecord]:
        """Return all steps so far."""
        return [StepRecord.model_validate_json(line) for line in self._lines.read()]
