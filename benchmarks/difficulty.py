"""How difficult problems are, and what they need: ``python benchmarks/difficulty.py [SET ...] [--items N]``.

Of the items of sets that `sim2reason generate` has made, or of N drawn for each recipe, mode and label. Each row has
the mean score of the items of a recipe and label, and how many of them have which need. Then: the share of each mode,
and of each recipe's items in a mode, that needs more than elementary means, and every recipe in which the mean score
does not rise with the label. Exit code 1 if a mode's share is above 10 % or a mean falls.
"""

import argparse
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from itertools import pairwise, product
from statistics import mean

from sim2reason.datasets.dataset import Dataset
from sim2reason.generation.item import Item
from sim2reason.generation.make import make
from sim2reason.generation.recipes import RECIPES
from sim2reason.generation.request import Request
from sim2reason.questions import MODES
from sim2reason.questions.difficulty import DIFFICULTIES, ELEMENTARY, NEEDS

MOST = 0.1  # of the items of a mode may need more than elementary means


def drawn(order: argparse.Namespace) -> Iterator[Item]:
    """Draw the items of each recipe, mode and label that the command names."""
    cells = product(order.recipe.split(","), order.mode.split(","), DIFFICULTIES, range(order.items))
    for recipe, mode, label, index in cells:
        item = make(Request(recipe, label, mode, order.seed, index)).item
        if item is not None:
            yield item


def row(items: list[Item]) -> tuple[float, str]:
    """The mean score and the needs; items that are not measured count in the needs alone."""
    scores = [item.measured.score for item in items if item.measured is not None]
    needs = Counter(item.needs for item in items)
    return mean(scores) if scores else 0.0, ", ".join(f"{n} {needs[n]}" for n in NEEDS if n in needs)


def falling(means: Iterable[float]) -> bool:
    """Whether one is below the one before it."""
    return any(later < earlier for earlier, later in pairwise(means))


def falls(cells: dict[tuple[str, str], list[Item]]) -> Iterator[str]:
    """Print the row of each recipe and label, and yield the recipes in which the mean falls."""
    for recipe in dict.fromkeys(recipe for recipe, _ in cells):
        means: list[float] = []
        for label in (label for label in DIFFICULTIES if cells.get((recipe, label))):
            score, needs = row(cells[recipe, label])
            means.append(score)
            print(f"{recipe:16} {label:7} {len(cells[recipe, label]):4} items, score {score:5.1f}: {needs}")
        if falling(means):
            yield f"{recipe}: {', '.join(f'{found:.1f}' for found in means)}"


def shares(items: list[Item]) -> Iterator[bool]:
    """Print the share of each mode that needs more than elementary means, and yield whether it is too large."""
    beyond: dict[str, dict[str, list[bool]]] = defaultdict(lambda: defaultdict(list))
    for item in items:
        beyond[item.mode][item.recipe].append(NEEDS[item.needs] > ELEMENTARY)
    for mode, recipes in beyond.items():
        found = [one for held in recipes.values() for one in held]
        worst = max(recipes, key=lambda recipe: mean(recipes[recipe]))
        most = f"{sum(recipes[worst])} of {len(recipes[worst])} of {worst}"
        print(f"{mode}: {mean(found):.1%} of {len(found)} need more than elementary means; at most {most}")
        yield mean(found) > MOST


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sets", nargs="*", help="folders that `sim2reason generate` has made")
    parser.add_argument("--items", type=int, default=10, help="how many of each recipe, mode and label (default: 10)")
    parser.add_argument("--seed", type=int, default=11)
    parser.add_argument("--recipe", default=",".join(RECIPES), help="recipes, separated by commas (default: all)")
    parser.add_argument("--mode", default=",".join(MODES), help="modes, separated by commas (default: all)")
    order = parser.parse_args()
    items = [item for folder in order.sets for item in Dataset(folder)] if order.sets else list(drawn(order))
    cells: dict[tuple[str, str], list[Item]] = defaultdict(list)
    for item in items:
        cells[item.recipe, item.difficulty].append(item)
    fallen = list(falls(cells))
    above = list(shares(items))
    for fall in fallen:
        print(f"the mean falls: {fall}")
    return int(bool(fallen) or any(above))


if __name__ == "__main__":
    raise SystemExit(main())
