"""Explanation of one problem of a dataset: its origin, its certificate, and the verdicts of all filters."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from textwrap import indent
from typing import TypeVar

from sim2reason.datasets.dataset import Dataset
from sim2reason.errors import DatasetError
from sim2reason.figures import canvas
from sim2reason.figures.drawing import drawing
from sim2reason.generation.certified import CertifiedQuestion, worked_solution
from sim2reason.generation.filters import in_order
from sim2reason.generation.item import Item
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.make import item_of
from sim2reason.generation.question_search import RefusedQuestion
from sim2reason.generation.request import Request
from sim2reason.grading.parts import LABELS
from sim2reason.simulation import trace_files

SHOWN = 40  # refused questions; a search may refuse hundreds
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
    found = search.find()
    made = None if found is None else item_of(request, found)
    if item is not None and made != item:
        remedy = "install the versions that it names, or make the dataset anew"
        raise DatasetError(f"{id}: this version of sim2reason makes another problem of these coordinates; {remedy}")
    before = _refusals(search, record if refused else None)
    if found is None or made is None:
        return Explanation({"Problem": ("none: no question passed every filter",), **before})
    if figure is not None:
        canvas.draw(drawing(found.description.scene, found.description), Path(figure))
    if trace is not None:
        trace_files.write_trace(found.study.trace, trace)
    return Explanation(_sections(made, request, found, before))


class RefusalRecord:
    """The refused questions of a search as lines of text, of the first 40 questions, and the number of all."""

    def __init__(self) -> None:
        """Start an empty record."""
        self.lines: list[str] = []
        self.number = 0

    def add(self, refused: RefusedQuestion) -> None:
        """Record a question, the reason of its filter, and the numbers that the filter compared."""
        self.number += 1
        if self.number > SHOWN:
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
    more = (f"and {record.number - SHOWN} more questions",) if record.number > SHOWN else ()
    return {"Refused before it": counts, "Refused questions": (*record.lines, *more) or ("none",)}


def _sections(
    item: Item, request: Request, found: CertifiedQuestion, before: dict[str, tuple[str, ...]]
) -> dict[str, tuple[str, ...]]:
    """Return the lines of an explanation by title."""
    return {
        "Problem": (*item.prompt.splitlines(), "", f"Answer: {item.answer.shown}"),
        "Scene": tuple(item.scene.splitlines()),
        "Certificate": tuple(_certificates(item)),
        **before,
        "Solution": (*_measured(item), "", *_solution(request, found).splitlines()),
        "Filters": tuple(_filters(found)),
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


def _solution(request: Request, found: CertifiedQuestion) -> str:
    """Return the worked solution, or the reason why there is none."""
    solution = worked_solution(request, found)
    return f"by {solution.strategy}\n\n{solution.text}" if solution.answer is not None else f"none: {solution.reason}"


def _certificates(item: Item) -> Iterator[str]:
    """Yield report lines: the agreement of the engines, for each part of the problem if there are several."""
    for label, certificate in _labelled([part.certificate for part in item.parts], item.certificate):
        yield from (f"{label}{key}: {value}" for key, value in certificate.items())


def _wrong_answers(item: Item) -> Iterator[str]:
    for label, wrong in _labelled([part.distractors for part in item.parts], item.distractors):
        yield from (f"{label}{each.value:.4g}: {each.reason}" for each in wrong)


def _labelled(parts: Sequence[T], whole: T) -> Iterator[tuple[str, T]]:
    """Yield each part's value with its label, such as (a); without parts, the value of the whole problem."""
    labels = [f"({label}) " for label in LABELS]
    yield from zip(labels, parts, strict=False) if parts else [("", whole)]


def _filters(found: CertifiedQuestion) -> Iterator[str]:
    """Yield report lines: each filter's verdict and findings, for each part of the problem if there are several."""
    for label, held in _labelled([part.certified for part in found.parts], found):
        yield from (f"{label}{line}" for line in _verdicts(held))


def _verdicts(found: CertifiedQuestion) -> Iterator[str]:
    candidate = replace(found.candidate, certificate=found.certificate)
    for name, each in in_order():
        yield f"{name}: {each.reason(candidate) or 'keeps it'}"
        yield from (f"  {line}" for line in each.findings(candidate))
