"""Content of a dataset card: histograms, worked examples and their pictures."""

import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from math import floor, log10
from pathlib import Path
from typing import NamedTuple

from sim2reason.base.atomic_files import checksum, write_atomically
from sim2reason.datasets.plan import MAKER, Config
from sim2reason.errors import FigureWarning, MissingExtraError, Sim2ReasonError
from sim2reason.figures.plot import Histogram, png
from sim2reason.generation.item import Item
from sim2reason.generation.request import Request
from sim2reason.questions.difficulty import DIFFICULTIES, NEEDS
from sim2reason.text.prose.description import Description

WORDS, MOST_WORDS = 10, 500  # per bin, and from which on all are in the last bin
HistogramCounts = dict[str, dict[str, int]]
"""By series, then by bin."""


@dataclass(frozen=True)
class HistogramDefinition:
    """The definition of a histogram: its bins, and the series by which its bars are stacked."""

    title: str
    axis: str
    bin: Callable[[Item], str | int]
    """A name, or a whole number whose neighbours are shown even if they are empty."""
    series: Callable[[Item], str]
    label: Callable[[int], str] = str
    step: int = 1


def _decade(item: Item) -> int:
    return floor(log10(abs(item.answer.value))) if item.answer.value else 0


SHOWN: dict[str, HistogramDefinition] = {
    "answers": HistogramDefinition(
        title="Sizes of answers, by mode",
        axis="size of the answer in its unit, rounded down to a power of ten",
        bin=_decade,
        series=lambda item: item.mode,
        label=lambda decade: f"$10^{{{decade}}}$",
    ),
    "lengths": HistogramDefinition(
        title="Lengths of prompts, by difficulty",
        axis=f"words of the prompt, rounded down to {WORDS}",
        bin=lambda item: min(len(item.prompt.split()), MOST_WORDS) // WORDS * WORDS,
        series=lambda item: item.difficulty,
        step=WORDS,
    ),
    "kinds": HistogramDefinition(
        title="Kinds of question, by mode", axis="kind", bin=lambda item: item.kind, series=lambda item: item.mode
    ),
    "needs": HistogramDefinition(
        title="What solutions need, by difficulty",
        axis="the most advanced mathematics of the shortest solution",
        bin=lambda item: item.needs,
        series=lambda item: item.difficulty,
    ),
    "recipes": HistogramDefinition(
        title="Recipes, by difficulty",
        axis="recipe",
        bin=lambda item: item.recipe,
        series=lambda item: item.difficulty,
    ),
}
"""By the name of the picture."""


def count_histograms(items: Iterable[Item]) -> dict[str, HistogramCounts]:
    """Return the counts of all histograms for some items."""
    histograms: dict[str, HistogramCounts] = {name: {} for name in SHOWN}
    for item in items:
        for name, shown in SHOWN.items():
            series, bin_key = histograms[name].setdefault(shown.series(item), {}), str(shown.bin(item))
            series[bin_key] = series.get(bin_key, 0) + 1
    return histograms


def histogram(name: str, counts: Mapping[str, Mapping[str, int]]) -> Histogram:
    """Return the histogram for drawing from its counts."""
    shown, bin_keys = SHOWN[name], {bin_key for series in counts.values() for bin_key in series}
    numeric = all(bin_key.lstrip("-").isdecimal() for bin_key in bin_keys)
    if numeric and bin_keys:
        numbers = [int(bin_key) for bin_key in bin_keys]
        bins = list(range(min(numbers), max(numbers) + 1, shown.step))
        places, labels = [str(number) for number in bins], [shown.label(number) for number in bins]
    else:
        places = labels = sorted(bin_keys, key=lambda bin_key: (NEEDS.get(bin_key, 0), bin_key))
    series = {name: [counts[name].get(bin_key, 0) for bin_key in places] for name in _ordered(counts)}
    return Histogram(shown.axis, labels, series, lying=not numeric)


def _ordered(names: Iterable[str]) -> list[str]:
    known = {name: rank for rank, name in enumerate(DIFFICULTIES)}
    return sorted(names, key=lambda name: (known.get(name, len(known)), name))


EXAMPLE_COUNT = 6
VARIED = "recipe", "kind", "difficulty", "mode", "shape"
"""In what examples should differ, what counts most first."""


