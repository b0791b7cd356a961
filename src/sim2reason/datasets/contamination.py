"""Overlap of problems with the texts of published benchmarks."""

import json
import re
import unicodedata
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import lru_cache
from hashlib import blake2b
from itertools import groupby
from pathlib import Path
from typing import NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from sim2reason.base.atomic_files import checksum
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Record

# pyarrow ships no types; what it reads leaves this module as text:
# pyright: reportMissingTypeStubs=false, reportUnknownMemberType=false
# pyright: reportUnknownVariableType=false, reportUnknownArgumentType=false


MAX_FILE_SIZE = 2**30  # bytes
MAX_PART_SIZE = 2**25  # bytes read at once: a whole .json, a line of text or .jsonl, a group of Parquet rows
ROWS_PER_READ = 100  # of a Parquet file, read at once
MAX_DEPTH = 100  # levels of nested lists and objects in one item


class BenchmarkFile(Record):
    """The name and checksum of a benchmark file with which a dataset shares no text."""

    name: str
    sha256: str


def benchmark_file_record(path: Path) -> BenchmarkFile:
    """Return the record of a benchmark file, without its folder; DatasetError if the file is unsuitable."""
    if not path.is_file():
        raise DatasetError(f"{path}: no such file; give the file of a benchmark, a {' or '.join(READERS)}")
    if path.suffix.lower() not in READERS:
        raise DatasetError(f"{path}: not a kind of file that is read; give {' or '.join(READERS)}")
    if path.stat().st_size > MAX_FILE_SIZE:
        raise DatasetError(f"{path}: larger than {MAX_FILE_SIZE} bytes; give it in several files")
    try:
        path.name.encode()
    except UnicodeEncodeError:
        raise DatasetError(f"{path}: a manifest can't say this name, which is not UTF-8; rename the file") from None
    return BenchmarkFile(name=path.name, sha256=checksum(path))


def texts(path: Path) -> Iterator[list[str]]:
    """Yield the texts of each item of a file; DatasetError if the file is unreadable or an item is too large."""
    try:
        for value in READERS[path.suffix.lower()](path):
            yield list(_strings(value))
    except DatasetError as error:
        raise DatasetError(f"{path}: {error}; give the file as the benchmark publishes it") from None
    except (ValueError, RecursionError, MemoryError) as error:  # those of JSON and of UTF-8, too
        why = " ".join(str(error).split())[:200] or type(error).__name__
        raise DatasetError(f"{path}: not readable ({why}); give the file as the benchmark publishes it") from None


def _strings(value: object) -> Iterator[str]:
    """Yield all texts in a value, in order, without recursion, which a malicious file could exhaust."""
    waiting = [(value, 0)]
    while waiting:
        node, depth = waiting.pop()
        if isinstance(node, str):
            yield node
        elif isinstance(node, list | dict):
            if depth == MAX_DEPTH:
                raise DatasetError(f"an item is nested in more than {MAX_DEPTH} levels")
            parts = node.values() if isinstance(node, dict) else cast("list[object]", node)
            waiting += [(part, depth + 1) for part in reversed(list(parts))]


def _json(path: Path) -> Iterable[object]:
    if path.stat().st_size > MAX_PART_SIZE:
        raise DatasetError(f"a .json of more than {MAX_PART_SIZE} bytes; write it as .jsonl, an item in each line")
    return _members(json.loads(path.read_bytes()))


def _members(value: object) -> Iterable[object]:
    """Return the items in a JSON value: those of a list, or of the lists in an object with only lists."""
    if isinstance(value, list):
        return cast("list[object]", value)
    if isinstance(value, dict) and value and all(isinstance(part, list | dict) for part in value.values()):
        return [item for part in value.values() for item in (part if isinstance(part, list) else [part])]
    return [value]


def _lines(path: Path) -> Iterator[str]:
    with path.open("rb") as file:
        while line := file.readline(MAX_PART_SIZE):
            if len(line) == MAX_PART_SIZE:
                raise DatasetError(f"a line of more than {MAX_PART_SIZE} bytes")
            yield line.decode("utf-8-sig")


def _json_lines(path: Path) -> Iterator[object]:
    return (json.loads(line) for line in _lines(path) if line.strip())


def _paragraphs(path: Path) -> Iterator[object]:
    """Yield the paragraphs of a text file, separated by blank lines; DatasetError if one is too long."""
    grouped = groupby(_lines(path), key=lambda line: bool(line.strip()))
    return ("".join(_bounded(lines)) for filled, lines in grouped if filled)


def _bounded(lines: Iterable[str]) -> Iterator[str]:
    size = 0
    for line in lines:
        size += len(line)
        if size > MAX_PART_SIZE:
            raise DatasetError(f"a paragraph of more than {MAX_PART_SIZE} characters")
        yield line


