"""Grading of a response against the answer of an item."""

from sim2reason.generation.item import Answer
from sim2reason.grading import Score, choice, formula, number, parts
from sim2reason.grading.parts import Grader
from sim2reason.questions.prompt_formats import LETTERS


def grade_answer(answer: Answer, response: object, *, lenient: bool = False, partial: bool = False) -> Score:
    """Grade a response against an answer, such as one in a row of an export, without the rest of its item."""
    if answer.parts:
        return parts(response, [_grader(part) for part in answer.parts], partial=partial)
    if answer.letter:
        letters = LETTERS[: len(answer.options)]
        if answer.texts:
            return choice(response, answer.letter, letters, texts=answer.texts)
        return choice(response, answer.letter, letters, answer.options, answer.unit)
    if answer.formula is not None:
        held = answer.formula
        return formula(response, held.latex, held.points, symbols=held.symbols, positive=answer.sign)
    return number(
        response, answer.value, answer.unit, tolerance=answer.tolerance, positive=answer.sign, lenient=lenient
    )


def _grader(answer: Answer) -> Grader:
    return lambda response: grade_answer(answer, response)
