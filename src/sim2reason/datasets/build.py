"""Build of a dataset, new or resumed, or as a subset of a finished one."""

from collections.abc import Callable
from contextlib import AbstractContextManager
from functools import partial
from pathlib import Path
from typing import TypedDict, Unpack

from sim2reason.base.atomic_files import (
    FOLDER,
    LOCK,
    checksum,
    lock_folder,
    put_text,
    remove_temporaries,
    write_atomically,
)
from sim2reason.datasets import card, shard_files
from sim2reason.datasets.card_content import (
    MIN_PICTURED_ITEMS,
    HistogramCounts,
    choose_examples,
    count_histograms,
    example,
    plotting_version,
    put_pictures,
    remove_pictures,
)
from sim2reason.datasets.contamination import Benchmarks
from sim2reason.datasets.dataset import Dataset, verify
from sim2reason.datasets.journal import Journal, RunPlan
from sim2reason.datasets.manifest import (
    COUNTED,
    MANIFEST,
    REFUSALS,
    SHARDS,
    Cell,
    Counts,
    Manifest,
    Refusal,
    RefusedPositions,
    Shard,
    all_histograms,
    load,
    merge_cells,
    merge_counts,
    shards,
)
from sim2reason.datasets.places import DEFAULT_TIMEOUT, HERE, Run, WorkerPool, opened
from sim2reason.datasets.plan import MAKER, Config
from sim2reason.datasets.rounds import FindsOverlap, make_all, make_positions
from sim2reason.datasets.shard_files import read_shard
from sim2reason.datasets.worker import Attempt
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item

CARD = "README.md"


def finish(journal: Journal) -> Manifest:
    """Write all missing files, with the manifest last, and return it; one shard is in memory at a time."""
    out, totals = journal.out, _Totals()

    def write(path: Path) -> None:
        with path.open("w", encoding="utf-8", newline="\n") as file:
            for number in range(journal.shards):
                shard = read_shard(journal, number)
                totals.add(shard)
                file.write(f"{shard.model_dump_json()}\n")

    write_atomically(out / SHARDS, write, journal.folder)
    manifest = _illustrated(journal, totals.manifest(journal)).sealed()
    put_text(out / MANIFEST, manifest.text(), journal.folder)
    return manifest


def _illustrated(journal: Journal, manifest: Manifest) -> Manifest:
    """Write the dataset card and its pictures, and return the manifest with the checksums of both."""
    out, config = journal.out, journal.plan.config
    shards = (read_shard(journal, number) for number in range(journal.shards))
    first = next((shard for shard in shards if shard.rows), None)
    pictured = manifest.rows >= MIN_PICTURED_ITEMS
    chosen = choose_examples(shard_files.items(out, first) if first else ())
    shown = [example(item, config, pictured=pictured) for item in chosen]
    pictures = put_pictures(out, journal.folder, manifest.histograms, shown) if pictured else ()
    manifest = manifest.model_copy(update={"pictures": plotting_version() if pictures else ""})
    put_text(out / CARD, card.text(manifest, shown, pictures), journal.folder)
    files = {name: checksum(out / name) for name in sorted([CARD, SHARDS, *pictures])}
    remove_pictures(out, {name: sha256 for name, sha256 in journal.files_before.items() if name not in files})
    return manifest.model_copy(update={"files": files})


class _Totals:
    """The sums, over all shards, of the counts that the manifest states."""

    def __init__(self) -> None:
        self.rows = 0
        self.counts: dict[str, Counts] = {}
        self.histograms: dict[str, HistogramCounts] = {}
        self.rejected: dict[str, Counts] = {}
        self.cells: tuple[Cell, ...] = ()
        self.refused: dict[Refusal, RefusedPositions] = {kind: RefusedPositions() for kind in REFUSALS}

    def add(self, shard: Shard) -> None:
        """Add the counts of one shard."""
        self.rows += shard.rows
        self.counts = merge_counts([self.counts, shard.counts])
        left_out = [{each.recipe: {name: 1}} for kind, name in COUNTED.items() for each in getattr(shard, kind)]
        self.rejected = merge_counts([self.rejected, shard.rejected, *left_out])
        self.histograms = all_histograms([self.histograms, shard.histograms])
        self.cells = merge_cells([self.cells, shard.cells])
        self.refused = {kind: refusals.with_more(getattr(shard, kind)) for kind, refusals in self.refused.items()}

    def manifest(self, journal: Journal) -> Manifest:
        """Return the manifest without checksums and seal."""
        plan = journal.plan
        return Manifest(
            config=plan.config,
            config_hash=plan.config.digest(plan.versions),
            versions=plan.versions,
            rows=self.rows,
            positions=journal.positions,
            counts=self.counts,
            histograms=self.histograms,
            cells=self.cells,
            rejected=self.rejected,
            refused=self.refused,
            shards=journal.shards,
            files={},
        )


