"""JEEBench: problems of the JEE Advanced in physics, chemistry and mathematics."""

from sim2reason.benchmarks import BENCHMARKS, BenchmarkItem
from sim2reason.benchmarks.parts.file_benchmark import FileBenchmark
from sim2reason.benchmarks.parts.files import Row
from sim2reason.benchmarks.scoring.jeebench import INTEGER, NUMERIC, ONE, SEVERAL, TYPES

__all__ = ["JEEBenchFile"]

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
        """With `type` and `gold` as the file has them."""
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
