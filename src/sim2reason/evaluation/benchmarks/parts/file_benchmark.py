"""Benchmarks that are read from a file of rows."""

import re
from abc import abstractmethod
from collections.abc import Iterator
from pathlib import Path
from typing import Self

from pydantic import model_validator

from sim2reason.errors import EvaluationError
from sim2reason.evaluation.benchmarks import Benchmark, BenchmarkItem
from sim2reason.evaluation.benchmarks.parts.files import HubFile, Row, fetched, rows

__all__ = ["FileBenchmark"]

_SHA = re.compile(r"[0-9a-fA-F]{64}")


class FileBenchmark(Benchmark):
    """Problems in a file of rows, local or on the Hugging Face Hub."""

    file: Path | None = None
    """A .json, .jsonl or .parquet file."""
    hub: HubFile | None = None
    """Or a file on the Hugging Face hub."""
    sha256: str | None = None
    """What the file's hash must be."""
    subjects: tuple[str, ...] = ()
    """Only these subjects, as the file spells them; none: all."""
    text_only: bool = True
    """Only problems that need no figure."""
    captions: str | None = None
    """The column with a figure's description; a problem that has one needs its figure no more."""

    @model_validator(mode="after")
    def _one_source(self) -> Self:
        if (self.file is None) == (self.hub is None):
            raise ValueError("give either file or hub")
        if self.sha256 is not None and not _SHA.fullmatch(self.sha256):
            raise ValueError("sha256 has 64 hexadecimal digits")
        return self

    @property
    def path(self) -> Path:
        """Return the path of the file, after downloading it if necessary."""
        if self.hub is not None:
            return fetched(self.hub)
        assert self.file is not None
        return self.file

    def problems(self) -> Iterator[BenchmarkItem]:
        """Yield the problems of all rows that pass the filters."""
        path, subjects = self.path, set[str]()
        for number, row in enumerate(rows(path, self.sha256)):
            subject = self.subject_of(row)
            subjects.add(subject)
            caption = self._caption(row)
            if (self.subjects and subject not in self.subjects) or (
                self.text_only and not caption and self.needs_figure(row)
            ):
                continue
            try:
                found = self.problem(row, number)
            except KeyError as error:
                raise EvaluationError(f"{path}: row {number} has no {error}; is it another benchmark's file?") from None
            except (TypeError, ValueError) as error:
                raise EvaluationError(f"{path}: row {number}: {error}") from None
            if found is not None:
                yield found.model_copy(update={"prompt": f"{caption}{found.prompt}"}) if caption else found
        if unknown := sorted(set(self.subjects) - subjects):
            there = ", ".join(sorted(subjects)[:20])
            raise EvaluationError(f"{path}: has no subject {unknown[0]!r}; there are: {there}")

    def _caption(self, row: Row) -> str:
        said = row.get(self.captions) if self.captions is not None else None
        return f"The figure shows: {said.strip()}\n\n" if isinstance(said, str) and said.strip() else ""

    @property
    def column_of_subject(self) -> str:
        """Return the name of the column with the subject."""
        return "subject"

    def subject_of(self, row: Row) -> str:
        """Return the subject of a row's problem, such as mechanics; empty if the row has none."""
        said = row.get(self.column_of_subject)
        return said if isinstance(said, str) else ""

    def needs_figure(self, row: Row) -> bool:
        """Return whether a problem requires its figure; by default none does."""
        del row
        return False

    @abstractmethod
    def problem(self, row: Row, number: int) -> BenchmarkItem | None:
        """Return the problem in the `number`-th row of the file; None to omit it.

        KeyError, TypeError or ValueError if the row is invalid.
        """
