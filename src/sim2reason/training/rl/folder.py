"""The folder of a run of reinforcement learning."""

# TRL and transformers are an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

import json
import shutil
from collections.abc import Sequence
from pathlib import Path

from sim2reason.base.atomic_files import canonical, put_text
from sim2reason.generation.item import Record
from sim2reason.training.extras import External, versions
from sim2reason.training.models import Checkpoint
from sim2reason.training.prefetch import prefetching
from sim2reason.training.problem import Problem
from sim2reason.training.problem_stream import ProblemStream
from sim2reason.training.rl.config import WARM_START, HeldOut, ReinforcementLearning
from sim2reason.training.run_plan import RL_PLAN, claim, finish, result_in
from sim2reason.training.sft.config import SftFolder

__all__ = ["Trained", "TrainingFolder"]

AVOIDED = "keys.json"


class Trained(Record):
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

    def result(self) -> Trained | None:
        """Return the result of a finished run, else None."""
        return result_in(self.path, Trained)

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
            for wanted, found in zip(sets, drawn, strict=True):
                text = "".join(f"{problem.item.model_dump_json()}\n" for problem in found)
                put_text(self.problems(wanted.problems.name), text, self.held_out)
            avoided = [key for found in drawn for each in found for key in (each.item.prompt, each.fingerprint)]
            put_text(keys, canonical(avoided), self.held_out)
        return frozenset(json.loads(keys.read_text("utf-8")))

    def finish(self, run: External, tokenizer: External, initial: Checkpoint) -> None:
        """Save the model with merged adapters, its tokenizer, and then the result."""
        scratch = self.path / "model.part"
        model = run.accelerator.unwrap_model(run.model)
        if hasattr(model, "merge_and_unload"):
            model = model.merge_and_unload()
        records = run.step_log.read()
        result = Trained(
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
        stream, found = ProblemStream((wanted.problems,), store), dict[str, Problem]()
        while len(found) < wanted.items:
            found |= {problem.fingerprint: problem for problem in stream.problems(wanted.items - len(found))}
            stream.avoid = frozenset(found)
    return list(found.values())
