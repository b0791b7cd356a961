"""Extraction of the answer from a response: the last complete box after the thinking that counts.

A box does not count if it is invisible when typeset, by a command that hides or strikes text, white ink, a comment of
LaTeX or HTML, or a hidden element; or if the text denies it, by *not* before it or *is wrong* after it.
"""

import re
from collections.abc import Mapping, Sequence
from typing import Final, cast

from sim2reason.grading.alphabet import HIDING, INK
from sim2reason.grading.score import Outcome, Refused

__all__ = [
    "MAX_ANSWER_LENGTH",
    "OPENING",
    "boxed",
    "closed_boxes",
    "fault_of_box",
    "opened",
    "remove_thinking",
    "response_string",
    "response_text",
]

_STRIKING: Final = "x?cancel|bcancel|sout|st|xout"
_SCAN: Final = re.compile(
    rf"\\[\\{{}}]|(?P<switch>\\(?:transparent|opacity|iffalse)(?![A-Za-z]))"
    rf"|(?P<hide>\\(?:{HIDING}|{_STRIKING})(?![A-Za-z])\s*)"
    r"|(?P<show>\\fi(?![A-Za-z]))|(?P<ink>\\(?:text)?color(?![A-Za-z])\s*(?:\[[^\[\]]{0,20}\])?\s*\{(?P<name>[^{}]{0,40})\}\s*)"
    r"|(?P<brace>[{}])"
)
_INKS: Final = re.compile(rf"\s*(?:{INK})(?:!(?:[4-9][0-9]|100)(?:!black)?)?\s*")
_COMMENT: Final = re.compile(r"(?<![\\0-9])(?<![0-9][ ~])(?<!\\ )%[^\n]*\Z")
_STYLE: Final = (
    r"display\s*:\s*none|visibility\s*:\s*hidden|opacity\s*:\s*0|font-size\s*:\s*0|(?<![-a-z])color\s*[:=]"
    r"|(?<![-a-z:])hidden(?![-a-z])"
)
_ELEMENT: Final = re.compile(
    rf"<(?P<name>s|del|strike|script|style|template|noscript|[a-z][a-z0-9]*(?=[^<>]{{0,400}}(?:{_STYLE})))(?:\s[^<>]{{0,400}})?>",
    re.IGNORECASE,
)
MAX_HARMLESS_LENGTH: Final = 6  # characters after a box that are too few to deny it
_SEARCH_WINDOW: Final = 4000  # characters before a box that are searched for the start of a hiding command
_DENYING: Final = re.compile(r"no|nev|nei|n['’]t|wit|exc|unl|rath|inst|wron|inco|fals")
"""A part of every word that denies, which is found at once."""
_DENIED_BEFORE: Final = re.compile(
    r"(?:\b(?:not|never|nor|neither|cannot|without|except|excluding|unlike|rather than|instead of|wrong|wrongly"
    r"|incorrect|incorrectly|false|falsely)|n['’]t)"
    r"(?:[\s$*]|\\[(\[]|=|\b(?:be|been|equal|equals|to|the|a|an|is|was|simply|just|really|actually|exactly|get|gives?"
    r"|answer|value|result|correct|right|final|by)\b){0,12}\Z",
    re.IGNORECASE,
)
_DENIED_BEHIND: Final = re.compile(
    r"\}[^.!?\n]{0,24}?(?:\b(?:is|was|are|looks|seems|would be|must be|can(?:not)? be|could be)\s+"
    r"(?:clearly\s+|obviously\s+|also\s+|actually\s+)?(?:wrong|incorrect|false|impossible|mistaken|invalid|absurd"
    r"|too\s+(?:large|small|big|high|low)|not\s+(?:the|correct|right|true|possible|valid|my|what|it)\b)"
    r"|\b(?:isn|wasn|can|couldn)['’]?(?:t|not)\s+(?:be\s+)?(?:the|correct|right|true|possible|valid|my|what|it)\b"
    r"|\((?:this is |that is |which is )?(?:wrong|incorrect|false|not\b))",
    re.IGNORECASE,
)


def fault_of_box(text: str, begin: int, end: int) -> str:
    """Return the reason why a box with its content from `begin` to `end` does not count; empty if it counts."""
    start = text.rfind("\\", 0, begin)
    before, behind = text[max(start - _SEARCH_WINDOW, 0) : start], text[end : end + 80]
    near = before[-60:].lower()
    denied = _DENYING.search(near) is not None and _DENIED_BEFORE.search(near) is not None
    if denied or (len(behind) > MAX_HARMLESS_LENGTH and _DENIED_BEHIND.match(behind)):
        return "words beside the box deny it"
    return "print hides the box" if _is_hidden(before, behind) else ""


