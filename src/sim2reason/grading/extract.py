r"""Where the answer stands: the content of the last complete ``\boxed{…}`` after the thinking.

Every step looks at each character at most once and at a bounded window, so that no text takes long.
"""

import re
from typing import Final

from sim2reason.grading.score import Outcome, Refused

__all__ = ["boxed", "last_number"]

MAX_RESPONSE: Final = 1_000_000
MAX_ANSWER: Final = 1_000
WINDOW: Final = 32_768  # of text after the thinking, in which the box must stand

_BRACE: Final = re.compile(r"\\boxed[ \t\n]?\{|\\[\\{}]|[{}]")
_NUMBER: Final = re.compile(
    r"(?<![\w.^{\\])(?<![\^{][-+−–])[-+−–]?(?:[0-9]{1,3}(?:,[0-9]{3})+|[0-9]+)(?:\.[0-9]+)?(?:[eE][-+]?[0-9]{1,4})?(?![0-9])"
    r"(?:[ ]?(?:\\times|\\cdot|×|·|\*|x)[ ]?10(?:\^\{?[-+−]?[0-9]{1,4}\}?|[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]{1,5}))?"
)


def _spoken(response: str) -> str:
    """What was said after the thinking; refused if the thinking never ended."""
    if len(response) > MAX_RESPONSE:
        raise Refused(Outcome.TOO_LONG, f"the response has more than {MAX_RESPONSE} characters")
    end = response.rfind("</think>")
    if response.rfind("<think>") > end:
        raise Refused(Outcome.NO_ANSWER, "the thinking never ends")
    start = end + len("</think>") if end >= 0 else 0
    return response[max(start, len(response) - WINDOW) :]


def boxed(response: str) -> str:
    """The content of the last complete box: where boxes are nested, of the outermost.

    Raises `Refused`: no answer without a complete box, too long beyond 1000 characters.
    """
    text = _spoken(response)
    open_braces: list[int] = []  # where the content of a box begins, or -1 for any other brace
    found: tuple[int, int] | None = None
    start = len(text[: max(text.find(r"\boxed"), 0)].rstrip("\\"))  # an even number of backslashes boxes nothing
    for match in _BRACE.finditer(text, start):
        brace = match[0]
        if brace == "}":
            begin = open_braces.pop() if open_braces else -1
            found = (begin, match.start()) if begin >= 0 else found
        elif brace == "{" or brace.startswith(r"\boxed"):
            open_braces.append(match.end() if brace != "{" else -1)
    if found is None:
        raise Refused(Outcome.NO_ANSWER, r"there is no complete \boxed{…} after the thinking")
    return _bounded(text[slice(*found)])


def last_number(response: str) -> tuple[str, str]:
    """The last number of an answer without a box, and the text that follows it in its line.

    For evaluation only: as a reward it could be farmed by ending on a likely number.
    """
    numbers = list(_NUMBER.finditer(_spoken(response)[-MAX_ANSWER:]))
    if not numbers:
        raise Refused(Outcome.NO_ANSWER, "there is neither a box nor a number")
    last = numbers[-1]
    tail = last.string[last.end() :].split("\n", 1)[0]
    return last[0], tail.strip().rstrip(".*$ ")


def _bounded(answer: str) -> str:
    if len(answer) > MAX_ANSWER:
        raise Refused(Outcome.TOO_LONG, f"the answer has more than {MAX_ANSWER} characters")
    if not answer.strip():
        raise Refused(Outcome.NO_ANSWER, "the box is empty")
    return answer
