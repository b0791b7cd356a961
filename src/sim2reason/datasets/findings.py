"""Faults in the folder of a dataset, file by file."""

from collections.abc import Collection, Iterator
from pathlib import Path

from sim2reason.base.atomic_files import FOLDER, checksum
from sim2reason.base.record import counted
from sim2reason.datasets import store
from sim2reason.datasets.manifest import MANIFEST, SHARDS, Manifest, ShardFile, load, shards
from sim2reason.datasets.plan import DATA, file_name
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Record


class Findings(Record):
    """Result of `verify`: the numbers of rows and shards in the manifest, and a line for each fault."""

    rows: int
    shards: int
    faults: tuple[str, ...]

    def __str__(self) -> str:
        """Return the numbers of rows and shards, and a line for each fault."""
        about = f"{counted(self.rows, 'row')} in {counted(self.shards, 'shard')}"
        return "\n".join([f"{about}: {counted(len(self.faults), 'fault')}", *(f"  {fault}" for fault in self.faults)])


def found(out: Path) -> Findings:
    """Check the folder of a dataset; DatasetError if it is missing, unfinished or without a manifest."""
    if not out.is_dir():
        raise DatasetError(f"{out}: no such folder; give one that sim2reason generate has made")
    if not (out / MANIFEST).is_file() and (out / FOLDER).is_dir():
        raise DatasetError(f"{out}: not finished; run the same sim2reason generate again to go on")
    if not (out / MANIFEST).is_file():
        load(out)  # says that there is none
    try:
        manifest = load(out)
    except DatasetError as error:
        return Findings(rows=0, shards=0, faults=(str(error),))
    faults = *_manifest(out, manifest), *_files(out, manifest), *_shards(out, manifest), *manifest.empty_cells()
    return Findings(rows=manifest.rows, shards=manifest.shards, faults=faults)


def _manifest(out: Path, manifest: Manifest) -> Iterator[str]:
    if manifest.text().encode() != (out / MANIFEST).read_bytes() or not manifest.is_whole:
        yield f"{MANIFEST}: damaged, it is not as it was written"
    if manifest.config.digest(manifest.versions) != manifest.config_hash:
        yield f"{MANIFEST}: the configuration or the versions don't fit their hash"
    if manifest.shards != manifest.config.shards(manifest.positions):
        yield f"{MANIFEST}: the number of shards doesn't fit the configuration"


def _files(out: Path, manifest: Manifest) -> Iterator[str]:
    for name, sha256 in manifest.files.items():
        if checksum(out / name) != sha256:
            yield f"{name}: {'damaged' if (out / name).is_file() else 'missing'}"


def _shards(out: Path, manifest: Manifest) -> Iterator[str]:
    """Yield the faults in the list of shards and in the shard files, and each extra Parquet file."""
    rows, numbers, known = 0, 0, set[str]()
    try:
        for shard in shards(out):
            rows, numbers = rows + shard.rows, numbers + 1
            known.update(file.name for file in shard.files)
            splits = [split for split in manifest.config.split if any(file.split == split for file in shard.files)]
            names = tuple(file_name(shard.number, manifest.shards, split) for split in splits)
            if shard.number != numbers - 1 or tuple(file.name for file in shard.files) != names:
                yield f"{SHARDS}: line {numbers} doesn't fit the configuration"
            for file in shard.files:
                yield from _file(out, file)
    except DatasetError as error:
        yield str(error)
        return
    if numbers != manifest.shards:
        yield f"{SHARDS}: {numbers} shards instead of {manifest.shards}"
    if manifest.rows != rows:
        yield f"{MANIFEST}: the number of rows is not the sum over the shards"
    yield from _strangers(out, known)


def _file(out: Path, file: ShardFile) -> Iterator[str]:
    path = out / file.name
    if not path.is_file():
        yield f"{file.name}: missing"
        return
    if checksum(path) != file.sha256:
        yield f"{file.name}: damaged, its SHA-256 is not that of the list of shards"
    try:
        rows = store.count(path)
    except (OSError, ValueError) as error:
        yield f"{file.name}: not readable as Parquet ({' '.join(str(error).split())})"
        return
    if rows != file.rows:
        yield f"{file.name}: {rows} rows instead of {file.rows}"


def _strangers(out: Path, known: Collection[str]) -> Iterator[str]:
    """Yield a fault for each Parquet file that is not part of the dataset."""
    for path in sorted((out / DATA).glob("*.parquet")):
        if (name := f"{DATA}/{path.name}") not in known:
            yield f"{name}: an extra file that the dataset does not know"
