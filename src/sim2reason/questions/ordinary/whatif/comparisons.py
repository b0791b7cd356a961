"""The split of a sentence about a changed scene into a question, the changes, and the form of the answer."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from sim2reason.questions.ordinary.hearing import Heard
from sim2reason.questions.ordinary.whatif.suppositions import Supposition, adjunct, suppositions
from sim2reason.questions.posing import DIFFERENCE, RATIO, VALUE

_IF = (
    r"(?:if|supposing(?: that)?|assuming(?: that)?|suppose(?: that)?|imagine(?: that)?|assume(?: that)?"
    r"|provided(?: that)?|were it that)"
)
_WHEN = r"(?<=change) (?:when|as|on) "  # *by how much does it change when ...* supposes something, too
_MORE = (
    "(?:increase|grow|rise|be larger|be greater|be increased|go up|become larger|become greater|be higher|be"
    " multiplied|be longer|be raised|lengthen|climb)"
)
_LESS = (
    "(?:decrease|fall|shrink|be smaller|be less|be reduced|go down|become smaller|drop|be lower|be shorter|be"
    " lowered|be decreased|shorten|sink)"
)
_CHANGE = "(?:change|be changed|differ)"
_FAR = {
    "further": "far",
    "farther": "far",
    "longer": "long",
    "faster": "fast",
    "higher": "high",
    "less far": "far",
    "sooner": "long",
    "later": "long",
    "slower": "fast",
    "shorter": "long",
    "less high": "high",
}
_FEWER = frozenset({"less far", "sooner", "slower", "shorter", "less high"})
_DIMENSIONS = "(?:larger|greater|higher|bigger|more|stronger|smaller|less|lower)"


class ChangedQuestion(NamedTuple):
    """A question and the changes that a sentence supposes, with `compare`, the form of the answer: see `posing`.

    `grows` says whether the sentence presumes that the answer is greater after the change, or less; None for neither.
    """

    question: str
    supposed: tuple[Supposition, ...]
    compare: str = VALUE
    grows: bool | None = None


def changed_questions(text: str, heard: Heard) -> Iterator[ChangedQuestion]:
    """Yield each way to read a sentence as a question about a changed scene."""
    for question, supposed in _split(text, heard):
        for asked, compare, grows in _compared(question):
            yield ChangedQuestion(_plainly(asked), supposed, compare, grows)


def _split(text: str, heard: Heard) -> Iterator[tuple[str, tuple[Supposition, ...]]]:
    """Yield each way to split a sentence into a question and the changes that it supposes."""
    text = _with_subject(text, heard)
    leading = re.match(rf"{_IF} ", text)
    if leading is not None:
        for found in re.finditer(r"(?: ,|\.) (?:then )?", text):
            if supposed := suppositions(text[leading.end() : found.start()], heard):
                yield text[found.end() :], supposed
        return
    for found in re.finditer(rf" ?,? {_IF} ", text):
        if supposed := suppositions(text[found.end() :], heard):
            yield text[: found.start()], supposed
    for found in re.finditer(_WHEN, text):
        if supposed := suppositions(text[found.end() :], heard):
            yield text[: found.start()], supposed
    first, parted, second = text.partition(". ")
    if parted and (supposed := suppositions(first, heard)):
        yield second, supposed
    yield from _with_adjunct(text, heard)


def _with_subject(text: str, heard: Heard) -> str:
    """Return a sentence with the only subject in its leading clause, as *if it is thrown* or *if thrown*."""
    if len(heard.subjects) != 1:
        return text
    text = re.sub(rf"^(?P<if>{_IF}) it (?=[a-z])", r"\g<if> @0@ ", text)
    return re.sub(
        rf"^(?P<if>{_IF}) (?=(?:thrown|launched|released|started|projected|fired)\b)", r"\g<if> @0@ were ", text
    )


def _with_adjunct(text: str, heard: Heard) -> Iterator[tuple[str, tuple[Supposition, ...]]]:
    """Yield the question and the changes of a sentence that ends or begins with a phrase such as *without friction*."""
    for found in re.finditer(r" (?=without |with |in absence |on )", text):
        if supposed := adjunct(text[found.end() :], heard):
            yield text[: found.start()], supposed
    for found in re.finditer(r" , ", text):
        if supposed := adjunct(text[: found.start()], heard):
            yield text[found.end() :], supposed


def _compared(question: str) -> Iterator[tuple[str, str, bool | None]]:
    """Yield each plain question in a sentence, such as *what is x* in *by what factor would x grow*.

    With it come the form of the answer, and whether the sentence presumes growth.
    """
    question = re.sub(r"\bthen \b", "", question)
    for told, compare in ((r"by (?:what|which) factor|how many times", RATIO), ("by how much|how much", DIFFERENCE)):
        found = re.fullmatch(
            rf"(?:{told}) (?:would|does|will|do) (?P<x>.+?) (?:(?P<more>{_MORE})|(?P<less>{_LESS})"
            rf"|(?P<change>{_CHANGE}))",
            question,
        )
        if found is not None and not (compare == RATIO and found["less"]):
            x = found["x"]
            grows = True if found["more"] else False if found["less"] else None
            high = re.search(r"higher$", found[0]) is not None
            yield f"what is {'height of ' if high else ''}{x}", compare, grows
    yield from _by_adverb(question)
    yield question, VALUE, None


def _by_adverb(question: str) -> Iterator[tuple[str, str, bool | None]]:
    """Yield the same for comparisons with an adverb: *how many times as far*, *how much later*, *how much larger*."""
    found = re.fullmatch(
        r"how many times (?:as (?:large|great|high|big|strong|long)|larger|greater) (?:would|will) (?P<x>.+) be",
        question,
    )
    if found is not None:
        yield f"what is {found['x']}", RATIO, None
    found = re.fullmatch(
        r"how many times (?:as|so) (?P<how>far|long|high|fast) (?P<rest>(?:would|does|will|is|do) .+)", question
    )
    if found is not None:
        yield f"how {found['how']} {found['rest']}", RATIO, None
    found = re.fullmatch(
        r"(?:by )?how (?:much|many seconds) (?P<how>later|earlier|sooner) (?:would|does|will) (?P<x>.+?)"
        r" (?:take place|happen|occur|come about)",
        question,
    )
    if found is not None:
        yield f"when does {found['x']} take place", DIFFERENCE, found["how"] == "later"
    found = re.fullmatch(
        rf"(?:by )?how (?:much|many (?:seconds|metres|times)) (?P<how>{'|'.join(_FAR)}) (?P<rest>(?:would|does"
        rf"|will|is|do) .+)",
        question,
    )
    if found is not None:
        yield f"how {_FAR[found['how']]} {found['rest']}", DIFFERENCE, found["how"] not in _FEWER
    found = re.fullmatch(rf"(?:by )?how much (?P<how>{_DIMENSIONS}) (?:would|will) (?P<x>.+) be", question)
    if found is not None:
        grows = found["how"] not in ("smaller", "less", "lower")
        yield f"what is {found['x']}", DIFFERENCE, grows


def _plainly(question: str) -> str:
    """Return a question such as *what would x be* in the indicative, as *what is x*."""
    said = re.sub(r"\b(?:new|resulting|then|instead|in that case|now|changed) ", "", f"{question} ").strip()
    said = re.sub(r"(?: ,)? (?:then|instead|in that case|now)$", "", said)
    said = re.sub(
        r"^how (?:large|great|big|strong) (?:would|will) (?P<x>.+?) be(?P<rest>(?: .+)?)$",
        r"what is \g<x>\g<rest>",
        said,
    )
    said = re.sub(r"^(?P<ask>what|which) would be (?P<x>.+)$", r"\g<ask> is \g<x>", said)
    said = re.sub(
        r"^(?P<ask>what|which) (?:would|will) (?P<x>.+?) be(?P<rest>(?: .+)?)$", r"\g<ask> is \g<x>\g<rest>", said
    )
    said = re.sub(r"\b(?:would|will) (?P<s>@\d+@) be\b", r"is \g<s>", said)
    said = re.sub(r"\b(?:would|will) (?P<s>@\d+@) (?P<verb>have|then have)\b", r"does \g<s> have", said)
    said = re.sub(r"\b(?:would|will) be\b", "is", said)
    said = re.sub(r"\bwould\b", "does", said)
    return " ".join(said.split())
