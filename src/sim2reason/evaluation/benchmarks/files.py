"""Benchmark files, local or on the Hugging Face Hub: verified by their hash, read as rows, and asked as questions."""

# pyarrow ships no types:
# pyright: reportMissingTypeStubs=false, reportUnknownMemberType=false, reportUnknownVariableType=false

import json
import re
from abc import abstractmethod
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Annotated, Any, Final, Self, cast

from annotated_types import Ge, Lt
from pydantic import BaseModel, ConfigDict, JsonValue, field_validator, model_validator

from sim2reason.base.atomic_files import checksum
from sim2reason.base.optional import optional
from sim2reason.errors import EvaluationError
from sim2reason.evaluation.benchmarks import Benchmark, BenchmarkItem
from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.evaluation.benchmarks.scoring.answers import read, unit_or_none
from sim2reason.evaluation.benchmarks.scoring.single_answers import NUMERIC_TOLERANCE
from sim2reason.evaluation.policies.network import out_of_reach

__all__ = ["ASKED", "FileBenchmark", "HubFile", "QuestionFile", "Row", "fetched", "rows"]


MAX_FILE_SIZE: Final = 2**30  # bytes
Row = dict[str, Any]


class HubFile(BaseModel):
    """A file of a dataset on the Hugging Face hub."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    repository: str
    path: str
    revision: str = "main"


def fetched(file: HubFile) -> Path:
    """Return the path of a file in the Hub's local cache, after downloading it if necessary.

    Raises:
        MissingExtraError: the library is missing.
        EvaluationError: the hub gives no such file.
    """
    hub = optional("huggingface_hub", "eval")
    try:
        kept = out_of_reach(file.repository, "dataset", file.revision)
        downloaded = hub.hf_hub_download(
            file.repository, file.path, repo_type="dataset", revision=file.revision, local_files_only=kept
        )
    except Exception as error:  # noqa: BLE001 - the library raises what its transport does
        why = type(error).__name__
        raise EvaluationError(f"hub: no {file.path} of {file.repository} at {file.revision} ({why})") from None
    return Path(downloaded)


def rows(path: Path, sha256: str | None = None) -> list[Row]:
    """Return the rows of a file with the suffix .json, .jsonl or .parquet.

    Raises:
        EvaluationError: it is missing, too large, of another hash, or no list of objects.
    """
    if not path.is_file():
        raise EvaluationError(f"{path}: no such file; say where the benchmark lies")
    if path.stat().st_size > MAX_FILE_SIZE:
        raise EvaluationError(f"{path}: more than {MAX_FILE_SIZE // 2**20} MiB; give the benchmark's file alone")
    digest = checksum(path)
    if sha256 is not None and digest != sha256.lower():
        raise EvaluationError(f"{path}: its SHA-256 is {digest}, not the expected one; is it another version?")
    read = {".json": _json, ".jsonl": _lines, ".parquet": _parquet}.get(path.suffix)
    if read is None:
        raise EvaluationError(f"{path}: no format that is known here; give a .json, .jsonl or .parquet file")
    try:
        parsed = read(path.read_bytes())
    except (ValueError, RecursionError, OSError) as error:
        raise EvaluationError(f"{path}: not readable: {' '.join(str(error).split())[:200]}") from None
    if not isinstance(parsed, list) or not all(isinstance(row, dict) for row in cast("list[object]", parsed)):
        raise EvaluationError(f"{path}: holds no list of objects")
    return cast("list[Row]", parsed)


def _json(content: bytes) -> object:
    return _writable(content, json.loads(content))


def _lines(content: bytes) -> object:
    return _writable(content, [json.loads(line) for line in content.decode().split("\n") if line.strip()])


def _writable(content: bytes, parsed: object) -> object:
    """Return the parsed value; ValueError for unpaired surrogates, which no file can contain."""
    if b"\\ud" in content.lower():
        json.dumps(parsed, ensure_ascii=False).encode()
    return parsed


def _parquet(content: bytes) -> object:
    from pyarrow import parquet  # noqa: PLC0415 - heavy

    # threads let go of what Python holds a moment late, and abort a Python that ends meanwhile
    return cast("Any", parquet).ParquetFile(BytesIO(content), pre_buffer=False).read(use_threads=False).to_pylist()


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
                problem = self.problem(row, number)
            except KeyError as error:
                raise EvaluationError(f"{path}: row {number} has no {error}; is it another benchmark's file?") from None
            except (TypeError, ValueError) as error:
                raise EvaluationError(f"{path}: row {number}: {error}") from None
            if problem is not None:
                yield problem.model_copy(update={"prompt": f"{caption}{problem.prompt}"}) if caption else problem
        if unknown := sorted(set(self.subjects) - subjects):
            there = ", ".join(sorted(subjects)[:20])
            raise EvaluationError(f"{path}: has no subject {unknown[0]!r}; there are: {there}")

    def _caption(self, row: Row) -> str:
        caption = row.get(self.captions) if self.captions is not None else None
        return f"The figure shows: {caption.strip()}\n\n" if isinstance(caption, str) and caption.strip() else ""

    @property
    def column_of_subject(self) -> str:
        """Return the name of the column with the subject."""
        return "subject"

    def subject_of(self, row: Row) -> str:
        """Return the subject of a row's problem, such as mechanics; empty if the row has none."""
        subject = row.get(self.column_of_subject)
        return subject if isinstance(subject, str) else ""

    def needs_figure(self, row: Row) -> bool:
        """Return whether a problem requires its figure; by default none does."""
        del row
        return False

    @abstractmethod
    def problem(self, row: Row, number: int) -> BenchmarkItem | None:
        """Return the problem in the `number`-th row of the file; None to omit it.

        KeyError, TypeError or ValueError if the row is invalid.
        """


