"""Find what is wrong with a dataset on disk."""

from collections.abc import Iterator
from pathlib import Path

from sim2reason.datasets import store
from sim2reason.datasets.atomic_files import checksum
from sim2reason.datasets.cells import empty
from sim2reason.datasets.item import Record
from sim2reason.datasets.journal import FOLDER
from sim2reason.datasets.manifest import MANIFEST, Manifest, Shard, load
from sim2reason.datasets.plan import file_name
from sim2reason.errors import DatasetError


class Findings(Record):
    """What `examine` saw: rows and shards by the manifest, and a line for each thing that is wrong."""

    rows: int
    shards: int
    faults: tuple[str, ...]


def examine(out: Path | str) -> Findings:
    """Check a dataset against its manifest.

    Finds a flipped byte in any file of the dataset, a missing and an extra shard, a wrong count of rows, and a mode,
    kind and recipe that was asked for, but of which none was kept.
    DatasetError if `out` is no finished dataset at all.
    """
    out = Path(out)
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
    faults = *_manifest(out, manifest), *_files(out, manifest), *_strangers(out, manifest), *empty(manifest.cells)
    return Findings(rows=manifest.rows, shards=len(manifest.shards), faults=faults)


def _manifest(out: Path, manifest: Manifest) -> Iterator[str]:
    if manifest.text().encode() != (out / MANIFEST).read_bytes() or manifest.sealed() != manifest:
        yield f"{MANIFEST}: damaged, it is not as it was written"
    if manifest.config.digest(manifest.versions) != manifest.config_hash:
        yield f"{MANIFEST}: the configuration or the versions don't fit their hash"
    if [shard.name for shard in manifest.shards] != [file_name(positions) for positions in manifest.config.shards()]:
        yield f"{MANIFEST}: the list of shards doesn't fit the configuration"
    if manifest.rows != sum(shard.rows for shard in manifest.shards):
        yield f"{MANIFEST}: the number of rows is not the sum over the shards"


def _files(out: Path, manifest: Manifest) -> Iterator[str]:
    for name, sha256 in manifest.files.items():
        if checksum(out / name) != sha256:
            yield f"{name}: {'damaged' if (out / name).is_file() else 'missing'}"
    for shard in manifest.shards:
        if not (out / shard.name).is_file():
            yield f"{shard.name}: missing"
            continue
        if checksum(out / shard.name) != shard.sha256:
            yield f"{shard.name}: damaged, its SHA-256 is not that of the manifest"
        yield from _rows(out, shard)


def _rows(out: Path, shard: Shard) -> Iterator[str]:
    try:
        rows = store.count(out / shard.name)
    except (OSError, ValueError) as error:
        yield f"{shard.name}: not readable as Parquet ({' '.join(str(error).split())})"
        return
    if rows != shard.rows:
        yield f"{shard.name}: {rows} rows instead of {shard.rows}"


def _strangers(out: Path, manifest: Manifest) -> Iterator[str]:
    known = {shard.name for shard in manifest.shards}
    for path in sorted(out.glob("*.parquet")):
        if path.name not in known:
            yield f"{path.name}: an extra shard that the manifest does not know"
