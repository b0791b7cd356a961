"""Multiple choice: one letter in the box, or the value of one option."""

import re
from collections.abc import Sequence
from typing import Final

from sim2reason.grading.extract import boxed
from sim2reason.grading.number import number
from sim2reason.grading.score import Outcome, Refused, Score

__all__ = ["choice"]

_DRESS: Final = re.compile(r"\\(?:text|mathrm|mathbf|textbf|mathsf|textsf|rm|bf)\b|[\s${}().*\[\]]")
"""What may stand around a letter: fonts, brackets, Markdown's stars, a full stop."""
_NAME: Final = r"\s*\(?([A-Za-z])\s*[).:]+[)\s]*"
_RUN: Final = re.compile(rf"\s*(\\(?:text|mathrm|textbf|mathbf)\s*\{{){_NAME}([^{{}}]*)\}}")
"""A letter at the beginning of a text in a font."""
_LED: Final = re.compile(rf"{_NAME}(?=\S)")
"""A letter with a bracket, a full stop or a colon, before more."""
VALUE_RTOL: Final = 0.01  # relative tolerance between a number and the option that it repeats


def choice(
    response: object,
    letter: str,
    letters: str,
    values: Sequence[float] = (),
    unit: str | None = None,
    texts: Sequence[str] = (),
) -> Score:
    """Grade a boxed letter against the correct one, where `letters` are those of all options; case is ignored.

    If the `values` of the options are known, in `unit`, the letter may be followed by the value of its option, and the
    value alone counts as the letter. The exact text of an option counts too if `texts` are known. Anything else beside
    the letter, such as a second letter or the value of another option, makes it unreadable.
    """
    try:
        content = boxed(response)
    except Refused as refused:
        return refused.score
    chosen = _DRESS.sub("", content).upper()
    if (len(chosen) != 1 or chosen not in letters) and values:
        chosen = _with_value(content, letters, values, unit)
    if (len(chosen) != 1 or chosen not in letters) and texts:
        chosen = _with_text(content, letters, texts)
    if len(chosen) != 1 or chosen not in letters:
        return Score.of(Outcome.UNREADABLE, None, f"the box holds no single letter of {', '.join(letters)}")
    outcome = Outcome.CORRECT if chosen == letter else Outcome.WRONG
    return Score.of(outcome, chosen, f"the answer is {chosen}; expected {letter}")


def _with_value(content: str, letters: str, values: Sequence[float], unit: str | None) -> str:
    """Return the letter of the option whose value an answer gives; empty if a different letter precedes it."""
    named, rest = _led(content)
    rest = rf"\boxed{{{rest}}}"
    pairs = zip(letters, values, strict=True)
    matching_letters = [
        name for name, value in pairs if number(rest, value, unit, tolerance=VALUE_RTOL).outcome is Outcome.CORRECT
    ]
    return matching_letters[0] if len(matching_letters) == 1 and named in ("", matching_letters[0]) else ""


def _with_text(content: str, letters: str, texts: Sequence[str]) -> str:
    """Return the letter of the option whose text an answer repeats; empty if none, or after a different letter."""
    named, rest = _led(content)
    plain_rest, plain = _normalize(rest), _normalize(content)
    pairs = zip(letters, texts, strict=True)
    matching_letters = [name for name, text in pairs if _normalize(text) in (plain_rest, plain)]
    return matching_letters[0] if len(matching_letters) == 1 and named in ("", matching_letters[0]) else ""


def _led(content: str) -> tuple[str, str]:
    """Split an answer into the letter at its beginning, which may be empty, and the rest."""
    content = _RUN.sub(r"\2. \1\3}", content, count=1) if _RUN.match(content) else content
    led = _LED.match(content)
    return (led[1].upper(), content[led.end() :]) if led else ("", content)


def _normalize(text: str) -> str:
    """Normalize a text for comparison: upper case, without LaTeX fonts, spaces and punctuation around words."""
    return re.sub(r"[,;~\\]", "", _DRESS.sub("", text)).upper()
