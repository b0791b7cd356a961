"""Rewards as trainers and benchmarks call them; one grader stands behind all of them.

What is right travels with each row of an export as one JSON text, its *solution*: the answer of an item, or the
letter of a multiple choice. The functions here read it, and are pure: any thread or process may call them.
"""

import json
from collections.abc import Sequence
from functools import lru_cache

from pydantic import TypeAdapter, ValidationError

from sim2reason.datasets.grade import grade_answer
from sim2reason.datasets.item import Answer, Item, Record
from sim2reason.errors import DatasetError
from sim2reason.grading import Score, choice
from sim2reason.grading.parts import LABELS

__all__ = ["Letter", "accuracy", "answered", "boxed", "compute_score", "partial_accuracy", "score", "solution"]

EXTRA = "parts", "letter", "options"  # of an answer, which most do not have
SHOWN = 80  # characters of a text that is no solution


class Letter(Record):
    """The answer to a multiple choice: the right letter, and all that there are."""

    letter: str
    letters: str


_SOLUTION: TypeAdapter[Answer | Letter] = TypeAdapter(Answer | Letter)


def solution(right: Item | Answer | Letter) -> str:
    """What a grader must know, as one line of JSON."""
    held = right.answer if isinstance(right, Item) else right
    given = held.model_dump(mode="json", exclude_none=True)
    return json.dumps({name: value for name, value in given.items() if name not in EXTRA or value}, ensure_ascii=False)


def answered(right: Item) -> str:
    """The right answer as somebody would write it: the formula, or the number to six digits in the asked unit.

    Of a problem with several parts, all answers with their labels; of one with options, the letter.
    """
    return _written(right.answer)


def _written(answer: Answer) -> str:
    if answer.letter:
        return answer.letter
    if answer.parts:
        return "; ".join(f"({label}) {_written(part)}" for label, part in zip(LABELS, answer.parts, strict=False))
    return answer.formula.latex if answer.formula is not None else f"{answer.value:.6g}"


def boxed(answer: str) -> str:
    """An answer as the grader looks for it: in a box, unless there is one in it already."""
    return answer if r"\boxed" in answer else rf"\boxed{{{answer}}}"


def score(solution: str, response: object, *, partial: bool = False) -> Score:
    """The grade of a response, which is a text or messages, by a row's solution.

    With `partial`, a response to a problem of several parts is paid the share of the parts that are right.

    Raises:
        DatasetError: the solution is none of ours.
    """
    right = _read(solution)
    if isinstance(right, Letter):
        return choice(response, right.letter, right.letters)
    return grade_answer(right, response, partial=partial)


def accuracy(
    prompts: Sequence[object],
    completions: Sequence[object],
    *,
    solution: Sequence[str | None],
    **columns: object,
) -> list[float | None]:
    """TRL's signature: a reward of 1 or 0 for each completion, a text or a list of messages.

    A row without a solution, as those of another dataset in a mixture, gets None, which TRL leaves out.

    Raises:
        DatasetError: a solution is none of ours.
    """
    del prompts, columns
    pairs = zip(solution, completions, strict=True)
    return [score(right, said).reward if right else None for right, said in pairs]


def partial_accuracy(
    prompts: Sequence[object],
    completions: Sequence[object],
    *,
    solution: Sequence[str | None],
    **columns: object,
) -> list[float | None]:
    """The same, but for a problem of several parts the share of the parts that are right."""
    del prompts, columns
    pairs = zip(solution, completions, strict=True)
    return [score(right, said, partial=True).reward if right else None for right, said in pairs]


def compute_score(
    data_source: str,
    solution_str: str,
    ground_truth: str,
    extra_info: object = None,
    **settings: object,
) -> float:
    """The signature of verl: a reward of 1 or 0 for one response; DatasetError for a ground truth that is none."""
    del data_source, extra_info, settings
    return score(ground_truth, solution_str).reward


@lru_cache(maxsize=1024)
def _read(solution: str) -> Answer | Letter:
    """A solution once for all completions of one prompt."""
    try:
        return _SOLUTION.validate_json(solution)
    except ValidationError:
        why = "is no solution of sim2reason; give the column that sim2reason export has written"
        raise DatasetError(f"{str(solution)[:SHOWN]!r} {why}") from None
