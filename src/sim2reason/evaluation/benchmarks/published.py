"""Published benchmarks, each read from its own files."""

from pydantic import JsonValue

from sim2reason.evaluation.benchmarks import BENCHMARKS, BenchmarkItem
from sim2reason.evaluation.benchmarks.files import FileBenchmark, QuestionFile, Row
from sim2reason.evaluation.benchmarks.scoring.answers import find_boxes
from sim2reason.evaluation.benchmarks.scoring.exams import INTEGER, NUMERIC, ONE, SEVERAL, TYPES, expected_parts

__all__ = ["ConceptsOfPhysics", "HiPhOFile", "JEEBenchFile", "Mathematics", "OlympiadBenchFile", "UniversityPhysics"]


@BENCHMARKS.register("hcv")
class ConceptsOfPhysics(QuestionFile):
    """Exercises of *Concepts of Physics* with numerical answers: one number within 5 %, in the answer's unit."""


NUMBER = "Numerical Value"
TEXT = "text-only", "text+illustration figure"


@BENCHMARKS.register("hipho")
class HiPhOFile(FileBenchmark):
    """A file of HiPhO, such as IPhO_2025.json; subjects are its fields, such as Mechanics.

    According to HiPhO, illustrations are not needed to understand a problem; other figures are.
    """

    numeric_only: bool = False
    """Only problems all of whose answers are numbers."""

    @property
    def column_of_subject(self) -> str:
        """Return the column with the field of physics."""
        return "field"

    def needs_figure(self, row: Row) -> bool:
        """Return whether a problem has a figure beyond an illustration."""
        return row.get("modality") not in TEXT

    def problem(self, row: Row, number: int) -> BenchmarkItem | None:
        """Return the problem with all its questions; None without a question, or without a required number."""
        del number  # it has an id
        if "question" not in row:
            return None
        kinds = [str(kind) for kind in row["answer_type"]]
        if self.numeric_only and any(kind != NUMBER for kind in kinds):
            return None
        answers = [(find_boxes(str(answer)) or [str(answer)])[-1] for answer in row["answer"]]
        together = zip(answers, row["unit"], row["points"], kinds, strict=True)
        parts: list[dict[str, JsonValue]] = [
            {"answer": a.strip(" $"), "unit": u, "points": float(p), "type": k} for a, u, p, k in together
        ]
        if not parts or not sum(float(points) for points in row["points"]) > 0:
            raise ValueError("its questions are worth no points")
        count = "the answer" if len(parts) == 1 else f"the {len(parts)} answers in order, each"
        instruction = rf"Reason step by step, and end with {count} in a \boxed{{}} of its own."
        return BenchmarkItem(
            id=str(row["id"]),
            prompt=f"{row.get('context', '')}\n\n{row['question']}\n\n{instruction}".strip(),
            scoring="hipho",
            reference={"parts": [*parts], "told": ", ".join(answers)},
            tags={
                "subject": (self.subject_of(row),),
                "type": tuple(sorted(set(kinds))),
                "source": (str(row["source"]),),
            },
        )


ASKED = {
    ONE: r"Exactly one option is correct. Reason step by step, and end with its letter in \boxed{}.",
    SEVERAL: r"One or more options are correct. Reason step by step, and end with the letters of all correct options "
    r"in one \boxed{}, without blanks, such as \boxed{AC}.",
    INTEGER: r"The answer is an integer. Reason step by step, and end with it in \boxed{}.",
    NUMERIC: r"The answer is a number. Reason step by step, and end with it in \boxed{}, to two decimal places.",
}


@BENCHMARKS.register("jeebench")
class JEEBenchFile(FileBenchmark):
    """The file ``dataset.json`` of JEEBench; subjects are phy, chem and math."""

    def problem(self, row: Row, number: int) -> BenchmarkItem:
        """Return the problem with `type` and `gold` as in the file."""
        kind, gold = row["type"], str(row["gold"]).strip()
        if kind not in TYPES:
            raise ValueError(f"no such type: {kind!r}")
        if kind in {ONE, SEVERAL}:
            if not gold or set(gold) - set("ABCD"):
                raise ValueError(f"no options: {gold!r}")
        else:
            float(gold)
        return BenchmarkItem(
            id=f"jeebench-{number}",
            prompt=f"{row['question'].strip()}\n\n{ASKED[kind]}",
            scoring="jeebench",
            reference={"type": kind, "answer": gold},
            tags={"subject": (self.subject_of(row),), "type": (kind,), "paper": (str(row.get("description", "")),)},
        )


@BENCHMARKS.register("math")
class Mathematics(QuestionFile):
    """AIME, MATH 500 and similar: rows with a problem and its answer, compared by math-verify."""

    question_column: str = "problem"
    scoring: str = "math"


FIGURES = "<image", "<img", "![]("
PEOPLE = "Need_human_evaluate"
WORDS = {
    "Numerical": "a number",
    "Expression": "an expression",
    "Equation": "an equation",
    "Interval": "an interval",
    "Tuple": "a tuple",
}


@BENCHMARKS.register("olympiadbench")
class OlympiadBenchFile(FileBenchmark):
    """A file of OlympiadBench; subjects are Mechanics, Electromagnetism, Modern Physics, Thermodynamics, Optics.

    Problems that, according to the file, only people can judge are omitted.
    """

    @property
    def column_of_subject(self) -> str:
        """Return the column with the field of physics."""
        return "subfield"

    def needs_figure(self, row: Row) -> bool:
        """Return whether the text or the context contains a picture."""
        text = f"{row.get('question', '')}{row.get('context') or ''}"
        return any(mark in text for mark in FIGURES) or any(key.startswith("image_") and row[key] for key in row)

    def problem(self, row: Row, number: int) -> BenchmarkItem | None:
        """Return the problem with the first of its final answers, as the published rule does."""
        kind = str(row["answer_type"])
        if kind == PEOPLE:
            return None
        answer, unit = str(row["final_answer"][0]), row.get("unit")
        reference = {"answer": answer, "unit": unit, "error": row.get("error"), "type": kind}
        expected_parts(reference)
        context = f"{row['context'].strip()}\n\n" if row.get("context") else ""
        instruction = _asked(kind, unit, several=bool(row["is_multiple_answer"]))
        return BenchmarkItem(
            id=f"olympiadbench-{row.get('id', number)}",
            prompt=f"{context}{row['question'].strip()}\n\n{instruction}",
            scoring="olympiadbench",
            reference=reference,
            tags={"subject": (self.subject_of(row),), "type": (kind,), "source": (str(row.get("source", "")),)},
        )


def _asked(kind: str, unit: object, *, several: bool) -> str:
    words = [WORDS.get(part.strip(), "an answer") for part in kind.split(",")]
    one = f"The answer is {words[0]}" if not several else f"There are several answers: {', '.join(words)}"
    form = r"in one \boxed{}, separated by commas" if several else r"in \boxed{}"
    where = f", in {unit.strip()}, without the unit" if isinstance(unit, str) and unit.strip(" ,") else ""
    return f"{one}. Reason step by step, and end with {'them' if several else 'it'} {form}{where}."


@BENCHMARKS.register("physics")
class UniversityPhysics(QuestionFile):
    """The test split of PHYSICS, scored by a rule and then, if configured, by a judge."""

    question_column: str = "questions"
    answer_column: str = "final_answers"
    figure_column: str = "graphs"
    scoring: str = "physics"
    instruction: str = r"Reason step by step, and end with each final answer, in order, in a \boxed{}."
