"""The last quantity of a response without a box, for evaluation only, never for a reward.

As a reward it could be exploited by ending on a likely number. Wrappers of the answer are removed: tags, JSON,
mathematical delimiters, Markdown, end-of-text tokens. Its sentence must contain neither a second value nor a denial.
"""

import re
from collections.abc import Iterator
from typing import Final

from sim2reason.grading.alphabet import HEDGES, SOFT_HEDGES
from sim2reason.grading.extract import MAX_ANSWER_LENGTH, response_text
from sim2reason.grading.labels import DENIALS
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.units import is_unit, parse_answer_unit
from sim2reason.scenes.dsl.units import UnitError

__all__ = ["last_quantity"]

MAX_WORDS: Final = 6  # of a unit
MIN_WORD_LENGTH: Final = 3  # letters from which a run is an English word, not a product of symbols

_NUMBER: Final = re.compile(
    r"(?<![\w.^{\\])(?<![\^{][-+−–])[-+−–]?(?:[0-9]{1,3}(?:,[0-9]{3})+|[0-9]+)(?:\.[0-9]+)?(?:[eE][-+]?[0-9]{1,4})?(?![0-9])"
    r"(?:[ ]?(?:\\times|\\cdot|×|·|\*|x)[ ]?10(?:\^\{?[-+−]?[0-9]{1,4}\}?|[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]{1,5}))?"
)
_OPERATES: Final = re.compile(
    r"(?:[/×·÷√^±<>≤≥≠(_]|(?<!\*)\*|[0-9})]\s*[-−–+]|\\(?:times|cdot|pm|frac|sqrt|to|leq?|geq?|neq?))\s*\Z"
)
_SENTENCE: Final = re.compile(r"[.!?](?=\s|\Z)|\n")
_BULLET: Final = re.compile(r"\A(?:[*•]|[-–](?=\s+[^0-9\s]))\s+")
_ANSWER: Final = re.compile(r"<answer>((?:(?!</?answer>).){1,400})(?:</answer>|\Z)", re.DOTALL | re.IGNORECASE)
_JSON: Final = re.compile(
    r'"(?:final[_ ]?)?(?:answer|result|value)"\s*:\s*(?:"([^"\n]{1,200})"|([^,"{}\[\]\n]{1,200}))', re.IGNORECASE
)
_TOKENS: Final = re.compile(r"<\|[^|<>\n]{1,40}\|>|</?(?:s|eos|bos|end_of_turn|start_of_turn)>|\[/?INST\]")
_TAGS: Final = re.compile(r"</?(?!su[bp]\b)[A-Za-z][A-Za-z0-9_:-]{0,20}(?:\s[^<>\n]{0,80})?/?>")
_WRAPPERS: Final = re.compile(r"\\[()\[\]](?!\s*[0-9.]+\s*(?:pt|em|ex|mm)\])|[$`“”„\"]|\\boxed(?![A-Za-z])|\*\*|✅")
_STARRED: Final = re.compile(r"(?<![\w*)}\]])\*(?=\S)([^*\n]{1,100}?)(?<=\S)\*(?![\w*({\\])")
_BRACKETED: Final = re.compile(r"\[\s*([^\[\]\n]{1,100}?)\s*\]\s*\Z")
_CLOSING: Final = re.compile(
    r"(?:(?<=[.!?:)\]*])|(?<=\n))\s+(?:please\s+)?(?:(?:let me know|feel free|i hope|hope this|would you like"
    r"|do you (?:have|want|need)|if you (?:have|need|want|would)|thank you|thanks for)\b.{0,400})\Z",
    re.IGNORECASE | re.DOTALL,
)
_WITH_CONSTANT: Final = re.compile(
    r"[,(]?\s*(?:using|taking|with|assuming|for)\s+(?:g|π|\\pi|pi)\s*(?:=|≈|\\approx)[^=≈]*\Z"
)
_CONCLUDES: Final = re.compile(r"(?:\b(?:so|hence|thus|therefore|gives?|giving|yields?)\b|⇒|\\Rightarrow|\\implies)")
_DENIES: Final = re.compile(
    r"(?:\b(?:not|never|no|nor|neither|cannot|between|from|at (?:most|least)|up to|(?:less|more|greater|fewer|smaller"
    r"|larger|higher|lower|other|rather) than|under|over|below|above|exceeds?|could|might|may|maybe|perhaps|possibly"
    r"|or|unless|minimum of|maximum of|until|within)\b|n['’]t\b|[<>≤≥≠±])",
    re.IGNORECASE,
)
_DENIED_BEHIND: Final = frozenset({"not", "wrong", "incorrect", "false", "isn't", "wasn't", "never", "impossible"})
_RELATION: Final = re.compile(r"(?:=|≈|\\approx|\\simeq)\s*\Z")
_WORDS: Final = re.compile(rf"[A-Za-z]{{{MIN_WORD_LENGTH},}}")
_LEFT: Final = re.compile(r"[^\s,;:]+")


