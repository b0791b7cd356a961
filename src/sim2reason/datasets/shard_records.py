"""The files and the record of a shard: put for items at their positions, read back, and lengthened."""

from collections.abc import Sequence

from sim2reason.datasets import shard_files
from sim2reason.datasets.cells import table, together
from sim2reason.datasets.distinct import Marks, marks
from sim2reason.datasets.histograms import counted
from sim2reason.datasets.journal import Journal
from sim2reason.datasets.manifest import REFUSALS, Shard, merged
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item
from sim2reason.generation.splits import split_of

Placed = Sequence[tuple[int, Item]]
"""Items with their positions, in order."""


def put_shard(journal: Journal, shard: Shard, items: Placed) -> None:
    """Write the files of a shard that holds `items`, then its record, which is `shard` with what hangs on them."""
    config = journal.plan.config
    homes = [(split_of(item, config.split), item) for _, item in items]
    by_split = {name: [item for home, item in homes if home == name] for name in config.split}
    asked = [((cell.mode, cell.kind, cell.recipe), cell.asked) for cell in shard.cells]
    changed = {
        "files": shard_files.write(journal.out, journal.folder, shard.number, journal.shards, by_split),
        "counts": shard_files.counts(by_split),
        "histograms": counted(item for _, item in items),
        "cells": table(asked, ((item.mode, kind, item.recipe) for _, item in items for kind in item.kinds)),
    }
    journal.note(shard.model_copy(update=changed), marks(items, scenes=len(config.split) > 1))


def lengthened(shard: Shard, by: Shard) -> Shard:
    """Return the record of the positions of a shard and those behind them, but for what hangs on its items."""
    refused = {kind: (*getattr(shard, kind), *getattr(by, kind)) for kind in REFUSALS}
    changed = {
        "positions": (shard.positions[0], by.positions[1]),
        "rejected": merged([shard.rejected, by.rejected]),
        "cells": together([shard.cells, by.cells]),
    }
    return shard.model_copy(update=refused | changed)


def shard_of(journal: Journal, number: int) -> Shard:
    """Return the record of a shard that stands."""
    shard = journal.shard(number)
    if shard is None:
        raise DatasetError(f"{journal.folder}: the record of shard {number} is gone; give the same command again")
    return shard


def items_of(journal: Journal, shard: Shard) -> list[tuple[int, Item]]:
    """Return the items of a shard with their positions, in order."""
    config, items = journal.plan.config, shard_files.items(journal.out, shard)
    named = ((config.position(config.named(item.id)), item) for item in items)
    return sorted(named, key=lambda pair: pair[0])


def marks_of(journal: Journal, number: int) -> Marks:
    """Return what no other item may share with those of a shard, read from its files where it was not kept."""
    known, shard = journal.marks(number), shard_of(journal, number)
    if known is None or len(known.table) != shard.rows:
        known = marks(items_of(journal, shard), scenes=len(journal.plan.config.split) > 1)
        journal.keep(number, known)
    return known
