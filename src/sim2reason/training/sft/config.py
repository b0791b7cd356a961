"""Configuration and folder of supervised fine-tuning."""

import json
import shutil
from collections.abc import Mapping
from dataclasses import asdict
from math import ceil
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Self

from annotated_types import Ge, Gt, Le, MinLen
from pydantic import BaseModel, BeforeValidator, ConfigDict, JsonValue, SerializeAsAny, model_validator

from sim2reason.base.atomic_files import canonical, put_text, sync, write_atomically
from sim2reason.base.settings import build_each, configuration
from sim2reason.errors import TrainingError
from sim2reason.generation.item import Record
from sim2reason.training.corpora import CORPORA, Corpus, Row, build_corpus
from sim2reason.training.corpora.rows import mix_corpora, read_rows
from sim2reason.training.models import MODELS, ModelSettings, model_given
from sim2reason.training.optimization import Lora
from sim2reason.training.run_files import SFT_PLAN, StepLines, claim, finish, read_result

__all__ = ["FineTuning", "FineTuningResult", "SftFolder", "build_fine_tuning"]

MAX_SEED = 2**32 - 1  # of numpy's global generator, which the trainer seeds
MAX_STEPS = 10**8


def _corpora(given: object) -> object:
    return build_each(given, build_corpus, "corpora")


Rate = Annotated[float, Gt(0.0), Le(10.0)]


class FineTuning(BaseModel):
    """The settings of fine-tuning: a model, its corpora, and the algorithm."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, protected_namespaces=())

    out: Path
    """The folder of the run."""
    model: Annotated[SerializeAsAny[ModelSettings], BeforeValidator(model_given)]
    corpora: Annotated[tuple[SerializeAsAny[Corpus], ...], MinLen(1), BeforeValidator(_corpora)]
    seed: Annotated[int, Ge(0), Le(MAX_SEED)] = 0
    """Of the mix of corpora and of the order of rows in each pass over them."""
    chat: bool | Literal["auto"] = "auto"
    """Whether rows are put into the tokenizer's chat template; by default if it has one."""
    max_prompt_tokens: Annotated[int, Ge(1)] = 2048
    max_completion_tokens: Annotated[int, Ge(1)] = 16_384
    """Longer rows are counted and left out."""
    steps: Annotated[int, Ge(1), Le(MAX_STEPS)] | None = None
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
    warmup: Annotated[int, Ge(0), Le(MAX_STEPS)] = 0
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
    save_every: Annotated[int, Ge(1), Le(MAX_STEPS)] = 500
    """Steps from one checkpoint to the next; a run that was broken off goes on from the last."""
    keep: Annotated[int, Ge(1), Le(1000)] = 2
    """Checkpoints that are kept."""
    log_every: Annotated[int, Ge(1), Le(MAX_STEPS)] = 10
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
        """Return the additional libraries that these settings need."""
        chosen = {"peft": self.lora is not None, "tensorboard": self.tensorboard}
        return tuple(name for name, wanted in chosen.items() if wanted)

    def check(self) -> None:
        """Check before a run that the model and corpora exist; TrainingError or DatasetError if not."""
        self.model.check()
        for corpus in self.corpora:
            corpus.check()

    @property
    def decisive(self) -> dict[str, Any]:
        """Return the settings that affect the weights, with the kinds of model and corpora."""
        settings = self.model_dump(mode="json", exclude=set(self.operational))
        settings["model"] = {"kind": MODELS.name_of(self.model), **settings["model"]}
        settings["corpora"] = [
            {"kind": CORPORA.name_of(corpus), **corpus.model_dump(mode="json", exclude=set(corpus.operational))}
            for corpus in self.corpora
        ]
        return settings

    def steps_of(self, rows: int) -> int:
        """Return the number of training steps: the configured one, or that of the epochs over so many rows."""
        return self.steps if self.steps is not None else min(MAX_STEPS, max(1, self._steps_of_epochs(rows)))

    def _steps_of_epochs(self, rows: int) -> int:
        assert self.epochs is not None
        return ceil(self.epochs * ceil(rows / self.batch))

    def accumulated(self, devices: int) -> tuple[int, int]:
        """Return the rows per device in one pass, and the passes per step; TrainingError if these do not divide."""
        share, rest = divmod(self.batch, devices)
        if rest:
            raise TrainingError(
                f"batch: {self.batch} rows can't be dealt to {devices} devices; give a multiple of them"
            )
        micro = min(self.micro_batch or share, share)
        if share % micro:
            raise TrainingError(f"micro_batch: {micro} does not divide the {share} rows of each of {devices} devices")
        return micro, share // micro


