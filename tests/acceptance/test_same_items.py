"""Tests that refactoring changes no item: digests of 300 items with their solutions.

The default tests compare one of each recipe, the slow ones a quarter. ``python tests/acceptance/test_same_items.py``
compares all, and with ``--write`` writes new digests, after a change that is meant to change items.
"""

import json
import sys
from hashlib import sha256
from itertools import product
from multiprocessing import Pool
from pathlib import Path

import pytest

from sim2reason.generation.make import make
from sim2reason.generation.recipes import RECIPES
from sim2reason.generation.request import Request
from sim2reason.questions import MODES
from sim2reason.questions.difficulty import DIFFICULTIES

DIGESTS = Path(__file__).parents[1] / "data" / "same_items.json"
SEED = 3232


def requests(recipe: str) -> list[Request]:
    cells = [(difficulty, mode, 0) for difficulty, mode in product(DIFFICULTIES, MODES)]
    cells += [("medium", mode, 1) for mode in MODES]
    return [Request(recipe, difficulty, mode, SEED, index, solutions=True) for difficulty, mode, index in cells]


def digest(request: Request) -> str:
    """Return a digest of an item without the versions of the libraries that made it."""
    item = make(request).item
    if item is None:
        return ""
    held = json.loads(item.model_dump_json())
    held["provenance"].pop("versions")
    return sha256(json.dumps(held, sort_keys=True).encode()).hexdigest()[:16]


def digests(recipe: str) -> dict[str, str]:
    return {request.id: digest(request) for request in requests(recipe)}


def differing(recipe: str, compared: list[Request]) -> list[str]:
    known = json.loads(DIGESTS.read_text(encoding="utf-8"))[recipe]
    return [request.id for request in compared if digest(request) != known[request.id]]


@pytest.mark.parametrize("recipe", RECIPES)
def test_an_item_of_each_recipe_is_the_same_byte_for_byte(recipe: str) -> None:
    """Modes and difficulties alternate from recipe to recipe."""
    held = requests(recipe)
    assert not differing(recipe, [held[4 * list(RECIPES).index(recipe) % len(held)]])


@pytest.mark.slow
@pytest.mark.parametrize("recipe", RECIPES)
def test_items_are_the_same_byte_for_byte(recipe: str) -> None:
    assert not differing(recipe, requests(recipe)[::4])


def main(options: list[str]) -> int:
    """Compare all digests, or write them; return the number of items that differ."""
    with Pool() as pool:
        made = dict(zip(RECIPES, pool.map(digests, RECIPES, chunksize=1), strict=True))
    if options == ["--write"]:
        DIGESTS.write_text(f"{json.dumps(made, indent=1)}\n", encoding="utf-8")
    known = json.loads(DIGESTS.read_text(encoding="utf-8"))
    differ = [name for recipe in RECIPES for name, found in made[recipe].items() if known[recipe][name] != found]
    sys.stdout.write("\n".join([f"{sum(map(len, made.values()))} items, {len(differ)} differ", *differ, ""]))
    return len(differ)


if __name__ == "__main__":
    sys.exit(min(main(sys.argv[1:]), 1))
