"""Files of published benchmarks: their items, each as the texts in it, whatever its fields are called.

Read are ``.json``, ``.jsonl``, ``.parquet`` and ``.txt`` (items between blank lines). They come from anywhere, so sizes
are bounded, and what can't be read is told in one line.
"""

# pyarrow ships no types; what it reads leaves this module as text:
# pyright: reportMissingTypeStubs=false, reportUnknownMemberType=false
# pyright: reportUnknownVariableType=false, reportUnknownArgumentType=false

import json
from collections.abc import Callable, Iterable, Iterator
from itertools import groupby
from pathlib import Path
from typing import cast

from sim2reason.base.atomic_files import checksum
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Record

LARGEST_FILE = 2**30  # bytes
LARGEST_PART = 2**25  # bytes of what is read at once: a whole .json, a line of text or .jsonl, a group of Parquet rows
ROWS = 100  # of a Parquet file, read at once
DEEPEST = 100  # levels of lists and objects in one item


class BenchmarkFile(Record):
    """What a dataset says of a file that it shares no text with."""

    name: str
    sha256: str


def described(path: Path) -> BenchmarkFile:
    """The name of a file and what is in it, without its folder; DatasetError if it can't be one of a benchmark."""
    if not path.is_file():
        raise DatasetError(f"{path}: no such file; give the file of a benchmark, a {' or '.join(READERS)}")
    if path.suffix.lower() not in READERS:
        raise DatasetError(f"{path}: not a kind of file that is read; give {' or '.join(READERS)}")
    if path.stat().st_size > LARGEST_FILE:
        raise DatasetError(f"{path}: larger than {LARGEST_FILE} bytes; give it in several files")
    try:
        path.name.encode()
    except UnicodeEncodeError:
        raise DatasetError(f"{path}: a manifest can't say this name, which is not UTF-8; rename the file") from None
    return BenchmarkFile(name=path.name, sha256=checksum(path))


def texts(path: Path) -> Iterator[list[str]]:
    """For each item of a file, all texts in it; DatasetError if it can't be read, or is too large at one place."""
    try:
        for value in READERS[path.suffix.lower()](path):
            yield list(_strings(value))
    except DatasetError as error:
        raise DatasetError(f"{path}: {error}; give the file as the benchmark publishes it") from None
    except (ValueError, RecursionError, MemoryError) as error:  # those of JSON and of UTF-8, too
        why = " ".join(str(error).split())[:200] or type(error).__name__
        raise DatasetError(f"{path}: not readable ({why}); give the file as the benchmark publishes it") from None


def _strings(value: object) -> Iterator[str]:
    """Yield all texts in a value, in order; no recursion, which a hostile file could exhaust."""
    waiting = [(value, 0)]
    while waiting:
        found, depth = waiting.pop()
        if isinstance(found, str):
            yield found
        elif isinstance(found, list | dict):
            if depth == DEEPEST:
                raise DatasetError(f"an item is nested in more than {DEEPEST} levels")
            parts = found.values() if isinstance(found, dict) else cast("list[object]", found)
            waiting += [(part, depth + 1) for part in reversed(list(parts))]


def _json(path: Path) -> Iterable[object]:
    if path.stat().st_size > LARGEST_PART:
        raise DatasetError(f"a .json of more than {LARGEST_PART} bytes; write it as .jsonl, an item in each line")
    return _members(json.loads(path.read_bytes()))


def _members(value: object) -> Iterable[object]:
    """Return the items of what a file holds: those of a list, or of the lists in an object that holds nothing else."""
    if isinstance(value, list):
        return cast("list[object]", value)
    if isinstance(value, dict) and value and all(isinstance(part, list | dict) for part in value.values()):
        return [item for part in value.values() for item in (part if isinstance(part, list) else [part])]
    return [value]


def _lines(path: Path) -> Iterator[str]:
    with path.open("rb") as file:
        while line := file.readline(LARGEST_PART):
            if len(line) == LARGEST_PART:
                raise DatasetError(f"a line of more than {LARGEST_PART} bytes")
            yield line.decode("utf-8-sig")


def _json_lines(path: Path) -> Iterator[object]:
    return (json.loads(line) for line in _lines(path) if line.strip())


def _paragraphs(path: Path) -> Iterator[object]:
    """Return the lines between blank ones; a long paragraph is one item, though it need not be held at once."""
    grouped = groupby(_lines(path), key=lambda line: bool(line.strip()))
    return ("".join(_bounded(lines)) for filled, lines in grouped if filled)


def _bounded(lines: Iterable[str]) -> Iterator[str]:
    size = 0
    for line in lines:
        size += len(line)
        if size > LARGEST_PART:
            raise DatasetError(f"a paragraph of more than {LARGEST_PART} characters")
        yield line


def _parquet(path: Path) -> Iterator[object]:
    """Yield the rows, without columns that hold no text."""
    import pyarrow as pa  # noqa: PLC0415 - heavy, and few files are of this kind
    import pyarrow.parquet as pq  # noqa: PLC0415 - the same

    try:
        file = pq.ParquetFile(path)
        size = sum(file.metadata.row_group(n).total_byte_size for n in range(file.metadata.num_row_groups))
        if size > LARGEST_FILE:
            raise DatasetError(f"more than {LARGEST_FILE} bytes when unpacked")
        columns = [field.name for field in file.schema_arrow if "string" in str(field.type)]
        for batch in file.iter_batches(batch_size=ROWS, columns=columns) if columns else ():
            if batch.nbytes > LARGEST_PART:
                raise DatasetError(f"{ROWS} rows of more than {LARGEST_PART} bytes")
            yield from batch.to_pylist()
    except (pa.ArrowException, OSError) as error:
        raise ValueError(str(error)) from error


READERS: dict[str, Callable[[Path], Iterable[object]]] = {
    ".json": _json,
    ".jsonl": _json_lines,
    ".parquet": _parquet,
    ".txt": _paragraphs,
}
