"""Export of a dataset into a folder that another library reads."""

import json
import shutil
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from importlib.metadata import PackageNotFoundError, distribution
from itertools import islice
from pathlib import Path
from typing import Any, Literal, get_args

import pyarrow as pa
import pyarrow.parquet as pq

from sim2reason.base.atomic_files import lock_folder, put_text, sync, write_atomically
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.exports import EXPORTS, Column, Export, Row, RowPosition
from sim2reason.datasets.plan import ALL_NAMES, Names
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Answer, Item, QuestionPart
from sim2reason.grading.parts import PART_LABELS
from sim2reason.questions.prompt_formats import MINUS, PartPrompt, format_numbers
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.solutions.algebra.rounded_numbers import DIGITS


def split_parts(item: Item) -> tuple[Item, ...]:
    """Return each part as an item whose prompt contains the answers to earlier parts; other items unchanged.

    The id of each is that of the item with the label of the part: ``pulley-easy-multipart-0-4-a``.
    """
    if not item.parts:
        return (item,)
    prompt = PartPrompt.read(item.prompt)
    answers = [_told(answer) for answer in item.answer.parts]
    return tuple(_single(item, number, prompt.after(number, answers)) for number in range(len(item.parts)))


def _single(item: Item, number: int, prompt: str) -> Item:
    part: QuestionPart = item.parts[number]
    return item.model_copy(
        update={
            "id": f"{item.id}-{PART_LABELS[number]}",
            "prompt": prompt,
            "answer": item.answer.parts[number],
            "kind": part.kind,
            "asked": part.asked,
            "parts": (),
            "distractors": part.distractors,
            "solution": part.solution,
            "unsolved": part.unsolved,
            "certificate": part.certificate,
        }
    )


def _told(answer: Answer) -> str:
    """Return a number with its unit, to the digits that solutions of later parts use."""
    return join_unit(format_numbers([answer.value], DIGITS)[0].replace("-", MINUS), answer.unit)


NAME = "sim2reason"
UNKNOWN = f"# {NAME}: write here the path of a clone of its repository"


def requirement() -> str:
    """Return the pip requirement line of the library's source; a comment if it is unknown."""
    try:
        origin: dict[str, Any] = json.loads(distribution(NAME).read_text("direct_url.json") or "{}")
    except PackageNotFoundError:
        return UNKNOWN
    url, version = origin.get("url", ""), origin.get("vcs_info")
    if not url:
        return UNKNOWN
    return f"{NAME} @ {version['vcs']}+{url}@{version['commit_id']}" if version else f"{NAME} @ {url}"


# pyarrow ships no types; this module speaks types to the others:
# pyright: reportMissingTypeStubs=false, reportUnknownMemberType=false
# pyright: reportUnknownVariableType=false, reportUnknownArgumentType=false


BATCH_ROWS = 1000  # rows in memory at once
BYTES: dict[str, Any] = {"compression": "zstd", "compression_level": 3, "version": "2.6"}
"""All that decides about the bytes of Parquet; none of it depends on the clock or the machine's cores."""
PLAIN = {str: pa.string(), int: pa.int64(), float: pa.float64()}


def write(path: Path, rows: Iterable[Row], columns: Mapping[str, Column]) -> int:
    """Write rows and return their number: Parquet if `columns` are given, else JSON lines; deterministic."""
    return _parquet(path, rows, columns) if columns else _lines(path, rows)


def _lines(path: Path, rows: Iterable[Row]) -> int:
    count = 0
    with path.open("w", encoding="utf-8", newline="\n") as file:
        for count, row in enumerate(rows, start=1):  # noqa: B007 - the last count is the result
            file.write(json.dumps(row, ensure_ascii=False, allow_nan=False) + "\n")
    return count


