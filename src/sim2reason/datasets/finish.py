"""End a dataset whose items all stand: count, and write list, card and manifest."""

from pathlib import Path

from sim2reason.base.atomic_files import checksum, put, put_text
from sim2reason.datasets import card, shard_files
from sim2reason.datasets.cells import Cell, together
from sim2reason.datasets.examples import chosen, example
from sim2reason.datasets.histograms import Counted
from sim2reason.datasets.journal import Journal
from sim2reason.datasets.manifest import (
    COUNTED,
    MANIFEST,
    REFUSALS,
    SHARDS,
    Counts,
    Manifest,
    Refusal,
    RefusedPositions,
    Shard,
    all_histograms,
    merged,
)
from sim2reason.datasets.pictures import drawn_by, put_pictures, remove_pictures
from sim2reason.datasets.shard_records import shard_of

CARD = "README.md"


def finish(journal: Journal) -> Manifest:
    """Write what is not there yet, the manifest last, and give it; whatever is held in memory is of one shard."""
    out, totals = journal.out, _Totals()

    def write(path: Path) -> None:
        with path.open("w", encoding="utf-8", newline="\n") as file:
            for number in range(journal.shards):
                shard = shard_of(journal, number)
                totals.add(shard)
                file.write(f"{shard.model_dump_json()}\n")

    put(out / SHARDS, write, journal.folder)
    manifest = _illustrated(journal, totals.manifest(journal)).sealed()
    put_text(out / MANIFEST, manifest.text(), journal.folder)
    return manifest


def _illustrated(journal: Journal, manifest: Manifest) -> Manifest:
    """Write the card and its pictures, and give the manifest that knows them."""
    out, config = journal.out, journal.plan.config
    shards = (shard_of(journal, number) for number in range(journal.shards))
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
        """Return the manifest, but for checksums and seal."""
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
