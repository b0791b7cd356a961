"""The right answer to a problem as the text in a row of an export, by which rewards grade."""

import json

from sim2reason.generation.item import Answer, Item, Record
from sim2reason.grading.parts import LABELS

EXTRA = "parts", "letter", "options", "texts"  # of an answer, which most do not have


class Letter(Record):
    """The answer to a multiple choice: the right letter, and all that there are."""

    letter: str
    letters: str


def ground_truth(right: Item | Answer | Letter) -> str:
    """Return the right answer, with all that a grader must know, as one line of JSON."""
    held = right.answer if isinstance(right, Item) else right
    given = held.model_dump(mode="json", exclude_none=True)
    return json.dumps({name: value for name, value in given.items() if name not in EXTRA or value}, ensure_ascii=False)


def answered(right: Item) -> str:
    """Return the right answer as somebody would write it: the formula, or the number to six digits in the asked unit.

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
    """Return an answer as the grader looks for it: in a box, unless there is one in it already."""
    return answer if r"\boxed" in answer else rf"\boxed{{{answer}}}"
