"""Random scenes by recipe, difficulty, seed and index, before questions and filters."""

import hashlib
import json

import numpy as np

from sim2reason.errors import DrawError, SceneError
from sim2reason.generation.recipes import RECIPES, difficulty_named
from sim2reason.scenes.dsl.scene import Scene

TRIES = 50


def generator(*key: object) -> np.random.Generator:
    """Return a random generator seeded by the hash of a key, independent of that of any other key."""
    digest = hashlib.sha256(json.dumps(["sim2reason", *key]).encode()).digest()
    return np.random.default_rng(int.from_bytes(digest, "big"))


def sample(recipe: str, difficulty: str = "medium", *, seed: int = 0, index: int = 0) -> Scene:
    """Draw the `index`-th scene of a recipe, difficulty and seed; invalid draws are repeated.

    Raises:
        UnknownNameError: no such recipe or difficulty.
        DrawError: nothing fitted together within the budget.
    """
    found = RECIPES[recipe]
    checked = difficulty_named(difficulty)
    for attempt in range(TRIES):
        try:
            scene = found(checked, generator("scene", recipe, difficulty, seed, index, attempt))
            scene.check()
        except SceneError:
            continue
        return scene
    raise DrawError(f"{recipe} {difficulty} {seed} {index}: no scene fitted together; take another index")