def last_quantity(response: object) -> Iterator[str]:
    """Yield candidates for the last quantity, longest first: its sentence, its equation, its number with unit.

    Raises `Refused`: no answer without a number, wrong if the sentence contains another value or a denial, unreadable
    if the number is part of an expression.
    """
    sentence = _last_sentence(_unwrapped(response_text(response)[-MAX_ANSWER_LENGTH:]))
    yield sentence
    *_, last = [None, *_NUMBER.finditer(sentence)]
    if last is None:
        return
    before, behind = sentence[: last.start()], sentence[last.end() :]
    if _OPERATES.search(before[-12:]):
        raise Refused(Outcome.UNREADABLE, f"{last[0]} is a part of something longer")
    _refuse_doubt(before)
    start = _equation(before) if _RELATION.search(before) else ""
    tail = behind.strip().rstrip("*~ ")
    yield f"{start}{last[0]} {tail}"
    unit = _unit_before_prose(tail)
    if unit is not None:
        yield f"{start}{last[0]} {unit}"


def _unwrapped(text: str) -> str:
    """Remove tags, tokens, Markdown and JSON around the answer."""
    *_, tagged = [None, *_ANSWER.finditer(text)]
    text = _TAGS.sub(" ", _TOKENS.sub(" ", tagged[1] if tagged else text))
    *_, field = [None, *_JSON.finditer(text)]
    text = _CLOSING.sub("", field[1] or field[2] if field else text)
    text = _STARRED.sub(r" \1 ", _WRAPPERS.sub(" ", text))
    return _BRACKETED.sub(r" \1 ", text.strip().rstrip("."))


def _last_sentence(text: str) -> str:
    """Return the last sentence with a number, without a final *using g = …*; raise `Refused` if there is none."""
    for sentence in reversed(_SENTENCE.split(text)):
        if re.search("[0-9]", sentence):
            stripped = _BULLET.sub("", sentence.strip(" \t|#>"))
            if stripped.startswith(("- ", "– ")):
                raise Refused(Outcome.UNREADABLE, "a dash before the value could be a minus sign or begin a list")
            used = _WITH_CONSTANT.search(stripped)
            return stripped[: used.start()] if used and re.search("[0-9]", stripped[: used.start()]) else stripped
    raise Refused(Outcome.NO_ANSWER, "there is neither a box nor a number")


def _refuse_doubt(before: str) -> None:
    """Raise Refused if the text before the last number denies it or lists another value."""
    *_, concluded = [None, *_CONCLUDES.finditer(before)]
    clause = before[concluded.end() :] if concluded else before
    denied = _DENIES.search(clause)
    word = denied[0] if denied else next((word for word in _WORDS.findall(clause) if word.lower() in DENIALS), "")
    if word:
        raise Refused(Outcome.WRONG, f"{word!r} before the value makes it more, or less, than one value")
    *_, earlier = [None, *_NUMBER.finditer(before)]
    if earlier is not None:
        between = [word for word in _WORDS.findall(before[earlier.end() :]) if word.lower() not in SOFT_HEDGES]
        if all(is_unit(word) for word in between):
            raise Refused(Outcome.WRONG, "a list is more than one value")


def _equation(before: str) -> str:
    """Return the left sides of the equation at the end of `before`, back to the last English word."""
    start = len(before)
    for piece in reversed(list(_LEFT.finditer(before))):
        if _WORDS.fullmatch(piece[0].strip("().")) and not is_unit(piece[0]):
            break
        start = piece.start()
    return before[start:]


def _unit_before_prose(tail: str) -> str | None:
    """Return the unit with which a sentence continues, empty after a comma; None if another value may follow."""
    if tail.startswith(","):
        return "" if _is_prose(tail.split()) else None
    words = tail.split()
    for count in range(min(MAX_WORDS, len(words)), 0, -1):
        unit = " ".join(words[:count]).rstrip(",;:*$")
        try:
            parse_answer_unit(unit, None)
        except UnitError:
            continue
        return unit if _is_prose(words[count:]) else None
    return None


def _is_prose(words: list[str]) -> bool:
    """Return whether words contain neither a number nor anything that offers another value."""
    plain = {word.strip(",.;:()").lower() for word in words}
    return not plain & (_DENIED_BEHIND | HEDGES | SOFT_HEDGES - {"to", "and"}) and not any(
        re.search(r"[0-9<>±~]", word) for word in words
    )
