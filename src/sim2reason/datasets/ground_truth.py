"""The ground truth of a problem: its answer as text in a row of an export, from which rewards grade."""

import json

from sim2reason.generation.item import Answer, Item, Record
from sim2reason.grading.parts import LABELS

EXTRA = "parts", "letter", "options", "texts"  # optional fields of an answer


class Letter(Record):
    """The answer to a multiple-choice item: the correct letter, and all letters."""

    letter: str
    letters: str


def ground_truth(right: Item | Answer | Letter) -> str:
    """Return the answer, with all data for grading, as one line of JSON."""
    held = right.answer if isinstance(right, Item) else right
    given = held.model_dump(mode="json", exclude_none=True)
    return json.dumps({name: value for name, value in given.items() if name not in EXTRA or value}, ensure_ascii=False)


def answered(right: Item) -> str:
    """Return the answer as a person would write it: the formula, or the number to six digits in its unit.

    For several parts, all answers with their labels; for multiple choice, the letter.
    """
    return _written(right.answer)


def _written(answer: Answer) -> str:
    if answer.letter:
        return answer.letter
    if answer.parts:
        return "; ".join(f"({label}) {_written(part)}" for label, part in zip(LABELS, answer.parts, strict=False))
    return answer.formula.latex if answer.formula is not None else f"{answer.value:.6g}"


def boxed(answer: str) -> str:
    """Return an answer in a box, unless it already contains one."""
    return answer if r"\boxed" in answer else rf"\boxed{{{answer}}}"
