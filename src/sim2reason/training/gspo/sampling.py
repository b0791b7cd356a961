"""Dynamic sampling of groups with unequal rewards (DAPO, Yu et al. 2025), and metrics of a step."""

from collections.abc import Callable, Generator, Mapping, MutableMapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from math import ceil, isfinite, isnan
from time import perf_counter
from typing import Literal, Protocol

from sim2reason.errors import TrainingError
from sim2reason.training.gspo.rollouts import Group
from sim2reason.training.gspo.settings import Drawn, Row
from sim2reason.training.run_files import StepRecord, StepSeconds

__all__ = [
    "FilledStep",
    "Meter",
    "ProcessRank",
    "RoundRewards",
    "Sampler",
    "balance",
    "collapse",
    "fill",
    "has_spread",
    "round_size",
]

REWARD_TOLERANCE = 1e-6  # rewards that differ by less are equal: float32 means of equal rewards differ by about 1e-8


@dataclass(frozen=True, slots=True)
class ProcessRank:
    """The rank of this process and the number of processes."""

    rank: int = 0
    world: int = 1


@dataclass(frozen=True, slots=True)
class RoundRewards:
    """The rewards of all prompts of a round, and a function that returns the group of completions of one prompt."""

    rewards: Sequence[Sequence[float]]
    """Of each prompt of all processes, in the order of the prompts; NaN where nothing could be scored."""
    cut: Callable[[int], Group]
    """The group of a prompt of this process, by its place among these."""


class Sampler(Protocol):
    """The methods of a trainer that dynamic sampling needs."""

    def draw(self, count: int) -> Drawn:
        """Return the next `count` prompts, the same in all processes."""
        ...

    def answer(self, rows: Sequence[Row]) -> RoundRewards:
        """Return completions of this process's prompts, and the rewards of all processes."""
        ...

    def observe(self, row: Row, rewards: Sequence[float]) -> None:
        """Report the rewards of a prompt to the curriculum, whether its group is used or not."""
        ...


@dataclass
class FilledStep:
    """The groups of completions selected for a step, and the statistics of the rounds that gave them."""

    owners: list[int] = field(default_factory=list[int])
    """Of each good group of all processes, the process that answered it; in the order of the prompts."""
    own: dict[int, Group] = field(default_factory=dict[int, Group])
    """The good groups that this process answered, by their place among all."""
    sizes: list[int] = field(default_factory=list[int])
    """Of the rounds: prompts answered."""
    good: int = 0
    """Groups of unequal rewards, with those that there was no more room for."""
    read: int = 0
    exhausted: bool = False
    rewards: list[float] = field(default_factory=list[float])
    """Of all completions that could be scored, also of groups left out."""

    @property
    def answered(self) -> int:
        """Return the number of prompts answered in all rounds."""
        return sum(self.sizes)


def fill(sampler: Sampler, process: ProcessRank, wanted: int, rounds: int, first: int = 0) -> FilledStep:
    """Answer prompts in rounds until enough groups have unequal rewards, or the rounds or prompts are used up.

    The first round answers `first` prompts, at least as many as groups are wanted.

    Surplus useful groups are dropped, the last prompts first, so that the selection does not depend on their durations.
    They are not kept for the next step: they come from the policy before this step's updates, and would be trained on
    up to twice as many updates late as other completions, with clipped ratios. Later rounds are therefore no larger
    than the fraction of useful groups so far suggests.
    """
    filled = FilledStep()
    while len(filled.owners) < wanted and len(filled.sizes) < rounds and not filled.exhausted:
        drawn = sampler.draw(round_size(wanted, filled, process.world, first))
        filled.read += drawn.read
        filled.exhausted = drawn.exhausted
        if drawn.rows:
            _add_round(filled, sampler, process, drawn.rows, wanted)
    return filled


def round_size(wanted: int, filled: FilledStep, world: int, first: int = 0) -> int:
    """Return the number of prompts in the next round, a multiple of the number of processes."""
    if not filled.sizes:
        return ceil(max(first, wanted) / world) * world
    missing = wanted - len(filled.owners)
    likely = ceil(missing * filled.answered / filled.good) if filled.good else wanted
    return ceil(min(likely, wanted) / world) * world


