r"""Where the answer stands: the content of the last complete ``\boxed{…}`` after the thinking.

Every step looks at each character at most once and at a bounded window, so that no text takes long.
"""

import re
from collections.abc import Mapping, Sequence
from typing import Final, cast

from sim2reason.grading.hiding import fault_of_box
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.thinking import OPENING, without_thinking

__all__ = ["MAX_ANSWER", "boxed", "closed_boxes", "opened", "spoken", "text_of"]

MAX_RESPONSE: Final = 1_000_000
MAX_ANSWER: Final = 1_000
WINDOW: Final = 32_768  # of text after the thinking, in which the box must stand

BLANK: Final = " \t\r\n\ufeff"  # what an empty box holds
NESTED: Final = 6  # a list of messages, whose content is a list of parts with a text

_BRACE: Final = re.compile(r"\\boxed[ \t\n]{0,8}\{|\\[\\{}]|[{}]")


def text_of(given: object) -> str:
    """Return the text of a response: itself, or that of the last of several messages; bytes as UTF-8.

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


def opened(given: object) -> object:
    """Prepend the opening mark of thinking to a response whose prompt already contains that mark."""
    try:
        text = text_of(given)
    except Refused:
        return given
    return text if text.lstrip()[: len(OPENING)] == OPENING else OPENING + text


def spoken(given: object) -> str:
    """Return what was said after the thinking; refused if the thinking never ended."""
    response = text_of(given)
    if len(response) > MAX_RESPONSE:
        raise Refused(Outcome.TOO_LONG, f"the response has more than {MAX_RESPONSE} characters")
    return without_thinking(response)[-WINDOW:]


def boxed(response: object) -> str:
    """Return the content of the last complete, non-empty box; of nested boxes, that of the outermost.

    Raises `Refused`: no answer without such a box, too long beyond 1000 characters, unreadable where print hides the
    box or words beside it deny it.
    """
    text = spoken(response)
    boxes = closed_boxes(text)
    found = next((span for span in reversed(boxes) if text[span[0] : span[1]].strip(BLANK)), None)
    if found is None:
        why = "the box is empty" if boxes else r"there is no complete \boxed{…} after the thinking"
        raise Refused(Outcome.NO_ANSWER, why)
    if fault := fault_of_box(text, *found):
        raise Refused(Outcome.UNREADABLE, fault)
    answer = content(text, found)
    if len(answer) > MAX_ANSWER:
        raise Refused(Outcome.TOO_LONG, f"the answer has more than {MAX_ANSWER} characters")
    return answer


def content(text: str, box: tuple[int, int]) -> str:
    """Return the content of a box from its start to its end, without blanks around it."""
    return text[slice(*box)].lstrip(BLANK).rstrip("\ufeff")  # a backslash may need the space behind it


def closed_boxes(text: str) -> list[tuple[int, int]]:
    """Return the start and end of the content of each complete box, in the order of their closing braces."""
    found: list[tuple[int, int]] = []
    open_braces: list[int] = []  # where the content of a box begins, or -1 for any other brace
    start = len(text[: max(text.find(r"\boxed"), 0)].rstrip("\\"))  # an even number of backslashes boxes nothing
    for match in _BRACE.finditer(text, start):
        brace = match[0]
        if brace == "}":
            begin = open_braces.pop() if open_braces else -1
            if begin >= 0:
                found.append((begin, match.start()))
        elif brace == "{" or brace.startswith(r"\boxed"):
            open_braces.append(match.end() if brace != "{" else -1)
    return found
