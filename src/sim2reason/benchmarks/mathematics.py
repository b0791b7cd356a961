"""AIME and MATH: answers are compared as mathematics, by the library math-verify."""

from sim2reason.benchmarks import BENCHMARKS
from sim2reason.benchmarks.parts.questions import QuestionFile

__all__ = ["Mathematics"]


@BENCHMARKS.register("math")
class Mathematics(QuestionFile):
    """AIME, MATH 500 and the like: rows with a problem and its answer, compared by math-verify."""

    question_column: str = "problem"
    scoring: str = "math"