def _add_round(filled: FilledStep, sampler: Sampler, process: ProcessRank, rows: list[Row], wanted: int) -> None:
    """Answer prompts, and keep the groups of completions with unequal rewards while there is room.

    At the end of a stream some prompts are answered twice so that no process waits; only the first time counts.
    """
    each = ceil(len(rows) / process.world)
    even = [rows[number % len(rows)] for number in range(each * process.world)]
    first = process.rank * each
    answered = sampler.answer(even[first : first + each])
    filled.sizes.append(len(rows))
    for number, rewards in enumerate(answered.rewards[: len(rows)]):
        scored = [reward for reward in rewards if not isnan(reward)]
        filled.rewards += scored
        sampler.observe(rows[number], scored)
        if not has_spread(scored):
            continue
        filled.good += 1
        if len(filled.owners) < wanted:
            if number // each == process.rank:
                filled.own[len(filled.owners)] = answered.cut(number - first)
            filled.owners.append(number // each)


def has_spread(rewards: Sequence[float]) -> bool:
    """Return whether the rewards of a group differ by more than rounding errors."""
    return bool(rewards) and max(rewards) - min(rewards) > REWARD_TOLERANCE


def balance(owners: Sequence[int], world: int) -> list[int]:
    """Return which process trains on each group of completions, in nearly equal numbers with few transfers."""
    shares = [len(owners) // world + (rank < len(owners) % world) for rank in range(world)]
    left, homeless, places = list(shares), list[int](), list(owners)
    for number, owner in enumerate(owners):
        if left[owner]:
            left[owner] -= 1
        else:
            homeless.append(number)
    free = [rank for rank in range(world) for _ in range(left[rank])]
    for number, rank in zip(homeless, free, strict=True):
        places[number] = rank
    return places


Part = Literal["generation", "reward", "drawing", "logprobs"]

NAMES = {  # of TRL's metrics, by the library's names
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
    """The timings and metrics of the current step."""

    parts: dict[Part, float] = field(default_factory=dict[Part, float])
    """Seconds."""
    grad_norms: list[float] = field(default_factory=list[float])
    filled: FilledStep = field(default_factory=FilledStep)
    _made: float = 0.0
    _problems: float = 0.0
    _began: float = 0.0
    _updating: float = 0.0

    def begin(self) -> None:
        """Start the measurement of a step."""
        self.parts, self.grad_norms, self._began = {}, [], perf_counter()

    @contextmanager
    def time(self, part: Part) -> Generator[None]:
        """Add the duration of the block to a part of the step."""
        start = perf_counter()
        try:
            yield
        finally:
            self.parts[part] = self.parts.get(part, 0.0) + perf_counter() - start

    def update(self, filled: FilledStep) -> None:
        """Record the groups selected for a step, and the current time as the start of the weights' update."""
        self.filled, self._updating = filled, perf_counter()

    def made(self, cpu_seconds: float) -> None:
        """Record the total CPU time that other processes have spent on generating problems, s."""
        self._problems, self._made = cpu_seconds - self._made, cpu_seconds

    def flat(self) -> dict[str, float]:
        """Return the metrics of the step that are added to TRL's own log."""
        filled, rewards = self.filled, self.filled.rewards
        metrics: dict[str, float] = {
            "rounds": len(filled.sizes),
            "prompts": filled.answered,
            "groups": len(filled.owners),
            "zero_variance": 1.0 - filled.good / max(filled.answered, 1),
        }
        if rewards:
            metrics |= {"pass_rate": _mean([reward >= 1.0 - REWARD_TOLERANCE for reward in rewards])}
        if self.grad_norms:
            metrics |= {"grad_norm": _mean(self.grad_norms)}
        return metrics | {f"seconds/{name}": value for name, value in self._seconds().model_dump().items()}

    def _seconds(self) -> StepSeconds:
        now, parts = perf_counter(), self.parts
        names: tuple[Part, ...] = ("generation", "reward", "drawing", "logprobs")
        update = now - self._updating
        spent = {name: parts.get(name, 0.0) for name in names}
        return StepSeconds(step=now - self._began, update=update, problems=self._problems, **spent)

    def record(self, logged: Mapping[str, float | None], *, step: int, updates: int, consumed: int) -> StepRecord:
        """Return the record of a step for the log file.

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
    """Merge the values that TRL logged in several rounds of a step into one per metric, weighted by prompts.

    `sizes` are the prompts of each round; `before` is the number of earlier entries of each metric. TRL would weight
    rounds equally.
    """
    for name, entries in metrics.items():
        start = before.get(name, 0)
        pairs = [(value, size) for value, size in zip(entries[start:], sizes, strict=False) if not isnan(value)]
        if len(entries) - start != len(sizes) or not pairs:
            continue
        kind = name.rpartition("/")[2].partition("_")[0]
        values = [value for value, _ in pairs]
        weighed = sum(value * size for value, size in pairs) / sum(size for _, size in pairs)
        entries[start:] = [min(values) if kind == "min" else max(values) if kind == "max" else weighed]
