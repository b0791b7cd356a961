"""Whether a problem shares words with a benchmark on which a model may be tested later.

Compared are runs of `RUN` words. A text is taken apart into words of two letters or more, in small letters, whatever
marks, LaTeX commands and spaces stand between them. Numbers and symbols are left out: a problem of the benchmark with
other numbers would spoil it too, they are spelled in many ways (*$m=60$ g*, *60 g*), and tables of numbers
look alike everywhere. Texts of a benchmark that are shorter than a run are not looked for: what every problem says
could not be told from them.
"""

import re
import unicodedata
from collections.abc import Iterator, Sequence
from functools import lru_cache
from hashlib import blake2b
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sim2reason.datasets.benchmark_files import BenchmarkFile, described, texts
from sim2reason.errors import DatasetError

RUN = 10
"""Words in a row that no problem may have in common with a benchmark.

A quarter of what problems say are numbers and symbols, so ten words are about the usual thirteen with them. Of 2000
problems, runs of seven words in 1300 from olympiads and entrance exams occurred in 112, of eight in 40 (all of them
*uniform thin rod of length and mass kg* and its like), of nine or more in none.
"""
MOST = 20_000_000  # words of all files together: 16 bytes each while they are read

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
    def told(self) -> str:
        """In words."""
        return f"shares {self.words!r} with item {self.item} of {self.file}"


class Benchmarks:
    """Files of benchmarks, with all runs of words in them."""

    def __init__(self, paths: Sequence[Path | str], run: int = RUN) -> None:
        """Read the files; DatasetError names one that can't be read, holds no text, or is too large."""
        self._run = run
        self.files: tuple[BenchmarkFile, ...] = tuple(described(Path(path)) for path in paths)
        """In the order in which they were given."""
        self._items: list[tuple[str, int]] = []  # of each item its file and number
        found = [(np.zeros(0, np.uint64), np.zeros(0, np.int32)), *self._read([Path(path) for path in paths])]
        hashes, places = (np.concatenate(part) for part in zip(*found, strict=True))
        order = np.argsort(hashes, kind="stable")
        self._hashes, self._places = hashes[order], places[order]

    def _read(self, paths: Sequence[Path]) -> Iterator[tuple[Hashes, NDArray[np.int32]]]:
        """Yield the runs of each text, and for each of them its item."""
        total = 0
        for path in paths:
            some = False
            for number, held in enumerate(texts(path), start=1):
                self._items.append((path.name, number))
                for own in map(words, held):
                    some, runs = some or bool(own), _runs(own, self._run)
                    total += len(runs)
                    if total > MOST:
                        raise DatasetError(f"{path}: with it there are more than {MOST} words; give fewer files")
                    yield runs, np.full(len(runs), len(self._items) - 1, dtype=np.int32)
            if not some:
                raise DatasetError(f"{path}: holds no text; give the file that holds the benchmark's questions")

    def overlap(self, text: str) -> Overlap | None:
        """Return the first run of words that a text has in common with a benchmark, and the first item that has it."""
        own = words(text)
        runs = _runs(own, self._run)
        places = np.searchsorted(self._hashes, runs)
        for start, place in enumerate(places.tolist()):
            if place < len(self._hashes) and self._hashes[place] == runs[start]:
                return Overlap(*self._items[self._places[place]], " ".join(own[start : start + self._run]))
        return None


def words(text: str) -> list[str]:
    """Return the words of a text in small letters, without numbers and single letters."""
    plain = _MARKUP.sub(" ", unicodedata.normalize("NFKC", text)).casefold()
    return _WORD.findall(plain)


def _runs(found: Sequence[str], run: int) -> Hashes:
    """Return a hash of each run of words, in order."""
    hashes = np.fromiter(map(_word_hash, found), dtype=np.uint64, count=len(found))
    total = np.zeros(max(0, len(found) - run + 1), dtype=np.uint64)
    for place in range(run if len(total) else 0):
        total = total * np.uint64(_MULTIPLIER) + hashes[place : place + len(total)]
    return total


@lru_cache(maxsize=100_000)
def _word_hash(word: str) -> int:
    return int.from_bytes(blake2b(word.encode(errors="replace"), digest_size=8).digest(), "little")
