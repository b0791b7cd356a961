"""Columns shared by several exports: conversations, facts, worked solutions, and ground truths."""

import json
from typing import TypedDict

from sim2reason.generation.item import Answer, Item, Record
from sim2reason.grading.parts import PART_LABELS

FACTS = "mode", "kind", "recipe", "difficulty"


class Message(TypedDict):
    """One message of a conversation."""

    role: str
    content: str


def conversation(prompt: str) -> list[Message]:
    """Return a conversation with the problem as its first message, which includes the answer format."""
    return [{"role": "user", "content": prompt}]


def facts(item: Item) -> dict[str, str]:
    """Return the mode, kind, recipe and difficulty of an item, by which results are grouped."""
    return {name: getattr(item, name) for name in FACTS}


def full_solution(item: Item) -> str | None:
    """Return an item's worked solution, or the labelled solutions of all its parts; None if any is missing."""
    if not item.parts:
        return item.solution.text if item.solution is not None else None
    pairs = zip(PART_LABELS, item.parts, strict=False)
    texts = [f"({label}) {part.solution.text}" for label, part in pairs if part.solution is not None]
    return "\n\n".join(texts) if len(texts) == len(item.parts) else None


EXTRA = "parts", "letter", "options", "texts"  # optional fields of an answer


class Letter(Record):
    """The answer to a multiple-choice item: the correct letter, and all letters."""

    letter: str
    letters: str


def ground_truth(right: Item | Answer | Letter) -> str:
    """Return the answer, with all data for grading, as one line of JSON."""
    answer = right.answer if isinstance(right, Item) else right
    given = answer.model_dump(mode="json", exclude_none=True)
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
        return "; ".join(f"({label}) {_written(part)}" for label, part in zip(PART_LABELS, answer.parts, strict=False))
    return answer.formula.latex if answer.formula is not None else f"{answer.value:.6g}"


def boxed(answer: str) -> str:
    """Return an answer in a box, unless it already contains one."""
    return answer if r"\boxed" in answer else rf"\boxed{{{answer}}}"
