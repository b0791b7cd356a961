"""Settings of a GSPO run, and the protocol of its prompt stream."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any, Literal, Protocol, Self

from annotated_types import Ge, Gt, Le
from pydantic import BaseModel, ConfigDict, FiniteFloat, JsonValue, model_validator

from sim2reason.errors import TrainingError
from sim2reason.training.optimization import Lora

__all__ = ["Drawn", "GSPOSettings", "PromptStream", "VllmSettings", "draw"]

Count = Annotated[int, Ge(1)]
Rate = Annotated[FiniteFloat, Ge(0.0)]


class _Settings(BaseModel):
    """The base of settings: frozen, without unknown names."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class VllmSettings(_Settings):
    """Generation by vLLM, in the training processes (*colocate*) or behind an address (*server*)."""

    mode: Literal["colocate", "server"] = "colocate"
    memory: Annotated[FiniteFloat, Gt(0.0), Le(1.0)] = 0.3
    """The share of a GPU's memory that vLLM may use, if colocated."""
    tensor_parallel: Count = 1
    sleep: bool = False
    """Whether vLLM gives its memory back between two generations, if colocated."""
    address: str | None = None
    """Of a server that `trl vllm-serve` runs, such as http://localhost:8000."""
    correction: bool = True
    """Truncated importance sampling against vLLM's other rounding."""


class GSPOSettings(_Settings):
    """The settings of one run; a *step* is one batch of prompts, trained in `minibatches` updates.

    verl and the paper count steps in this way; TRL, transformers and the names of checkpoints count updates.
    """

    steps: Count = 200
    prompts: Count = 32
    """Groups of a step, over all processes; their number divides it."""
    generations: Annotated[int, Ge(2)] = 16
    """Completions of a prompt, which make one group (G)."""
    minibatches: Annotated[int, Ge(2)] = 4
    """Updates of a step. With one alone the ratio would be one, and nothing would ever be clipped."""
    microbatch: Count | None = None
    """Completions that a device takes through the model at once; gradients add up to the same. None: a minibatch."""
    rounds: Count = 10
    """At most as often are prompts drawn and answered to fill a step with groups of unequal rewards."""
    first_round: Annotated[FiniteFloat, Ge(1.0), Le(100.0)] = 1.0
    """Times `prompts`, how many the first round answers; more than 1 is quicker where rounds are what costs time."""
    epsilon_low: Annotated[FiniteFloat, Gt(0.0), Le(1.0)] = 3e-4
    epsilon_high: Annotated[FiniteFloat, Gt(0.0)] = 4e-4
    """The ratio is a geometric mean over tokens, so these are far below the 0.2 of PPO."""
    beta: Rate = 1e-3
    """The weight of the KL divergence to the model that training began with; zero does without that model."""
    temperature: Annotated[FiniteFloat, Gt(0.0)] = 1.0
    learning_rate: Annotated[FiniteFloat, Gt(0.0)] = 1e-6
    """Of AdamW; it rises linearly over `warmup_steps` and stays."""
    warmup_steps: Annotated[int, Ge(0)] = 10
    weight_decay: Rate = 0.1
    max_grad_norm: Annotated[FiniteFloat, Gt(0.0)] = 1.0
    max_prompt_tokens: Count = 2048
    """A longer prompt is passed over."""
    max_completion_tokens: Count = 16384
    save_every: Count = 20
    """Steps between two checkpoints; the last step always has one."""
    keep: Annotated[int, Ge(2)] = 2
    """Checkpoints that stay on disk. Fewer than two would leave none if a run were killed while it writes the next."""
    seed: Annotated[int, Ge(0), Le(2**32 - 1)] = 0
    """Of what is sampled. Prompts come from a stream, which has a seed of its own."""
    precision: Literal["float32", "bfloat16"] = "float32"
    """Of the arithmetic; weights that are trained are float32 in either case, since an update of 1e-6 needs it, unless
    the model's own settings say otherwise."""
    gradient_checkpointing: bool = True
    """Less memory for a fifth more time: for long completions of large models."""
    lora: Lora | None = None
    cuda_graphs: bool = False
    """Rollouts with a cache of fixed size, and each token on a GPU the replay of one recorded pass: for models so small
    that launches bound them."""
    vllm: VllmSettings | None = None
    report_to: tuple[Literal["tensorboard", "wandb"], ...] = ()

    @property
    def libraries(self) -> tuple[str, ...]:
        """Return the additional libraries that these settings need."""
        chosen = {"peft": self.lora, "vllm": self.vllm}
        return (*(name for name, settings in chosen.items() if settings is not None), *self.report_to)

    def check_context(self, tokens: int) -> None:
        """Raise TrainingError if a context of `tokens` has no room for a completion."""
        if self.max_completion_tokens >= tokens:
            raise TrainingError(
                f"gspo.max_completion_tokens: {self.max_completion_tokens} leave no room for a prompt in the model's "
                f"context of {tokens} tokens; give fewer"
            )

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        self.shares(1)
        if self.cuda_graphs and (self.vllm is not None or self.lora is not None):
            raise ValueError("cuda_graphs: cannot be combined with vllm or lora; leave one of them out")
        return self

    def shares(self, processes: int) -> tuple[int, int]:
        """Return how many completions a process handles per forward pass, and how many passes make an update.

        TrainingError if completions cannot be divided evenly.
        """
        all_of_them, on = self.prompts * self.generations, f" on {processes} processes" if processes > 1 else ""
        if self.prompts % processes:
            raise TrainingError(f"gspo.prompts: {self.prompts} cannot be shared evenly by {processes} processes")
        rows, rest = divmod(all_of_them, processes * self.minibatches)
        if rest:
            raise TrainingError(
                f"gspo.minibatches: {all_of_them} completions a step, prompts times generations, cannot be cut into "
                f"{self.minibatches} minibatches{on}"
            )
        micro = self.microbatch or rows
        if rows % micro:
            raise TrainingError(
                f"gspo.microbatch: the {rows} completions of a minibatch{on} cannot be cut into microbatches of {micro}"
            )
        return micro, rows // micro


