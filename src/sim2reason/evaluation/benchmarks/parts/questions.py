"""Files of questions with answers whose columns are settings."""

from typing import Annotated, Any, cast

from annotated_types import Ge, Lt
from pydantic import JsonValue, field_validator

from sim2reason.evaluation.benchmarks import BenchmarkItem
from sim2reason.evaluation.benchmarks.parts.file_benchmark import FileBenchmark
from sim2reason.evaluation.benchmarks.parts.files import Row
from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.evaluation.benchmarks.scoring.parts.answers import read, unit_or_none
from sim2reason.evaluation.benchmarks.scoring.single_answers import NUMERIC_TOLERANCE

__all__ = ["ASKED", "QuestionFile"]

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
        question = _at(row, self.question_column)
        if not isinstance(question, str) or not question.strip():
            raise ValueError(f"its {self.question_column} is no text")
        name = _at(row, self.id_column, optional=True)
        return BenchmarkItem(
            id=f"{self.name}-{number}" if name is None else str(name),
            prompt=f"{question.strip()}\n\n{self.instruction}".strip(),
            scoring=self.scoring,
            reference=self.reference(row),
            tags={"subject": (subject,)} if (subject := self.subject_of(row)) else {},
        )

    def reference(self, row: Row) -> dict[str, JsonValue]:
        """Return the correct answer of a row as the scoring rule needs it; ValueError if it is invalid."""
        held: Any = _at(row, self.answer_column)
        several = [str(part) for part in cast("list[object]", held)] if isinstance(held, list) else [str(held)]
        if not all(part.strip() for part in several):
            raise ValueError(f"its {self.answer_column} is empty")
        unit = row.get(self.unit_column)
        answers: list[JsonValue] = list(several)
        told: dict[str, JsonValue] = {"answer": ", ".join(several), "answers": answers, "lenient": self.lenient}
        return told | ({"unit": unit} if isinstance(unit, str) else {}) | self._number(several, unit)

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


def _at(row: Row, path: str, *, optional: bool = False) -> object:
    """Return the value of a column, or of a dotted path inside it; KeyError if there is none."""
    if path in row:
        return row[path]
    held: object = row
    for part in path.split("."):
        several = cast("list[object]", held) if isinstance(held, list) else []
        named = cast("dict[str, object]", held) if isinstance(held, dict) else {}
        if part.isdecimal() and int(part) < len(several):
            held = several[int(part)]
        elif part in named:
            held = named[part]
        elif optional:
            return None
        else:
            raise KeyError(path)
    return held
