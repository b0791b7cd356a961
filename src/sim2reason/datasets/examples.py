"""Worked examples for the card of a dataset: problems of several sorts, each with its solution and its figure."""

import warnings
from collections.abc import Iterable
from typing import NamedTuple

from sim2reason.datasets.plan import MAKER, Config
from sim2reason.errors import FigureWarning, MissingExtraError, Sim2ReasonError
from sim2reason.generation.item import Item
from sim2reason.generation.request import Request

EXAMPLES = 6
VARIED = "recipe", "kind", "difficulty", "mode", "shape"
"""In what examples should differ, what counts most first."""


class Example(NamedTuple):
    """A problem that a card shows."""

    item: Item
    solution: str
    """The worked solution, or why there is none."""
    picture: bytes | None
    """A PNG, if the scene can be drawn here."""


def chosen(items: Iterable[Item]) -> list[Item]:
    """Return a few of some items that differ as much as they can, the first ones if in doubt."""
    waiting, found = list(items), list[Item]()
    while waiting and len(found) < EXAMPLES:
        seen = {name: [getattr(item, name) for item in found] for name in VARIED}
        best = min(waiting, key=lambda item: [seen[name].count(getattr(item, name)) for name in VARIED])
        waiting.remove(best)
        found.append(best)
    return found


def example(item: Item, config: Config) -> Example:
    """Return an item of a dataset with its solution and its figure, which calls things as the prompt does."""
    try:
        solution, picture = _made_again(item) if config.maker == MAKER else ("", None)
    except Sim2ReasonError as error:  # a version that fits, but a scene that can't be told or drawn
        solution, picture = f"None: {error}", None
    if item.solution is not None:
        solution = item.solution.text
    return Example(item, solution or item.unsolved or "This dataset has none.", picture)


def _made_again(item: Item) -> tuple[str, bytes | None]:
    """The worked solution and the figure of an item of the library's own maker: both need more than items keep."""
    from sim2reason.figures import canvas, drawing  # noqa: PLC0415 - the same
    from sim2reason.generation.item_search import ItemSearch  # noqa: PLC0415 - it loads what else only workers need
    from sim2reason.generation.worked_solutions import recorded, worked  # noqa: PLC0415 - the same

    request = Request.of(item)
    found = ItemSearch(request).found()
    if found is None or found.prompt != item.prompt:
        return "", None
    solution, unsolved = recorded(worked(request, found)) if item.solution is None else (item.solution, "")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", FigureWarning)
        drawn = drawing.drawing(found.description.scene, found.description)
    try:
        picture = canvas.png(drawn)
    except MissingExtraError:
        picture = None
    return solution.text if solution is not None else f"None: {unsolved}.", picture