def _parquet(path: Path) -> Iterator[object]:
    """Yield the rows without columns that contain no text."""
    import pyarrow as pa  # noqa: PLC0415 - heavy, and few files are of this kind
    import pyarrow.parquet as pq  # noqa: PLC0415 - the same

    try:
        file = pq.ParquetFile(path)
        size = sum(file.metadata.row_group(n).total_byte_size for n in range(file.metadata.num_row_groups))
        if size > MAX_FILE_SIZE:
            raise DatasetError(f"more than {MAX_FILE_SIZE} bytes when unpacked")
        columns = [field.name for field in file.schema_arrow if "string" in str(field.type)]
        for batch in file.iter_batches(batch_size=ROWS_PER_READ, columns=columns) if columns else ():
            if batch.nbytes > MAX_PART_SIZE:
                raise DatasetError(f"{ROWS_PER_READ} rows of more than {MAX_PART_SIZE} bytes")
            yield from batch.to_pylist()
    except (pa.ArrowException, OSError) as error:
        raise ValueError(str(error)) from error


READERS: dict[str, Callable[[Path], Iterable[object]]] = {
    ".json": _json,
    ".jsonl": _json_lines,
    ".parquet": _parquet,
    ".txt": _paragraphs,
}


RUN_LENGTH = 10
"""Words in a row that no problem may have in common with a benchmark.

A quarter of what problems say are numbers and symbols, so ten words are about the usual thirteen with them. Of 2000
problems, runs of seven words in 1300 from olympiads and entrance exams occurred in 112, of eight in 40 (all of them
*uniform thin rod of length and mass kg* and its like), of nine or more in none.
"""
MAX_WORDS = 20_000_000  # words of all files together, 16 bytes each while they are read

_MARKUP = re.compile(r"\\[a-zA-Z]+|[{}$^_~]")
_WORD = re.compile(r"[^\W\d_]{2,}")
_MULTIPLIER = 0x9E3779B97F4A7C15  # odd, so that no bit of a word is lost
Hashes = NDArray[np.uint64]


class Overlap(NamedTuple):
    """A run of words that a text shares with an item of a benchmark."""

    file: str
    item: int
    """Counted from 1 in its file."""
    words: str

    @property
    def text(self) -> str:
        """Return the overlap as a message."""
        return f"shares {self.words!r} with item {self.item} of {self.file}"


class Benchmarks:
    """The word sequences in files of benchmarks, which no problem of a dataset may contain."""

    def __init__(self, paths: Sequence[Path | str], run: int = RUN_LENGTH) -> None:
        """Read the files; DatasetError for an unreadable, empty or too large file."""
        self._run = run
        self.files: tuple[BenchmarkFile, ...] = tuple(benchmark_file_record(Path(path)) for path in paths)
        """In the order in which they were given."""
        self._items: list[tuple[str, int]] = []  # of each item its file and number
        chunks = [(np.zeros(0, np.uint64), np.zeros(0, np.int32)), *self._read([Path(path) for path in paths])]
        hashes, places = (np.concatenate(part) for part in zip(*chunks, strict=True))
        order = np.argsort(hashes, kind="stable")
        self._hashes, self._places = hashes[order], places[order]

    def _read(self, paths: Sequence[Path]) -> Iterator[tuple[Hashes, NDArray[np.int32]]]:
        """Yield the hashed runs of each text, with the item numbers."""
        total = 0
        for path in paths:
            some = False
            for number, item_texts in enumerate(texts(path), start=1):
                self._items.append((path.name, number))
                for own in map(words, item_texts):
                    some, runs = some or bool(own), _runs(own, self._run)
                    total += len(runs)
                    if total > MAX_WORDS:
                        raise DatasetError(f"{path}: with it there are more than {MAX_WORDS} words; give fewer files")
                    yield runs, np.full(len(runs), len(self._items) - 1, dtype=np.int32)
            if not some:
                raise DatasetError(f"{path}: holds no text; give the file that holds the benchmark's questions")

    def overlap(self, text: str) -> Overlap | None:
        """Return the first word sequence that a text shares with a benchmark, with the benchmark's item; else None."""
        own = words(text)
        runs = _runs(own, self._run)
        places = np.searchsorted(self._hashes, runs)
        for start, index in enumerate(places.tolist()):
            if index < len(self._hashes) and self._hashes[index] == runs[start]:
                return Overlap(*self._items[self._places[index]], " ".join(own[start : start + self._run]))
        return None


def words(text: str) -> list[str]:
    """Return the words of a text in lower case, without numbers and single letters."""
    plain = _MARKUP.sub(" ", unicodedata.normalize("NFKC", text)).casefold()
    return _WORD.findall(plain)


def _runs(tokens: Sequence[str], run: int) -> Hashes:
    """Return a hash of each run of `run` words, in order."""
    hashes = np.fromiter(map(_word_hash, tokens), dtype=np.uint64, count=len(tokens))
    total = np.zeros(max(0, len(tokens) - run + 1), dtype=np.uint64)
    for offset in range(run if len(total) else 0):
        total = total * np.uint64(_MULTIPLIER) + hashes[offset : offset + len(total)]
    return total


@lru_cache(maxsize=100_000)
def _word_hash(word: str) -> int:
    return int.from_bytes(blake2b(word.encode(errors="replace"), digest_size=8).digest(), "little")
