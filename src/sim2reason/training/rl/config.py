"""Configuration and folder of reinforcement learning: a model, problems, a reward, and held-out problems."""

# TRL and transformers are an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

import json
import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, Literal, Self, cast

from annotated_types import Ge, Le, MinLen
from pydantic import BaseModel, BeforeValidator, ConfigDict, SerializeAsAny, model_validator

from sim2reason.base.atomic_files import canonical, put_text
from sim2reason.base.settings import build_each, configuration
from sim2reason.errors import TrainingError
from sim2reason.generation.item import Record
from sim2reason.training.extras import External, versions
from sim2reason.training.gspo.settings import GSPOSettings
from sim2reason.training.models import MODELS, Checkpoint, ModelSettings, model_given
from sim2reason.training.problem_stream import Curriculum, ProblemStream, prefetching
from sim2reason.training.rewards import REWARDS, Reward, build_reward
from sim2reason.training.run_files import RL_PLAN, claim, finish, read_result
from sim2reason.training.sft.config import FineTuning, SftFolder, build_fine_tuning
from sim2reason.training.sources import SOURCES, Problem, ProblemSource, build_source
from sim2reason.training.sources.problems import Fresh

__all__ = [
    "WARM_START",
    "HeldOut",
    "Prefetch",
    "ReinforcementLearning",
    "TrainingFolder",
    "TrainingResult",
    "build_reinforcement_learning",
]

WARM_START = "warm-start"


def _sources(given: object) -> object:
    return build_each(given, build_source, "problems")


def _one_or_more(given: object) -> object:
    return (cast("object", given),) if isinstance(given, Mapping) else given


def _warm_start(given: object) -> object:
    """Return the settings of a warm start with its folder inside that of the run."""
    if not isinstance(given, Mapping):
        return given
    if "out" in given:
        raise TrainingError("warm_start.out: its folder is in that of the run; leave it out")
    return build_fine_tuning({**cast("Mapping[str, object]", given), "out": WARM_START})


class _Settings(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, protected_namespaces=())


class Prefetch(_Settings):
    """The worker processes that generate problems ahead of time, without affecting which ones."""

    workers: Annotated[int, Ge(0), Le(1024)] = 1
    depth: Annotated[int, Ge(1), Le(100_000)] = 64
    """Problems of each cell that are ordered ahead."""


class HeldOut(_Settings):
    """Problems kept for evaluation: like those of a source, but from another seed or other recipes."""

    problems: SerializeAsAny[Fresh]
    items: Annotated[int, Ge(1), Le(10**6)] = 500
    samples: Annotated[int, Ge(1), Le(4096)] = 1
    """Sampled responses to each problem, beside the greedy one."""


