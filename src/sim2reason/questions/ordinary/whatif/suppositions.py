"""Suppositions, such as *if g were 5 m/s²*, and the questions about the changed scene."""

import re
from collections.abc import Iterator, Mapping
from functools import cache
from typing import NamedTuple

from sim2reason.questions.ordinary.hearing import TokenizedSentence
from sim2reason.questions.ordinary.whatif.numbers import NUMBER, NamedNumber, named_number, number_pattern
from sim2reason.questions.ordinary.whatif.supposed_rows import (
    ADJUNCTS,
    CLAUSES,
    DONE,
    MULTIPLES,
    SWAPPED,
    TIMES,
)
from sim2reason.questions.posing import DIFFERENCE, RATIO, VALUE

Rows = tuple[tuple[str, str, str], ...]
_JOINED = re.compile(r" (?:,? ?and|,) (?:if )?")


class Supposition(NamedTuple):
    """A supposed change of a number or a body.

    `how` is one of the changes of `supposed_rows`. The number changes to a `value`, with the unit of the sentence, by a
    `factor`, or by the value with a `sign`. A speed may be told with the `way`, *up* or *down*.
    """

    how: str
    number: NamedNumber
    value: str = ""
    factor: float = 1.0
    sign: int = 0
    way: str = ""


def suppositions(text: str, heard: TokenizedSentence) -> tuple[Supposition, ...]:
    """Return the changes that a clause such as *A were twice as heavy and g were 5 m/s²* supposes, joined by *and*.

    There are none if a part of the clause is not understood.
    """
    alone = _first(text, heard, CLAUSES)
    if alone:
        return alone
    for found in _JOINED.finditer(text):
        # The first part is one change, not several: else each *and* would double the work.
        one = _first(text[: found.start()], heard, CLAUSES)
        if other := suppositions(text[found.end() :], heard) if one else ():
            return (*one, *other)
    return ()


def adjunct(text: str, heard: TokenizedSentence) -> tuple[Supposition, ...]:
    """Return the change that a phrase such as *without friction* supposes; none if it is not understood."""
    return _first(text, heard, ADJUNCTS)


def _first(text: str, heard: TokenizedSentence, rows: Rows) -> tuple[Supposition, ...]:
    """Return the change of the first row that a text matches; none if it matches no row."""
    subject = {f"@{index}@": said for index, said in enumerate(heard.subjects)}
    said = re.sub(r"\b(?:just|instead only|only)\b ?", "", text).strip(" ,")
    for told, kind, how in rows:
        found = _compiled(told).fullmatch(said)
        if found is None:
            continue
        groups = found.groupdict()
        number = named_number(found, subject) if NUMBER in told else NamedNumber(kind or f"{groups.get('e')} field")
        owners = tuple(subject[groups[key]] for key in ("s", "t") if groups.get(key))
        if owners and not number.owners and how != SWAPPED:
            number = number._replace(owners=owners[:1])
        elif how == SWAPPED:
            number = number._replace(owners=owners)
        return (_changed(how, number, groups, heard),)
    return ()


MEANT = {"level": "0", "ground": "0 m", "flat": "0", "upright": "90", "elastic": "1", "plastic": "0"}
"""By the group of a row that matches, the value that its words mean."""


def _changed(how: str, number: NamedNumber, groups: Mapping[str, str | None], heard: TokenizedSentence) -> Supposition:
    token = groups.get("n")
    value = heard.number(token) if token else ""
    value = next((told for name, told in MEANT.items() if groups.get(name)), value)
    sign = 1 if groups.get("grow") else -1 if groups.get("shrink") else 0
    if groups.get("pct") or (sign and value.endswith(("%", "percent"))):
        return Supposition(TIMES, number, factor=1.0 + sign * float(value.partition(" ")[0].rstrip("%")) / 100.0)
    return Supposition(how, number, value, _factor(groups, heard), sign, groups.get("way") or "")


def _factor(groups: Mapping[str, str | None], heard: TokenizedSentence) -> float:
    done, multiple = groups.get("done"), groups.get("mult")
    if done:
        return DONE[done]
    if multiple and multiple.startswith("#"):
        return float(heard.number(multiple.partition(" ")[0]).partition(" ")[0])
    return next((value for told, value in MULTIPLES.items() if multiple and re.fullmatch(told, multiple)), 1.0)


@cache
def _compiled(told: str) -> re.Pattern[str]:
    return re.compile(told.replace(NUMBER, number_pattern()))


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
    """A question, the changes of the scene that it supposes, and the form of its answer: ratio, difference or value.

    `grows` says whether the sentence presumes that the answer is greater after the change, or less; None for neither.
    """

    question: str
    supposed: tuple[Supposition, ...]
    compare: str = VALUE
    grows: bool | None = None


def changed_questions(text: str, heard: TokenizedSentence) -> Iterator[ChangedQuestion]:
    """Yield each way to read a sentence as a question about a changed scene."""
    for question, supposed in _split(text, heard):
        for asked, compare, grows in _compared(question):
            yield ChangedQuestion(_plainly(asked), supposed, compare, grows)


def _split(text: str, heard: TokenizedSentence) -> Iterator[tuple[str, tuple[Supposition, ...]]]:
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


def _with_subject(text: str, heard: TokenizedSentence) -> str:
    """Return a sentence with the only subject in its leading clause, as *if it is thrown* or *if thrown*."""
    if len(heard.subjects) != 1:
        return text
    text = re.sub(rf"^(?P<if>{_IF}) it (?=[a-z])", r"\g<if> @0@ ", text)
    return re.sub(
        rf"^(?P<if>{_IF}) (?=(?:thrown|launched|released|started|projected|fired)\b)", r"\g<if> @0@ were ", text
    )


def _with_adjunct(text: str, heard: TokenizedSentence) -> Iterator[tuple[str, tuple[Supposition, ...]]]:
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
    """Yield the plain question in a comparison such as *how many times as far* or *how much later*, and its form."""
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
