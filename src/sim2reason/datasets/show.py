"""Some problems of a dataset: from all over it, or from all over those that fit."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.plan import ALL, Names, several
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item

PROBLEMS = 3


def show(  # noqa: PLR0913 - filters, by name
    dataset: Dataset | Path | str,
    *,
    items: int = PROBLEMS,
    id: str | None = None,  # noqa: A002 - the column's name
    recipe: Names = ALL,
    difficulty: Names = ALL,
    mode: Names = ALL,
    kind: Names = ALL,
    quantity: Names = ALL,
    needs: Names = ALL,
    split: Names = ALL,
) -> Iterator[Item]:
    """Yield some problems of a dataset, spread over all that match.

    Each filter takes one name, several, or ``all``. One file of the dataset is in memory at a time.

    Args:
        dataset: A dataset, or its folder.
        items: Greatest number of problems.
        id: The id of a single problem; the filters are then ignored.
        recipe: Recipes of the problems.
        difficulty: Difficulties of the problems.
        mode: Modes of the problems.
        kind: Kinds of question.
        quantity: Quantities asked for.
        needs: Mathematics that the solutions need.
        split: Splits of the dataset.

    Yields:
        At most `items` problems, in the order of the dataset.

    Raises:
        DatasetError: There is no finished dataset, a file is damaged, a name does not occur, or no problem matches.

    Examples:
        >>> import sim2reason
        >>> sim2reason.generate("problems", items=2, recipe="pulley", difficulty="easy", workers=1)
        <Dataset 'problems': 2 train>
        >>> [problem.id for problem in sim2reason.show("problems", items=1, mode="numeric")]
        ['pulley-easy-numeric-0-...']
    """
    data = dataset if isinstance(dataset, Dataset) else Dataset(dataset)
    if id is not None:
        return iter([data.item(id)])
    given = {"recipe": recipe, "difficulty": difficulty, "mode": mode, "kind": kind, "needs": needs}
    given["asked.quantity"] = quantity
    wanted = {column: several(column.rpartition(".")[2], names) for column, names in given.items() if names != ALL}
    for column, names in wanted.items():
        _check(data, column.rpartition(".")[2], names)
    return _some(data, items, wanted, data.splits(split))


def _check(data: Dataset, by: str, names: Sequence[str]) -> None:
    held = data.manifest.counts.get(by, {})
    for name in names:
        if name not in held:
            raise DatasetError(f"{data.path}: holds no problem of {by} {name!r}; there is {', '.join(held) or 'none'}")


def _some(data: Dataset, items: int, wanted: Mapping[str, Sequence[str]], split: Sequence[str]) -> Iterator[Item]:
    found = data.some(items, wanted, split)
    first = next(found, None)
    if first is not None:
        yield first
        yield from found
    elif chosen := wanted if split == data.splits() else {**wanted, "split": split}:
        said = ", ".join(f"{by.rpartition('.')[2]} {' or '.join(names)}" for by, names in chosen.items())
        raise DatasetError(f"{data.path}: holds no problem of {said}; see: sim2reason stats {data.path}")
