"""Problems of the International Physics Olympiad, in the format of HiPhO."""

from pydantic import JsonValue

from sim2reason.benchmarks import BENCHMARKS, BenchmarkItem
from sim2reason.benchmarks.parts.file_benchmark import FileBenchmark
from sim2reason.benchmarks.parts.files import Row
from sim2reason.benchmarks.scoring.parts.answers import boxes

__all__ = ["HiPhOFile"]

NUMBER = "Numerical Value"
TEXT = "text-only", "text+illustration figure"


@BENCHMARKS.register("hipho")
class HiPhOFile(FileBenchmark):
    """A file of HiPhO, such as IPhO_2025.json; subjects are its fields, Mechanics among them.

    An illustration is not needed to understand a problem, by HiPhO's own account; other figures are.
    """

    numeric_only: bool = False
    """Only problems all of whose answers are numbers."""

    @property
    def column_of_subject(self) -> str:
        """Where a row has its field of physics."""
        return "field"

    def needs_figure(self, row: Row) -> bool:
        """Where a figure is more than an illustration."""
        return row.get("modality") not in TEXT

    def problem(self, row: Row, number: int) -> BenchmarkItem | None:
        """With all its questions at once; None for what has no question, or no number where only those are wanted."""
        del number  # it has an id
        if "question" not in row:
            return None
        kinds = [str(kind) for kind in row["answer_type"]]
        if self.numeric_only and any(kind != NUMBER for kind in kinds):
            return None
        answers = [(boxes(str(answer)) or [str(answer)])[-1] for answer in row["answer"]]
        together = zip(answers, row["unit"], row["points"], kinds, strict=True)
        parts: list[dict[str, JsonValue]] = [
            {"answer": a.strip(" $"), "unit": u, "points": float(p), "type": k} for a, u, p, k in together
        ]
        if not parts or not sum(float(points) for points in row["points"]) > 0:
            raise ValueError("its questions are worth no points")
        count = "the answer" if len(parts) == 1 else f"the {len(parts)} answers in order, each"
        asked = rf"Reason step by step, and end with {count} in a \boxed{{}} of its own."
        return BenchmarkItem(
            id=str(row["id"]),
            prompt=f"{row.get('context', '')}\n\n{row['question']}\n\n{asked}".strip(),
            scoring="hipho",
            reference={"parts": [*parts], "told": ", ".join(answers)},
            tags={
                "subject": (self.subject_of(row),),
                "type": tuple(sorted(set(kinds))),
                "source": (str(row["source"]),),
            },
        )
