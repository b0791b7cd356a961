"""Build a dataset, or go on with one: shards first, duplicates out, then the card, and the manifest last."""

import os
from collections import Counter
from collections.abc import Callable, Sequence
from contextlib import closing
from pathlib import Path

from sim2reason.datasets import card, store
from sim2reason.datasets.atomic_files import checksum, locked, put_text
from sim2reason.datasets.cells import Key, table
from sim2reason.datasets.distinct import duplicates
from sim2reason.datasets.item import Item
from sim2reason.datasets.journal import Journal
from sim2reason.datasets.manifest import MANIFEST, Counts, Manifest, RefusedPosition, Shard, merged, save
from sim2reason.datasets.plan import MAKER, Config, file_name
from sim2reason.datasets.pool import run
from sim2reason.datasets.work_queue import WorkQueue
from sim2reason.datasets.worker import Attempt

PATIENCE = 120.0
"""Seconds after which a batch counts as hung: a safety net, far above what any item needs."""
CARD = "README.md"


def build(
    out: Path | str,
    config: Config,
    *,
    workers: int | None = None,
    patience: float = PATIENCE,
    advance: Callable[[int], object] = lambda _: None,
) -> Manifest:
    """Fill the folder `out` with the dataset of `config`, and give its manifest.

    May be interrupted at any moment: the next call makes what is missing or damaged, and ends in the same
    bytes, whatever the number of `workers` (default: one per core that this process may use). `advance` is
    called with the number of positions that are done. DatasetError if `out` holds anything else, or a weight makes no
    sense.
    """
    if config.weights and config.maker == MAKER:
        from sim2reason.datasets.weights import check  # noqa: PLC0415 - it loads what else only workers need

        check(config.weights, config.modes, config.recipes)
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    with locked(out):
        journal = Journal(out, config)
        shards = journal.finished()
        missing = [positions for positions in config.shards() if file_name(positions) not in shards]
        advance(config.items - sum(map(len, missing)))
        board = WorkQueue(config, missing)
        crew = min(workers or cores(), max(1, sum(map(len, missing))))
        with closing(run(board.next, config.maker, crew, patience)) as replies:
            for batch, reply in replies:
                before = board.done
                for positions, outcomes in board.settle(batch, reply):
                    shard = _shard(out, config, positions, outcomes)
                    journal.note(shard)
                    shards[shard.name] = shard
                advance(board.done - before)
        manifest = _finish(out, journal, [shards[file_name(positions)] for positions in config.shards()])
        journal.close()
    return manifest


def cores() -> int:
    """How many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _shard(out: Path, config: Config, positions: range, outcomes: Sequence[Attempt]) -> Shard:
    """Write the file of a complete range, and give its record."""
    path = out / file_name(positions)
    items = [outcome.item for outcome in outcomes if outcome.item is not None]
    store.write(path, items)
    rejected: list[dict[str, Counts]] = []
    wanted: list[tuple[Key, int]] = []
    quarantined: list[RefusedPosition] = []
    unfilled: list[RefusedPosition] = []
    for outcome in outcomes:
        request = config.request(outcome.position)
        rejected.append({request.recipe: outcome.rejected})
        if outcome.wanted:
            wanted.append(((request.mode, outcome.wanted, request.recipe), 1))
        if outcome.failure:
            quarantined.append(RefusedPosition.of(outcome.position, request, outcome.failure))
        elif outcome.item is None:
            unfilled.append(RefusedPosition.of(outcome.position, request, _why(outcome.rejected)))
    return Shard(
        name=path.name,
        rows=len(items),
        sha256=checksum(path),
        rejected=merged(rejected),
        cells=table(wanted, map(_key, items)),
        quarantined=tuple(quarantined),
        unfilled=tuple(unfilled),
    )


def _key(item: Item) -> Key:
    return item.mode, item.kind, item.recipe


def _why(rejected: Counts) -> str:
    return "no draw passed: " + (", ".join(f"{name} {n}" for name, n in sorted(rejected.items())) or "none was made")


def _finish(out: Path, journal: Journal, shards: Sequence[Shard]) -> Manifest:
    """Leave duplicates out, count, and write card and manifest."""
    config, seen, final = journal.plan.config, dict[bytes, str](), list[Shard]()
    counts: dict[str, Counter[str]] = {by: Counter() for by in ("recipe", "difficulty", "mode", "kind")}
    example: Item | None = None
    keys: list[Key] = []
    for positions, shard in zip(config.shards(), shards, strict=True):
        items = store.read_shard(out / shard.name)
        double = duplicates(items, seen)
        kept = [item for item in items if item.id not in double]
        final.append(_without(out, journal, positions, shard, kept, double) if double else shard)
        example = example or next(iter(kept), None)
        for by, counter in counts.items():
            counter.update(str(getattr(item, by)) for item in kept)
        keys += map(_key, kept)
    asked = [((cell.mode, cell.kind, cell.recipe), cell.asked) for shard in final for cell in shard.cells]
    distinct = [{problem.recipe: {"distinct": 1}} for shard in final for problem in shard.duplicates]
    manifest = Manifest(
        config=config,
        config_hash=config.digest(journal.plan.versions),
        versions=journal.plan.versions,
        rows=sum(shard.rows for shard in final),
        counts=merged([counts]),
        cells=table(asked, keys),
        rejected=merged([*(shard.rejected for shard in final), *distinct]),
        shards=tuple(final),
        files={},
    )
    put_text(out / CARD, card.text(manifest, example))
    manifest = manifest.model_copy(update={"files": {CARD: checksum(out / CARD)}}).sealed()
    save(manifest, out / MANIFEST)
    return manifest


def _without(
    out: Path, journal: Journal, positions: range, shard: Shard, kept: Sequence[Item], double: dict[str, str]
) -> Shard:
    """Write a shard again without its duplicates."""
    store.write(out / shard.name, kept)
    requests = [(k, journal.plan.config.request(k)) for k in positions]
    found = [
        RefusedPosition.of(k, request, f"same as {double[request.id]}")
        for k, request in requests
        if request.id in double
    ]
    everything = tuple(sorted([*shard.duplicates, *found], key=lambda problem: problem.position))
    shard = shard.model_copy(update={"rows": len(kept), "sha256": checksum(out / shard.name), "duplicates": everything})
    journal.note(shard)
    return shard