Part = tuple[int, int]
"""Of N processes that share the work, this one's number, from 0, and N."""


class Work(TypedDict, total=False):
    """Options of a build that do not affect the dataset, such as the number of workers."""

    workers: int | None
    """How many processes; by default one for each core of the place."""
    on: str
    """A name in `PLACES`; by default this machine."""
    patience: float
    """Seconds after which a batch counts as hung."""
    advance: Callable[[int], object]
    """Called with the number of positions that are done; with less than nothing where that many hold no item."""
    watch: Callable[[Attempt], object]
    """Called with what became of each position, in any order."""
    benchmarks: Benchmarks | None
    """The files that the configuration names, so that no problem shares a run of words with them."""


def build(out: Path | str, config: Config, **work: Unpack[Work]) -> Manifest:
    """Build the dataset of `config` in the folder `out`, and return its manifest.

    The build may be interrupted at any time: the next call makes what is missing or damaged, and produces the same
    bytes with any number of workers on any machine. A smaller dataset with otherwise the same configuration is
    extended.

    Raises:
        DatasetError: `out` holds anything else, a weight makes no sense, or `config` names other benchmarks. And if
            fewer items are to be had than it asks for: then those there are stand in `out`, a dataset as any other.
    """
    overlap, advance = _overlap(config, work.get("benchmarks")), work.get("advance", ignore_progress)
    with _workers(config, work) as run, lock_folder(out := _folder(out, config)):
        manifest = _existing_manifest(out, config)
        if manifest is not None:
            advance(manifest.rows)
        else:
            journal = Journal(out, config)
            make_all(journal, run, overlap, advance, work.get("watch", ignore_attempt))
            manifest = finish(journal)
            journal.close()
    if manifest.rows < config.items:
        raise DatasetError(
            f"{out}: {manifest.rows} problems of {config.items} asked for, and of {manifest.positions} tries the last "
            "ones gave nothing new; ask for fewer, or for more recipes, difficulties, modes or kinds, in another folder"
        )
    return manifest


def build_part(out: Path | str, config: Config, part: Part, **work: Unpack[Work]) -> int:
    """Make every N-th shard of a dataset, while other processes make the others; `build` then completes it.

    `part` is the index of this process, from 0, and the number of processes. Returns the number of items in its shards,
    before duplicates are removed and replaced. DatasetError if another process has the same part, or `build` is
    running.
    """
    number, parts = part
    if not 0 <= number < parts:
        remedy = f"count from 1/{parts} to {parts}/{parts}" if parts > 0 else "write K/N, as in 3/8"
        raise DatasetError(f"part {number + 1}/{parts}: there is none; {remedy}")
    overlap = _overlap(config, work.get("benchmarks"))
    with _workers(config, work) as run, lock_folder(out := _folder(out, config), shared=True):
        journal = Journal(out, config, alone=False)
        mine = journal.folder / f"part-{number + 1}-of-{parts}{LOCK}"
        mine.touch()
        numbers = range(number, journal.shards, parts)
        with lock_folder(mine):
            make_positions(
                journal, numbers, run, overlap, work.get("advance", ignore_progress), work.get("watch", ignore_attempt)
            )
            mine.unlink()
        return sum(shard.rows for n in numbers if (shard := journal.shard(n)) is not None)


def ignore_progress(done: int) -> None:
    """Ignore the number of finished positions; the function called if the caller gives no `advance`."""
    del done


def ignore_attempt(attempt: Attempt) -> None:
    """Ignore an attempt to make an item; the function called if the caller gives no `watch`."""
    del attempt


