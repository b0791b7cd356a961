"""The manifest: the contents of a dataset, its cells, rejections, unfilled positions, and all checksums."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from hashlib import sha256
from itertools import islice
from math import ceil, log
from pathlib import Path
from typing import Literal, get_args

from pydantic import Field, ValidationError

from sim2reason.base.atomic_files import canonical
from sim2reason.datasets.card_content import HistogramCounts
from sim2reason.datasets.plan import Config
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Record
from sim2reason.generation.request import Request

MIN_KEPT_SHARE = 0.25
"""The share of the questions asked for in a cell that a sound library keeps as such, at least."""
FALSE_ALARM_PROBABILITY = 1e-3
"""The probability that a dataset from a sound library has an empty cell that counts as an error, at most."""


class Cell(Record):
    """The counts for one mode, kind and recipe.

    `asked` counts the requests that the weights assigned to this kind, among kinds that the scenes offer and that are
    not rejected as textbook problems (`few laws`); `kept` counts the items, including those that replaced a kind whose
    questions were all rejected. An item with several parts counts for each of its kinds.
    """

    mode: str
    kind: str
    recipe: str
    asked: int
    kept: int


Key = tuple[str, str, str]
"""Mode, kind and recipe."""


def table(requests: Iterable[tuple[Key, int]], kept: Iterable[Key]) -> tuple[Cell, ...]:
    """Return all cells with requests or items, in alphabetical order."""
    return _summed([*((key, number, 0) for key, number in requests), *((key, 0, 1) for key in kept)])


def merge_cells(tables: Iterable[Iterable[Cell]]) -> tuple[Cell, ...]:
    """Return the cells of several tables in one table, with the counts of equal cells added."""
    cells = (cell for table in tables for cell in table)
    return _summed(((cell.mode, cell.kind, cell.recipe), cell.asked, cell.kept) for cell in cells)


def _summed(entries: Iterable[tuple[Key, int, int]]) -> tuple[Cell, ...]:
    counts: dict[Key, tuple[int, int]] = {}
    for key, requested, kept in entries:
        before = counts.get(key, (0, 0))
        counts[key] = before[0] + requested, before[1] + kept
    return tuple(
        Cell(mode=mode, kind=kind, recipe=recipe, asked=requested, kept=kept)
        for (mode, kind, recipe), (requested, kept) in sorted(counts.items())
    )


def failure_limit(cells: int) -> int:
    """Return how many failed requests of a cell are too many for an accident, given the number of cells.

    If each request is kept with probability at least p, all n fail with probability at most (1 − p)^n, the binomial
    distribution's P(0). The sum over all cells is limited to `FALSE_ALARM_PROBABILITY`, by Bonferroni's inequality.
    """
    return ceil(log(FALSE_ALARM_PROBABILITY / max(cells, 1)) / log(1.0 - MIN_KEPT_SHARE))


def empty(cells: Iterable[Cell]) -> Iterator[str]:
    """Yield a line for each mode, kind and recipe without an item, after too many requests for an accident."""
    all_cells = tuple(cells)
    for cell in all_cells:
        if cell.kept == 0 and cell.asked >= failure_limit(len(all_cells)):
            name = f"{cell.recipe}.{cell.mode}.{cell.kind}"
            yield (
                f"{name}: asked for {cell.asked} times, and none was kept; see which filters refuse them, "
                f"or order no more of them with the weight {name}=0"
            )


MANIFEST, SHARDS = "manifest.json", "shards.jsonl"
MAX_LISTED_POSITIONS = 20  # positions listed in the manifest itself; the shards' records list all
Counts = dict[str, int]
Refusal = Literal["quarantined", "unfilled", "contaminated", "duplicates", "variants"]
REFUSALS: tuple[Refusal, ...] = get_args(Refusal)
COUNTED: dict[Refusal, str] = {
    "contaminated": "contaminated",
    "duplicates": "distinct: same",
    "variants": "distinct: alike",
}
"""Under which name items that were left out are counted beside the draws that filters refused."""


class RefusedPosition(Record):
    """A position without an item: its request, and the reason."""

    position: int
    recipe: str
    difficulty: str
    mode: str
    seed: int
    index: int
    reason: str

    @classmethod
    def of(cls, position: int, request: Request, reason: str) -> "RefusedPosition":
        """Return the record of a request at `position` that gave no item."""
        return cls(
            position=position,
            recipe=request.recipe,
            difficulty=request.difficulty,
            mode=request.mode,
            seed=request.seed,
            index=request.index,
            reason=reason,
        )


class ShardFile(Record):
    """One file of items."""

    name: str
    """Within the dataset's folder."""
    split: str
    rows: int
    sha256: str


