"""Sample problems and statistics of a dataset."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from sim2reason.base.record import counted
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.manifest import Counts
from sim2reason.datasets.plan import ALL, Names, several
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item, Record

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


COUNTED = "recipe", "difficulty", "mode", "kind", "needs", "shape"
COLUMNS = *COUNTED, "asked.quantity", "prompt", "answer.value", "answer.unit"
DIGITS = 3  # of numbers for the median, as many as a prompt requests


class Spread(Record):
    """The minimum, median and maximum of a number over items; the median is rounded to three digits."""

    items: int
    least: float
    median: float
    greatest: float

    def __str__(self) -> str:
        """Return the three values and the number of items."""
        return f"{self.least:.3g} to {self.greatest:.3g}, median {self.median:.3g} ({counted(self.items, 'item')})"


class Stats(Record):
    """The statistics of a dataset.

    Attributes:
        items: Number of items.
        counts: Numbers of items by recipe, difficulty, mode, kind, needs, shape, quantity and split.
        refused: Numbers of draws that were rejected while the items were made, by filter.
        words: Spread of the lengths of prompts.
        answers: Spread of the answers by unit; of a formula, its value in the scene counts.
    """

    items: int
    counts: dict[str, Counts]
    refused: Counts
    words: Spread
    answers: dict[str, Spread]

    def __repr__(self) -> str:
        """Return the number of items and of rejected draws."""
        return f"<Stats: {counted(self.items, 'item')}, {counted(sum(self.refused.values()), 'refused draw')}>"

    def __str__(self) -> str:
        """Return a line with the counts of each column, and with the spread of prompts and answers."""
        counts = (
            f"  {by}: {', '.join(f'{name} {n}' for name, n in found.items())}" for by, found in self.counts.items()
        )
        answers = (f"  answers in {unit or 'pure numbers'}: {found}" for unit, found in self.answers.items())
        return "\n".join([repr(self)[1:-1], *counts, f"  words of prompts: {self.words}", *answers])


class _Numbers:
    """The smallest and largest of some numbers, and counts of the numbers rounded to three digits."""

    def __init__(self) -> None:
        self.least, self.greatest = float("inf"), float("-inf")
        self.rounded: Counter[float] = Counter()

    def add(self, value: float) -> None:
        self.least, self.greatest = min(self.least, value), max(self.greatest, value)
        self.rounded[float(f"{value:.{DIGITS - 1}e}")] += 1

    def spread(self) -> Spread:
        total, behind = self.rounded.total(), 0
        for value, count in sorted(self.rounded.items()):
            behind += count
            if 2 * behind >= total:
                return Spread(items=total, least=self.least, median=value, greatest=self.greatest)
        return Spread(items=0, least=0.0, median=0.0, greatest=0.0)


def stats(dataset: Dataset | Path | str) -> Stats:
    """Count the items of a dataset, and the lengths of their prompts and the sizes of their answers.

    Args:
        dataset: A dataset, or its folder.

    Returns:
        The counts by column, and the spread of prompts and answers.

    Raises:
        DatasetError: There is no finished dataset, or a file is damaged.

    Examples:
        >>> import sim2reason
        >>> data = sim2reason.generate("problems", items=2, recipe="pulley", difficulty="easy", workers=1)
        >>> sim2reason.stats(data).counts["recipe"]
        {'pulley': 2}
    """
    data = dataset if isinstance(dataset, Dataset) else Dataset(dataset)
    counts = {name: Counter[str]() for name in (*COUNTED, "quantity")}
    words, answers = _Numbers(), dict[str, _Numbers]()
    for row in data.rows(*COLUMNS):
        for name in COUNTED:
            counts[name][row[name]] += 1
        counts["quantity"][row["asked"]["quantity"]] += 1
        words.add(len(row["prompt"].split()))
        answers.setdefault(row["answer"]["unit"], _Numbers()).add(row["answer"]["value"])
    manifest = data.manifest
    return Stats(
        items=len(data),
        counts={name: _sorted(found) for name, found in counts.items()} | {"split": manifest.counts.get("split", {})},
        refused=_sorted(sum((Counter(found) for found in manifest.rejected.values()), Counter[str]())),
        words=words.spread(),
        answers={unit: found.spread() for unit, found in sorted(answers.items(), key=_commonest_first)},
    )


def _sorted(found: Counter[str]) -> Counts:
    return dict(sorted(found.items(), key=lambda pair: (-pair[1], pair[0])))


def _commonest_first(pair: tuple[str, _Numbers]) -> tuple[int, str]:
    return -pair[1].rounded.total(), pair[0]
