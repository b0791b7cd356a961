"""What cheap tricks earn: ``python benchmarks/controls.py [ITEMS] [SEED]``.

Negative controls on fresh items: zero and negative constants, the best of all positive constants, every number that the
prompt states, and the median of what the same recipe and kind of question ask for.
"""

import re
import sys
from bisect import bisect_left
from collections import defaultdict
from collections.abc import Sequence
from statistics import median

from sim2reason.datasets.grade import grade
from sim2reason.datasets.item import Item
from sim2reason.datasets.make import make
from sim2reason.datasets.plan import Config
from sim2reason.recipes import RECIPES

NUMBER = re.compile(r"(?<![\w.])[−-]?\d+(?:\.\d+)?")
MEDIAN = 0.2  # of a cell: where its median earns more, the cell should be drawn less
LEAST = 20  # items of a cell whose median says anything


def rewarded(item: Item, text: str) -> bool:
    """Whether a boxed answer is paid."""
    return grade(item, rf"\boxed{{{text}}}").reward > 0.0


def best_constant(items: Sequence[Item]) -> tuple[float, float]:
    """The positive constant that most items would pay, and their share: a window that slides over all answers."""
    values = sorted(item.answer.value for item in items if item.answer.value > 0.0)
    best, share = 1.0, 0.0
    for value in values:  # the largest constant that the smallest of them pays
        constant = value * (1.0 + items[0].answer.tolerance)
        highest = constant / (1.0 - items[0].answer.tolerance)
        paid = bisect_left(values, highest) - bisect_left(values, value)
        if paid / len(items) > share:
            best, share = constant, paid / len(items)
    return best, share


def repeats(item: Item) -> tuple[float, float, float]:
    """What a number of the prompt earns that is drawn at random; the last one; and whether any would."""
    numbers = [number.replace("−", "-") for number in NUMBER.findall(item.prompt)]
    paid = [rewarded(item, number) for number in numbers]
    return sum(paid) / len(paid), float(paid[-1]), float(any(paid))


def main(count: int = 500, seed: int = 31) -> int:
    """Print what each earns; exit code 1 if one earns more than it may."""
    config = Config(items=count, recipes=tuple(RECIPES), seed=seed)
    items = [item for k in range(count) if (item := make(config.request(k)).item) is not None]
    paid = sum(rewarded(item, text) for item in items for text in ("0", "-1", "-0.5"))
    constant, share = best_constant(items)
    repeated = [repeats(item) for item in items]
    chance, last, some = (sum(part) / len(items) for part in zip(*repeated, strict=True))
    print(f"{len(items)} items: zero and negative constants are paid {paid} times")
    print(f"the best constant, {constant:.4g}, earns {share:.2%}")
    print(f"a number of the prompt drawn at random earns {chance:.2%}, the last one {last:.2%}; any would {some:.2%}")
    cells: dict[tuple[str, str], list[Item]] = defaultdict(list)
    for item in items:
        cells[item.recipe, item.kind].append(item)
    for (recipe, kind), found in sorted(cells.items()):
        if len(found) >= LEAST:
            middle = median(item.answer.value for item in found)
            won = sum(rewarded(item, repr(middle)) for item in found) / len(found)
            print(f"{recipe:16} {kind:14} {len(found):5}  median {middle:9.3g} earns {won:.1%}{' !' * (won > MEDIAN)}")
    return int(paid > 0 or share > 0.03 or max(chance, last) > 0.02)


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
