"""Items by their coordinates: single ones, or endless sequences."""

from collections.abc import Iterator, Mapping
from itertools import count

from sim2reason.datasets.plan import (
    ALL_NAMES,
    Config,
    Names,
    difficulties_named,
    find_modes,
    find_needs,
    find_recipes,
    numbers,
)
from sim2reason.errors import DrawError
from sim2reason.generation.certified import CertifiedQuestion
from sim2reason.generation.item import Item
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.make import build_item, make
from sim2reason.generation.request import SI, Request, check, nonnegative_integer
from sim2reason.questions.accuracy import TOLERANCE
from sim2reason.questions.spoken_units import system_named
from sim2reason.scenes.dsl.scene import Scene


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
    r"""Make the problem with the given coordinates.

    With the same versions of the packages, the same arguments give the same problem on any machine.

    Args:
        recipe: Name of a recipe, a kind of scene; ``sim2reason.list("recipes")`` returns all of them.
        difficulty: ``easy``, ``medium`` or ``hard``.
        mode: Mode of questions: ``numeric``, ``reverse``, ``symbolic``, ``multipart`` or ``choice``.
        seed: Number of a series of problems, 0 or greater.
        index: Position of the problem in its series, from 0.
        weights: Relative frequencies of kinds of question, as in ``{"period": 2, "reverse.count": 0}``; by default
            those that the library declares.
        units: System of units of the text and the answer: ``SI``, ``cgs``, or ``mixed`` (cm, g and km/h beside the SI).
        tolerance: Relative error that an answer may have, from 0.005 to 0.05; the filters apply it, too.
        needs: Mathematics that the solution may need: one or several of ``arithmetic``, ``quadratic``,
            ``inverse function``, ``root``, ``special function`` and ``integration``, or ``all``. By default one of the
            first three, except for a few items.
        solutions: Whether to add the worked solution.

    Returns:
        The problem with its answer, its scene, and the certificate of the two engines.

    Raises:
        UnknownNameError: There is no such recipe, difficulty, mode, system of units or need.
        DrawError: The seed or index is negative, the tolerance is out of range, or no draw passed the filters; in the
            last case take another index.
        DatasetError: A weight is invalid.

    Examples:
        >>> import sim2reason
        >>> problem = sim2reason.item("pulley", "easy", seed=7)
        >>> print(problem)
        pulley-easy-numeric-7-0 (pulley, easy, numeric)
        <BLANKLINE>
        ...
        <BLANKLINE>
        Answer: ...
        >>> sim2reason.grade(problem, rf"\boxed{{{problem.answer.value}}}").reward
        1.0
    """
    how = weights, units
    order = build_request(
        recipe, difficulty, mode, seed, index, *how, tolerance=tolerance, needs=needs, solutions=solutions
    )
    return make_item(order)[0]


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
    """Draw the scene of the problem with the given coordinates.

    Args:
        recipe: Name of a recipe, a kind of scene; ``sim2reason.list("recipes")`` returns all of them.
        difficulty: ``easy``, ``medium`` or ``hard``.
        mode: Mode of questions: ``numeric``, ``reverse``, ``symbolic``, ``multipart`` or ``choice``.
        seed: Number of a series of problems, 0 or greater.
        index: Position of the problem in its series, from 0.
        weights: Relative frequencies of kinds of question, as in ``{"period": 2, "reverse.count": 0}``; by default
            those that the library declares.
        tolerance: Relative error that an answer may have, from 0.005 to 0.05; the filters apply it, too.
        needs: Mathematics that the solution may need: one or several of ``arithmetic``, ``quadratic``,
            ``inverse function``, ``root``, ``special function`` and ``integration``, or ``all``. By default one of the
            first three, except for a few items.

    Returns:
        The scene of `item` with the same arguments.

    Raises:
        UnknownNameError: There is no such recipe, difficulty, mode or need.
        DrawError: The seed or index is negative, the tolerance is out of range, or no draw passed the filters.
        DatasetError: A weight is invalid.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.sample("incline", "easy", seed=3)
        >>> scene.value("world.gravity")
        9.8
        >>> scene == sim2reason.load(sim2reason.item("incline", "easy", seed=3).scene)
        True
    """
    return _find(
        build_request(recipe, difficulty, mode, seed, index, weights, SI, tolerance=tolerance, needs=needs)
    ).study.scene


def stream(  # noqa: PLR0913 - the same
    recipe: Names = ALL_NAMES,
    difficulty: Names = ALL_NAMES,
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
    """Yield problems without end, in turn from the given recipes, difficulties and modes.

    The few coordinates at which no draw passes the filters are skipped, as in a dataset.

    Args:
        recipe: Kinds of scenes: one name, several, or ``all``; ``sim2reason.list("recipes")`` returns them.
        difficulty: ``easy``, ``medium``, ``hard``, several of these, or ``all``.
        mode: Modes of questions: one name, several, or ``all``.
        seed: Number of the series of problems, 0 or greater.
        start: Position at which to start, from 0; no problem before it is made.
        weights: Relative frequencies of kinds of question, as in ``{"period": 2, "reverse.count": 0}``; by default
            those that the library declares.
        units: System of units of the text and the answer: ``SI``, ``cgs``, or ``mixed`` (cm, g and km/h beside the SI).
        tolerance: Relative error that an answer may have, from 0.005 to 0.05; the filters apply it, too.
        needs: Mathematics that the solution may need: one or several of ``arithmetic``, ``quadratic``,
            ``inverse function``, ``root``, ``special function`` and ``integration``, or ``all``. By default one of the
            first three, except for a few items.
        solutions: Whether to add worked solutions.

    Yields:
        The problems, in the order of their positions.

    Raises:
        UnknownNameError: There is no such recipe, difficulty, mode, system of units or need.
        DrawError: The seed or start is negative.
        DatasetError: A weight is invalid.

    Examples:
        >>> from itertools import islice
        >>> import sim2reason
        >>> [problem.id for problem in islice(sim2reason.stream("pulley", "easy"), 2)]
        ['pulley-easy-numeric-0-0', 'pulley-easy-numeric-0-1']
    """
    first = nonnegative_integer("start", start)
    config = Config(
        items=0,
        recipes=find_recipes(recipe),
        difficulties=difficulties_named(difficulty),
        modes=find_modes(mode),
        seed=nonnegative_integer("seed", seed),
        weights=numbers("weights", weights or {}),
        units=system_named(units).name,
        needs=find_needs(needs),
        tolerance=tolerance,
        solutions=solutions,
    )
    check(config.weights, config.modes, config.recipes)
    for position in count(first):
        problem = make(config.request(position)).item
        if problem is not None:
            yield problem


def build_request(  # noqa: PLR0913 - the same
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
    """Return the request for some coordinates; it raises the errors of `item`."""
    given = numbers("weights", weights or {})
    check(given, find_modes((mode,)), find_recipes((recipe,)))
    ordered = tuple(sorted(given.items()))
    how = system_named(units).name, solutions
    return Request(recipe, difficulty, mode, seed, index, ordered, *how, tolerance=tolerance, needs=find_needs(needs))


def make_item(request: Request) -> tuple[Item, CertifiedQuestion]:
    """Return the item of a request, with its certified question; DrawError if no draw passed the filters."""
    certified = _find(request)
    return build_item(request, certified), certified


def _find(request: Request) -> CertifiedQuestion:
    search = ItemSearch(request)
    certified = search.find()
    if certified is None:
        refused = ", ".join(f"{count} {name}" for name, count in sorted(search.rejected.items()))
        raise DrawError(f"{request.id}: no draw passed the filters ({refused}); take another index")
    return certified