def _is_hidden(before: str, behind: str) -> bool:
    if "%" in before and _COMMENT.search(before, before.rfind("\n") + 1):
        return True
    if "\\" in before and _is_within(before):
        return True
    if "<" in before and _is_in_element(before):
        return True
    return before.rstrip(" $")[-2:] == "~~" and behind[1:].lstrip(" $").startswith("~~")


def _is_within(before: str) -> bool:
    """Return whether an open LaTeX group, or the last command, hides or strikes out the text that follows."""
    levels = [False]  # for each open group, whether it is hidden
    pending = -1  # where the argument of a command that hides it begins
    for match in _SCAN.finditer(before):
        if match["hide"]:
            pending = match.end()
        elif match["switch"] or match["show"]:
            levels[-1] = bool(match["switch"])
        elif match["ink"] and match["ink"].startswith(r"\text"):
            pending = pending if _INKS.fullmatch(match["name"]) else match.end()
        elif match["ink"]:
            levels[-1] = _INKS.fullmatch(match["name"]) is None
        elif match["brace"] == "{":
            levels.append(levels[-1] or pending == match.start())
        elif match["brace"] and len(levels) > 1:
            levels.pop()
    return levels[-1] or pending == len(before)


def _is_in_element(before: str) -> bool:
    comment = before.rfind("<!--")
    if comment >= 0 and "-->" not in before[comment:]:
        return True
    lowered = before.lower()
    return any(lowered.rfind(f"</{match['name'].lower()}") < match.start() for match in _ELEMENT.finditer(before))


OPENING: Final = "<think>"
MAX_TAGS: Final = 20_000  # signs "<" that are examined, which bounds the time
MAX_QUOTED_MARKS: Final = 8  # opening marks that a text may quote
_WORDS: Final = "think|thinking|thoughts?|reason|reasoning|reflection|scratchpad|analysis"
_TAG: Final = rf"(?:[a-z]{{1,12}}[:_])?(?:{_WORDS})\s{{0,8}}>"
_CHANNEL: Final = r"<\|channel\|>\s{0,8}"
_CLOSE: Final = (
    rf"</{_TAG}|<\|end_of_thought\|>|<\|think_end\|>|<\|END_THINKING\|>|<unused95>|<\|inner_suffix\|>|<channel\|>"
    rf"|{_CHANNEL}final[^<\n]{{0,40}}(?:<\|constrain\|>[^<\n]{{0,40}})?<\|message\|>"
)
_TOKEN: Final = (
    r"<\|begin_of_thought\|>|<\|think_start\|>|<\|START_THINKING\|>|<unused94>|<\|inner_prefix\|>|<\|channel>thought"
    rf"|{_CHANNEL}(?:analysis|commentary)"
)
_ANGLED: Final = re.compile(rf"(?P<close>{_CLOSE})|(?P<token>{_TOKEN})|<{_TAG}", re.IGNORECASE)
_PLAIN: Final = (
    ("[/THINK]", "[THINK]"),
    ("◁/think▷", "◁think▷"),
    ("[unused17]", "[unused16]"),
    ("[BEGIN FINAL RESPONSE]", ""),
    ("Here is my response:", ""),
    ("Here's my response:", ""),
    ("assistantfinal", ""),
)
_BEGINNING: Final = re.compile(
    r"\s{0,8}(?:(?:assistant)?(?:analysis|commentary)(?=[^\s:,.;\-–—'’])"
    r"|Here are my reasoning steps:|Here(?: is|'s) my thought process:)"
)
"""Matches the beginning of a response that starts with thinking: of gpt-oss without its tokens, Apriel, Granite 3.2."""


def remove_thinking(text: str) -> str:
    """Return the text after the last closing mark of the thinking.

    Raises `Refused` (no answer) if the thinking is unfinished. An opening mark that is only quoted, within a line and
    without a later box, does not count.
    """
    begins = _BEGINNING.match(text) is not None
    if not begins and "<" not in text and not any(mark in text for pair in _PLAIN for mark in pair if mark):
        return text
    end, tags, tokens = _angled(text)
    for close, opening in _PLAIN:
        end = max(end, at + len(close) if (at := text.rfind(close, end)) >= 0 else 0)
        if opening and (at := text.rfind(opening, end)) >= 0:
            tags.append(at)
    late = [at for at in tags if at >= end]
    if any(at >= end for at in tokens) or (begins and not end) or (late and not _spoken_of(text, end, late)):
        raise Refused(Outcome.NO_ANSWER, "the thinking never ends")
    return text[end:]


