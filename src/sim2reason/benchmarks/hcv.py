"""HCV: exercises of H. C. Verma, *Concepts of Physics*, volume 1. The file is the user's own."""

from sim2reason.benchmarks import BENCHMARKS
from sim2reason.benchmarks.parts.questions import QuestionFile

__all__ = ["ConceptsOfPhysics"]


@BENCHMARKS.register("hcv")
class ConceptsOfPhysics(QuestionFile):
    """Exercises of *Concepts of Physics* with numerical answers: one number within 5 %, in the answer's unit."""
