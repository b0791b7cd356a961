"""Worked solutions, written step by step, with each equation checked.

A `ProblemContext` is a scene with the names of its text and a query about it; `solve` finds the cheapest strategy
that leads to the answer. Symbols come from the scene alone, see `writing.lexicon`; the properties that
every solution must have are checked by `testing.solution_verification.faults`.
"""

from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.solution import Relation, Solution, Step
from sim2reason.solutions.solve import solve, solve_prompt, solve_with
from sim2reason.solutions.strategies import STRATEGIES
from sim2reason.solutions.writing.steps import UnsolvedError

__all__ = [
    "STRATEGIES",
    "ProblemContext",
    "Relation",
    "Solution",
    "Step",
    "UnsolvedError",
    "solve",
    "solve_prompt",
    "solve_with",
]
