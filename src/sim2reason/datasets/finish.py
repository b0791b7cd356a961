"""End a dataset whose shards all stand: leave duplicates out, count, and write list, card and manifest."""

from collections.abc import Sequence
from pathlib import Path

from sim2reason.datasets import card, shard_files
from sim2reason.datasets.atomic_files import checksum, put, put_text
from sim2reason.datasets.cells import Cell, table, together
from sim2reason.datasets.distinct import Double, Marks, doubles, marks
from sim2reason.datasets.item import Item
from sim2reason.datasets.journal import Journal
from sim2reason.datasets.manifest import (
    MANIFEST,
    REFUSALS,
    SHARDS,
    Counts,
    Manifest,
    Refusal,
    RefusedPosition,
    RefusedPositions,
    Shard,
    merged,
)
from sim2reason.datasets.plan import Request
from sim2reason.errors import DatasetError

CARD = "README.md"


def finish(journal: Journal) -> Manifest:
    """Write what is not there yet, the manifest last, and give it; whatever is held in memory is of one shard."""
    out, config = journal.out, journal.plan.config
    for number, found in doubles(lambda number: _marks(journal, number), config.shards):
        _leave_out(journal, number, found)
    totals = _Totals()

    def write(path: Path) -> None:
        with path.open("w", encoding="utf-8", newline="\n") as file:
            for number in range(config.shards):
                shard = _shard(journal, number)
                totals.add(shard)
                file.write(f"{shard.model_dump_json()}\n")

    put(out / SHARDS, write, journal.folder)
    example = next((item for n in range(config.shards) for item in shard_files.items(out, _shard(journal, n))), None)
    manifest = totals.manifest(journal)
    put_text(out / CARD, card.text(manifest, example), journal.folder)
    files = {CARD: checksum(out / CARD), SHARDS: checksum(out / SHARDS)}
    manifest = manifest.model_copy(update={"files": files}).sealed()
    put_text(out / MANIFEST, manifest.text(), journal.folder)
    return manifest


class _Totals:
    """The sums over all shards."""

    def __init__(self) -> None:
        self.rows = 0
        self.counts: dict[str, Counts] = {}
        self.rejected: dict[str, Counts] = {}
        self.cells: tuple[Cell, ...] = ()
        self.refused: dict[Refusal, RefusedPositions] = {kind: RefusedPositions() for kind in REFUSALS}

    def add(self, shard: Shard) -> None:
        """Take one more."""
        self.rows += shard.rows
        self.counts = merged([self.counts, shard.counts])
        left_out = [{problem.recipe: {"distinct": 1}} for problem in shard.duplicates]
        self.rejected = merged([self.rejected, shard.rejected, *left_out])
        self.cells = together([self.cells, shard.cells])
        self.refused = {kind: held.with_more(getattr(shard, kind)) for kind, held in self.refused.items()}

    def manifest(self, journal: Journal) -> Manifest:
        """The manifest, but for checksums and seal."""
        plan = journal.plan
        return Manifest(
            config=plan.config,
            config_hash=plan.config.digest(plan.versions),
            versions=plan.versions,
            rows=self.rows,
            counts=self.counts,
            cells=self.cells,
            rejected=self.rejected,
            refused=self.refused,
            shards=plan.config.shards,
            files={},
        )


def _shard(journal: Journal, number: int) -> Shard:
    """The record of a shard that stands."""
    shard = journal.shard(number)
    if shard is None:
        raise DatasetError(f"{journal.folder}: the record of shard {number} is gone; give the same command again")
    return shard


def _marks(journal: Journal, number: int) -> Marks:
    """What no other item may share with those of a shard, read from its files where it was not kept."""
    config = journal.plan.config
    known, shard = journal.marks(number), _shard(journal, number)
    if known is not None and len(known) == shard.rows:
        return known
    return marks(_placed(journal, shard), scenes=len(config.split) > 1)


def _placed(journal: Journal, shard: Shard) -> list[tuple[int, Item]]:
    """The items of a shard with their positions, in order."""
    items = shard_files.items(journal.out, shard)
    named = ((journal.plan.config.position(_request(item)), item) for item in items)
    return sorted(named, key=lambda pair: pair[0])


def _request(item: Item) -> Request:
    made = item.provenance
    weights = tuple(sorted(made.weights.items()))
    return Request(made.recipe, made.difficulty, made.mode, made.seed, made.index, weights, made.units)


def _leave_out(journal: Journal, number: int, found: Sequence[Double]) -> None:
    """Write a shard again without its duplicates."""
    config, shard, same = journal.plan.config, _shard(journal, number), dict(found)
    placed = _placed(journal, shard)
    kept = [(position, item) for position, item in placed if position not in same]
    ids = {item.id for _, item in kept}
    by_split = {
        file.split: [item for item in shard_files.read(journal.out, file) if item.id in ids] for file in shard.files
    }
    left_out = [
        RefusedPosition.of(position, config.request(position), f"same as {config.request(first).id}")
        for position, first in found
    ]
    asked = [((cell.mode, cell.kind, cell.recipe), cell.asked) for cell in shard.cells]
    changed = {
        "files": shard_files.write(journal.out, journal.folder, number, config.shards, by_split),
        "counts": shard_files.counts(by_split),
        "cells": table(asked, ((item.mode, item.kind, item.recipe) for _, item in kept)),
        "duplicates": tuple(sorted([*shard.duplicates, *left_out], key=lambda each: each.position)),
    }
    journal.note(shard.model_copy(update=changed), marks(kept, scenes=len(config.split) > 1))