class Shard(Record):
    """A range of positions: its files, one for each split, and the positions without items.

    The list of all shards is a file beside the manifest, one per line, so that it need not be in memory.
    """

    number: int
    positions: tuple[int, int]
    """The first one, and that behind the last one."""
    files: tuple[ShardFile, ...]
    counts: dict[str, Counts]
    """Items by recipe, difficulty, mode, kind, needs, quantity and split."""
    histograms: dict[str, HistogramCounts] = Field(default_factory=dict[str, HistogramCounts])
    """What the card shows as pictures: by the picture's name, series and bin."""
    rejected: dict[str, Counts]
    """By recipe, then by filter: the draws that were refused while these items were made."""
    cells: tuple[Cell, ...] = ()
    """By mode, kind and recipe: what these items were asked to be, and what was kept."""
    quarantined: tuple[RefusedPosition, ...] = ()
    """Requests that crashed or hung their worker twice, or raised an error that they should not."""
    unfilled: tuple[RefusedPosition, ...] = ()
    """Requests for which no draw passed within the maker's budget."""
    contaminated: tuple[RefusedPosition, ...] = ()
    """Items that were left out because they share a run of words with a benchmark."""
    duplicates: tuple[RefusedPosition, ...] = ()
    """Items that were left out because one at a lower position says or asks the same."""
    variants: tuple[RefusedPosition, ...] = ()
    """Items that were left out because one at a lower position asks the same with nearly the same numbers."""

    @property
    def rows(self) -> int:
        """Return the number of rows of all its files."""
        return sum(file.rows for file in self.files)


class RefusedPositions(Record):
    """The positions that hold no item for one reason, such as duplicates: their number, and the first few."""

    total: int = 0
    first: tuple[RefusedPosition, ...] = ()

    def with_more(self, found: Iterable[RefusedPosition]) -> "RefusedPositions":
        """Return the record with further positions without an item added."""
        more = tuple(found)
        return (
            RefusedPositions(total=self.total + len(more), first=(*self.first, *more)[:MAX_LISTED_POSITIONS])
            if more
            else self
        )


class Manifest(Record):
    """The contents of ``manifest.json``: all metadata of a dataset."""

    config: Config
    config_hash: str
    versions: dict[str, str]
    rows: int
    """As many as were asked for, or fewer where nothing more was left to be had."""
    positions: int
    """How many positions were tried, in order; those that hold no item are made up for by later ones."""
    counts: dict[str, Counts]
    """Items by recipe, difficulty, mode, kind, needs, quantity and split."""
    histograms: dict[str, HistogramCounts] = Field(default_factory=dict[str, HistogramCounts])
    """What the card shows as pictures: by the picture's name, series and bin."""
    cells: tuple[Cell, ...]
    """By mode, kind and recipe: what was asked for, and what was kept."""
    rejected: dict[str, Counts]
    """By recipe, then by filter."""
    refused: dict[Refusal, RefusedPositions]
    shards: int
    files: dict[str, str]
    """The card, its pictures and the list of shards, each with its SHA-256."""
    pictures: str = ""
    """The package that drew those of the card, with its version; empty for none."""
    seal: str = ""
    """The SHA-256 of this manifest with an empty seal."""

    def sealed(self) -> "Manifest":
        """Return the manifest with its seal: the checksum of all its other contents."""
        bare = self.model_copy(update={"seal": ""}).text()
        return self.model_copy(update={"seal": sha256(bare.encode()).hexdigest()})

    @property
    def is_whole(self) -> bool:
        """Return whether the seal, a checksum, matches the contents of the manifest."""
        return self.sealed().seal == self.seal

    def empty_cells(self) -> Iterator[str]:
        """Yield a line for each combination of mode, kind and recipe without an item, though requested often."""
        yield from empty(self.cells)
        unfilled = self.refused["unfilled"].total if "unfilled" in self.refused else 0
        if not self.rows and unfilled:
            yield f"no problem at all: none of {unfilled} could be made; order other recipes, modes, kinds or weights"

    def text(self) -> str:
        """Return the text of ``manifest.json``."""
        return canonical(self.model_dump(mode="json"))


