"""Items by their coordinates: any one at once, or as many as are wanted in order."""

from collections.abc import Iterator, Mapping

from sim2reason.datasets.item import Item
from sim2reason.datasets.make import make
from sim2reason.datasets.plan import SI, Config, Request
from sim2reason.datasets.weights import check
from sim2reason.errors import DrawError
from sim2reason.questions.spoken_units import system_named
from sim2reason.recipes import DIFFICULTIES, all_recipes


def item(
    recipe: str = "pulley",
    difficulty: str = "medium",
    mode: str = "numeric",
    *,
    seed: int = 0,
    index: int = 0,
    weights: Mapping[str, float] | None = None,
    units: str = SI,
) -> Item:
    """The `index`-th problem of a recipe, difficulty, mode and seed: the same one wherever and whenever it is made.

    `weights` say how often kinds of question are asked, compared with others: ``{"period": 2, "reverse.count": 0}``.
    `units` is the system in which it is told: ``SI``, ``cgs``, or ``mixed`` (cm, g and km/h beside the SI).

    Raises:
        DatasetError: a weight that makes no sense.
        UnknownNameError: no such recipe, difficulty, mode or units.
        DrawError: a negative seed or index, or no draw passed the filters within the budget; take another index.
    """
    check(weights or {}, (mode,), (recipe,))
    request = Request(recipe, difficulty, mode, seed, index, tuple(sorted((weights or {}).items())), units)
    made = make(request)
    if made.item is None:
        refused = ", ".join(f"{count} {name}" for name, count in sorted(made.rejected.items()))
        raise DrawError(f"{request.id}: no draw passed the filters ({refused}); take another index")
    return made.item


def stream(
    recipe: str = "all",
    difficulty: str = "all",
    mode: str = "numeric",
    *,
    seed: int = 0,
    start: int = 0,
    weights: Mapping[str, float] | None = None,
    units: str = SI,
) -> Iterator[Item]:
    """Problems without end, dealt in turn to the recipes and difficulties; `start` goes straight to a position.

    The few requests that no draw fills are passed over, as in a dataset. `weights` and `units` are those of `item`.

    Raises:
        UnknownNameError: no such recipe, difficulty, mode or units.
        DrawError: a negative seed or start.
        DatasetError: a weight that makes no sense.
    """
    if seed < 0 or start < 0:
        raise DrawError(f"seed {seed}, start {start}: one is negative; count from 0")
    config = Config(
        items=0,
        recipes=all_recipes() if recipe == "all" else (recipe,),
        difficulties=DIFFICULTIES if difficulty == "all" else (difficulty,),
        modes=(mode,),
        seed=seed,
        weights=dict(weights or {}),
        units=system_named(units).name,
    )
    check(config.weights, config.modes, config.recipes)
    position = start
    while True:
        made = make(config.request(position))
        position += 1
        if made.item is not None:
            yield made.item
