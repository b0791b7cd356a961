"""Recipes: random scenes of one family by difficulty, which belongs to recipes and not to entities."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from inspect import getdoc
from typing import TYPE_CHECKING

from sim2reason.base.registry import Registry
from sim2reason.errors import UnknownNameError
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty

if TYPE_CHECKING:  # plans of datasets read the names here, and no more
    import numpy as np

    from sim2reason.scenes.dsl.scene import Scene

Draw = Callable[[Difficulty, "np.random.Generator"], "Scene"]
"""One random scene. May raise SceneError for a draw that does not fit together: the caller draws again."""


@dataclass(frozen=True)
class Recipe:
    """The generator of random scenes of one family; `share` is its relative frequency among recipes.

    `weights` are factors on the frequencies of question kinds; 0 excludes a kind. The keys are names of kinds, or of a
    mode and a kind, as in ``reverse.period``.
    """

    draw: Draw
    share: int = 1
    weights: Mapping[str, float] = field(default_factory=dict[str, float])

    def __call__(self, difficulty: Difficulty, rng: "np.random.Generator") -> "Scene":
        """Draw one scene."""
        return self.draw(difficulty, rng)

    @property
    def summary(self) -> str:
        """Return the first line of the draw function's docstring."""
        return (getdoc(self.draw) or "").partition("\n")[0]


RECIPES: Registry[Recipe] = Registry("recipes", package="sim2reason.generation.recipes")


def recipe(name: str, share: int = 1, weights: Mapping[str, float] | None = None) -> Callable[[Draw], Draw]:
    """Return a decorator that registers a draw function as a recipe."""

    def register(draw: Draw) -> Draw:
        RECIPES.add(name, Recipe(draw, share, weights or {}))
        return draw

    return register


def all_recipes() -> tuple[str, ...]:
    """Return the names of all recipes, each repeated by its relative frequency."""
    rounds = range(max(member.share for member in RECIPES.values()))
    return tuple(name for turn in rounds for name, member in RECIPES.items() if member.share > turn)


def find_difficulty(difficulty: str) -> Difficulty:
    """Return a difficulty by its name; UnknownNameError, with the valid names, for an unknown one."""
    for name in DIFFICULTIES:
        if name == difficulty:
            return name
    raise UnknownNameError(f"no such difficulty: {difficulty!r}; there are: {', '.join(DIFFICULTIES)}")
