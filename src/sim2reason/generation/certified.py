"""Questions that passed all filters, with their worked solutions."""

from dataclasses import dataclass

from sim2reason.base.records import cached_property
from sim2reason.generation.filters import Candidate
from sim2reason.generation.item import Distractor, SolutionRecord, SolutionStep
from sim2reason.generation.request import Request
from sim2reason.questions import Question, SimulatedScene
from sim2reason.questions.prompt_formats import LETTERS as LETTERS_OF_OPTIONS
from sim2reason.questions.spoken_units import system_named
from sim2reason.simulation.certify import Certificate
from sim2reason.solutions import ProblemContext, Solution, solve
from sim2reason.solutions.difficulty import SolutionDifficulty, measure_difficulty, number_of_events
from sim2reason.solutions.multipart import sequential_solutions
from sim2reason.solutions.solution import choice_solution, combine_parts, convert_answer
from sim2reason.text.prose.description import Description


@dataclass(frozen=True)
class CertifiedQuestion:
    """A question that passed all filters, with its text and the certificate of its answer."""

    candidate: Candidate
    study: SimulatedScene  # its motion is recorded beyond what is asked, and cut where the engines part
    certificate: Certificate
    description: Description
    shape: str  # of the prompt
    parts: "tuple[CertifiedPart, ...]" = ()  # where there are several, of which this is the last
    text: str = ""  # the prompt with all parts
    options: tuple[Distractor | None, ...] = ()  # of a multiple choice; None is the right one

    @property
    def question(self) -> Question:
        """Return the question, which contains its answer."""
        return self.candidate.question

    @property
    def prompt(self) -> str:
        """Return the complete text of the problem, with all its parts."""
        return self.text or self.candidate.prompt

    @cached_property
    def shortest(self) -> Solution:
        """Return the worked solution that determines difficulty and needs; integrated only if no other exists."""
        solution = self.candidate.solution
        return solution if solution is not None and solution.answer is not None else solve(self.setting)

    @cached_property
    def measured(self) -> SolutionDifficulty | None:
        """Return the measured difficulty, from the shortest solutions of all parts; None if a part has no solution."""
        parts = [part.certified for part in self.parts] or [self]
        if any(part.shortest.answer is None for part in parts):
            return None
        studied = [(part.shortest, part.candidate) for part in parts]
        return measure_difficulty(*((solution, number_of_events(of.study.trace, of.time)) for solution, of in studied))

    @property
    def setting(self) -> ProblemContext:
        """Return the scene, motion, names and question that a worked solution starts from."""
        assert self.candidate.words is not None
        return ProblemContext.from_query(self.question, self.study, self.candidate.words, self.description)


@dataclass(frozen=True)
class CertifiedPart:
    """A part of a problem: a certified question with its solution and the earlier parts that it uses."""

    certified: CertifiedQuestion
    solution: Solution
    text: str  # of the question, as the prompt has it
    uses: tuple[int, ...]


def worked_solution(request: Request, certified: CertifiedQuestion) -> Solution:
    """Return the worked solution of a question in the units of its text; without an answer, it states the reason.

    For several parts this is the solution of all parts.
    """
    if certified.parts:
        return combine_parts(part_solutions(request, certified, whole=True))
    solution = _convert_units(request, certified, certified.question, solve(certified.setting))
    if certified.options and solution.answer is not None:
        return choice_solution(solution, LETTERS_OF_OPTIONS[certified.options.index(None)])
    return solution


def part_solutions(request: Request, certified: CertifiedQuestion, *, whole: bool = False) -> list[Solution]:
    """Return the solution of each part of a problem, using the answers to earlier parts."""
    settings = [part.certified.setting for part in certified.parts]
    solutions = sequential_solutions(settings, [part.solution for part in certified.parts], whole=whole)
    questions = (part.certified.question for part in certified.parts)
    return [_convert_units(request, certified, *pair) for pair in zip(questions, solutions, strict=True)]


def _convert_units(
    request: Request, certified: CertifiedQuestion, target_question: Question, solution: Solution
) -> Solution:
    """Return the solution of one question in the units of the complete text."""
    answers = [part.certified.question for part in certified.parts] or [target_question]
    amounts = ((question.answer, question.unit) for question in answers)
    return convert_answer(
        system_named(request.units).suited_to(certified.prompt, *amounts), solution, target_question.unit
    )


def solution_record(solution: Solution) -> tuple[SolutionRecord | None, str]:
    """Return the record of a solution; None, with the reason, if it has no answer."""
    if solution.answer is None:
        return None, solution.reason
    steps = tuple(
        SolutionStep(
            kind=step.kind,
            text=step.text,
            relations=tuple(relation.latex() for relation in step.relations),
            needs=step.needs,
        )
        for step in solution.steps
    )
    record = SolutionRecord(strategy=solution.strategy, derived=solution.derived, text=solution.text, steps=steps)
    return record, ""
