"""How often a prompt alone leads back to its answer: ``python benchmarks/round_trip.py [ITEMS] [SEED]``.

Each prompt, of every mode in turn, is read back into a scene and a question, hidden numbers are drawn anew, and the
scene is solved again: one in symbols at the item's own numbers, a reverse one for its unknown.
How often each shape of prompts was drawn is printed as well, and the largest share of one within a recipe.
"""

import sys
import time
from collections import Counter

import numpy as np

from sim2reason.datasets.plan import Config
from sim2reason.errors import Sim2ReasonError
from sim2reason.generation.make import make
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import MODES
from sim2reason.questions.prompt import parse_prompt

TOLERANCE = 0.01


def main(items: int = 500, seed: int = 11) -> int:
    """Print the share, and every item that is not answered again; exit code 1 if fewer than 99 % are."""
    config = Config(items=items, recipes=tuple(RECIPES), modes=tuple(MODES), seed=seed)
    right, asked, spent = 0, 0, 0.0
    drawn, of_recipe = Counter[tuple[str, str]](), Counter[str]()
    for position in range(items):
        item = make(config.request(position)).item
        if item is None:
            continue
        asked += 1
        drawn[item.recipe, item.shape] += 1
        of_recipe[item.recipe] += 1
        begin = time.process_time()
        try:
            formula = item.answer.formula
            given = formula.given() if formula is not None else {}
            read = parse_prompt(item.prompt, np.random.default_rng(position), given)
            answer = read.answer if read.shape == item.shape else None
        except Sim2ReasonError as error:
            print(f"{item.id}: {error}")
            continue
        finally:
            spent += time.process_time() - begin
        if answer is not None and abs(answer - item.answer.value) <= TOLERANCE * abs(item.answer.value):
            right += 1
        else:
            print(f"{item.id}: {answer} for {item.answer.value}")
    print(f"{right} of {asked} prompts lead back to their answer; {1e3 * spent / asked:.1f} ms of CPU each")
    shapes = Counter[str]()
    for (_, shape), count in drawn.items():
        shapes[shape] += count
    print(", ".join(f"{shape} {count / asked:.0%}" for shape, count in shapes.most_common()))
    share, recipe, shape = max((count / of_recipe[recipe], recipe, shape) for (recipe, shape), count in drawn.items())
    print(f"at most {share:.0%} of one recipe: {shape} of {recipe}")
    return 0 if right >= 0.99 * asked else 1


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
