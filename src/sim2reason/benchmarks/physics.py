"""PHYSICS: problems of university physics with one or several answers, scored by a rule and then by a judge."""

from sim2reason.benchmarks import BENCHMARKS
from sim2reason.benchmarks.parts.questions import QuestionFile

__all__ = ["UniversityPhysics"]


@BENCHMARKS.register("physics")
class UniversityPhysics(QuestionFile):
    """The test split of PHYSICS: a rule first, then, where the configuration names one, a judge."""

    question_column: str = "questions"
    answer_column: str = "final_answers"
    figure_column: str = "graphs"
    scoring: str = "physics"
    instruction: str = r"Reason step by step, and end with each final answer, in order, in a \boxed{}."