class ReinforcementLearning(_Settings):
    """The complete settings of a run: model, problems, reward and algorithm."""

    out: Path
    """The folder of the run."""
    model: Annotated[SerializeAsAny[ModelSettings], BeforeValidator(model_given)] | None = None
    """A checkpoint; with a warm start, its result is trained."""
    warm_start: Annotated[FineTuning, BeforeValidator(_warm_start)] | None = None
    """Supervised fine-tuning before, without its folder."""
    problems: Annotated[tuple[SerializeAsAny[ProblemSource], ...], MinLen(1), BeforeValidator(_sources)]
    prefetch: Prefetch = Prefetch()
    curriculum: Curriculum | None = None
    reward: Annotated[SerializeAsAny[Reward], BeforeValidator(build_reward)]
    gspo: GSPOSettings = GSPOSettings()
    processes: Annotated[int, Ge(1), Le(1024)] = 1
    """How many share each step on this machine, one for each GPU or core; accelerate and torchrun say it themselves."""
    chat: bool | Literal["auto"] = "auto"
    """Whether prompts are messages; by default if the tokenizer has a chat template."""
    held_out: Annotated[tuple[HeldOut, ...], BeforeValidator(_one_or_more)] = ()
    """One set of problems, or several, each with a name of its own."""
    answers_together: Annotated[int, Ge(1), Le(4096)] | None = None
    """Responses to held-out problems that are generated at once; by default 64, or as many as a prompt has in training
    if that is more. A GPU takes many more."""

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        if (self.model is None) == (self.warm_start is None):
            raise ValueError("give either model or warm_start")
        self.check_shares(self.processes)
        self._check_held_out()
        return self

    def check_shares(self, processes: int) -> None:
        """Raise TrainingError if the completions and rows of a step cannot be divided among `processes` processes."""
        self.gspo.shares(processes)
        if self.warm_start is not None:
            try:
                self.warm_start.accumulated(processes)
            except TrainingError as error:
                raise TrainingError(f"warm_start.{error}") from None

    def _check_held_out(self) -> None:
        """Raise ValueError if held-out problems are trained on, or two sets have the same name."""
        seeds = {source.seed for source in self.problems if isinstance(source, Fresh)}
        names = [each.problems.name for each in self.held_out]
        if any(each.problems.seed in seeds for each in self.held_out):
            raise ValueError("held_out.problems.seed: problems are trained on with this seed; take another")
        if twice := sorted({name for name in names if names.count(name) > 1}):
            raise ValueError(f"held_out: the name {twice[0]!r} stands twice; give each set its own")

    @property
    def libraries(self) -> tuple[str, ...]:
        """Return the additional libraries that these settings need."""
        return (*self.gspo.libraries, *(() if self.warm_start is None else self.warm_start.libraries))

    @property
    def evaluation_policy(self) -> dict[str, Any]:
        """Return the settings of the policy for held-out problems, without model and temperature."""
        return {
            "kind": "transformers",
            "precision": "bfloat16" if self.gspo.precision == "bfloat16" else "auto",
            "chat": self.chat is not False,
            "sampling": {"max_tokens": self.gspo.max_completion_tokens},
            "batch_size": self.answers_together or max(64, self.gspo.generations),
            "cuda_graphs": self.gspo.cuda_graphs,
        }

    def check(self) -> None:
        """Check before a run that model, corpora and problems exist.

        Raises:
            TrainingError, EvaluationError, DatasetError: one of them is not there, or not what it must be.
        """
        ProblemStream(self.problems)
        for part in (self.model, self.warm_start):
            if part is not None:
                part.check()

    @property
    def decisive(self) -> dict[str, Any]:
        """Return the settings that affect the weights."""
        settings = self.model_dump(
            mode="json",
            exclude={"out": True, "prefetch": True, "answers_together": True, "held_out": {"__all__": {"samples"}}},
        )
        settings["reward"]["kind"] = REWARDS.name_of(self.reward)
        pairs = zip(self.problems, settings["problems"], strict=True)
        settings["problems"] = [{"kind": SOURCES.name_of(source), **each} for source, each in pairs]
        if self.model is not None:
            settings["model"]["kind"] = MODELS.name_of(self.model)
        if self.warm_start is not None:
            settings["warm_start"] = self.warm_start.decisive
        operational = "save_every", "keep", "microbatch", "report_to"
        settings["gspo"] = {name: value for name, value in settings["gspo"].items() if name not in operational}
        return settings


def build_reinforcement_learning(
    config: "Path | str | Mapping[str, object] | ReinforcementLearning", out: Path | None = None
) -> ReinforcementLearning:
    """Return the configuration in a YAML file or settings; `out` overrides the output folder.

    Relative paths refer to the current working directory.

    Raises:
        TrainingError: what is missing, unknown or makes no sense; the line names its place.
        EvaluationError: a file that is no YAML.
        UnknownNameError: no such kind of model, source or reward.
    """
    if isinstance(config, ReinforcementLearning):
        return config if out is None else config.model_copy(update={"out": out})
    return configuration(config, out, ReinforcementLearning.model_validate, TrainingError, ReinforcementLearning)


AVOIDED = "keys.json"