MAX_SKIPPED_PER_PROMPT = 100  # prompts skipped per wanted one before a stream counts as unsuitable
PICTURES = {"image", "images", "environment"}  # columns that TRL would interpret

Row = dict[str, Any]


class PromptStream(Protocol):
    """A finite or endless stream of prompts in a reproducible order.

    A row is a dictionary with *prompt*, a text or a list of messages, and the columns for rewards: *ground_truth*,
    *id*, *source*. All other columns are passed to the reward functions, with None where a row lacks them.
    """

    @property
    def cpu_seconds(self) -> float:
        """Return the CPU time that other processes have spent on rows so far."""
        ...

    def next_prompts(self, count: int) -> Sequence[Mapping[str, Any]]:
        """Return the next `count` rows; a smaller number means that the stream has ended."""
        ...

    def observe(self, row: Mapping[str, Any], rewards: Sequence[float]) -> None:
        """Receive the rewards of a row's completions, from which a curriculum measures pass rates."""
        ...

    def state(self) -> JsonValue:
        """Return a value from which `restore` continues the stream with the next row."""
        ...

    def restore(self, state: JsonValue) -> None:
        """Continue from a value that `state` returned."""
        ...


@dataclass
class Drawn:
    """The rows that one process read from the stream for all processes, and whether the stream has ended."""

    rows: list[Row] = field(default_factory=list[Row])
    read: int = 0
    """Rows that the stream gave, with those that were passed over."""
    exhausted: bool = False


def draw(stream: PromptStream, count: int, fits: Callable[[Row], bool]) -> Drawn:
    """Return the next `count` rows with short enough prompts, or as many as there are, all with equal columns.

    Raises:
        TrainingError: a row has no prompt or has pictures, texts and messages are mixed, or hardly a prompt fits.
    """
    drawn = Drawn()
    while len(drawn.rows) < count and not drawn.exhausted:
        wanted = count - len(drawn.rows)
        batch = [dict(row) for row in stream.next_prompts(wanted)]
        if len(batch) > wanted:
            raise TrainingError(f"a stream of prompts gave {len(batch)} rows where {wanted} were asked for")
        drawn.exhausted = len(batch) < wanted
        drawn.read += len(batch)
        drawn.rows += [row for row in batch if _checked(row) and fits(row)]
        if drawn.read - len(drawn.rows) > MAX_SKIPPED_PER_PROMPT * count:
            raise TrainingError(
                f"only {len(drawn.rows)} of {drawn.read} prompts are short enough; raise max_prompt_tokens"
            )
    if len({isinstance(row["prompt"], str) for row in drawn.rows}) > 1:
        raise TrainingError("some prompts are texts and some are messages; give all of them in one form")
    columns = sorted({name for row in drawn.rows for name in row})
    drawn.rows = [{name: row.get(name) for name in columns} for row in drawn.rows]
    return drawn


def _checked(row: Row) -> bool:
    prompt = row.get("prompt")
    if not isinstance(prompt, str | list) or not prompt:
        raise TrainingError(f"a row without a prompt, with the columns {', '.join(map(str, row))}"[:200])
    if PICTURES & row.keys():
        raise TrainingError(f"a row with the column {min(PICTURES & row.keys())!r}: prompts here are text alone")
    return True
