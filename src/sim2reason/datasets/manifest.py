"""The manifest: what a dataset holds, what was refused, what could not be made, and every checksum."""

from collections import Counter
from collections.abc import Iterable, Mapping
from hashlib import sha256
from pathlib import Path

from pydantic import ValidationError

from sim2reason.datasets.atomic_files import canonical, put_text
from sim2reason.datasets.cells import Cell
from sim2reason.datasets.item import Record
from sim2reason.datasets.plan import Config, Request
from sim2reason.errors import DatasetError

MANIFEST = "manifest.json"
Counts = dict[str, int]


class RefusedPosition(Record):
    """A position that holds no item: the request that makes it again, and why."""

    position: int
    recipe: str
    difficulty: str
    mode: str
    seed: int
    index: int
    reason: str

    @classmethod
    def of(cls, position: int, request: Request, reason: str) -> "RefusedPosition":
        """Say why `request` at `position` gave no item."""
        return cls(
            position=position,
            recipe=request.recipe,
            difficulty=request.difficulty,
            mode=request.mode,
            seed=request.seed,
            index=request.index,
            reason=reason,
        )


class Shard(Record):
    """One file of items."""

    name: str
    rows: int
    sha256: str
    rejected: dict[str, Counts]
    """By recipe, then by filter: the draws that were refused while these items were made."""
    cells: tuple[Cell, ...] = ()
    """By mode, kind and recipe: what these items were asked to be, and what they are, duplicates included."""
    quarantined: tuple[RefusedPosition, ...] = ()
    """Requests that crashed or hung their worker twice, or raised an error that they should not."""
    unfilled: tuple[RefusedPosition, ...] = ()
    """Requests for which no draw passed within the maker's budget."""
    duplicates: tuple[RefusedPosition, ...] = ()
    """Items that were left out because one at a lower position says or asks the same."""


class Manifest(Record):
    """All about a dataset; ``manifest.json`` is its one canonical spelling."""

    config: Config
    config_hash: str
    versions: dict[str, str]
    rows: int
    counts: dict[str, Counts]
    """Items by recipe, difficulty, mode and kind."""
    cells: tuple[Cell, ...]
    """By mode, kind and recipe: what was asked for, and what was kept."""
    rejected: dict[str, Counts]
    """By recipe, then by filter."""
    shards: tuple[Shard, ...]
    files: dict[str, str]
    """Other files of the dataset and their SHA-256."""
    seal: str = ""
    """The SHA-256 of this manifest with an empty seal."""

    def sealed(self) -> "Manifest":
        """The same with its seal set."""
        bare = self.model_copy(update={"seal": ""}).text()
        return self.model_copy(update={"seal": sha256(bare.encode()).hexdigest()})

    def text(self) -> str:
        """The bytes of ``manifest.json``, as text."""
        return canonical(self.model_dump(mode="json"))

    def problems(self, kind: str) -> list[RefusedPosition]:
        """All that are `quarantined`, `unfilled` or `duplicates`, in the order of positions."""
        return [problem for shard in self.shards for problem in getattr(shard, kind)]


def save(record: Record, path: Path) -> None:
    """Write a record as canonical JSON."""
    put_text(path, canonical(record.model_dump(mode="json")))


def load(path: Path) -> Manifest:
    """Read ``manifest.json`` of the folder `path`; DatasetError if it is not there or makes no sense."""
    file = path / MANIFEST
    if not file.is_file():
        raise DatasetError(f"{path}: no {MANIFEST} here; give a folder that sim2reason generate has finished")
    try:
        return Manifest.model_validate_json(file.read_bytes())
    except ValidationError as error:
        raise DatasetError(
            f"{file}: not a manifest of this version ({_first(error)}); make it anew in another folder"
        ) from None


def merged(parts: Iterable[Mapping[str, Counts]]) -> dict[str, Counts]:
    """Add counts of counts, in alphabetical order."""
    total: dict[str, Counter[str]] = {}
    for part in parts:
        for key, counts in part.items():
            total.setdefault(key, Counter()).update(counts)
    return {key: dict(sorted(total[key].items())) for key in sorted(total)}


def _first(error: ValidationError) -> str:
    detail = error.errors()[0]
    where = ".".join(map(str, detail["loc"])) or "text"
    return f"{where}: {detail['msg']}"