def _angled(text: str) -> tuple[int, list[int], list[int]]:
    """Return the end of the last </think>-like mark, or 0, and the positions of opening marks after it."""
    tags, tokens = list[int](), list[int]()
    at = len(text)
    for _ in range(MAX_TAGS):
        at = text.rfind("<", 0, at)
        if at < 0:
            return 0, tags, tokens
        mark = _ANGLED.match(text, at)
        if mark is None:
            continue
        if mark["close"]:
            return mark.end(), tags, tokens
        (tokens if mark["token"] else tags).append(at)
    raise Refused(Outcome.TOO_LONG, f"the response has more than {MAX_TAGS} signs <")


def _spoken_of(text: str, end: int, marks: list[int]) -> bool:
    """Return whether opening marks such as <think> are only quoted: within lines of text, no box after the first."""
    first = min(marks)
    within = all(text[max(text.rfind("\n", end, at) + 1, end) : at].strip() for at in marks[:MAX_QUOTED_MARKS])
    return within and len(marks) <= MAX_QUOTED_MARKS and r"\boxed" not in text[first:]


MAX_RESPONSE_LENGTH: Final = 1_000_000
MAX_ANSWER_LENGTH: Final = 1_000
MAX_BOX_DISTANCE: Final = 32_768  # characters after the thinking in which the box must occur

BLANK: Final = " \t\r\n\ufeff"  # characters of an empty box
MAX_NESTING: Final = 6  # levels of lists of messages and their content parts

_BRACE: Final = re.compile(r"\\boxed[ \t\n]{0,8}\{|\\[\\{}]|[{}]")


def response_string(given: object) -> str:
    """Return the text of a response: the string, or the last of several messages; bytes are decoded as UTF-8.

    Raises `Refused` (no answer) if there is no text.
    """
    response = given
    for _ in range(MAX_NESTING):
        if isinstance(response, str):
            return response
        if isinstance(response, bytes | bytearray):
            return bytes(response[: 4 * MAX_RESPONSE_LENGTH + 4]).decode(errors="replace")
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
    """Prepend the opening mark <think>, which the prompt already contained, to a response."""
    try:
        text = response_string(given)
    except Refused:
        return given
    return text if text.lstrip()[: len(OPENING)] == OPENING else OPENING + text


def response_text(given: object) -> str:
    """Return the text of a response after the thinking; Refused if the thinking never ends."""
    response = response_string(given)
    if len(response) > MAX_RESPONSE_LENGTH:
        raise Refused(Outcome.TOO_LONG, f"the response has more than {MAX_RESPONSE_LENGTH} characters")
    return remove_thinking(response)[-MAX_BOX_DISTANCE:]


def boxed(response: object) -> str:
    """Return the content of the last complete, non-empty box; of nested boxes, that of the outermost.

    Raises `Refused`: no answer without such a box, too long beyond 1000 characters, unreadable if the box is invisible
    or denied by words beside it.
    """
    text = response_text(response)
    boxes = closed_boxes(text)
    last_span = next((span for span in reversed(boxes) if text[span[0] : span[1]].strip(BLANK)), None)
    if last_span is None:
        why = "the box is empty" if boxes else r"there is no complete \boxed{…} after the thinking"
        raise Refused(Outcome.NO_ANSWER, why)
    if fault := fault_of_box(text, *last_span):
        raise Refused(Outcome.UNREADABLE, fault)
    answer = content(text, last_span)
    if len(answer) > MAX_ANSWER_LENGTH:
        raise Refused(Outcome.TOO_LONG, f"the answer has more than {MAX_ANSWER_LENGTH} characters")
    return answer


def content(text: str, box: tuple[int, int]) -> str:
    """Return the content of a box between two indices, without surrounding blanks."""
    return text[slice(*box)].lstrip(BLANK).rstrip("\ufeff")  # a backslash may need the space behind it


def closed_boxes(text: str) -> list[tuple[int, int]]:
    """Return the start and end of the content of each complete box, in the order of their closing braces."""
    spans: list[tuple[int, int]] = []
    open_braces: list[int] = []  # where the content of a box begins, or -1 for any other brace
    start = len(text[: max(text.find(r"\boxed"), 0)].rstrip("\\"))  # an even number of backslashes boxes nothing
    for match in _BRACE.finditer(text, start):
        brace = match[0]
        if brace == "}":
            begin = open_braces.pop() if open_braces else -1
            if begin >= 0:
                spans.append((begin, match.start()))
        elif brace == "{" or brace.startswith(r"\boxed"):
            open_braces.append(match.end() if brace != "{" else -1)
    return spans
