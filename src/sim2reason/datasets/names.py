"""Names of recipes, difficulties, modes and needs as an order gives them: one, several, or all."""

from sim2reason.datasets.plan import ALL, Names, several
from sim2reason.errors import UnknownNameError
from sim2reason.generation.recipes import RECIPES, all_recipes, difficulty_named
from sim2reason.questions import MODES
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.questions.need import NEEDS, Need


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


def needs_named(names: Names) -> tuple[str, ...]:
    """Needs of solutions by their labels, each once and in ascending order; UnknownNameError for another.

    A hyphen may stand for a space. Without any the default quota holds.
    """
    found = {_need(name) for name in (tuple(NEEDS) if names == ALL else several("needs", names))}
    return tuple(need.label for need in sorted(found))


def _need(name: str) -> Need:
    need = NEEDS.get(name.replace("-", " "))
    if need is None:
        raise UnknownNameError(f"no such need: {name!r}; there are: {', '.join(NEEDS)}, or {ALL}")
    return need
