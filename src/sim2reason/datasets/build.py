"""Build a dataset, or go on with one: items first, then the card, and the manifest last."""

from collections.abc import Callable
from contextlib import AbstractContextManager
from functools import partial
from pathlib import Path
from typing import TypedDict, Unpack

from sim2reason.base.atomic_files import FOLDER, LOCK, locked
from sim2reason.datasets.contamination import Benchmarks
from sim2reason.datasets.finish import finish
from sim2reason.datasets.journal import Journal, RunPlan
from sim2reason.datasets.manifest import MANIFEST, Manifest, load
from sim2reason.datasets.places import HERE, PATIENCE, Crew, Run, opened
from sim2reason.datasets.plan import MAKER, Config
from sim2reason.datasets.rounds import FindsOverlap, make_all, make_positions
from sim2reason.datasets.verify import verify
from sim2reason.datasets.worker import Attempt
from sim2reason.errors import DatasetError

Part = tuple[int, int]
"""Of N processes that share the work, this one's number, from 0, and N."""


class Work(TypedDict, total=False):
    """How the work is done; nothing of it changes the result."""

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
    """Fill the folder `out` with the dataset of `config`, and give its manifest.

    May be interrupted at any moment: the next call makes what is missing or damaged, and ends in the same bytes,
    whoever works and where. A dataset of fewer items and otherwise the same configuration is gone on with, too.

    Raises:
        DatasetError: `out` holds anything else, a weight makes no sense, or `config` names other benchmarks. And if
            fewer items are to be had than it asks for: then those there are stand in `out`, a dataset as any other.
    """
    overlap, advance = _overlap(config, work.get("benchmarks")), work.get("advance", unseen)
    with _workers(config, work) as run, locked(out := _folder(out, config)):
        manifest = _standing(out, config)
        if manifest is not None:
            advance(manifest.rows)
        else:
            journal = Journal(out, config)
            make_all(journal, run, overlap, advance, work.get("watch", unwatched))
            manifest = finish(journal)
            journal.close()
    if manifest.rows < config.items:
        raise DatasetError(
            f"{out}: {manifest.rows} problems of {config.items} asked for, and of {manifest.positions} tries the last "
            "ones gave nothing new; ask for fewer, or for more recipes, difficulties, modes or kinds, in another folder"
        )
    return manifest


def build_part(out: Path | str, config: Config, part: Part, **work: Unpack[Work]) -> int:
    """Make every N-th shard of a dataset, beside other processes that make the others; `build` then ends the work.

    `part` is this process's number, from 0, and how many there are. It gives the number of items that stand in its
    shards, among which duplicates are not yet looked for, nor what is to take their place. DatasetError if another
    process has the same part, or `build` is at work, too.
    """
    number, parts = part
    if not 0 <= number < parts:
        remedy = f"count from 1/{parts} to {parts}/{parts}" if parts > 0 else "write K/N, as in 3/8"
        raise DatasetError(f"part {number + 1}/{parts}: there is none; {remedy}")
    overlap = _overlap(config, work.get("benchmarks"))
    with _workers(config, work) as run, locked(out := _folder(out, config), shared=True):
        journal = Journal(out, config, alone=False)
        mine = journal.folder / f"part-{number + 1}-of-{parts}{LOCK}"
        mine.touch()
        numbers = range(number, journal.shards, parts)
        with locked(mine):
            make_positions(journal, numbers, run, overlap, work.get("advance", unseen), work.get("watch", unwatched))
            mine.unlink()
        return sum(shard.rows for n in numbers if (shard := journal.shard(n)) is not None)


def unseen(done: int) -> None:
    """Ignore the number of finished positions; the function called if the caller gives no `advance`."""
    del done


def unwatched(attempt: Attempt) -> None:
    """Ignore an attempt to make an item; the function called if the caller gives no `watch`."""
    del attempt


def _standing(out: Path, config: Config) -> Manifest | None:
    """The manifest of a whole dataset of this configuration, where nothing is left to do: it may be read-only."""
    if (out / FOLDER).exists() or not (out / MANIFEST).is_file():
        return None
    try:
        manifest = load(out)
    except DatasetError:
        return None
    same = RunPlan(config=manifest.config, versions=manifest.versions) == RunPlan.of(config)
    return manifest if same and set(verify(out).faults) <= set(manifest.empty_cells()) else None


def _folder(out: Path | str, config: Config) -> Path:
    """Return the folder, made if it is not there, once the configuration makes sense."""
    if config.weights and config.maker == MAKER:
        from sim2reason.generation.weights import check  # noqa: PLC0415 - it loads what else only workers need

        check(config.weights, config.modes, config.recipes)
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    return out


def _overlap(config: Config, benchmarks: Benchmarks | None) -> FindsOverlap:
    """Return what finds the words that a prompt shares with a benchmark."""
    if config.decontaminate != (benchmarks.files if benchmarks is not None else ()):
        names = ", ".join(file.name for file in config.decontaminate)
        raise DatasetError(
            f"decontaminate: the configuration names {names or 'no file'}; give the benchmarks that it names"
        )
    return benchmarks.overlap if benchmarks is not None else lambda _: None


def _workers(config: Config, work: Work) -> AbstractContextManager[Run]:
    """Return those who shall make the items, at their place; DatasetError for a number of them that is none."""
    workers = work.get("workers")
    if workers is not None and not _counts(workers):
        raise DatasetError(f"workers: {workers!r} is no number of processes; give a whole number from 1 on, or None")
    crew = partial(Crew, config.maker, workers, work.get("patience", PATIENCE))
    return opened(work.get("on", HERE), crew)


def _counts(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and value >= 1
