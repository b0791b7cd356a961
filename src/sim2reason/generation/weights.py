"""How often each kind of question is asked: weights declared by kinds and recipes, or by whoever orders a dataset.

The name of a weight is that of a kind, and may have a mode, a recipe or both before it: ``period``, ``reverse.period``,
``springs.period``, ``springs.reverse.period``. The most special one counts.
"""

from collections.abc import Mapping
from math import isfinite

import numpy as np

from sim2reason.errors import DatasetError
from sim2reason.generation.recipes import RECIPES
from sim2reason.generation.request import Weights
from sim2reason.questions import KINDS, MODES

REMEDY = "write KIND, MODE.KIND, RECIPE.KIND or RECIPE.MODE.KIND, as in reverse.period=0.5"


def weight(kind: str, mode: str, recipe: str, ordered: Mapping[str, float]) -> float:
    """Return how often a kind is asked, compared with others: as ordered, else as its class and the recipe declare."""
    for name in (f"{recipe}.{mode}.{kind}", f"{recipe}.{kind}", f"{mode}.{kind}", kind):
        if name in ordered:
            return ordered[name]
    declared = RECIPES[recipe].weights
    own = declared.get(f"{mode}.{kind}", declared.get(kind, 1.0))
    return KINDS[kind].share * MODES[mode].weights.get(kind, 1.0) * own


def in_drawn_order(mode: str, recipe: str, ordered: Weights, rng: np.random.Generator) -> list[str]:
    """Return all kinds of a mode but those of weight 0, each the next one by its weight among those that are left.

    Where the first one that can be had is taken, each is by its weight among those that can be had.
    """
    given = dict(ordered)
    found = {kind: weight(kind, mode, recipe, given) for kind in _kinds(mode)}
    kinds = [kind for kind, size in found.items() if size > 0.0]
    sizes = np.array([found[kind] for kind in kinds])
    order: list[int] = rng.choice(len(kinds), size=len(kinds), replace=False, p=sizes / sizes.sum()).tolist()
    return [kinds[number] for number in order]


def check(weights: Mapping[str, float], modes: tuple[str, ...], recipes: tuple[str, ...]) -> None:
    """DatasetError for a weight that is none, a name that means nothing, and where no kind is left to be asked."""
    for name, size in weights.items():
        if not (isfinite(size) and size >= 0.0):
            raise _error(name, f"{size} is no weight", "give a number that is not negative; 0 is never asked")
        *before, kind = name.split(".")
        if kind not in KINDS:
            raise _error(name, f"there is no kind {kind!r}", f"there are: {', '.join(KINDS)}; {REMEDY}")
        known = (RECIPES, MODES) if len(before) > 1 else (RECIPES if before and before[0] in RECIPES else MODES,)
        asking = next((MODES[part] for part in before if part in MODES), None)
        if asking is not None and size > 0.0 and kind not in asking.kinds:
            raise _error(name, f"the mode {asking.name} has no {kind!r}", f"it has: {', '.join(_kinds(asking.name))}")
        if len(before) > 2 or any(part not in found for part, found in zip(before, known, strict=False)):
            raise _error(name, f"{'.'.join(before)!r} is no recipe, mode, or recipe and mode", REMEDY)
    for mode in dict.fromkeys(modes):
        for recipe in dict.fromkeys(recipes):
            if not any(weight(kind, mode, recipe, weights) > 0.0 for kind in _kinds(mode)):
                raise _error(f"{recipe}.{mode}", "all kinds have the weight 0", "leave one that can be asked")


def _kinds(mode: str) -> list[str]:
    return [kind for kind in KINDS if kind in MODES[mode].kinds]


def _error(name: str, problem: str, remedy: str) -> DatasetError:
    return DatasetError(f"weights: {name}: {problem}; {remedy}")