def load(path: Path) -> Manifest:
    """Read ``manifest.json`` in the folder `path`; DatasetError if it is missing or invalid."""
    file = path / MANIFEST
    if not file.is_file():
        raise DatasetError(f"{path}: no {MANIFEST} here; give a folder that sim2reason generate has finished")
    try:
        return Manifest.model_validate_json(file.read_bytes())
    except ValidationError as error:
        raise DatasetError(
            f"{file}: not a manifest of this version ({_first(error)}); make it anew in another folder"
        ) from None


def load_sealed(path: Path) -> Manifest:
    """Read a manifest and verify its checksum (seal); DatasetError if it was changed."""
    manifest = load(path)
    if not manifest.is_whole:
        raise DatasetError(f"{path / MANIFEST}: changed since it was written; see: sim2reason verify {path}")
    return manifest


def shards(path: Path) -> Iterator[Shard]:
    """Yield the shards of a finished dataset in order; DatasetError for an invalid line."""
    return (_shard(path, *numbered) for numbered in enumerate(_lines(path), start=1))


def shard(path: Path, number: int) -> Shard:
    """Return one shard of a finished dataset; DatasetError if its line is invalid or missing."""
    line = next(islice(_lines(path), number, None), b"")
    return _shard(path, number + 1, line)


def _lines(path: Path) -> Iterator[bytes]:
    try:
        with (path / SHARDS).open("rb") as lines:
            yield from lines
    except FileNotFoundError:
        raise DatasetError(f"{path / SHARDS}: missing; run the same sim2reason generate again") from None


def _shard(path: Path, count: int, line: bytes) -> Shard:
    try:
        return Shard.model_validate_json(line)
    except ValidationError as error:
        why = f"line {count} is no shard ({_first(error)}); run the same sim2reason generate again"
        raise DatasetError(f"{path / SHARDS}: {why}") from None


def read_refusals(path: Path, kind: Refusal) -> Iterator[RefusedPosition]:
    """Yield all positions of a finished dataset without items for one cause, in order."""
    return (position for shard in shards(path) for position in getattr(shard, kind))


def merge_counts(parts: Iterable[Mapping[str, Counts]]) -> dict[str, Counts]:
    """Return the sum of nested counts, in alphabetical order."""
    total: dict[str, Counter[str]] = {}
    for part in parts:
        for key, counts in part.items():
            total.setdefault(key, Counter()).update(counts)
    return {key: dict(sorted(total[key].items())) for key in sorted(total)}


def all_histograms(parts: Iterable[Mapping[str, HistogramCounts]]) -> dict[str, HistogramCounts]:
    """Return the sum of histograms."""
    histograms = tuple(parts)
    return {
        name: merge_counts(part.get(name, {}) for part in histograms)
        for name in sorted({n for part in histograms for n in part})
    }


def _first(error: ValidationError) -> str:
    detail = error.errors()[0]
    where = ".".join(map(str, detail["loc"])) or "text"
    return f"{where}: {detail['msg']}"
