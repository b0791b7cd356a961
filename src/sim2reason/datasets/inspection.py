"""Inspection of a dataset: sample problems, statistics, and the explanation of one problem."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from textwrap import indent
from typing import TypeVar

from sim2reason.base.records import format_count
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.manifest import Counts
from sim2reason.datasets.plan import ALL_NAMES, Names, several
from sim2reason.errors import DatasetError
from sim2reason.figures import canvas
from sim2reason.figures.drawing import drawing
from sim2reason.generation.certified import CertifiedQuestion, worked_solution
from sim2reason.generation.filters import ordered_filters
from sim2reason.generation.item import Item, Record
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.make import build_item
from sim2reason.generation.question_search import RefusedQuestion
from sim2reason.generation.request import Request
from sim2reason.grading.parts import PART_LABELS
from sim2reason.simulation import trace_files

SHOWN_PROBLEMS = 3


def show(  # noqa: PLR0913 - filters, by name
    dataset: Dataset | Path | str,
    *,
    items: int = SHOWN_PROBLEMS,
    id: str | None = None,  # noqa: A002 - the column's name
    recipe: Names = ALL_NAMES,
    difficulty: Names = ALL_NAMES,
    mode: Names = ALL_NAMES,
    kind: Names = ALL_NAMES,
    quantity: Names = ALL_NAMES,
    needs: Names = ALL_NAMES,
    split: Names = ALL_NAMES,
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
    wanted = {
        column: several(column.rpartition(".")[2], names) for column, names in given.items() if names != ALL_NAMES
    }
    for column, names in wanted.items():
        _check(data, column.rpartition(".")[2], names)
    return _some(data, items, wanted, data.splits(split))


def _check(data: Dataset, by: str, names: Sequence[str]) -> None:
    available = data.manifest.counts.get(by, {})
    for name in names:
        if name not in available:
            raise DatasetError(
                f"{data.path}: holds no problem of {by} {name!r}; there is {', '.join(available) or 'none'}"
            )


def _some(data: Dataset, items: int, wanted: Mapping[str, Sequence[str]], split: Sequence[str]) -> Iterator[Item]:
    matches = data.some(items, wanted, split)
    first = next(matches, None)
    if first is not None:
        yield first
        yield from matches
    elif chosen := wanted if split == data.splits() else {**wanted, "split": split}:
        criteria = ", ".join(f"{by.rpartition('.')[2]} {' or '.join(names)}" for by, names in chosen.items())
        raise DatasetError(f"{data.path}: holds no problem of {criteria}; see: sim2reason stats {data.path}")


COUNTED = "recipe", "difficulty", "mode", "kind", "needs", "shape"
COLUMNS = *COUNTED, "asked.quantity", "prompt", "answer.value", "answer.unit"
MEDIAN_DIGITS = 3  # of numbers for the median, as many as a prompt requests


class Spread(Record):
    """The minimum, median and maximum of a number over items; the median is rounded to three digits."""

    items: int
    least: float
    median: float
    greatest: float

    def __str__(self) -> str:
        """Return the three values and the number of items."""
        return f"{self.least:.3g} to {self.greatest:.3g}, median {self.median:.3g} ({format_count(self.items, 'item')})"


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
        return (
            f"<Stats: {format_count(self.items, 'item')}, {format_count(sum(self.refused.values()), 'refused draw')}>"
        )

    def __str__(self) -> str:
        """Return a line with the counts of each column, and with the spread of prompts and answers."""
        counts = (
            f"  {by}: {', '.join(f'{name} {n}' for name, n in entry.items())}" for by, entry in self.counts.items()
        )
        answers = (f"  answers in {unit or 'pure numbers'}: {entry}" for unit, entry in self.answers.items())
        return "\n".join([repr(self)[1:-1], *counts, f"  words of prompts: {self.words}", *answers])


class _Numbers:
    """The smallest and largest of some numbers, and counts of the numbers rounded to three digits."""

    def __init__(self) -> None:
        self.least, self.greatest = float("inf"), float("-inf")
        self.rounded: Counter[float] = Counter()

    def add(self, value: float) -> None:
        self.least, self.greatest = min(self.least, value), max(self.greatest, value)
        self.rounded[float(f"{value:.{MEDIAN_DIGITS - 1}e}")] += 1

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
        counts={name: _sorted(group) for name, group in counts.items()} | {"split": manifest.counts.get("split", {})},
        refused=_sorted(sum((Counter(group) for group in manifest.rejected.values()), Counter[str]())),
        words=words.spread(),
        answers={unit: group.spread() for unit, group in sorted(answers.items(), key=_commonest_first)},
    )


def _sorted(counter: Counter[str]) -> Counts:
    return dict(sorted(counter.items(), key=lambda pair: (-pair[1], pair[0])))


def _commonest_first(pair: tuple[str, _Numbers]) -> tuple[int, str]:
    return -pair[1].rounded.total(), pair[0]


MAX_REFUSALS = 40  # refused questions; a search may refuse hundreds
T = TypeVar("T")


class Explanation(dict[str, tuple[str, ...]]):
    """The lines of an explanation by title, in reading order; `str` joins all of them."""

    def __repr__(self) -> str:
        """Return the titles."""
        return f"<Explanation: {', '.join(self)}>"

    def __str__(self) -> str:
        """Return all titles with their lines, as the command of this name prints them."""
        return "\n".join(f"{title}\n{section_text(lines)}\n" for title, lines in self.items())


def section_text(lines: Iterable[str]) -> str:
    """Return the lines of a section as text."""
    return indent("\n".join(lines), "  ")


def explain(
    dataset: Dataset | Path | str | None,
    id: str,  # noqa: A002 - the column's name
    *,
    refused: bool = False,
    figure: Path | str | None = None,
    trace: Path | str | None = None,
) -> Explanation:
    """Explain where a problem comes from, why every filter kept it, and which questions were refused before it.

    The problem is regenerated from its id, so that the explanation does not rely on a file.

    Args:
        dataset: A dataset, or its folder, to compare the problem with. None makes the problem from its id alone.
        id: The id of the problem.
        refused: Whether to show each question that was refused before it, with the numbers that its filter compared.
        figure: File (.svg, .png or .pdf) for a drawing of the scene; by default none is written.
        trace: File (.parquet) for the motion; by default none is written.

    Returns:
        Lines by title: the problem, its scene, certificate, solution, filters, wrong answers, and more. Without a
        dataset, an id for which no question passes has only what was refused.

    Raises:
        DatasetError: There is no finished dataset or no such problem, or this version makes a different problem.
        DrawError: There is no dataset, and the id is malformed.
        UnsupportedError: A file name has another ending.
        OSError: A file cannot be written.

    Examples:
        >>> import sim2reason
        >>> data = sim2reason.generate("problems", items=2, recipe="pulley", difficulty="easy", workers=1)
        >>> explanation = sim2reason.explain(data, "pulley-easy-numeric-0-0")
        >>> list(explanation)[:4]
        ['Problem', 'Scene', 'Certificate', 'Refused before it']
    """
    check(figure, trace)
    item = None
    if dataset is not None:
        item = (dataset if isinstance(dataset, Dataset) else Dataset(dataset)).item(id)
    request = Request.named(id) if item is None else Request.of(item)
    search, record = ItemSearch(request), RefusalRecord()
    search.on_refusal = record.add if refused else None
    certified = search.find()
    made = None if certified is None else build_item(request, certified)
    if item is not None and made != item:
        remedy = "install the versions that it names, or make the dataset anew"
        raise DatasetError(f"{id}: this version of sim2reason makes another problem of these coordinates; {remedy}")
    before = _refusals(search, record if refused else None)
    if certified is None or made is None:
        return Explanation({"Problem": ("none: no question passed every filter",), **before})
    if figure is not None:
        canvas.draw(drawing(certified.description.scene, certified.description), Path(figure))
    if trace is not None:
        trace_files.write_trace(certified.study.trace, trace)
    return Explanation(_sections(made, request, certified, before))


class RefusalRecord:
    """The refused questions of a search as lines of text, of the first 40 questions, and the number of all."""

    def __init__(self) -> None:
        """Start an empty record."""
        self.lines: list[str] = []
        self.number = 0

    def add(self, refused: RefusedQuestion) -> None:
        """Record a question, the reason of its filter, and the numbers that the filter compared."""
        self.number += 1
        if self.number > MAX_REFUSALS:
            return
        verdict, question = refused.verdict, refused.candidate.question
        self.lines += [*question.text.splitlines(), f"  answer: {question.answer:.4g} {question.unit}".rstrip()]
        self.lines.append(f"  refused by {verdict.filter}{f': {verdict.reason}' if verdict.reason else ''}")
        self.lines += [f"    {line}" for line in refused.findings]


def _refusals(search: ItemSearch, record: RefusalRecord | None) -> dict[str, tuple[str, ...]]:
    """Return the counts of refusals by reason, and with a record the refused questions themselves."""
    counts = tuple(f"{n} × {reason}" for reason, n in sorted(search.rejected.items())) or ("nothing",)
    if record is None:
        return {"Refused before it": counts}
    more = (f"and {record.number - MAX_REFUSALS} more questions",) if record.number > MAX_REFUSALS else ()
    return {"Refused before it": counts, "Refused questions": (*record.lines, *more) or ("none",)}


def _sections(
    item: Item, request: Request, certified: CertifiedQuestion, before: dict[str, tuple[str, ...]]
) -> dict[str, tuple[str, ...]]:
    """Return the lines of an explanation by title."""
    return {
        "Problem": (*item.prompt.splitlines(), "", f"Answer: {item.answer.shown}"),
        "Scene": tuple(item.scene.splitlines()),
        "Certificate": tuple(_certificates(item)),
        **before,
        "Solution": (*_measured(item), "", *_solution(request, certified).splitlines()),
        "Filters": tuple(_filters(certified)),
        "Wrong answers": tuple(_wrong_answers(item)) or ("none",),
        "Without bearing": (*item.idle, *(f"the number {path}" for path in item.idle_numbers)) or ("nothing",),
    }


def check(figure: Path | str | None, trace: Path | str | None) -> None:
    """Raise UnsupportedError for the suffix of a file that `explain` could not write."""
    if figure is not None:
        canvas.check(Path(figure))
    if trace is not None:
        trace_files.check(Path(trace))


def _measured(item: Item) -> Iterator[str]:
    """Yield the difficulty of the shortest solution, line by line."""
    yield f"needs: {item.needs}"
    if item.measured is not None:
        yield from (f"{name}: {number}" for name, number in item.measured)


def _solution(request: Request, certified: CertifiedQuestion) -> str:
    """Return the worked solution, or the reason why there is none."""
    solution = worked_solution(request, certified)
    return f"by {solution.strategy}\n\n{solution.text}" if solution.answer is not None else f"none: {solution.reason}"


def _certificates(item: Item) -> Iterator[str]:
    """Yield report lines: the agreement of the engines, for each part of the problem if there are several."""
    for label, certificate in _labelled([part.certificate for part in item.parts], item.certificate):
        yield from (f"{label}{key}: {value}" for key, value in certificate.items())


def _wrong_answers(item: Item) -> Iterator[str]:
    for label, wrong in _labelled([part.distractors for part in item.parts], item.distractors):
        yield from (f"{label}{each.value:.4g}: {each.reason}" for each in wrong)


def _labelled(parts: Sequence[T], complete: T) -> Iterator[tuple[str, T]]:
    """Yield each part's value with its label, such as (a); without parts, the value of the whole problem."""
    labels = [f"({label}) " for label in PART_LABELS]
    yield from zip(labels, parts, strict=False) if parts else [("", complete)]


def _filters(certified: CertifiedQuestion) -> Iterator[str]:
    """Yield report lines: each filter's verdict and findings, for each part of the problem if there are several."""
    for label, question in _labelled([part.certified for part in certified.parts], certified):
        yield from (f"{label}{line}" for line in _verdicts(question))


def _verdicts(certified: CertifiedQuestion) -> Iterator[str]:
    candidate = replace(certified.candidate, certificate=certified.certificate)
    for name, each in ordered_filters():
        yield f"{name}: {each.reason(candidate) or 'keeps it'}"
        yield from (f"  {line}" for line in each.findings(candidate))
