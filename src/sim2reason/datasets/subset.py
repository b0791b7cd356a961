"""Writing of a subset of a finished dataset as a new dataset."""

from collections.abc import Callable
from pathlib import Path

from sim2reason.base.atomic_files import checksum, put_text, remove_temporaries
from sim2reason.datasets import card, shard_files
from sim2reason.datasets.build import CARD
from sim2reason.datasets.card_content import count_histograms
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.manifest import MANIFEST, SHARDS, Counts, Manifest, Shard, all_histograms, merged, shards
from sim2reason.generation.item import Item

__all__ = ["put_subset"]


def put_subset(source: Dataset, out: Path, keeps: Callable[[Item], bool], filter_name: str, why: str) -> Manifest:
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
        found, left_out = _subset(source, out, shard, keeps)
        kept.append(found)
        gone = merged([gone, *({item.recipe: {filter_name: 1}} for item in left_out)])
    put_text(out / SHARDS, "".join(f"{shard.model_dump_json()}\n" for shard in kept), out)
    manifest = source.manifest.model_copy(
        update={
            "rows": sum(shard.rows for shard in kept),
            "counts": merged(shard.counts for shard in kept),
            "histograms": all_histograms(shard.histograms for shard in kept),
            "rejected": merged([source.manifest.rejected, gone]),
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
    held = {file.split: shard_files.read(source.path, file) for file in shard.files}
    kept = {split: [item for item in items if keeps(item)] for split, items in held.items()}
    changed = {
        "files": shard_files.write(out, out, shard.number, source.manifest.shards, kept),
        "counts": shard_files.counts(kept),
        "histograms": count_histograms(shard_files.flat(kept)),
    }
    return shard.model_copy(update=changed), [item for item in shard_files.flat(held) if not keeps(item)]
