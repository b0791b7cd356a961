"""The folder of a run of supervised fine-tuning.

OUT/sft.json       what decides the weights, and the versions of the libraries with which it was begun
OUT/rows.jsonl     all rows in their order, before the limits of tokens
OUT/corpora.json   how many rows each corpus gave
OUT/initial/       the model that was made here, if one was
OUT/checkpoints/   what a run goes on from; those with the file `whole` are whole
OUT/log.jsonl      loss, learning rate and tokens a second, every few steps
OUT/model/         the trained model; with adapters these are merged into it, and stand alone in OUT/adapter/
OUT/result.json    what came of it; written last
"""

import json
import shutil
from dataclasses import asdict
from pathlib import Path

from pydantic import JsonValue

from sim2reason.datasets.atomic_files import canonical, put, put_text, sync
from sim2reason.datasets.item import Record
from sim2reason.training.corpora import Row
from sim2reason.training.corpora.parts.lines import rows_in
from sim2reason.training.corpora.parts.mix import mixed
from sim2reason.training.run_plan import SFT_PLAN, claim, finish, result_in
from sim2reason.training.sft.config import FineTuning
from sim2reason.training.step_lines import StepLines

__all__ = ["FineTuned", "SftFolder"]

ROWS, CORPORA, LOG, WHOLE = "rows.jsonl", "corpora.json", "log.jsonl", "whole"
CHECKPOINT = "checkpoint-"


class FineTuned(Record):
    """What came of a run; ``result.json``."""

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
    """The files of a run."""

    def __init__(self, path: Path) -> None:
        """At `path`, which need not be there yet."""
        self.path = path
        self.initial, self.checkpoints, self.log = path / "initial", path / "checkpoints", StepLines(path / LOG)
        self.model, self.adapter = path / "model", path / "adapter"

    def claim(self, config: FineTuning) -> None:
        """As `run_plan.claim` does."""
        claim(self.path / SFT_PLAN, config.decisive, config.check, self.prepared)

    @property
    def prepared(self) -> tuple[Path, ...]:
        """What comes before the first step of training."""
        return *(self.path / name for name in (SFT_PLAN, ROWS, CORPORA)), self.initial

    def result(self) -> FineTuned | None:
        """What came of a run that is finished."""
        return result_in(self.path, FineTuned)

    def finish(self, result: FineTuned) -> None:
        """Write the result."""
        finish(self.path, result)

    def draw(self, config: FineTuning, avoid: frozenset[str] = frozenset()) -> None:
        """Write the rows, unless they are there: a run that goes on learns from the same, whatever became of files."""
        if (self.path / CORPORA).is_file():
            return
        mix = mixed(config.corpora, config.seed, avoid)

        def write(temporary: Path) -> None:
            with temporary.open("w", encoding="utf-8", newline="\n") as file:
                file.writelines(f"{json.dumps(asdict(row), ensure_ascii=False)}\n" for row in mix.rows)

        put(self.path / ROWS, write, self.path)
        put_text(self.path / CORPORA, canonical([asdict(each) for each in mix.corpora]), self.path)

    def rows(self) -> list[Row]:
        """All rows in their order."""
        return list(rows_in(self.path / ROWS))

    def corpora(self) -> list[dict[str, JsonValue]]:
        """What each corpus gave."""
        return json.loads((self.path / CORPORA).read_text("utf-8"))

    def checkpoint(self) -> Path | None:
        """The last whole checkpoint; None before the first."""
        found = {
            int(path.parent.name.removeprefix(CHECKPOINT)): path.parent
            for path in self.checkpoints.glob(f"{CHECKPOINT}[0-9]*/{WHOLE}")
        }
        return found[max(found)] if found else None

    def rewind(self) -> int:
        """Forget what came after the last whole checkpoint; the step of that, zero before the first."""
        last = self.checkpoint()
        step = int(last.name.removeprefix(CHECKPOINT)) if last else 0
        for path in self.checkpoints.glob(f"{CHECKPOINT}*"):
            if not (path / WHOLE).is_file():
                shutil.rmtree(path)
        self.log.rewind(step)
        return step

    def whole(self, step: int) -> None:
        """Mark a checkpoint, all of whose files are written, as whole, once they are on disk."""
        folder = self.checkpoints / f"{CHECKPOINT}{step}"
        for path in folder.rglob("*"):
            sync(path)
        put_text(folder / WHOLE, f"{step}\n", folder)