class Example(NamedTuple):
    """A problem shown on a card."""

    item: Item
    solution: str
    """The worked solution, or why there is none."""
    picture: bytes | None
    """A PNG, if the scene can be drawn here."""


def choose_examples(items: Iterable[Item]) -> list[Item]:
    """Return a few items that differ in as many properties as possible; ties go to the first."""
    waiting, chosen = list(items), list[Item]()
    while waiting and len(chosen) < EXAMPLE_COUNT:
        seen = {name: [getattr(item, name) for item in chosen] for name in VARIED}
        best = min(waiting, key=lambda item: [seen[name].count(getattr(item, name)) for name in VARIED])
        waiting.remove(best)
        chosen.append(best)
    return chosen


MIN_PICTURED_ITEMS = 5
"""The least number of problems of a dataset with pictures, which take longer to draw than few problems to make."""


def example(item: Item, config: Config, *, pictured: bool) -> Example:
    """Return an item with its solution and, if `pictured`, a figure that uses the names of the prompt."""
    try:
        solution, picture = _made_again(item, pictured=pictured) if config.maker == MAKER else ("", None)
    except Sim2ReasonError as error:  # a version that fits, but a scene that can't be told or drawn
        solution, picture = f"None: {error}", None
    if item.solution is not None:
        solution = item.solution.text
    return Example(item, solution or item.unsolved or "This dataset has none.", picture)


def _made_again(item: Item, *, pictured: bool) -> tuple[str, bytes | None]:
    """Return the worked solution and figure of an item after regenerating it, since items do not store them."""
    from sim2reason.generation.certified import solution_record, worked_solution  # noqa: PLC0415 - the same
    from sim2reason.generation.item_search import ItemSearch  # noqa: PLC0415 - it loads what else only workers need

    request = Request.of(item)
    certified = ItemSearch(request).find()
    if certified is None or certified.prompt != item.prompt:
        return "", None
    solution, unsolved = (
        solution_record(worked_solution(request, certified)) if item.solution is None else (item.solution, "")
    )
    text = solution.text if solution is not None else f"None: {unsolved}."
    return text, _picture(certified.description) if pictured else None


def _picture(description: Description) -> bytes | None:
    """Return a PNG of a scene; None without a plotting package."""
    from sim2reason.figures import canvas, drawing  # noqa: PLC0415 - the same

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", FigureWarning)
        drawn = drawing.drawing(description.scene, description)
    try:
        return canvas.png(drawn)
    except MissingExtraError:
        return None


FIGURES = "figures"
"""The folder of all pictures."""
PACKAGE = "matplotlib"


def histogram_file(name: str) -> str:
    """Return the file name of a histogram."""
    return f"{FIGURES}/{name}.png"


def example_file(number: int) -> str:
    """Return the file name of an example's figure, numbered from 1."""
    return f"{FIGURES}/example-{number}.png"


def plotting_version() -> str:
    """Return the name and version of the plotting package, which affect pictures; empty if not installed."""
    try:
        return f"{PACKAGE} {version(PACKAGE)}"
    except PackageNotFoundError:
        return ""


def put_pictures(
    out: Path, scratch: Path, histograms: Mapping[str, HistogramCounts], examples: Sequence[Example]
) -> tuple[str, ...]:
    """Write the pictures of a dataset and return their names; none without a plotting package."""
    try:
        pictures = dict(_pictures(histograms, examples))
    except MissingExtraError:
        return ()
    for name, data in pictures.items():
        write_atomically(out / name, lambda path, data=data: path.write_bytes(data), scratch)
    return tuple(pictures)


def _pictures(histograms: Mapping[str, HistogramCounts], examples: Sequence[Example]) -> Iterator[tuple[str, bytes]]:
    for name in SHOWN:
        if histograms.get(name):
            yield histogram_file(name), png(histogram(name, histograms[name]))
    for number, example in enumerate(examples, start=1):
        if example.picture is not None:
            yield example_file(number), example.picture


def remove_pictures(out: Path, files: Mapping[str, str]) -> None:
    """Remove the pictures in a manifest's `files` that are unchanged."""
    ours = [name for name in files if Path(name).parent == Path(FIGURES) and checksum(out / name) == files[name]]
    for name in ours:
        (out / name).unlink()
    if ours and not any((out / FIGURES).iterdir()):
        (out / FIGURES).rmdir()
