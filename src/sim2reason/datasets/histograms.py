"""What of a dataset is shown as histograms: counted shard by shard, drawn at the end."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from math import floor, log10

from sim2reason.figures.histogram import Histogram
from sim2reason.generation.item import Item
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.questions.need import NEEDS

WORDS, MOST_WORDS = 10, 500  # in a bin, and from which on all are in the last one
Counted = dict[str, dict[str, int]]
"""By series, then by bin."""


@dataclass(frozen=True)
class Shown:
    """One histogram of all items: its bins, and the series in which its bars are stacked."""

    title: str
    axis: str
    bin: Callable[[Item], str | int]
    """A name, or a whole number whose neighbours are shown even if they are empty."""
    series: Callable[[Item], str]
    label: Callable[[int], str] = str
    step: int = 1


def _decade(item: Item) -> int:
    return floor(log10(abs(item.answer.value))) if item.answer.value else 0


SHOWN: dict[str, Shown] = {
    "answers": Shown(
        title="Sizes of answers, by mode",
        axis="size of the answer in its unit, rounded down to a power of ten",
        bin=_decade,
        series=lambda item: item.mode,
        label=lambda decade: f"$10^{{{decade}}}$",
    ),
    "lengths": Shown(
        title="Lengths of prompts, by difficulty",
        axis=f"words of the prompt, rounded down to {WORDS}",
        bin=lambda item: min(len(item.prompt.split()), MOST_WORDS) // WORDS * WORDS,
        series=lambda item: item.difficulty,
        step=WORDS,
    ),
    "kinds": Shown(
        title="Kinds of question, by mode", axis="kind", bin=lambda item: item.kind, series=lambda item: item.mode
    ),
    "needs": Shown(
        title="What solutions need, by difficulty",
        axis="the most advanced mathematics of the shortest solution",
        bin=lambda item: item.needs,
        series=lambda item: item.difficulty,
    ),
    "recipes": Shown(
        title="Recipes, by difficulty",
        axis="recipe",
        bin=lambda item: item.recipe,
        series=lambda item: item.difficulty,
    ),
}
"""By the name of the picture."""


def counted(items: Iterable[Item]) -> dict[str, Counted]:
    """Return all histograms of some items."""
    found: dict[str, Counted] = {name: {} for name in SHOWN}
    for item in items:
        for name, shown in SHOWN.items():
            series, place = found[name].setdefault(shown.series(item), {}), str(shown.bin(item))
            series[place] = series.get(place, 0) + 1
    return found


def histogram(name: str, counts: Mapping[str, Mapping[str, int]]) -> Histogram:
    """Return what is drawn of the counts of one histogram."""
    shown, found = SHOWN[name], {place for series in counts.values() for place in series}
    numeric = all(place.lstrip("-").isdecimal() for place in found)
    if numeric and found:
        numbers = [int(place) for place in found]
        bins = list(range(min(numbers), max(numbers) + 1, shown.step))
        places, labels = [str(number) for number in bins], [shown.label(number) for number in bins]
    else:
        places = labels = sorted(found, key=lambda place: (NEEDS.get(place, 0), place))
    series = {name: [counts[name].get(place, 0) for place in places] for name in _ordered(counts)}
    return Histogram(shown.axis, labels, series, lying=not numeric)


def _ordered(names: Iterable[str]) -> list[str]:
    known = {name: place for place, name in enumerate(DIFFICULTIES)}
    return sorted(names, key=lambda name: (known.get(name, len(known)), name))
