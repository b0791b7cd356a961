r"""Where the answer stands: the content of the last complete ``\boxed{…}`` after the thinking.

Every step looks at each character at most once and at a bounded window, so that no text takes long.
"""

import re
from collections.abc import Mapping, Sequence
from typing import Final, cast

from sim2reason.grading.score import Outcome, Refused

__all__ = ["boxed", "spoken", "text_of"]

MAX_RESPONSE: Final = 1_000_000
MAX_ANSWER: Final = 1_000
WINDOW: Final = 32_768  # of text after the thinking, in which the box must stand

NESTED: Final = 6  # a list of messages, whose content is a list of parts with a text

_BRACE: Final = re.compile(r"\\boxed[ \t\n]{0,8}\{|\\[\\{}]|[{}]")


def text_of(given: object) -> str:
    """The text of a response: itself, or that of the last of several messages; bytes as UTF-8.

    Raises `Refused`: no answer, where it holds no text.
    """
    response = given
    for _ in range(NESTED):
        if isinstance(response, str):
            return response
        if isinstance(response, bytes | bytearray):
            return bytes(response[: 4 * MAX_RESPONSE + 4]).decode(errors="replace")
        if isinstance(response, Mapping):
            fields = cast("Mapping[object, object]", response)
            response = fields.get("content", fields.get("text"))
        elif isinstance(response, Sequence):
            parts = cast("Sequence[object]", response)
            response = parts[-1] if parts else None
        else:
            break
    raise Refused(Outcome.NO_ANSWER, f"a response is text, not {type(given).__name__}")


def spoken(given: object) -> str:
    """What was said after the thinking; refused if the thinking never ended."""
    response = text_of(given)
    if len(response) > MAX_RESPONSE:
        raise Refused(Outcome.TOO_LONG, f"the response has more than {MAX_RESPONSE} characters")
    end = response.rfind("</think>")
    if response.rfind("<think>") > end:
        raise Refused(Outcome.NO_ANSWER, "the thinking never ends")
    start = end + len("</think>") if end >= 0 else 0
    return response[max(start, len(response) - WINDOW) :]


def boxed(response: object) -> str:
    """The content of the last complete box: where boxes are nested, of the outermost.

    Raises `Refused`: no answer without a complete box, too long beyond 1000 characters.
    """
    text = spoken(response)
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


def _bounded(answer: str) -> str:
    if len(answer) > MAX_ANSWER:
        raise Refused(Outcome.TOO_LONG, f"the answer has more than {MAX_ANSWER} characters")
    if not answer.strip():
        raise Refused(Outcome.NO_ANSWER, "the box is empty")
    return answer
