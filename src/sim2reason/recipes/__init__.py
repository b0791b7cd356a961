"""Recipes: which entities meet, and how hard; difficulty belongs here and not to entities."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Literal

from sim2reason.errors import UnknownNameError
from sim2reason.registry import Registry

if TYPE_CHECKING:  # plans of datasets read the names here, and no more
    import numpy as np

    from sim2reason.dsl.scene import Scene

Difficulty = Literal["easy", "medium", "hard"]
DIFFICULTIES: tuple[Difficulty, ...] = ("easy", "medium", "hard")

Recipe = Callable[[Difficulty, "np.random.Generator"], "Scene"]
"""One random scene. May raise SceneError for a draw that does not fit together: the caller draws again."""

RECIPES: Registry[Recipe] = Registry("recipes")
recipe = RECIPES.register


def known(difficulty: str) -> Difficulty:
    """A difficulty by its name; UnknownNameError with the names there are."""
    for name in DIFFICULTIES:
        if name == difficulty:
            return name
    raise UnknownNameError(f"no such difficulty: {difficulty!r}; there are: {', '.join(DIFFICULTIES)}")
