"""Items per CPU second, filters and engines included, by recipe: ``python benchmarks/generation_speed.py [ITEMS]``.

The maker runs in this process, so that only its own time is counted; loading it is counted apart, as is the
first item, which people wait for.
"""

import sys
from collections import Counter
from time import process_time

from sim2reason.cli.kinds import chosen
from sim2reason.datasets.plan import MAKER, Config, load_maker


def main(items: int) -> None:
    start = process_time()
    make = load_maker(MAKER)
    config = Config(items=items, recipes=chosen("recipes", "all"))
    make(config.request(0))
    print(f"first item after {process_time() - start:.2f} CPU s")
    spent: Counter[str] = Counter()
    made: Counter[str] = Counter()
    for position in range(items):
        request = config.request(position)
        start = process_time()
        item = make(request).item
        for key in (request.recipe, request.difficulty, "all"):
            spent[key] += process_time() - start
            made[key] += item is not None
    for key, seconds in spent.items():
        print(f"{key:12} {made[key] / seconds:8.1f} items per CPU s  ({made[key]} items)")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 240)