class TrainingResult(Record):
    """The result of a run, stored in ``result.json``."""

    model: str
    """The folder of the trained model, seen from that of the run."""
    initial: str
    """The checkpoint that training began with: a folder, or a name on the hub."""
    revision: str | None = None
    """Of the name on the hub."""
    steps: int
    prompts_consumed: int
    seconds: float
    """Of all steps."""
    versions: dict[str, str]


class TrainingFolder:
    """The files of a run of reinforcement learning."""

    def __init__(self, path: Path) -> None:
        """Store the path, which need not exist."""
        self.path = path
        self.warm_start, self.train, self.model = path / WARM_START, path / "train", path / "model"
        self.held_out, self.initial = path / "held-out", path / "initial"
        self.learned = self.warm_start / "corpora.json"
        self.evaluation, self.report = path / "evaluation", path / "report" / "report.json"

    def claim(self, config: ReinforcementLearning) -> None:
        """Write the plan of a new run, or check that the folder holds a run with equal settings."""
        prepared = self.held_out, self.initial, *SftFolder(self.warm_start).prepared
        claim(self.path / RL_PLAN, config.decisive, config.check, prepared)

    def is_prepared(self, config: ReinforcementLearning) -> bool:
        """Return whether all steps before reinforcement learning are complete."""
        warm = config.warm_start is None or SftFolder(self.warm_start).result() is not None
        return warm and (not config.held_out or self._avoided.is_file())

    def result(self) -> TrainingResult | None:
        """Return the result of a finished run, else None."""
        return read_result(self.path, TrainingResult)

    def problems(self, name: str) -> Path:
        """Return the path of a held-out set."""
        return self.held_out / f"{name}.jsonl"

    @property
    def _avoided(self) -> Path:
        """Return the path of the file with the prompts and hashes of held-out problems, which training must avoid."""
        return self.held_out / AVOIDED

    def hold_out(self, sets: Sequence[HeldOut], workers: int) -> frozenset[str]:
        """Generate the held-out problems unless they exist; return the prompts and hashes that training must avoid."""
        keys = self._avoided
        if not keys.is_file():
            self.held_out.mkdir(exist_ok=True)
            drawn = [_drawn(wanted, workers) for wanted in sets]
            for wanted, problems in zip(sets, drawn, strict=True):
                text = "".join(f"{problem.item.model_dump_json()}\n" for problem in problems)
                put_text(self.problems(wanted.problems.name), text, self.held_out)
            avoided = [key for problems in drawn for each in problems for key in (each.item.prompt, each.fingerprint)]
            put_text(keys, canonical(avoided), self.held_out)
        return frozenset(json.loads(keys.read_text("utf-8")))

    def finish(self, run: External, tokenizer: External, initial: Checkpoint) -> None:
        """Save the model with merged adapters, its tokenizer, and then the result."""
        scratch = self.path / "model.part"
        model = run.accelerator.unwrap_model(run.model)
        if hasattr(model, "merge_and_unload"):
            model = model.merge_and_unload()
        records = run.step_log.read()
        result = TrainingResult(
            model=self.model.name,
            initial=initial.path,
            revision=initial.revision,
            steps=records[-1].step if records else 0,
            prompts_consumed=run.prompts_consumed,
            seconds=sum(record.seconds.step for record in records),
            versions=versions(),
        )
        if run.accelerator.is_main_process:
            model.save_pretrained(scratch)
            tokenizer.save_pretrained(scratch)
            if self.model.is_dir():
                shutil.rmtree(self.model)  # of a run that was killed before its result was written
            scratch.rename(self.model)
            finish(self.path, result)


def _drawn(wanted: HeldOut, workers: int) -> list[Problem]:
    """Return the first problems of a source, without repeated numbers."""
    with prefetching(workers, 4 * max(workers, 1)) as store:
        stream, by_fingerprint = ProblemStream((wanted.problems,), store), dict[str, Problem]()
        while len(by_fingerprint) < wanted.items:
            by_fingerprint |= {
                problem.fingerprint: problem for problem in stream.problems(wanted.items - len(by_fingerprint))
            }
            stream.avoid = frozenset(by_fingerprint)
    return list(by_fingerprint.values())
