"""The difficulty of a problem, measured from its worked solution.

The score counts the laws that have to be chosen, the phases of the motion and the unknowns that have to be found
together, and adds the level of mathematics that the solution needs. `docs/difficulty.md` explains it.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import inf, isfinite

from sim2reason.questions.difficulty import Difficulty, Need, most_advanced
from sim2reason.simulation.trace import Trace, events_before
from sim2reason.solutions.algebra.expressions import Expression, Sum, Symbol
from sim2reason.solutions.algebra.functions import Power, Root
from sim2reason.solutions.closed_forms.gathering import symbols_in
from sim2reason.solutions.solution import Relation, Solution

SQUARE_EXPONENT = 2
POINTS_PER_PHASE = 2  # points of the score for each phase after the first: its start and its laws have to be found
MAX_COUNTED_PHASES = 4  # largest number of phases that the score counts; later ones mostly repeat earlier ones
_SUBSCRIPT = re.compile(r"_(?:\{(?:[^{}]|\{[^{}]*\})*\}|\\?[A-Za-z0-9])|'+")


@dataclass(frozen=True, slots=True)
class ScoreRange:
    """The range of difficulty scores of one difficulty label, both ends included, with a description."""

    least: float
    most: float
    meaning: str

    @property
    def text(self) -> str:
        """Return the range of scores in words, such as *3 to 14*."""
        if not isfinite(self.least):
            return f"at most {self.most:g}"
        return f"{self.least:g} to {self.most:g}" if isfinite(self.most) else f"at least {self.least:g}"

    def __contains__(self, score: int) -> bool:
        """Return whether a difficulty score lies in the range of the label."""
        return self.least <= score <= self.most


LABELS: Mapping[Difficulty, ScoreRange] = {
    "easy": ScoreRange(-inf, 9, "a few laws that belong to one idea, few unknowns"),
    "medium": ScoreRange(3, 14, "several laws combined, or two phases of a motion"),
    "hard": ScoreRange(5, inf, "many laws, several bodies whose equations are solved together, or several phases"),
}
"""Score ranges of the difficulty labels. Neighbouring ranges overlap: the label is requested, the score is measured."""


@dataclass(frozen=True, slots=True)
class SolutionDifficulty:
    """The measured difficulty of a worked solution.

    Attributes:
        laws: number of different laws of physics; a law that is used for several bodies, or again, counts once.
        phases: number of phases of the motion, each between two events.
        unknowns: largest number of unknowns that coupled equations determine together.
        needs: most advanced mathematics of any step.
    """

    laws: int
    phases: int
    unknowns: int
    needs: Need

    @property
    def score(self) -> int:
        """Return the score: laws + 2 per further phase + unknowns after the first + level of mathematics."""
        further = min(self.phases, MAX_COUNTED_PHASES) - 1
        return self.laws + POINTS_PER_PHASE * further + (self.unknowns - 1) + int(self.needs)


def measure_difficulty(*parts: tuple[Solution, int]) -> SolutionDifficulty:
    """Return the difficulty of a solution, or of the solutions of all parts, which count each law once.

    Each solution is paired with the number of events before the moment of its question.
    """
    solutions = [solution for solution, _ in parts]
    return SolutionDifficulty(
        count_different_laws(*solutions),
        max(max(len(solution.phases), 1 + events) for solution, events in parts),
        max(map(count_coupled_unknowns, solutions)),
        most_advanced(solution.needs for solution in solutions),
    )


def number_of_events(trace: Trace, time: float | None) -> int:
    """Return the number of event times before a time, s; by default before the end of the reliable motion."""
    until = trace.stable_until if time is None else time
    return len({event.time for event in events_before(trace.events, until)})


def count_different_laws(*solutions: Solution) -> int:
    """Return the number of laws in some solutions that differ by more than subscripts."""
    return len({_SUBSCRIPT.sub("", law.latex()) for solution in solutions for law in _laws(solution)})


def count_laws(solution: Solution) -> int:
    """Return the number of laws of physics in a solution.

    Definitions do not count: a multiple or sum of names, as v = -v_x, T = 2π/ω or e = ℓ - ℓ_0, a number, as a = 0 in a
    limiting case, or the magnitude of a vector.
    """
    return sum(1 for _ in _laws(solution))


def _laws(solution: Solution) -> Iterator[Relation]:
    return (relation for relation in solution.relations if relation.role == "law" and not _is_bookkeeping(relation))


def count_coupled_unknowns(solution: Solution) -> int:
    """Return the size of the largest set of unknowns that laws connect with each other; at least 1."""
    groups: list[set[str]] = []
    for names in _unknowns_of_laws(solution):
        touching = [group for group in groups if not group.isdisjoint(names)]
        groups = [group for group in groups if group.isdisjoint(names)]
        groups.append(names.union(*touching))
    return max((len(group) for group in groups), default=1)


def _unknowns_of_laws(solution: Solution) -> Iterator[set[str]]:
    """Yield for each law the set of its names that have no value yet, without a name that the law defines."""
    known: set[str] = set()
    for step in solution.steps:
        for relation in step.relations:
            defined = {relation.left.name} if isinstance(relation.left, Symbol) else set[str]()
            if relation.role in ("given", "result"):
                known |= defined
            elif relation.role == "law":
                new = defined & {*step.gives} - known
                names = {*relation.symbols()} - known - new
                known |= new
                if names:
                    yield names
        known.update(step.gives)


def is_vector(expression: Expression) -> bool:
    """Return whether a formula is the magnitude of a vector: the root of a sum of squares."""
    squares = isinstance(expression, Root) and isinstance(expression.inside, Sum) and expression.inside.terms
    return bool(squares) and all(isinstance(term, Power) and term.exponent == SQUARE_EXPONENT for term in squares)


def _is_bookkeeping(relation: Relation) -> bool:
    if not isinstance(relation.left, Symbol):
        return False
    if isinstance(relation.right, Sum):
        return all(map(_is_multiple, relation.right.terms))
    return is_vector(relation.right) or _is_multiple(relation.right)


def _is_multiple(expression: Expression) -> bool:
    return symbols_in(expression) <= 1
