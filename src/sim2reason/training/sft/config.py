"""The configuration of supervised fine-tuning: which model learns from which corpora, and how."""

from collections.abc import Mapping
from math import ceil
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Self

from annotated_types import Ge, Gt, Le, MinLen
from pydantic import BaseModel, BeforeValidator, ConfigDict, SerializeAsAny, model_validator

from sim2reason.errors import TrainingError
from sim2reason.policies.parts.settings import configuration, each_of
from sim2reason.training.corpora import CORPORA, Corpus, corpus_from
from sim2reason.training.lora import Lora
from sim2reason.training.models import MODELS, ModelSettings, model_given

__all__ = ["FineTuning", "fine_tuning_from"]

LARGEST_SEED = 2**32 - 1  # that numpy's global generator takes, which the trainer seeds, too
MOST_STEPS = 10**8


def _corpora(given: object) -> object:
    return each_of(given, corpus_from, "corpora")


Rate = Annotated[float, Gt(0.0), Le(10.0)]


class FineTuning(BaseModel):
    """A model, the corpora that it learns from, and how it does."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, protected_namespaces=())

    out: Path
    """The folder of the run."""
    model: Annotated[SerializeAsAny[ModelSettings], BeforeValidator(model_given)]
    corpora: Annotated[tuple[SerializeAsAny[Corpus], ...], MinLen(1), BeforeValidator(_corpora)]
    seed: Annotated[int, Ge(0), Le(LARGEST_SEED)] = 0
    """Of the mix of corpora and of the order of rows in each pass over them."""
    chat: bool | Literal["auto"] = "auto"
    """Whether rows are put into the tokenizer's chat template; by default if it has one."""
    max_prompt_tokens: Annotated[int, Ge(1)] = 2048
    max_completion_tokens: Annotated[int, Ge(1)] = 16_384
    """Longer rows are counted and left out."""
    steps: Annotated[int, Ge(1), Le(MOST_STEPS)] | None = None
    """Updates of the weights; else as many as `epochs` take."""
    epochs: Annotated[float, Gt(0.0), Le(1e6)] | None = None
    """Passes over all rows."""
    batch: Annotated[int, Ge(1), Le(2**20)] = 32
    """Rows of a step, over all devices."""
    micro_batch: Annotated[int, Ge(1), Le(2**20)] | None = None
    """Rows that a device holds at once; by default its share of the batch."""
    by_length: bool = False
    """Whether the rows of a batch are about equally long: less is computed for padding, in a less random order."""
    optimizer: Literal["adamw", "muon"] = "adamw"
    """Muon has the matrices of hidden layers, and AdamW the rest; it is for models made from scratch."""
    learning_rate: Rate = 2e-5
    """The highest of AdamW."""
    muon_learning_rate: Rate = 0.02
    """The highest of Muon."""
    weight_decay: Annotated[float, Ge(0.0), Le(1.0)] = 0.0
    max_grad_norm: Annotated[float, Gt(0.0)] = 1.0
    """To which gradients are clipped."""
    warmup: Annotated[int, Ge(0), Le(MOST_STEPS)] = 0
    """Steps at the start over which learning rates rise linearly."""
    decay: Annotated[float, Ge(0.0), Le(1.0)] = 0.5
    """The share of the steps, at the end, over which they fall linearly to zero."""
    lora: Lora | None = None
    """Adapters that are trained in place of all weights."""
    precision: Literal["auto", "float32", "bfloat16"] = "auto"
    """In which is computed; by default bfloat16 on a GPU that knows it, else float32."""
    gradient_checkpointing: bool = False
    """Whether activations are computed twice to save memory."""
    device: Literal["auto", "cpu"] = "auto"
    save_every: Annotated[int, Ge(1), Le(MOST_STEPS)] = 500
    """Steps from one checkpoint to the next; a run that was broken off goes on from the last."""
    keep: Annotated[int, Ge(1), Le(1000)] = 2
    """Checkpoints that are kept."""
    log_every: Annotated[int, Ge(1), Le(MOST_STEPS)] = 10
    """Steps from one line of the log to the next."""
    tensorboard: bool = False
    """Whether the log is written for TensorBoard, too."""

    operational: ClassVar[frozenset[str]] = frozenset(
        {"out", "device", "save_every", "keep", "log_every", "tensorboard", "micro_batch", "gradient_checkpointing"}
    )
    """Settings that may change while a run is not finished."""

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if (self.steps is None) == (self.epochs is None):
            raise ValueError("give either steps or epochs")
        if self.optimizer == "muon" and self.lora is not None:
            raise ValueError("optimizer: muon trains whole matrices; leave lora out, or take adamw")
        if self.micro_batch is not None and self.batch % self.micro_batch:
            raise ValueError(f"micro_batch: {self.micro_batch} does not divide the batch of {self.batch}")
        return self

    @property
    def libraries(self) -> tuple[str, ...]:
        """Those that these settings need beside what every run does."""
        chosen = {"peft": self.lora is not None, "tensorboard": self.tensorboard}
        return tuple(name for name, wanted in chosen.items() if wanted)

    def check(self) -> None:
        """Look for the model and the corpora, before a folder is claimed; TrainingError or DatasetError without one."""
        self.model.check()
        for corpus in self.corpora:
            corpus.check()

    @property
    def decisive(self) -> dict[str, Any]:
        """What decides the weights, with the kinds of model and corpora."""
        held = self.model_dump(mode="json", exclude=set(self.operational))
        held["model"] = {"kind": MODELS.name_of(self.model), **held["model"]}
        held["corpora"] = [
            {"kind": CORPORA.name_of(corpus), **corpus.model_dump(mode="json", exclude=set(corpus.operational))}
            for corpus in self.corpora
        ]
        return held

    def steps_of(self, rows: int) -> int:
        """How many steps a run over so many rows takes."""
        return self.steps if self.steps is not None else min(MOST_STEPS, max(1, self._steps_of_epochs(rows)))

    def _steps_of_epochs(self, rows: int) -> int:
        assert self.epochs is not None
        return ceil(self.epochs * ceil(rows / self.batch))

    def accumulated(self, devices: int) -> tuple[int, int]:
        """Rows that a device holds at once, and how many times it does in a step; TrainingError if none fit."""
        share, rest = divmod(self.batch, devices)
        if rest:
            raise TrainingError(
                f"batch: {self.batch} rows can't be dealt to {devices} devices; give a multiple of them"
            )
        micro = min(self.micro_batch or share, share)
        if share % micro:
            raise TrainingError(f"micro_batch: {micro} does not divide the {share} rows of each of {devices} devices")
        return micro, share // micro


def fine_tuning_from(config: "Path | str | Mapping[str, object] | FineTuning", out: Path | None = None) -> FineTuning:
    """What a YAML file, or settings, describe; `out` stands for the folder that they name.

    Paths in it are seen from where the program runs.

    Raises:
        TrainingError: what is missing, unknown or makes no sense; the line names its place.
        EvaluationError: a file that is no YAML.
        UnknownNameError: no such kind of model or corpus.
    """
    if isinstance(config, FineTuning):
        return config if out is None else config.model_copy(update={"out": out})
    return configuration(config, out, FineTuning.model_validate, TrainingError)
