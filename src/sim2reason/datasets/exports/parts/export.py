"""Exporting a dataset: from its shards to the folder that another library reads, all of it or nothing."""

import shutil
from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal, get_args

from sim2reason.base.atomic_files import locked, put, put_text, sync
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.exports import EXPORTS, Export, Place, Row
from sim2reason.datasets.exports.parts import row_files
from sim2reason.datasets.exports.parts.origin import requirement
from sim2reason.datasets.plan import ALL, Names
from sim2reason.datasets.separate import separated
from sim2reason.errors import DatasetError

EVALUATED = "test", "validation"
"""The splits to evaluate on, the best first; without them, the last one."""
MARK = ".sim2reason-export"
"""The file by which a folder that is being written says that it is ours."""


Parts = Literal["together", "separate"]
"""How problems with several parts are written."""


@dataclass(frozen=True)
class Exported:
    """The result of an export.

    Attributes:
        folder: The folder that was written.
        rows: Number of rows by split; a split without rows has no file.
        left_out: Number of items that the format cannot represent.
    """

    folder: Path
    rows: dict[str, int]
    """By split. One without rows has no file."""
    left_out: int
    """Items that this format can't hold, which the export says in `lacks`."""


def export(
    dataset: Dataset | Path | str,
    out: Path | str,
    *,
    to: str,
    split: Names = ALL,
    parts: Parts = "together",
    advance: Callable[[int], object] = lambda _: None,
) -> Exported:
    """Export a dataset to a folder in the format of another library.

    The same dataset gives the same bytes. If the process is killed, no partial folder remains.

    Args:
        dataset: A dataset, or the folder that `generate` has finished.
        out: The folder to write; it must be new or empty.
        to: Name of the format; ``sim2reason.list("exports")`` returns all of them.
        split: Splits to export: one name, several, or ``all``.
        parts: How to write a problem with several parts: ``together``, as one row with all answers, or ``separate``, as
            a row for each part, which states the answers to the parts before it.
        advance: Callback that takes the number of further items that are finished.

    Returns:
        The folder, the number of rows by split, and the number of items left out.

    Raises:
        UnknownNameError: There is no such format.
        DatasetError: There is no finished dataset, no such split or no item that fits, `parts` is invalid, or `out` has
            contents or is the current folder.

    Examples:
        >>> import sim2reason
        >>> data = sim2reason.generate("problems", items=2, recipe="pulley", difficulty="easy", workers=1)
        >>> sim2reason.export("problems", "problems-hf", to="hf").rows
        {'train': 2}
    """
    if parts not in get_args(Parts):
        raise DatasetError(f"parts: {parts!r} is none of {', '.join(get_args(Parts))}; give one of them")
    format_, source, folder = EXPORTS[to], Dataset(dataset), Path(out)
    with _replacing(folder) as place:
        writing = _Writing(format_, source, place, advance, separate=parts == "separate")
        rows = {name: writing.split(name) for name in source.splits(split)}
        rows = {name: count for name, count in rows.items() if count}
        if not rows:
            lacking = f": {format_.lacks}" if format_.lacks else ""
            raise DatasetError(f"{dataset}: holds no problem for {to}{lacking}; give another dataset or split")
        _copy(format_, place, rows, source)
    return Exported(folder, rows, writing.left_out)


@dataclass
class _Writing:
    """The state of an export: what to write, where, and the number of items left out."""

    export: Export
    dataset: Dataset
    place: Path
    advance: Callable[[int], object]
    separate: bool = False
    left_out: int = field(default=0, init=False)

    def split(self, name: str) -> int:
        """Write the file of a split and give the number of its rows; one without rows gets none."""
        path, count = self.place / self.export.data.format(split=name), 0

        def fill(temporary: Path) -> None:
            nonlocal count
            count = row_files.write(temporary, self._rows(name), self.export.columns)

        path.parent.mkdir(parents=True, exist_ok=True)
        put(path, fill, self.place)
        if not count:
            path.unlink()
        return count

    def _rows(self, split: str) -> Iterator[Row]:
        count = 0
        for item in self.dataset.items(split):
            for each in separated(item) if self.separate else (item,):
                row = self.export.row(each, Place(split, count))
                if row is None:
                    self.left_out += 1
                else:
                    yield row
                    count += 1
            self.advance(1)


def _copy(export: Export, place: Path, rows: dict[str, int], dataset: Dataset) -> None:
    """Put beside the data what else the library needs: Python as it is, other texts with their marks filled in."""
    counts = "\n".join(f"- `{export.data.format(split=name)}`: {count} problems" for name, count in rows.items())
    marks = {
        "{split}": next((name for name in EVALUATED if name in rows), list(rows)[-1]),
        "{training}": "train" if "train" in rows else next(iter(rows)),
        "{splits}": counts,
        "{license}": export.license(dataset.manifest.config.license),
        "{repository}": requirement(),
        "{source}": f"configuration {dataset.manifest.config_hash[:12]}",
    }
    for source in sorted(path for path in export.folder.rglob("*") if path.is_file() and path.suffix != ".pyc"):
        text = source.read_text(encoding="utf-8")
        for mark, value in marks.items() if source.suffix != ".py" else ():
            text = text.replace(mark, value)
        path = place / source.relative_to(export.folder)
        path.parent.mkdir(parents=True, exist_ok=True)
        put_text(path, text, place)


@contextmanager
def _replacing(folder: Path) -> Generator[Path, None, None]:
    """Return a folder beside `folder` that takes its name when the block ends well, and is removed when it doesn't."""
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise DatasetError(f"{folder}: is there already, and nothing is overwritten; give a new folder or remove it")
    if folder.exists() and folder.samefile("."):
        raise DatasetError(f"{folder}: is the folder that you are in, which can't be replaced; give a new one in it")
    folder.parent.mkdir(parents=True, exist_ok=True)
    target = folder.resolve()  # once: a relative name may lead elsewhere when folders have moved
    place = target.with_name(f".{target.name}.export")
    place.mkdir(exist_ok=True)
    with locked(place):
        if place.is_symlink() or (any(place.iterdir()) and not (place / MARK).is_file()):
            raise DatasetError(f"{place}: is there, and no export was begun in it; move it away or give another folder")
        (place / MARK).touch()
        try:
            _clear(place)  # what a kill has left
            yield place
            place.replace(target)
            (target / MARK).unlink()
            sync(target.parent)
        finally:
            shutil.rmtree(place, ignore_errors=True)


def _clear(place: Path) -> None:
    for path in place.iterdir():
        if path.name != MARK:
            shutil.rmtree(path) if path.is_dir() else path.unlink()
