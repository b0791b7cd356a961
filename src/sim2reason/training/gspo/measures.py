"""What a step measures: times, rewards, how it was filled."""

from collections.abc import Generator, Mapping, MutableMapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from math import isfinite, isnan
from time import perf_counter
from typing import Literal

from sim2reason.errors import TrainingError
from sim2reason.training.gspo.sampling import EQUAL, Filled
from sim2reason.training.gspo.step_log import StepRecord, StepSeconds

__all__ = ["Meter", "collapse"]

Part = Literal["generation", "reward", "drawing", "logprobs"]

NAMES = {  # of TRL, by ours
    "completion_tokens": "completions/mean_length",
    "truncated": "completions/clipped_ratio",
    "kl": "kl",
    "clip_low": "clip_ratio/low_mean",
    "clip_high": "clip_ratio/high_mean",
    "entropy": "entropy",
    "loss": "loss",
    "grad_norm": "grad_norm",
    "learning_rate": "learning_rate",
}


@dataclass
class Meter:
    """Of the step at hand."""

    parts: dict[Part, float] = field(default_factory=dict[Part, float])
    """Seconds."""
    grad_norms: list[float] = field(default_factory=list[float])
    filled: Filled = field(default_factory=Filled)
    _made: float = 0.0
    _problems: float = 0.0
    _began: float = 0.0
    _updating: float = 0.0

    def begin(self) -> None:
        """Start a step."""
        self.parts, self.grad_norms, self._began = {}, [], perf_counter()

    @contextmanager
    def time(self, part: Part) -> Generator[None]:
        """Add what the block takes."""
        start = perf_counter()
        try:
            yield
        finally:
            self.parts[part] = self.parts.get(part, 0.0) + perf_counter() - start

    def update(self, filled: Filled) -> None:
        """From here on a filled batch is learned."""
        self.filled, self._updating = filled, perf_counter()

    def made(self, cpu_seconds: float) -> None:
        """So much have other processes spent on problems by now."""
        self._problems, self._made = cpu_seconds - self._made, cpu_seconds

    def flat(self) -> dict[str, float]:
        """Numbers for TRL's log; its own has the rest."""
        filled, rewards = self.filled, self.filled.rewards
        found: dict[str, float] = {
            "rounds": len(filled.sizes),
            "prompts": filled.answered,
            "groups": len(filled.owners),
            "zero_variance": 1.0 - filled.good / max(filled.answered, 1),
        }
        if rewards:
            found |= {"pass_rate": _mean([reward >= 1.0 - EQUAL for reward in rewards])}
        if self.grad_norms:
            found |= {"grad_norm": _mean(self.grad_norms)}
        return found | {f"seconds/{name}": value for name, value in self._seconds().model_dump().items()}

    def _seconds(self) -> StepSeconds:
        now, parts = perf_counter(), self.parts
        names: tuple[Part, ...] = ("generation", "reward", "drawing", "logprobs")
        update = now - self._updating
        spent = {name: parts.get(name, 0.0) for name in names}
        return StepSeconds(step=now - self._began, update=update, problems=self._problems, **spent)

    def record(self, logged: Mapping[str, float | None], *, step: int, updates: int, consumed: int) -> StepRecord:
        """The line of a step whose numbers were logged.

        Raises:
            TrainingError: one of them is not finite.
        """
        rewards = self.filled.rewards
        values = {ours: logged.get(theirs) for ours, theirs in NAMES.items()}
        wild = [name for name, value in values.items() if value is not None and not isfinite(value)]
        if wild:
            why = "training has diverged; go on from an earlier checkpoint with a lower learning_rate"
            raise TrainingError(f"step {step}: {', '.join(wild)} is not finite: {why}")
        own = {name: logged.get(name) for name in ("rounds", "prompts", "groups", "zero_variance", "pass_rate")}
        seconds = {name: logged[f"seconds/{name}"] for name in StepSeconds.model_fields}
        return StepRecord.model_validate(
            {
                "step": step,
                "updates": updates,
                "prompts_consumed": consumed,
                "reward": _mean(rewards) if rewards else None,
                **own,
                **values,
                "seconds": seconds,
            }
        )


def _mean(values: Sequence[float]) -> float:
    return sum(values) / len(values)


def collapse(metrics: MutableMapping[str, list[float]], before: Mapping[str, int], sizes: Sequence[int]) -> None:
    """Make one entry of those that TRL's metrics got in the rounds of a step, which it would weigh alike.

    `sizes` are the prompts of each round; `before` says how many entries a metric had.
    """
    for name, held in metrics.items():
        start = before.get(name, 0)
        found = [(value, size) for value, size in zip(held[start:], sizes, strict=False) if not isnan(value)]
        if len(held) - start != len(sizes) or not found:
            continue
        kind = name.rpartition("/")[2].partition("_")[0]
        values = [value for value, _ in found]
        weighed = sum(value * size for value, size in found) / sum(size for _, size in found)
        held[start:] = [min(values) if kind == "min" else max(values) if kind == "max" else weighed]
