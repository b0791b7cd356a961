"""Multiple choice: one letter in the box."""

import re
from typing import Final

from sim2reason.grading.extract import boxed
from sim2reason.grading.score import Outcome, Refused, Score

__all__ = ["choice"]

_DRESS: Final = re.compile(r"\\(?:text|mathrm|mathbf|textbf|mathsf|textsf|rm|bf)\b|[\s${}().*\[\]]")
"""What may stand around a letter: fonts, brackets, Markdown's stars, a full stop."""


def choice(response: object, letter: str, letters: str) -> Score:
    """Grade a boxed letter against the right one, of all the `letters` that there are; small ones pass for capitals.

    Anything beside the letter, such as a second one or a number, makes it unreadable.
    """
    try:
        said = _DRESS.sub("", boxed(response)).upper()
    except Refused as refused:
        return refused.score
    if len(said) != 1 or said not in letters:
        return Score.of(Outcome.UNREADABLE, None, f"the box holds no single letter of {', '.join(letters)}")
    outcome = Outcome.CORRECT if said == letter else Outcome.WRONG
    return Score.of(outcome, said, f"the answer is {said}; expected {letter}")
