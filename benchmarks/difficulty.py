"""How difficult problems are, and what they need, by recipe and label: ``python benchmarks/difficulty.py [--items N]``.

Each row has the mean score of items of a recipe, mode and label, and how many of them have which need. Then: the share
of each mode that needs more than elementary means, and every recipe and mode in which the mean does not rise with the
label. Exit code 1 if a share is above 10 % or a mean falls.
"""

import argparse
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from itertools import pairwise
from statistics import mean

from sim2reason.datasets.item import Item
from sim2reason.datasets.make import make
from sim2reason.datasets.request import Request
from sim2reason.questions import MODES
from sim2reason.questions.need import ELEMENTARY, NEEDS
from sim2reason.recipes import DIFFICULTIES, RECIPES

MOST = 0.1  # of the items of a recipe and mode may need more than elementary means


def made(recipe: str, mode: str, label: str, count: int, seed: int) -> Iterator[Item]:
    """The items of one cell."""
    found = (make(Request(recipe, label, mode, seed, index)).item for index in range(count))
    return (item for item in found if item is not None)


def row(items: list[Item]) -> tuple[float, str]:
    """The mean score and the needs; items that are not measured count in the needs alone."""
    scores = [item.measured.score for item in items if item.measured is not None]
    needs = Counter(item.needs for item in items)
    return mean(scores) if scores else 0.0, ", ".join(f"{n} {needs[n]}" for n in NEEDS if n in needs)


def falling(means: Iterable[float]) -> bool:
    """Whether one is below the one before it."""
    return any(later < earlier for earlier, later in pairwise(means))


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--items", type=int, default=10, help="how many of each recipe, mode and label (default: 10)")
    parser.add_argument("--seed", type=int, default=11)
    parser.add_argument("--recipe", default=",".join(RECIPES), help="recipes, separated by commas (default: all)")
    parser.add_argument("--mode", default=",".join(MODES), help="modes, separated by commas (default: all)")
    order = parser.parse_args()
    beyond: dict[str, list[bool]] = defaultdict(list)
    falls: list[str] = []
    for mode in order.mode.split(","):
        for recipe in order.recipe.split(","):
            means: list[float] = []
            for label in DIFFICULTIES:
                items = list(made(recipe, mode, label, order.items, order.seed))
                score, needs = row(items)
                means += [score] if items else []
                beyond[mode] += [NEEDS[item.needs] > ELEMENTARY for item in items]
                print(f"{recipe:16} {mode:9} {label:7} {len(items):3} items, score {score:5.1f}: {needs}", flush=True)
            falls += [f"{recipe} {mode}: {', '.join(f'{found:.1f}' for found in means)}"] if falling(means) else []
    shares = {mode: mean(found) for mode, found in beyond.items() if found}
    for mode, share in shares.items():
        print(f"{mode}: {share:.1%} of {len(beyond[mode])} need more than elementary means")
    for fall in falls:
        print(f"the mean falls: {fall}")
    return int(bool(falls) or any(share > MOST for share in shares.values()))


if __name__ == "__main__":
    raise SystemExit(main())