def _parquet(path: Path, rows: Iterable[Row], columns: Mapping[str, Column]) -> int:
    schema, left, count = pa.schema({name: _type(column) for name, column in columns.items()}), iter(rows), 0
    # by its own name pyarrow opens only what is UTF-8
    with path.open("wb") as file, pq.ParquetWriter(file, schema, **BYTES) as writer:
        while batch := list(islice(left, BATCH_ROWS)):
            writer.write_table(pa.Table.from_pylist(batch, schema=schema))
            count += len(batch)
    return count


def _type(column: Column) -> Any:  # noqa: ANN401 - pyarrow has no types
    if isinstance(column, list):
        return pa.list_(_type(column[0]))
    if isinstance(column, dict):
        return pa.struct({name: _type(part) for name, part in column.items()})
    return PLAIN[column]


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
    split: Names = ALL_NAMES,
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
    with _replacing(folder) as staging:
        writing = _Writing(format_, source, staging, advance, separate=parts == "separate")
        rows = {name: writing.split(name) for name in source.splits(split)}
        rows = {name: count for name, count in rows.items() if count}
        if not rows:
            lacking = f": {format_.lacks}" if format_.lacks else ""
            raise DatasetError(f"{dataset}: holds no problem for {to}{lacking}; give another dataset or split")
        _copy(format_, staging, rows, source)
    return Exported(folder, rows, writing.left_out)


@dataclass
class _Writing:
    """The state of an export: the data, the folder, and the number of omitted items."""

    export: Export
    dataset: Dataset
    place: Path
    advance: Callable[[int], object]
    separate: bool = False
    left_out: int = field(default=0, init=False)

    def split(self, name: str) -> int:
        """Write the file of a split and return the number of its rows; no file without rows."""
        path, count = self.place / self.export.data.format(split=name), 0

        def fill(temporary: Path) -> None:
            nonlocal count
            count = write(temporary, self._rows(name), self.export.columns)

        path.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(path, fill, self.place)
        if not count:
            path.unlink()
        return count

    def _rows(self, split: str) -> Iterator[Row]:
        count = 0
        for item in self.dataset.items(split):
            for each in split_parts(item) if self.separate else (item,):
                row = self.export.row(each, RowPosition(split, count))
                if row is None:
                    self.left_out += 1
                else:
                    yield row
                    count += 1
            self.advance(1)


def _copy(export: Export, staging: Path, rows: dict[str, int], dataset: Dataset) -> None:
    """Copy the export's files beside the data: Python unchanged, placeholders in other texts filled in."""
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
        path = staging / source.relative_to(export.folder)
        path.parent.mkdir(parents=True, exist_ok=True)
        put_text(path, text, staging)


@contextmanager
def _replacing(folder: Path) -> Generator[Path, None, None]:
    """Return a context with a temporary folder that replaces `folder` on success, and is removed on failure."""
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise DatasetError(f"{folder}: already exists, and nothing is overwritten; give a new folder or remove it")
    if folder.exists() and folder.samefile("."):
        raise DatasetError(f"{folder}: is the folder that you are in, which can't be replaced; give a new one in it")
    folder.parent.mkdir(parents=True, exist_ok=True)
    target = folder.resolve()  # once: a relative name may lead elsewhere when folders have moved
    staging = target.with_name(f".{target.name}.export")
    staging.mkdir(exist_ok=True)
    with lock_folder(staging):
        if staging.is_symlink() or (any(staging.iterdir()) and not (staging / MARK).is_file()):
            raise DatasetError(
                f"{staging}: is there, and no export was begun in it; move it away or give another folder"
            )
        (staging / MARK).touch()
        try:
            _clear(staging)  # what a kill has left
            yield staging
            staging.replace(target)
            (target / MARK).unlink()
            sync(target.parent)
        finally:
            shutil.rmtree(staging, ignore_errors=True)


def _clear(staging: Path) -> None:
    for path in staging.iterdir():
        if path.name != MARK:
            shutil.rmtree(path) if path.is_dir() else path.unlink()
