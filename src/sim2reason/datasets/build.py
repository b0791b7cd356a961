"""Build a dataset, or go on with one: shards first, duplicates out, then the card, and the manifest last."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, closing
from functools import partial
from pathlib import Path
from typing import TypedDict, Unpack

from sim2reason.datasets import shard_files
from sim2reason.datasets.atomic_files import LOCK, locked
from sim2reason.datasets.cells import table
from sim2reason.datasets.contamination import Benchmarks, Overlap
from sim2reason.datasets.distinct import marks
from sim2reason.datasets.finish import finish
from sim2reason.datasets.histograms import counted
from sim2reason.datasets.journal import FOLDER, Journal, RunPlan
from sim2reason.datasets.manifest import MANIFEST, Counts, Manifest, RefusedPosition, Shard, load, merged
from sim2reason.datasets.places import HERE, PATIENCE, Crew, Run, opened
from sim2reason.datasets.plan import MAKER, Config
from sim2reason.datasets.splits import split_of
from sim2reason.datasets.verify import verify
from sim2reason.datasets.work_queue import WorkQueue
from sim2reason.datasets.worker import Attempt
from sim2reason.errors import DatasetError

Part = tuple[int, int]
"""Of N processes that share the work, this one's number, from 0, and N."""
FindsOverlap = Callable[[str], Overlap | None]
"""Finds the words that a prompt shares with a benchmark."""


class Work(TypedDict, total=False):
    """How the work is done; nothing of it changes the result."""

    workers: int | None
    """How many processes; by default one for each core of the place."""
    on: str
    """A name in `PLACES`; by default this machine."""
    patience: float
    """Seconds after which a batch counts as hung."""
    advance: Callable[[int], object]
    """Called with the number of positions that are done."""
    benchmarks: Benchmarks | None
    """The files that the configuration names, so that no problem shares a run of words with them."""


def build(out: Path | str, config: Config, **work: Unpack[Work]) -> Manifest:
    """Fill the folder `out` with the dataset of `config`, and give its manifest.

    May be interrupted at any moment: the next call makes what is missing or damaged, and ends in the same bytes,
    whoever works and where. A dataset of fewer items and otherwise the same configuration is gone on with, too.
    DatasetError if `out` holds anything else, a weight makes no sense, or `config` names other benchmarks.
    """
    overlap = _overlap(config, work.get("benchmarks"))
    with _workers(config, work) as run, locked(out := _folder(out, config)):
        standing = _standing(out, config)
        if standing is not None:
            work.get("advance", _unseen)(config.items)
            return standing
        journal = Journal(out, config)
        _fill(journal, range(config.shards), run, overlap, work)
        manifest = finish(journal)
        journal.close()
    return manifest


def build_part(out: Path | str, config: Config, part: Part, **work: Unpack[Work]) -> int:
    """Make every N-th shard of a dataset, beside other processes that make the others; `build` then ends the work.

    `part` is this process's number, from 0, and how many there are. It gives the number of items that stand in its
    shards, among which duplicates are not yet looked for. DatasetError if another process has the same part, or `build`
    is at work, too.
    """
    number, parts = part
    if not 0 <= number < parts:
        remedy = f"count from 1/{parts} to {parts}/{parts}" if parts > 0 else "write K/N, as in 3/8"
        raise DatasetError(f"part {number + 1}/{parts}: there is none; {remedy}")
    numbers = range(number, config.shards, parts)
    overlap = _overlap(config, work.get("benchmarks"))
    with _workers(config, work) as run, locked(out := _folder(out, config), shared=True):
        journal = Journal(out, config, alone=False)
        mine = journal.folder / f"part-{number + 1}-of-{parts}{LOCK}"
        mine.touch()
        with locked(mine):
            _fill(journal, numbers, run, overlap, work)
            mine.unlink()
        return sum(shard.rows for n in numbers if (shard := journal.shard(n)) is not None)


