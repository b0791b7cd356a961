"""Any file of questions with answers."""

from sim2reason.benchmarks import BENCHMARKS
from sim2reason.benchmarks.parts.questions import QuestionFile

__all__ = ["AnyFile"]


@BENCHMARKS.register("jsonl")
class AnyFile(QuestionFile):
    """Any .json, .jsonl or .parquet file of questions with answers; columns and rule are settings."""
