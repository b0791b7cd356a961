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
    FACTORS_BY_PARTICIPLE,
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
    `factor`, or by the value with a `sign`. A speed may be told with the `direction`, *up* or *down*.
    """

    how: str
    number: NamedNumber
    value: str = ""
    factor: float = 1.0
    sign: int = 0
    direction: str = ""


def suppositions(text: str, sentence: TokenizedSentence) -> tuple[Supposition, ...]:
    """Return the changes that a clause such as *A were twice as heavy and g were 5 m/s²* supposes, joined by *and*.

    There are none if a part of the clause is not understood.
    """
    alone = _first(text, sentence, CLAUSES)
    if alone:
        return alone
    for match in _JOINED.finditer(text):
        # The first part is one change, not several: else each *and* would double the work.
        one = _first(text[: match.start()], sentence, CLAUSES)
        if other := suppositions(text[match.end() :], sentence) if one else ():
            return (*one, *other)
    return ()


def adjunct(text: str, sentence: TokenizedSentence) -> tuple[Supposition, ...]:
    """Return the change that a phrase such as *without friction* supposes; none if it is not understood."""
    return _first(text, sentence, ADJUNCTS)


def _first(text: str, sentence: TokenizedSentence, rows: Rows) -> tuple[Supposition, ...]:
    """Return the change of the first row that a text matches; none if it matches no row."""
    subject = {f"@{index}@": phrase for index, phrase in enumerate(sentence.subjects)}
    phrase = re.sub(r"\b(?:just|instead only|only)\b ?", "", text).strip(" ,")
    for template, kind, how in rows:
        match = _compiled(template).fullmatch(phrase)
        if match is None:
            continue
        groups = match.groupdict()
        number = named_number(match, subject) if NUMBER in template else NamedNumber(kind or f"{groups.get('e')} field")
        owners = tuple(subject[groups[key]] for key in ("s", "t") if groups.get(key))
        if owners and not number.owners and how != SWAPPED:
            number = number._replace(owners=owners[:1])
        elif how == SWAPPED:
            number = number._replace(owners=owners)
        return (_changed(how, number, groups, sentence),)
    return ()


NUMBERS_BY_WORD = {"level": "0", "ground": "0 m", "flat": "0", "upright": "90", "elastic": "1", "plastic": "0"}
"""By the group of a row that matches, the value that its words mean."""


def _changed(
    how: str, number: NamedNumber, groups: Mapping[str, str | None], sentence: TokenizedSentence
) -> Supposition:
    token = groups.get("n")
    value = sentence.number(token) if token else ""
    value = next((implied_value for name, implied_value in NUMBERS_BY_WORD.items() if groups.get(name)), value)
    sign = 1 if groups.get("grow") else -1 if groups.get("shrink") else 0
    if groups.get("pct") or (sign and value.endswith(("%", "percent"))):
        return Supposition(TIMES, number, factor=1.0 + sign * float(value.partition(" ")[0].rstrip("%")) / 100.0)
    return Supposition(how, number, value, _factor(groups, sentence), sign, groups.get("way") or "")


def _factor(groups: Mapping[str, str | None], sentence: TokenizedSentence) -> float:
    done, multiple = groups.get("done"), groups.get("mult")
    if done:
        return FACTORS_BY_PARTICIPLE[done]
    if multiple and multiple.startswith("#"):
        return float(sentence.number(multiple.partition(" ")[0]).partition(" ")[0])
    return next((value for regex, value in MULTIPLES.items() if multiple and re.fullmatch(regex, multiple)), 1.0)


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


def changed_questions(text: str, sentence: TokenizedSentence) -> Iterator[ChangedQuestion]:
    """Yield each way to read a sentence as a question about a changed scene."""
    for question, supposed in _split(text, sentence):
        for plain_question, compare, grows in _compared(question):
            yield ChangedQuestion(_plainly(plain_question), supposed, compare, grows)


def _split(text: str, sentence: TokenizedSentence) -> Iterator[tuple[str, tuple[Supposition, ...]]]:
    """Yield each way to split a sentence into a question and the changes that it supposes."""
    text = _with_subject(text, sentence)
    leading = re.match(rf"{_IF} ", text)
    if leading is not None:
        for match in re.finditer(r"(?: ,|\.) (?:then )?", text):
            if supposed := suppositions(text[leading.end() : match.start()], sentence):
                yield text[match.end() :], supposed
        return
    for match in re.finditer(rf" ?,? {_IF} ", text):
        if supposed := suppositions(text[match.end() :], sentence):
            yield text[: match.start()], supposed
    for match in re.finditer(_WHEN, text):
        if supposed := suppositions(text[match.end() :], sentence):
            yield text[: match.start()], supposed
    first, parted, second = text.partition(". ")
    if parted and (supposed := suppositions(first, sentence)):
        yield second, supposed
    yield from _with_adjunct(text, sentence)


def _with_subject(text: str, sentence: TokenizedSentence) -> str:
    """Return a sentence with the only subject in its leading clause, as *if it is thrown* or *if thrown*."""
    if len(sentence.subjects) != 1:
        return text
    text = re.sub(rf"^(?P<if>{_IF}) it (?=[a-z])", r"\g<if> @0@ ", text)
    return re.sub(
        rf"^(?P<if>{_IF}) (?=(?:thrown|launched|released|started|projected|fired)\b)", r"\g<if> @0@ were ", text
    )


def _with_adjunct(text: str, sentence: TokenizedSentence) -> Iterator[tuple[str, tuple[Supposition, ...]]]:
    """Yield the question and the changes of a sentence that ends or begins with a phrase such as *without friction*."""
    for match in re.finditer(r" (?=without |with |in absence |on )", text):
        if supposed := adjunct(text[match.end() :], sentence):
            yield text[: match.start()], supposed
    for match in re.finditer(r" , ", text):
        if supposed := adjunct(text[: match.start()], sentence):
            yield text[match.end() :], supposed


def _compared(question: str) -> Iterator[tuple[str, str, bool | None]]:
    """Yield each plain question in a sentence, such as *what is x* in *by what factor would x grow*.

    With it come the form of the answer, and whether the sentence presumes growth.
    """
    question = re.sub(r"\bthen \b", "", question)
    for regex, compare in ((r"by (?:what|which) factor|how many times", RATIO), ("by how much|how much", DIFFERENCE)):
        match = re.fullmatch(
            rf"(?:{regex}) (?:would|does|will|do) (?P<x>.+?) (?:(?P<more>{_MORE})|(?P<less>{_LESS})"
            rf"|(?P<change>{_CHANGE}))",
            question,
        )
        if match is not None and not (compare == RATIO and match["less"]):
            x = match["x"]
            grows = True if match["more"] else False if match["less"] else None
            high = re.search(r"higher$", match[0]) is not None
            yield f"what is {'height of ' if high else ''}{x}", compare, grows
    yield from _by_adverb(question)
    yield question, VALUE, None


def _by_adverb(question: str) -> Iterator[tuple[str, str, bool | None]]:
    """Yield the plain question in a comparison such as *how many times as far* or *how much later*, and its form."""
    match = re.fullmatch(
        r"how many times (?:as (?:large|great|high|big|strong|long)|larger|greater) (?:would|will) (?P<x>.+) be",
        question,
    )
    if match is not None:
        yield f"what is {match['x']}", RATIO, None
    match = re.fullmatch(
        r"how many times (?:as|so) (?P<how>far|long|high|fast) (?P<rest>(?:would|does|will|is|do) .+)", question
    )
    if match is not None:
        yield f"how {match['how']} {match['rest']}", RATIO, None
    match = re.fullmatch(
        r"(?:by )?how (?:much|many seconds) (?P<how>later|earlier|sooner) (?:would|does|will) (?P<x>.+?)"
        r" (?:take place|happen|occur|come about)",
        question,
    )
    if match is not None:
        yield f"when does {match['x']} take place", DIFFERENCE, match["how"] == "later"
    match = re.fullmatch(
        rf"(?:by )?how (?:much|many (?:seconds|metres|times)) (?P<how>{'|'.join(_FAR)}) (?P<rest>(?:would|does"
        rf"|will|is|do) .+)",
        question,
    )
    if match is not None:
        yield f"how {_FAR[match['how']]} {match['rest']}", DIFFERENCE, match["how"] not in _FEWER
    match = re.fullmatch(rf"(?:by )?how much (?P<how>{_DIMENSIONS}) (?:would|will) (?P<x>.+) be", question)
    if match is not None:
        grows = match["how"] not in ("smaller", "less", "lower")
        yield f"what is {match['x']}", DIFFERENCE, grows


def _plainly(question: str) -> str:
    """Return a question such as *what would x be* in the indicative, as *what is x*."""
    indicative = re.sub(r"\b(?:new|resulting|then|instead|in that case|now|changed) ", "", f"{question} ").strip()
    indicative = re.sub(r"(?: ,)? (?:then|instead|in that case|now)$", "", indicative)
    indicative = re.sub(
        r"^how (?:large|great|big|strong) (?:would|will) (?P<x>.+?) be(?P<rest>(?: .+)?)$",
        r"what is \g<x>\g<rest>",
        indicative,
    )
    indicative = re.sub(r"^(?P<ask>what|which) would be (?P<x>.+)$", r"\g<ask> is \g<x>", indicative)
    indicative = re.sub(
        r"^(?P<ask>what|which) (?:would|will) (?P<x>.+?) be(?P<rest>(?: .+)?)$", r"\g<ask> is \g<x>\g<rest>", indicative
    )
    indicative = re.sub(r"\b(?:would|will) (?P<s>@\d+@) be\b", r"is \g<s>", indicative)
    indicative = re.sub(r"\b(?:would|will) (?P<s>@\d+@) (?P<verb>have|then have)\b", r"does \g<s> have", indicative)
    indicative = re.sub(r"\b(?:would|will) be\b", "is", indicative)
    indicative = re.sub(r"\bwould\b", "does", indicative)
    return " ".join(indicative.split())
