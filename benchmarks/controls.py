"""What cheap tricks earn: ``python benchmarks/controls.py [ITEMS] [SEED]``.

Negative controls on fresh items: zero, the best of all positive and of all negative constants, every number that the
prompt states, and the median of what the same recipe and kind of question ask for.

The best constant of a few items owes much to luck: it is chosen on one half of the items and judged by the other. No
negative one is right, for no answer is negative.
"""

import re
import sys
from bisect import bisect_left
from collections import defaultdict
from collections.abc import Sequence
from statistics import median

from sim2reason.datasets.grade import grade
from sim2reason.datasets.plan import Config
from sim2reason.generation.item import Item
from sim2reason.generation.make import make
from sim2reason.generation.recipes import all_recipes

NUMBER = re.compile(r"(?<![\w.])[−-]?\d+(?:\.\d+)?")
CONSTANT, NEGATIVE, REPEATED = 0.03, 0.0, 0.02  # what each may earn at most
MEDIAN = 0.2  # of a cell: where its median earns more, the cell should be drawn less
LEAST = 20  # items of a cell whose median says anything


def rewarded(item: Item, text: str) -> bool:
    """Whether a boxed answer is paid."""
    return grade(item, rf"\boxed{{{text}}}").reward > 0.0


def best_constant(items: Sequence[Item], sign: float = 1.0) -> tuple[float, float]:
    """The constant of a sign that most items would pay, and their share: a window that slides over all answers."""
    values = sorted(sign * item.answer.value for item in items if sign * item.answer.value > 0.0)
    best, share = 1.0, 0.0
    for value in values:  # the largest constant that the smallest of them pays
        constant = value * (1.0 + items[0].answer.tolerance)
        highest = constant / (1.0 - items[0].answer.tolerance)
        paid = bisect_left(values, highest) - bisect_left(values, value)
        if paid / len(items) > share:
            best, share = constant, paid / len(items)
    return sign * best, share


def judged_by_the_other(items: Sequence[Item], sign: float = 1.0) -> float:
    """What the best constant of one half earns in the other, on the average of both."""
    one, other = items[::2], items[1::2]
    pairs = ((best_constant(one, sign)[0], other), (best_constant(other, sign)[0], one))
    return sum(rewarded(item, repr(constant)) for constant, half in pairs for item in half) / len(items)


def repeats(item: Item) -> tuple[float, float, float]:
    """What a number of the prompt earns that is drawn at random; the last one; and whether any would."""
    numbers = [number.replace("−", "-") for number in NUMBER.findall(item.prompt)]
    paid = [rewarded(item, number) for number in numbers]
    return sum(paid) / len(paid), float(paid[-1]), float(any(paid))


def main(count: int = 500, seed: int = 31) -> int:
    """Print what each earns; exit code 1 if one earns more than it may."""
    config = Config(items=count, recipes=all_recipes(), seed=seed)
    return report([item for k in range(count) if (item := make(config.request(k)).item) is not None])


def report(items: Sequence[Item]) -> int:
    """Print what each earns on some items; exit code 1 if one earns more than it may."""
    zero = sum(rewarded(item, "0") for item in items)
    repeated = [repeats(item) for item in items]
    chance, last, some = (sum(part) / len(items) for part in zip(*repeated, strict=True))
    print(f"{len(items)} items, {sum(item.answer.value < 0.0 for item in items)} negative: zero is paid {zero} times")
    earned: list[float] = []
    for sign in (1.0, -1.0):
        constant, share = best_constant(items, sign)
        earned.append(judged_by_the_other(items, sign))
        print(f"the best constant, {constant:.4g}, earns {share:.2%}; that of the other half {earned[-1]:.2%}")
    print(f"a number of the prompt drawn at random earns {chance:.2%}, the last one {last:.2%}; any would {some:.2%}")
    cells: dict[tuple[str, str], list[Item]] = defaultdict(list)
    for item in items:
        cells[item.recipe, item.kind].append(item)
    for (recipe, kind), found in sorted(cells.items()):
        if len(found) >= LEAST:
            middle = median(item.answer.value for item in found)
            won = sum(rewarded(item, repr(middle)) for item in found) / len(found)
            print(f"{recipe:16} {kind:14} {len(found):5}  median {middle:9.3g} earns {won:.1%}{' !' * (won > MEDIAN)}")
    return int(zero > 0 or earned[0] > CONSTANT or earned[1] > NEGATIVE or max(chance, last) > REPEATED)


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
