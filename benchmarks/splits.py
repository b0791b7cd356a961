"""What splits share, which must be nothing: python benchmarks/splits.py [items] [folder] [mode].

Makes a dataset of three splits over all recipes and difficulties, of all modes or one, by default 20,000 items in a
folder under the temporary directory, and compares every two splits: scenes, problems up to numbers, prompts up to
numbers. About two items a CPU-second, eight of the numeric mode alone; interrupted, the same command goes on where it
stopped, and with more items the dataset grows.
Exit code 1: two splits share something.
"""

import argparse
import sys
from hashlib import blake2b
from itertools import combinations
from pathlib import Path
from tempfile import gettempdir

from sim2reason import Dataset, generate
from sim2reason.generation.item import Item
from sim2reason.generation.splits import mask_numbers, problem

SPLIT = {"train": 0.8, "validation": 0.1, "test": 0.1}
COMPARED = {
    "scenes": lambda item: item.scene,
    "problems up to numbers": problem,
    "prompts up to numbers": lambda item: mask_numbers(item.prompt),
}


def mark(text: str) -> bytes:
    return blake2b(text.encode(), digest_size=16).digest()


def marks(data: Dataset, split: str) -> dict[str, set[bytes]]:
    """What the items of a split are, in every way that is compared."""
    found: dict[str, set[bytes]] = {name: set() for name in COMPARED}

    def add(item: Item) -> None:
        for name, of in COMPARED.items():
            found[name].add(mark(of(item)))

    for item in data.items(split):
        add(item)
    return found


def main(items: int = 20_000, folder: str = "", mode: str = "all") -> int:
    out = Path(folder) if folder else Path(gettempdir()) / "sim2reason-splits"
    data = generate(out, items=items, mode=mode, split=SPLIT)
    counts, refused = data.manifest.counts["split"], data.manifest.refused
    print(f"{len(data)} items of {items} asked for in {out}: " + ", ".join(f"{counts[name]} {name}" for name in SPLIT))
    print("left out: " + ", ".join(f"{found.total} {kind}" for kind, found in refused.items()))
    found, total = {split: marks(data, split) for split in SPLIT}, 0
    for name in COMPARED:
        sizes = ", ".join(f"{len(found[split][name])} in {split}" for split in SPLIT)
        shared = sum(len(found[a][name] & found[b][name]) for a, b in combinations(SPLIT, 2))
        print(f"{name}: {sizes}; {shared} in two splits")
        total += shared
    return 1 if total else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("items", type=int, nargs="?", default=20_000, help="how many (default: 20000)")
    parser.add_argument("folder", nargs="?", default="", help="of the dataset (default: one for temporary files)")
    parser.add_argument("mode", nargs="?", default="all", help="one mode, or all (the default)")
    sys.exit(main(**vars(parser.parse_args())))
