"""End a dataset whose shards all stand: leave duplicates out, count, and write list, card and manifest."""

from collections.abc import Sequence
from functools import partial
from pathlib import Path

from sim2reason.datasets import card, shard_files
from sim2reason.datasets.atomic_files import checksum, put, put_text
from sim2reason.datasets.cells import Cell, table, together
from sim2reason.datasets.distinct import Double, Marks, doubles, marks
from sim2reason.datasets.examples import chosen, example
from sim2reason.datasets.histograms import Counted, counted
from sim2reason.datasets.item import Item
from sim2reason.datasets.journal import Journal
from sim2reason.datasets.manifest import (
    COUNTED,
    MANIFEST,
    REFUSALS,
    SHARDS,
    Counts,
    Manifest,
    Refusal,
    RefusedPosition,
    RefusedPositions,
    Shard,
    all_histograms,
    merged,
)
from sim2reason.datasets.pictures import drawn_by, put_pictures, remove_pictures
from sim2reason.datasets.plan import Config
from sim2reason.errors import DatasetError

CARD = "README.md"


def finish(journal: Journal) -> Manifest:
    """Write what is not there yet, the manifest last, and give it; whatever is held in memory is of one shard."""
    out, config = journal.out, journal.plan.config
    for number, found in doubles(partial(_marks, journal), config.shards, config.items, config.distance):
        _leave_out(journal, number, found)
    totals = _Totals()

    def write(path: Path) -> None:
        with path.open("w", encoding="utf-8", newline="\n") as file:
            for number in range(config.shards):
                shard = _shard(journal, number)
                totals.add(shard)
                file.write(f"{shard.model_dump_json()}\n")

    put(out / SHARDS, write, journal.folder)
    manifest = _illustrated(journal, totals.manifest(journal)).sealed()
    put_text(out / MANIFEST, manifest.text(), journal.folder)
    return manifest


def _illustrated(journal: Journal, manifest: Manifest) -> Manifest:
    """Write the card and its pictures, and give the manifest that knows them."""
    out, config = journal.out, journal.plan.config
    shards = (_shard(journal, number) for number in range(config.shards))
    first = next((shard for shard in shards if shard.rows), None)
    shown = [example(item, config) for item in chosen(shard_files.items(out, first) if first else ())]
    pictures = put_pictures(out, journal.folder, manifest.histograms, shown)
    manifest = manifest.model_copy(update={"pictures": drawn_by() if pictures else ""})
    put_text(out / CARD, card.text(manifest, shown, pictures), journal.folder)
    files = {name: checksum(out / name) for name in sorted([CARD, SHARDS, *pictures])}
    remove_pictures(out, {name: sha256 for name, sha256 in journal.files_before.items() if name not in files})
    return manifest.model_copy(update={"files": files})


class _Totals:
    """The sums over all shards."""

    def __init__(self) -> None:
        self.rows = 0
        self.counts: dict[str, Counts] = {}
        self.histograms: dict[str, Counted] = {}
        self.rejected: dict[str, Counts] = {}
        self.cells: tuple[Cell, ...] = ()
        self.refused: dict[Refusal, RefusedPositions] = {kind: RefusedPositions() for kind in REFUSALS}

    def add(self, shard: Shard) -> None:
        """Take one more."""
        self.rows += shard.rows
        self.counts = merged([self.counts, shard.counts])
        left_out = [{each.recipe: {name: 1}} for kind, name in COUNTED.items() for each in getattr(shard, kind)]
        self.rejected = merged([self.rejected, shard.rejected, *left_out])
        self.histograms = all_histograms([self.histograms, shard.histograms])
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
            histograms=self.histograms,
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
    if known is None or len(known.table) != shard.rows:
        known = marks(_placed(journal, shard), scenes=len(config.split) > 1)
        journal.keep(number, known)
    return known


def _placed(journal: Journal, shard: Shard) -> list[tuple[int, Item]]:
    """The items of a shard with their positions, in order."""
    config, items = journal.plan.config, shard_files.items(journal.out, shard)
    named = ((config.position(config.named(item.id)), item) for item in items)
    return sorted(named, key=lambda pair: pair[0])


def _leave_out(journal: Journal, number: int, found: Sequence[Double]) -> None:
    """Write a shard again without its duplicates."""
    config, shard, gone = journal.plan.config, _shard(journal, number), {each.position for each in found}
    kept = [(position, item) for position, item in _placed(journal, shard) if position not in gone]
    ids = {item.id for _, item in kept}
    by_split = {
        file.split: [item for item in shard_files.read(journal.out, file) if item.id in ids] for file in shard.files
    }
    asked = [((cell.mode, cell.kind, cell.recipe), cell.asked) for cell in shard.cells]
    changed = {
        "files": shard_files.write(journal.out, journal.folder, number, config.shards, by_split),
        "counts": shard_files.counts(by_split),
        "histograms": counted(item for _, item in kept),
        "cells": table(asked, ((item.mode, item.kind, item.recipe) for _, item in kept)),
        "duplicates": _left_out(shard.duplicates, config, [each for each in found if not each.alike]),
        "variants": _left_out(shard.variants, config, [each for each in found if each.alike]),
    }
    journal.note(shard.model_copy(update=changed), marks(kept, scenes=len(config.split) > 1))


def _left_out(
    before: Sequence[RefusedPosition], config: Config, found: Sequence[Double]
) -> tuple[RefusedPosition, ...]:
    """Those of a shard that were left out before, and more of them, in order."""
    more = [
        RefusedPosition.of(
            each.position,
            config.request(each.position),
            f"{'like' if each.alike else 'same as'} {config.request(each.first).id}",
        )
        for each in found
    ]
    return tuple(sorted([*before, *more], key=lambda each: each.position))