ASKED = r"Reason step by step, and end with the answer in \boxed{}."


class QuestionFile(FileBenchmark):
    """A file with a question and its answer in each row; missing columns count as empty.

    A column may be a dotted path into nested values, as in ``prompt.0.content``.
    """

    question_column: str = "question"
    answer_column: str = "answer"
    """A number, a text, or a list of them."""
    unit_column: str = "unit"
    id_column: str = "id"
    """By default rows that have none are counted."""
    subject_column: str = "subject"
    figure_column: str = "image"
    """It has something in it where a problem needs its figure."""
    scoring: str = "numeric"
    """The registered rule."""
    tolerance: Annotated[float, Ge(0.0), Lt(1.0)] = NUMERIC_TOLERANCE
    """Relative, where the rule knows one."""
    instruction: str = ASKED
    """What stands behind each question."""

    @field_validator("scoring")
    @classmethod
    def _known(cls, value: str) -> str:
        if value not in SCORINGS:
            raise ValueError(f"no such rule; there are: {', '.join(SCORINGS)}")
        return value

    @property
    def column_of_subject(self) -> str:
        """Return the name of the column with the subject, as configured."""
        return self.subject_column

    def needs_figure(self, row: Row) -> bool:
        """Return whether the column of figures is not empty."""
        return bool(row.get(self.figure_column))

    def problem(self, row: Row, number: int) -> BenchmarkItem:
        """Return the problem of a row, with the reference that the scoring rule needs."""
        question = _column_value(row, self.question_column)
        if not isinstance(question, str) or not question.strip():
            raise ValueError(f"its {self.question_column} is no text")
        name = _column_value(row, self.id_column, optional=True)
        return BenchmarkItem(
            id=f"{self.name}-{number}" if name is None else str(name),
            prompt=f"{question.strip()}\n\n{self.instruction}".strip(),
            scoring=self.scoring,
            reference=self.reference(row),
            tags={"subject": (subject,)} if (subject := self.subject_of(row)) else {},
        )

    def reference(self, row: Row) -> dict[str, JsonValue]:
        """Return the correct answer of a row as the scoring rule needs it; ValueError if it is invalid."""
        answer: Any = _column_value(row, self.answer_column)
        several = [str(part) for part in cast("list[object]", answer)] if isinstance(answer, list) else [str(answer)]
        if not all(part.strip() for part in several):
            raise ValueError(f"its {self.answer_column} is empty")
        unit = row.get(self.unit_column)
        answers: list[JsonValue] = list(several)
        fields: dict[str, JsonValue] = {"answer": ", ".join(several), "answers": answers, "lenient": self.lenient}
        return fields | ({"unit": unit} if isinstance(unit, str) else {}) | self._number(several, unit)

    def _number(self, several: list[str], unit: object) -> dict[str, JsonValue]:
        """Return the number and unit of the correct answer, for the rule that compares one number."""
        if self.scoring != "numeric":
            return {}
        known = unit_or_none(unit)
        value = read(several[0], known) if len(several) == 1 else None
        if value is None:
            raise ValueError(
                f"its {self.answer_column} {', '.join(several)[:60]!r} is no number; choose another scoring"
            )
        return {"value": value, "unit": known, "tolerance": self.tolerance}


def _column_value(row: Row, path: str, *, optional: bool = False) -> object:
    """Return the value of a column, or of a dotted path inside it; KeyError if there is none."""
    if path in row:
        return row[path]
    node: object = row
    for part in path.split("."):
        several = cast("list[object]", node) if isinstance(node, list) else []
        named = cast("dict[str, object]", node) if isinstance(node, dict) else {}
        if part.isdecimal() and int(part) < len(several):
            node = several[int(part)]
        elif part in named:
            node = named[part]
        elif optional:
            return None
        else:
            raise KeyError(path)
    return node
