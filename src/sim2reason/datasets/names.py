"""Names of recipes, difficulties and modes as an order gives them: one, several, or all."""

from sim2reason.datasets.plan import ALL, Names, several
from sim2reason.questions import MODES
from sim2reason.recipes import DIFFICULTIES, RECIPES, Difficulty, all_recipes, difficulty_named


def recipes_named(names: Names, *, check: bool = True) -> tuple[str, ...]:
    """Recipes; `check` raises UnknownNameError, with what is near, for one that there is not."""
    found = all_recipes() if names == ALL else several("recipe", names)
    for name in found if check else ():
        RECIPES[name]
    return found


def modes_named(names: Names, *, check: bool = True) -> tuple[str, ...]:
    """Modes of questions, checked as recipes are."""
    found = tuple(MODES) if names == ALL else several("mode", names)
    for name in found if check else ():
        MODES[name]
    return found


def difficulties_named(names: Names) -> tuple[Difficulty, ...]:
    """Difficulties; UnknownNameError for another."""
    found = DIFFICULTIES if names == ALL else several("difficulty", names)
    return tuple(difficulty_named(name) for name in found)
