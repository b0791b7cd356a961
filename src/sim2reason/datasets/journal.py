"""Journal of a build: one record per finished shard in a hidden folder, so that a later run can resume.

    OUT/.sim2reason/plan.json      the configuration and versions, written before anything else: the folder is ours
    OUT/.sim2reason/00007.json     a shard's record, written after its files
    OUT/.sim2reason/00007.npy      what no other item may share, of each of its items (`distinct`)
    OUT/.sim2reason/*.tmp          files that are being written
    OUT/.sim2reason/*.lock         locks of processes that share the work

It goes when the manifest stands, which leads to the same records: file by file, and only what is named so.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import TypeVar

import numpy as np
from pydantic import ValidationError

from sim2reason.base.atomic_files import (
    FOLDER,
    TEMPORARY,
    canonical,
    checksum,
    put_text,
    remove_temporaries,
    write_atomically,
)
from sim2reason.datasets.card_content import remove_pictures
from sim2reason.datasets.duplicates import Marks
from sim2reason.datasets.manifest import MANIFEST, SHARDS, Manifest, Shard, ShardFile, load, shards
from sim2reason.datasets.plan import DATA, Config, file_name
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Record
from sim2reason.generation.request import versions

PLAN = "plan.json"
R = TypeVar("R", bound=Record)


class RunPlan(Record):
    """The configuration and versions, which determine every byte of a dataset."""

    config: Config
    versions: dict[str, str]

    @classmethod
    def of(cls, config: Config) -> "RunPlan":
        """Return the plan of a configuration with the installed versions."""
        return cls(config=config, versions=versions())

    def differences(self, other: "RunPlan") -> list[str]:
        """Return, in words, how another run's plan differs; additional items do not count as a difference."""
        mine, theirs = _flat(self), _flat(other)
        names = sorted(mine.keys() | theirs.keys())
        if self.config.items <= other.config.items:
            names.remove("items")
        return [f"{n} {mine.get(n)!r} ≠ {theirs.get(n)!r}" for n in names if mine.get(n) != theirs.get(n)]


