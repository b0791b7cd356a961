"""Items by their coordinates: any one at once, or as many as are wanted in order."""

from collections.abc import Iterator, Mapping
from itertools import count

from sim2reason.datasets.certified import CertifiedQuestion
from sim2reason.datasets.item import Item
from sim2reason.datasets.item_search import ItemSearch
from sim2reason.datasets.make import item_of, make
from sim2reason.datasets.names import difficulties_named, modes_named, needs_named, recipes_named
from sim2reason.datasets.plan import ALL, Config, Names, numbers
from sim2reason.datasets.request import SI, Request, whole
from sim2reason.datasets.weights import check
from sim2reason.dsl.scene import Scene
from sim2reason.errors import DrawError
from sim2reason.questions.spoken_units import system_named
from sim2reason.questions.tolerance import TOLERANCE


def item(  # noqa: PLR0913 - the coordinates of a problem, by name
    recipe: str = "pulley",
    difficulty: str = "medium",
    mode: str = "numeric",
    *,
    seed: int = 0,
    index: int = 0,
    weights: Mapping[str, float] | None = None,
    units: str = SI,
    tolerance: float = TOLERANCE,
    needs: Names = (),
    solutions: bool = False,
) -> Item:
    """The `index`-th problem of a recipe, difficulty, mode and seed: the same one wherever and whenever it is made.

    `weights` say how often kinds of question are asked, compared with others: ``{"period": 2, "reverse.count": 0}``.
    `units` is the system in which it is told: ``SI``, ``cgs``, or ``mixed`` (cm, g and km/h beside the SI).
    `tolerance` is the relative error that an answer may have, and by which filters judge: from 0.005 to 0.05.
    `needs` is what its solution may need: one or several of ``arithmetic``, ``quadratic``, ``inverse function``,
    ``root``, ``special function`` and ``integration``, or ``all``; by default one of the first three, save
    for a few items.
    With `solutions` it has its worked solution.

    Raises:
        DatasetError: a weight that makes no sense.
        UnknownNameError: no such recipe, difficulty, mode, units or need.
        DrawError: a negative seed or index, a tolerance out of range, or no draw passed the filters within the budget;
            take another index.
    """
    how = weights, units
    order = requested(
        recipe, difficulty, mode, seed, index, *how, tolerance=tolerance, needs=needs, solutions=solutions
    )
    return made(order)[0]


def sample(  # noqa: PLR0913 - the same
    recipe: str = "pulley",
    difficulty: str = "medium",
    mode: str = "numeric",
    *,
    seed: int = 0,
    index: int = 0,
    weights: Mapping[str, float] | None = None,
    tolerance: float = TOLERANCE,
    needs: Names = (),
) -> Scene:
    """The scene of the `item` of these coordinates; it raises what that does."""
    return _found(
        requested(recipe, difficulty, mode, seed, index, weights, SI, tolerance=tolerance, needs=needs)
    ).study.scene


def stream(  # noqa: PLR0913 - the same
    recipe: Names = ALL,
    difficulty: Names = ALL,
    mode: Names = "numeric",
    *,
    seed: int = 0,
    start: int = 0,
    weights: Mapping[str, float] | None = None,
    units: str = SI,
    tolerance: float = TOLERANCE,
    needs: Names = (),
    solutions: bool = False,
) -> Iterator[Item]:
    """Problems without end, dealt in turn to the recipes, difficulties and modes; `start` goes straight to a position.

    The few requests that no draw fills are passed over, as in a dataset. What follows `start` is as in `item`.

    Raises:
        UnknownNameError: no such recipe, difficulty, mode, units or need.
        DrawError: a negative seed or start.
        DatasetError: a weight that makes no sense.
    """
    first = whole("start", start)
    config = Config(
        items=0,
        recipes=recipes_named(recipe),
        difficulties=difficulties_named(difficulty),
        modes=modes_named(mode),
        seed=whole("seed", seed),
        weights=numbers("weights", weights or {}),
        units=system_named(units).name,
        needs=needs_named(needs),
        tolerance=tolerance,
        solutions=solutions,
    )
    check(config.weights, config.modes, config.recipes)
    for position in count(first):
        found = make(config.request(position)).item
        if found is not None:
            yield found


def requested(  # noqa: PLR0913 - the same
    recipe: str,
    difficulty: str,
    mode: str,
    seed: int,
    index: int,
    weights: Mapping[str, float] | None,
    units: str,
    *,
    tolerance: float = TOLERANCE,
    needs: Names = (),
    solutions: bool = False,
) -> Request:
    """The request of some coordinates; it raises what `item` does of them."""
    given = numbers("weights", weights or {})
    check(given, modes_named((mode,)), recipes_named((recipe,)))
    ordered = tuple(sorted(given.items()))
    how = system_named(units).name, solutions
    return Request(recipe, difficulty, mode, seed, index, ordered, *how, tolerance=tolerance, needs=needs_named(needs))


def made(request: Request) -> tuple[Item, CertifiedQuestion]:
    """The item of a request, with all that it was made of; DrawError if no draw passed the filters."""
    found = _found(request)
    return item_of(request, found), found


def _found(request: Request) -> CertifiedQuestion:
    search = ItemSearch(request)
    found = search.found()
    if found is None:
        refused = ", ".join(f"{count} {name}" for name, count in sorted(search.rejected.items()))
        raise DrawError(f"{request.id}: no draw passed the filters ({refused}); take another index")
    return found
