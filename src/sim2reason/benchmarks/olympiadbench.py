"""OlympiadBench: open problems of physics olympiads in English, whose answers a rule can score."""

from sim2reason.benchmarks import BENCHMARKS, BenchmarkItem
from sim2reason.benchmarks.parts.file_benchmark import FileBenchmark
from sim2reason.benchmarks.parts.files import Row
from sim2reason.benchmarks.scoring.olympiadbench import expected_parts

__all__ = ["OlympiadBenchFile"]

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

    What the file says only people can judge is left out.
    """

    @property
    def column_of_subject(self) -> str:
        """Where a row has its field of physics."""
        return "subfield"

    def needs_figure(self, row: Row) -> bool:
        """Where the text or the context has a picture."""
        said = f"{row.get('question', '')}{row.get('context') or ''}"
        return any(mark in said for mark in FIGURES) or any(key.startswith("image_") and row[key] for key in row)

    def problem(self, row: Row, number: int) -> BenchmarkItem | None:
        """With the first of its final answers, as the published rule takes it."""
        kind = str(row["answer_type"])
        if kind == PEOPLE:
            return None
        answer, unit = str(row["final_answer"][0]), row.get("unit")
        reference = {"answer": answer, "unit": unit, "error": row.get("error"), "type": kind}
        expected_parts(reference)
        context = f"{row['context'].strip()}\n\n" if row.get("context") else ""
        asked = _asked(kind, unit, several=bool(row["is_multiple_answer"]))
        return BenchmarkItem(
            id=f"olympiadbench-{row.get('id', number)}",
            prompt=f"{context}{row['question'].strip()}\n\n{asked}",
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