class Journal:
    """The records of finished shards from this and earlier runs in one folder; the caller holds the folder's lock."""

    def __init__(self, out: Path, config: Config, *, alone: bool = True) -> None:
        """Open the journal of `out`; DatasetError, without changes, if the folder belongs to something else.

        `alone` means that no other run writes here at this time.
        """
        self.out, self.folder, self.plan = out, out / FOLDER, RunPlan.of(config)
        manifest = self._claim()
        self.files_before: dict[str, str] = manifest.files if manifest else {}
        """The card and what belongs to it, with their checksums, if the dataset was finished before."""
        self.folder.mkdir(exist_ok=True)
        if alone:
            remove_temporaries(self.folder)
        if alone or not (self.folder / PLAN).is_file():
            put_text(self.folder / PLAN, canonical(self.plan.model_dump(mode="json")), self.folder)
        if not alone:
            self._claim()  # another part may have begun at the same moment
        if manifest is not None:
            self._open_again(manifest)
        self.positions = max(config.items, self._last_position())
        """How many positions are to be tried: as many as items are asked for, and more where some hold none."""

    @property
    def shards(self) -> int:
        """Return the number of shards."""
        return self.plan.config.shards(self.positions)

    def range(self, number: int) -> range:
        """Return the positions of a shard by its number."""
        return self.plan.config.positions(number, self.positions)

    def _last_position(self) -> int:
        """Return the first position after the last one that an earlier run tried."""
        numbers = (int(path.stem) for path in self.folder.glob("*.json") if path.stem.isdecimal())
        last = self.shard(max(numbers, default=0))
        return last.positions[1] if last is not None else 0

    def _claim(self) -> Manifest | None:
        """Return the manifest of a finished dataset that this run extends, or None; DatasetError for other contents."""
        if self.folder.is_symlink():
            raise DatasetError(f"{self.folder}: is a link; choose a new folder")
        strangers = sorted(path.name for path in self.out.iterdir() if not self._is_fresh(path))
        begun = _read(self.folder / PLAN, RunPlan)  # after the look at the folder: another part may be putting it
        manifest = load(self.out) if (self.out / MANIFEST).is_file() else None
        existing = RunPlan(config=manifest.config, versions=manifest.versions) if manifest else begun
        if existing is None:
            if strangers:
                raise DatasetError(f"{self.out}: holds {strangers[0]} and is no dataset; choose a new folder")
        elif differences := (begun or existing).differences(self.plan):
            raise DatasetError(
                f"{self.out}: holds a dataset of another configuration ({'; '.join(differences)}); "
                "choose a new folder, or the same options and versions to go on"
            )
        return manifest

    def _is_fresh(self, path: Path) -> bool:
        """Return whether a path is only the remains of a run that was interrupted before it wrote its plan."""
        if path != self.folder or not path.is_dir():
            return False
        return all(child.name.startswith(f"{PLAN}.") and child.suffix == TEMPORARY for child in path.iterdir())

    def _open_again(self, manifest: Manifest) -> None:
        """Restore the records of a finished dataset; the manifest is removed if the dataset grows."""
        try:
            for shard in shards(self.out):
                if not self._record(shard.number).is_file():
                    self._save(shard)
        except DatasetError:
            pass  # damaged: what has no record is made anew
        if manifest.config != self.plan.config:
            (self.out / MANIFEST).unlink(missing_ok=True)
            (self.out / SHARDS).unlink(missing_ok=True)
            remove_pictures(self.out, manifest.files)

    def valid_record(self, number: int) -> Shard | None:
        """Return the record of a shard if all its files are undamaged, after giving them this plan's names; else None.

        The record may cover only the first of the shard's positions.
        """
        shard, wanted = self.shard(number), self.range(number)
        if shard is None or shard.positions[0] != wanted.start or shard.positions[1] > wanted.stop:
            return None
        renamed = tuple(
            file.model_copy(update={"name": file_name(number, self.shards, file.split)}) for file in shard.files
        )
        for before, file in zip(shard.files, renamed, strict=True):
            target = self.out / file.name
            path = next((path for path in (self._path(before), target) if checksum(path) == file.sha256), None)
            if path is None:
                return None
            if path != target:
                path.replace(target)
        if renamed != shard.files:
            shard = shard.model_copy(update={"files": renamed})
            self._save(shard)
        return shard

    def shard(self, number: int) -> Shard | None:
        """Return the record of a shard, or None."""
        return _read(self._record(number), Shard)

    def marks(self, number: int) -> Marks | None:
        """Return the stored hashes and numbers of a shard's items, for the detection of duplicates, or None."""
        try:
            with self._marks(number).open("rb") as file:
                return Marks(np.load(file, allow_pickle=False), np.load(file, allow_pickle=False))
        except (OSError, ValueError, EOFError):
            return None

    def keep(self, number: int, marks: Marks) -> None:
        """Store the hashes and numbers of a shard's items, for the detection of duplicates."""

        def write(path: Path) -> None:
            with path.open("wb") as file:
                for part in marks:
                    np.save(file, part, allow_pickle=False)

        write_atomically(self._marks(number), write, self.folder)

    def note(self, shard: Shard, marks: Marks) -> None:
        """Store the record of a written shard, and remove the files of its previous record."""
        self.keep(shard.number, marks)
        before, names = self.shard(shard.number), {file.name for file in shard.files}
        for file in before.files if before is not None else ():
            path = self._path(file)
            if file.name not in names and checksum(path) == file.sha256:
                path.unlink()  # of a split of which no item is left
        self._save(shard)

    def close(self) -> None:
        """Remove the journal after the manifest is written, and its folder if empty."""
        for number in range(self.shards):
            self._record(number).unlink(missing_ok=True)
            self._marks(number).unlink(missing_ok=True)
        (self.folder / PLAN).unlink(missing_ok=True)
        if not any(self.folder.iterdir()):
            self.folder.rmdir()

    def _path(self, file: ShardFile) -> Path:
        """Return the path of a file in a record, restricted to the shards' folder."""
        return self.out / DATA / Path(file.name).name

    def _save(self, shard: Shard) -> None:
        put_text(self._record(shard.number), canonical(shard.model_dump(mode="json")), self.folder)

    def _record(self, number: int) -> Path:
        return self.folder / f"{number:05}.json"

    def _marks(self, number: int) -> Path:
        return self.folder / f"{number:05}.npy"


def _flat(plan: RunPlan) -> Mapping[str, object]:
    return plan.config.model_dump(mode="json") | plan.versions


def _read(path: Path, kind: type[R]) -> R | None:
    try:
        return kind.model_validate_json(path.read_bytes())
    except (FileNotFoundError, ValidationError):
        return None
