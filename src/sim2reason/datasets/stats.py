"""What a dataset holds, counted: one pass over its files, with one in memory at a time."""

from collections import Counter
from pathlib import Path

from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.item import Record
from sim2reason.datasets.manifest import Counts

COUNTED = "recipe", "difficulty", "mode", "kind", "needs", "shape"
COLUMNS = *COUNTED, "asked.quantity", "prompt", "answer.value", "answer.unit"
DIGITS = 3  # of numbers whose middle is sought: as many as a prompt asks for


class Spread(Record):
    """The least, the middle and the greatest of some numbers; the middle is rounded to three digits."""

    items: int
    least: float
    median: float
    greatest: float


class Stats(Record):
    """What a dataset holds."""

    items: int
    counts: dict[str, Counts]
    """By recipe, difficulty, mode, kind, needs, shape, quantity and split."""
    refused: Counts
    """Draws that a filter refused while the items were made, by filter."""
    words: Spread
    """Lengths of prompts."""
    answers: dict[str, Spread]
    """By unit, as the items have it; a formula by its value in the scene."""


class _Numbers:
    """Numbers of which only the extremes and a rounded histogram are kept."""

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
    """Count a dataset: what its items are, how long their prompts are, and which answers they have.

    Raises:
        DatasetError: no finished dataset, or a damaged file.
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