def _unseen(done: int) -> None:
    """Nobody looks on."""
    del done


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
    """The folder, made if it is not there, once the configuration makes sense."""
    if config.weights and config.maker == MAKER:
        from sim2reason.datasets.weights import check  # noqa: PLC0415 - it loads what else only workers need

        check(config.weights, config.modes, config.recipes)
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    return out


def _overlap(config: Config, benchmarks: Benchmarks | None) -> FindsOverlap:
    """What finds the words that a prompt shares with a benchmark."""
    if config.decontaminate != (benchmarks.files if benchmarks is not None else ()):
        names = ", ".join(file.name for file in config.decontaminate)
        raise DatasetError(
            f"decontaminate: the configuration names {names or 'no file'}; give the benchmarks that it names"
        )
    return benchmarks.overlap if benchmarks is not None else lambda _: None


def _workers(config: Config, work: Work) -> AbstractContextManager[Run]:
    """Those who shall make the items, at their place; DatasetError for a number of them that is none."""
    workers = work.get("workers")
    if workers is not None and not _counts(workers):
        raise DatasetError(f"workers: {workers!r} is no number of processes; give a whole number from 1 on, or None")
    crew = partial(Crew, config.maker, workers, work.get("patience", PATIENCE))
    return opened(work.get("on", HERE), crew)


def _counts(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and value >= 1


def _fill(journal: Journal, numbers: range, run: Run, overlap: FindsOverlap, work: Work) -> None:
    """Make those of some shards that do not stand."""
    config, advance = journal.plan.config, work.get("advance", _unseen)

    def missing() -> Iterator[int]:
        for number in numbers:
            if journal.stands(number) is None:
                yield number
            else:
                advance(len(config.positions(number)))

    queue = WorkQueue(config, missing())
    with closing(run(queue.next)) as replies:
        for batch, reply in replies:
            before = queue.done
            for number, outcomes in queue.settle(batch, reply):
                _write(journal, overlap, number, outcomes)
            advance(queue.done - before)


def _write(journal: Journal, overlap: FindsOverlap, number: int, outcomes: Sequence[Attempt]) -> None:
    """Write the files of a complete range, and keep its record."""
    config, positions = journal.plan.config, journal.plan.config.positions(number)
    found = [(outcome.position, outcome.item) for outcome in outcomes if outcome.item is not None]
    overlaps = {position: shared for position, item in found if (shared := overlap(item.prompt))}
    made = [(position, item) for position, item in found if position not in overlaps]
    homes = [(split_of(item, config.split), item) for _, item in made]
    by_split = {name: [item for home, item in homes if home == name] for name in config.split}
    requests = [(outcome, config.request(outcome.position)) for outcome in outcomes]
    wanted = [((r.mode, each.wanted, r.recipe), 1) for each, r in requests if each.wanted]
    failed = [RefusedPosition.of(each.position, r, each.failure) for each, r in requests if each.failure]
    empty = [(each, r) for each, r in requests if not each.failure and each.item is None]
    shard = Shard(
        number=number,
        positions=(positions.start, positions.stop),
        files=shard_files.write(journal.out, journal.folder, number, config.shards, by_split),
        counts=shard_files.counts(by_split),
        histograms=counted(item for _, item in made),
        rejected=merged({r.recipe: each.rejected} for each, r in requests),
        cells=table(wanted, ((item.mode, kind, item.recipe) for _, item in made for kind in item.kinds)),
        quarantined=tuple(failed),
        contaminated=tuple(RefusedPosition.of(k, config.request(k), found.told) for k, found in overlaps.items()),
        unfilled=tuple(RefusedPosition.of(each.position, r, _why(each.rejected)) for each, r in empty),
    )
    journal.note(shard, marks(made, scenes=len(config.split) > 1))


def _why(rejected: Counts) -> str:
    return "no draw passed: " + (", ".join(f"{name} {n}" for name, n in sorted(rejected.items())) or "none was made")
