"""Recipes: which entities meet, and how hard; difficulty belongs here and not to entities."""

from collections.abc import Callable
from typing import Literal

import numpy as np

from sim2reason.dsl.scene import Scene
from sim2reason.registry import Registry

Difficulty = Literal["easy", "medium", "hard"]
DIFFICULTIES: tuple[Difficulty, ...] = ("easy", "medium", "hard")

Recipe = Callable[[Difficulty, np.random.Generator], Scene]
"""One random scene. May raise SceneError for a draw that does not fit together: the caller draws again."""

RECIPES: Registry[Recipe] = Registry("recipes")
recipe = RECIPES.register
