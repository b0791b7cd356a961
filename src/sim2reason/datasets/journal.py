"""What a run has finished, so that the next can go on: one small record per shard, in a hidden folder.

    OUT/.journal/plan.json                 the configuration and versions, written before anything else
    OUT/.journal/items-00000-00499.json    a shard's record, written after the shard

The folder goes when the manifest stands, which holds the same records.
"""

import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import TypeVar

from pydantic import ValidationError

from sim2reason.datasets.atomic_files import checksum, sweep
from sim2reason.datasets.item import Record
from sim2reason.datasets.manifest import MANIFEST, Manifest, Shard, load, save
from sim2reason.datasets.plan import Config, file_name, versions
from sim2reason.errors import DatasetError

FOLDER, PLAN = ".journal", "plan.json"
R = TypeVar("R", bound=Record)


class RunPlan(Record):
    """What decides every byte of a dataset."""

    config: Config
    versions: dict[str, str]

    def differences(self, other: "RunPlan") -> list[str]:
        """In words: where `other` differs from this."""
        mine, theirs = _flat(self), _flat(other)
        names = sorted(mine.keys() | theirs.keys())
        return [f"{n} {mine.get(n)!r} ≠ {theirs.get(n)!r}" for n in names if mine.get(n) != theirs.get(n)]


class Journal:
    """The records of one run or of the runs before it; the caller holds the folder's lock."""

    def __init__(self, out: Path, config: Config) -> None:
        """Open the journal of `out`; DatasetError, and nothing touched, if the folder is not ours to fill."""
        self.out, self.folder, self.plan = out, out / FOLDER, RunPlan(config=config, versions=versions())
        manifest = self._claim()
        self.folder.mkdir(exist_ok=True)
        sweep(out)
        sweep(self.folder)
        save(self.plan, self.folder / PLAN)
        self._known = {shard.name: shard for shard in manifest.shards} if manifest else {}

    def _claim(self) -> Manifest | None:
        manifest = load(self.out) if (self.out / MANIFEST).is_file() else None
        begun = _read(self.folder / PLAN, RunPlan)
        found = RunPlan(config=manifest.config, versions=manifest.versions) if manifest else begun
        if found is None:
            if strangers := sorted(p.name for p in self.out.iterdir() if p.name != FOLDER):
                raise DatasetError(f"{self.out}: holds {strangers[0]} and is no dataset; choose a new folder")
        elif differences := found.differences(self.plan):
            raise DatasetError(
                f"{self.out}: holds a dataset of another configuration ({'; '.join(differences)}); "
                "choose a new folder, or the same options and versions to go on"
            )
        return manifest

    def finished(self) -> dict[str, Shard]:
        """The records of the shards that stand undamaged, by name."""
        expected = [file_name(positions) for positions in self.plan.config.shards()]
        records = {name: _read(self._record(name), Shard) or self._known.get(name) for name in expected}
        return {n: shard for n, shard in records.items() if shard and shard.sha256 == checksum(self.out / n)}

    def note(self, shard: Shard) -> None:
        """Keep the record of a shard that stands."""
        save(shard, self._record(shard.name))

    def close(self) -> None:
        """The manifest stands: the journal may go."""
        shutil.rmtree(self.folder)

    def _record(self, name: str) -> Path:
        return self.folder / f"{Path(name).stem}.json"


def _flat(plan: RunPlan) -> Mapping[str, object]:
    return plan.config.model_dump(mode="json") | plan.versions


def _read(path: Path, kind: type[R]) -> R | None:
    try:
        return kind.model_validate_json(path.read_bytes())
    except (FileNotFoundError, ValidationError):
        return None