def _existing_manifest(out: Path, config: Config) -> Manifest | None:
    """Return the manifest of a complete, undamaged dataset with this configuration, or None; it writes nothing."""
    if (out / FOLDER).exists() or not (out / MANIFEST).is_file():
        return None
    try:
        manifest = load(out)
    except DatasetError:
        return None
    same = RunPlan(config=manifest.config, versions=manifest.versions) == RunPlan.of(config)
    return manifest if same and set(verify(out).faults) <= set(manifest.empty_cells()) else None


def _folder(out: Path | str, config: Config) -> Path:
    """Return the folder after validating the configuration; it is created if it does not exist."""
    if config.weights and config.maker == MAKER:
        from sim2reason.generation.request import check  # noqa: PLC0415 - it loads what else only workers need

        check(config.weights, config.modes, config.recipes)
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    return out


def _overlap(config: Config, benchmarks: Benchmarks | None) -> FindsOverlap:
    """Return the function that finds text shared between a prompt and a benchmark."""
    if config.decontaminate != (benchmarks.files if benchmarks is not None else ()):
        names = ", ".join(file.name for file in config.decontaminate)
        raise DatasetError(
            f"decontaminate: the configuration names {names or 'no file'}; give the benchmarks that it names"
        )
    return benchmarks.overlap if benchmarks is not None else lambda _: None


def _workers(config: Config, work: Work) -> AbstractContextManager[Run]:
    """Return a context with the workers that make the items; DatasetError for an invalid number of them."""
    workers = work.get("workers")
    if workers is not None and not _counts(workers):
        raise DatasetError(f"workers: {workers!r} is no number of processes; give a whole number from 1 on, or None")
    crew = partial(WorkerPool, config.maker, workers, work.get("patience", DEFAULT_TIMEOUT))
    return opened(work.get("on", HERE), crew)


def _counts(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and value >= 1


def write_subset(source: Dataset, out: Path, keeps: Callable[[Item], bool], filter_name: str, why: str) -> Manifest:
    """Write the items that `keeps` accepts as a new dataset into the folder `out`, with the manifest last.

    Items stay in their shards, so that they are found by their ids as before; removed ones are counted under
    `filter_name`, by recipe, and the card states `why`.
    """
    out.mkdir(parents=True, exist_ok=True)
    remove_temporaries(out)
    (out / MANIFEST).unlink(missing_ok=True)
    kept: list[Shard] = []
    gone: dict[str, Counts] = {}
    for shard in shards(source.path):
        subset, left_out = _subset(source, out, shard, keeps)
        kept.append(subset)
        gone = merge_counts([gone, *({item.recipe: {filter_name: 1}} for item in left_out)])
    put_text(out / SHARDS, "".join(f"{shard.model_dump_json()}\n" for shard in kept), out)
    manifest = source.manifest.model_copy(
        update={
            "rows": sum(shard.rows for shard in kept),
            "counts": merge_counts(shard.counts for shard in kept),
            "histograms": all_histograms(shard.histograms for shard in kept),
            "rejected": merge_counts([source.manifest.rejected, gone]),
            "pictures": "",
        }
    )
    put_text(out / CARD, f"{card.text(manifest, (), ())}\n## Which were kept\n\n{why}\n", out)
    files = {name: checksum(out / name) for name in (CARD, SHARDS)}
    manifest = manifest.model_copy(update={"files": files}).sealed()
    put_text(out / MANIFEST, manifest.text(), out)
    return manifest


def _subset(source: Dataset, out: Path, shard: Shard, keeps: Callable[[Item], bool]) -> tuple[Shard, list[Item]]:
    """Return a shard's record without the items that `keeps` rejects, and the rejected items."""
    by_split = {file.split: shard_files.read(source.path, file) for file in shard.files}
    kept = {split: [item for item in items if keeps(item)] for split, items in by_split.items()}
    changed = {
        "files": shard_files.write(out, out, shard.number, source.manifest.shards, kept),
        "counts": shard_files.counts(kept),
        "histograms": count_histograms(shard_files.flat(kept)),
    }
    return shard.model_copy(update=changed), [item for item in shard_files.flat(by_split) if not keeps(item)]