def build_fine_tuning(config: "Path | str | Mapping[str, object] | FineTuning", out: Path | None = None) -> FineTuning:
    """Return the configuration in a YAML file or settings; `out` overrides the output folder.

    Relative paths refer to the current working directory.

    Raises:
        TrainingError: what is missing, unknown or makes no sense; the line names its place.
        EvaluationError: a file that is no YAML.
        UnknownNameError: no such kind of model or corpus.
    """
    if isinstance(config, FineTuning):
        return config if out is None else config.model_copy(update={"out": out})
    return configuration(config, out, FineTuning.model_validate, TrainingError, FineTuning)


ROWS, CORPORA_FOLDER, LOG, WHOLE = "rows.jsonl", "corpora.json", "log.jsonl", "whole"
CHECKPOINT = "checkpoint-"


class FineTuningResult(Record):
    """The result of a run, stored in ``result.json``."""

    model: str
    """The folder of the trained model, seen from that of the run."""
    parameters: int
    """Of the model, with the adapters merged."""
    rows: int
    """Those that were learned from."""
    left_out: dict[str, int]
    """Those that were too long, by which limit."""
    steps: int
    loss: float
    """The mean over the tokens of completions, nats, over the last stretch of the log."""
    corpora: list[dict[str, JsonValue]]


class SftFolder:
    """The files of a fine-tuning run."""

    def __init__(self, path: Path) -> None:
        """Store the path, which need not exist."""
        self.path = path
        self.initial, self.checkpoints, self.log = path / "initial", path / "checkpoints", StepLines(path / LOG)
        self.model, self.adapter = path / "model", path / "adapter"

    def claim(self, config: FineTuning) -> None:
        """Write the plan of a new run, or check that the folder holds a run with equal settings."""
        claim(self.path / SFT_PLAN, config.decisive, config.check, self.prepared)

    @property
    def prepared(self) -> tuple[Path, ...]:
        """Return the paths of the files before the first step of training."""
        return *(self.path / name for name in (SFT_PLAN, ROWS, CORPORA_FOLDER)), self.initial

    def result(self) -> FineTuningResult | None:
        """Return the result of a finished run, else None."""
        return read_result(self.path, FineTuningResult)

    def finish(self, result: FineTuningResult) -> None:
        """Write the result of the run into its folder."""
        finish(self.path, result)

    def draw(self, config: FineTuning, avoid: frozenset[str] = frozenset()) -> None:
        """Write the rows unless they exist, so that a resumed run uses the same ones."""
        if (self.path / CORPORA_FOLDER).is_file():
            return
        mix = mix_corpora(config.corpora, config.seed, avoid)

        def write(temporary: Path) -> None:
            with temporary.open("w", encoding="utf-8", newline="\n") as file:
                file.writelines(f"{json.dumps(asdict(row), ensure_ascii=False)}\n" for row in mix.rows)

        write_atomically(self.path / ROWS, write, self.path)
        put_text(self.path / CORPORA_FOLDER, canonical([asdict(each) for each in mix.corpora]), self.path)

    def rows(self) -> list[Row]:
        """Return all rows in order."""
        return list(read_rows(self.path / ROWS))

    def corpora(self) -> list[dict[str, JsonValue]]:
        """Return the counts of each corpus."""
        return json.loads((self.path / CORPORA_FOLDER).read_text("utf-8"))

    def checkpoint(self) -> Path | None:
        """Return the last complete checkpoint; None before the first."""
        by_step = {
            int(path.parent.name.removeprefix(CHECKPOINT)): path.parent
            for path in self.checkpoints.glob(f"{CHECKPOINT}[0-9]*/{WHOLE}")
        }
        return by_step[max(by_step)] if by_step else None

    def rewind(self) -> int:
        """Remove everything later than the last complete checkpoint; return its step, zero without one."""
        last = self.checkpoint()
        step = int(last.name.removeprefix(CHECKPOINT)) if last else 0
        for path in self.checkpoints.glob(f"{CHECKPOINT}*"):
            if not (path / WHOLE).is_file():
                shutil.rmtree(path)
        self.log.rewind(step)
        return step

    def whole(self, step: int) -> None:
        """Mark a checkpoint as complete after syncing its files to disk."""
        folder = self.checkpoints / f"{CHECKPOINT}{step}"
        for path in folder.rglob("*"):
            sync(path)
        put_text(folder / WHOLE, f"{step}\n", folder)
