"""Sentences: parsing of questions into queries, and topics that matter only to some questions."""

import re
from collections.abc import Callable, Collection, Iterator, Mapping
from decimal import Decimal
from functools import cache
from math import inf, isclose
from typing import get_args

from sim2reason.questions import KINDS, Question, SimulatedScene, Words
from sim2reason.questions.moments.reached import Reached
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.query import Query, targets
from sim2reason.questions.regimes.strings import AllStayTaut, StaysTaut
from sim2reason.questions.study import TIME_MARGIN
from sim2reason.questions.unknown import range_of
from sim2reason.questions.words import DIGITS_PATTERN, format_number
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import Topic
from sim2reason.scenes.dsl.units import UnitSystem
from sim2reason.simulation.trace import events_before

_LENGTHS = {
    "m metre metres meter meters": "1",
    "cm centimetre centimetres centimeter centimeters": "0.01",
    "mm millimetre millimetres millimeter millimeters": "0.001",
    "km kilometre kilometres kilometer kilometers": "1000",
}
_TIMES = {
    "s sec secs second seconds": "1",
    "ms millisecond milliseconds": "0.001",
    "min mins minute minutes": "60",
    "h hr hrs hour hours": "3600",
}
_ANGLES = {"° deg degs degree degrees": "1"}
_ASTRONOMICAL = {"au": {"au AU": "1"}, "yr": {"yr yrs year years": "1"}}
SPELLINGS: Mapping[str, Mapping[str, str]] = {"m": _LENGTHS, "s": _TIMES, "deg": _ANGLES, **_ASTRONOMICAL}
"""By the unit in which a text counts: what else people write, and how many of these units one of it is."""

_COUNTED = "one two three four five six seven eight nine ten eleven twelve"
_PARTS = {"half": 2, "third": 3, "quarter": 4, "fifth": 5, "tenth": 10}
_PLAIN = {word: str(n) for n, word in enumerate(_COUNTED.split(" "), start=1)}
_SHARES = {
    f"{word} {part}{'s' if count > 1 else ''} of {article}": str(Decimal(count) / size)
    for count, word in enumerate(("a", *_COUNTED.split(" ")[1:]), start=1)
    for part, size in _PARTS.items()
    for article in ("a", "an")
    if count < size
}
_HALVES = {"half a": "0.5", "half an": "0.5"}
_SMALL = _SHARES | _HALVES | _PLAIN
_WORDS = _SMALL | {word.capitalize(): number for word, number in _SMALL.items()}
_FRACTIONS = {"½": "0.5", "¼": "0.25", "¾": "0.75"}
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_GROUPED = r"\d{1,3}(?:[,\u2009\u202f]\d{3})+" + rf"(?:\.{DIGITS_PATTERN})?"
_POWER = r"(?:\s?[×x]\s?10\^?(?P<power>[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3}|-?\d{1,2})|[eE](?P<exponent>[+-]?\d{1,2}))?"
_DECIMAL = rf"{DIGITS_PATTERN}(?:\.{DIGITS_PATTERN})?|\.{DIGITS_PATTERN}"
_NUMBER = rf"(?P<number>{_GROUPED}|{_DECIMAL}|[½¼¾]|(?:{'|'.join(_WORDS)})\b){_POWER}"
_BETWEEN = "(?:\\s|\N{NO-BREAK SPACE}|-)?"  # a number and its unit
LARGEST = Decimal("1e15")  # larger numbers are left as they are
APOSTROPHES, DASHES = "\N{RIGHT SINGLE QUOTATION MARK}", "\N{NON-BREAKING HYPHEN}\N{HYPHEN}"
SPELLED_OUT = {"What's": "What is", "what's": "what is", "how's": "how is", "How's": "How is"}


def plainly(text: str, units: UnitSystem) -> str:
    """Return a question with its times, lengths and angles rewritten in the library's units and digits.

    Numbers in other units stay unchanged, and so does a sentence that is already written in this way.
    """
    text = " ".join(text.replace(APOSTROPHES, "'").split())
    for phrase, spelled in SPELLED_OUT.items():
        text = text.replace(phrase, spelled)
    text = re.sub(r"\bt\s*=\s*(?=[\d.])", "t = ", text)
    for unit in ("m", "s", "deg"):
        shown = units.spell(unit)
        if shown in SPELLINGS:
            text = _pattern(shown).sub(lambda match, shown=shown: _told(match, shown), text)
    return text


@cache
def _pattern(unit: str) -> re.Pattern[str]:
    names = sorted((name for group in SPELLINGS[unit] for name in group.split()), key=len, reverse=True)
    units = f"(?P<unit>{'|'.join(map(re.escape, names))})"
    return re.compile(rf"(?<![\w.,$\\^]){_NUMBER}{_BETWEEN}{units}(?![\w/·^²³⁴*]|\s?/)")


@cache
def _sizes(unit: str) -> Mapping[str, Decimal]:
    return {name: Decimal(size) for group, size in SPELLINGS[unit].items() for name in group.split()}


def _told(match: re.Match[str], unit: str) -> str:
    said = match["number"]
    digits = _WORDS.get(said) or _FRACTIONS.get(said) or re.sub(r"[,\u2009\u202f]", "", said)
    power = (match["power"] or "").translate(_RAISED) or match["exponent"] or "0"
    value = Decimal(digits).scaleb(int(power)) * _sizes(unit)[match["unit"]]
    return format_number(float(value), unit) if 0 < value < LARGEST else match[0]


def parse_question(
    text: str, study: SimulatedScene, words: Words, kinds: Collection[str] | None = None
) -> Query | None:
    """Return the query that a sentence expresses, found by trying all phrases of all kinds; None if none matches.

    Each kind reads numbers and names from the sentence. The rest must match the kind's `shapes` word for word, but
    numbers may be spelled in any usual way. Where `kinds` are named, only those are tried.
    """
    text, offered = sentence(plainly(text, words.units)), targets(words)
    mentioned = {target: noun for target, noun in offered.items() if noun.occurs_in(text)}
    for kind in (candidate for name, candidate in KINDS.items() if kinds is None or name in kinds):
        for query in kind.parsed(text, study, words, mentioned):
            noun = offered[query.target] if query.target is not None else None
            if any(
                sentence(shape) == text
                for shape in (*kind.shapes(query, words, noun), *kind.former_sentences(query, words))
            ):
                return query
    return None


RANGE_STRIDE = 6  # stride through the range of an unknown number
AXES = "x", "y", "z"
STRAIN = ".strain.by"  # final part of the address of a spring's initial strain
SHIFTED, FROM_NONE = 0.9, (0.05, 0.01)  # altered strains: a factor, and values in m for a relaxed spring
ANSWER_RTOL = 1e-6  # relative, and in SI units: answers that differ by less are equal
TOPICS: tuple[Topic, ...] = get_args(Topic)


def irrelevant(question: Question, study: SimulatedScene, among: Collection[Topic] = TOPICS) -> frozenset[Topic]:
    """Return the topics that do not matter to a question, so that the text may omit their sentences.

    With an unknown number, a topic is irrelevant only if it is for all usual values of the number.
    """
    return frozenset(topic for topic, matters in MATTERS.items() if topic in among and not matters(question, study))


def _uses_axes(question: Question, study: SimulatedScene) -> bool:
    """Return whether a question is about a component along an axis, or its moment refers to one."""
    del study
    moment = question.query.moment
    targets = question.query.target, moment.target if isinstance(moment, Reached) else None
    return any(target is not None and target.sense is not None and target.sense.axis in AXES for target in targets)


def _slackens(question: Question, study: SimulatedScene) -> bool:
    """Return whether a string goes slack before the moment, or may with other values of the unknown number."""
    query = question.query
    if query.hides:
        return True
    time = KINDS[query.kind].time(query, study)
    ends = any(event.kind == "slack" and event.time == time for event in study.trace.events)
    if time == 0.0 or ends or any(isinstance(each, StaysTaut | AllStayTaut) for each in question.assumed):
        return _has_slackened(question, study)
    if question.formula is not None:
        return True
    return any(_has_slackened(question, each) for each in (study, *_others(question, study)))


def _others(question: Question, study: SimulatedScene) -> Iterator[SimulatedScene]:
    """Yield motions with other values of the unknown number, for the usual duration of the question."""
    time = KINDS[question.query.kind].time(question.query, study)
    until = time * TIME_MARGIN if time is not None else None
    values = range_of(study.scene, question.unknown)[::RANGE_STRIDE] if question.unknown else ()
    yield from filter(None, (study.with_values({question.unknown: value}, until) for value in values))


def _has_slackened(question: Question, study: SimulatedScene) -> bool:
    """Return whether a string goes slack before the moment, or before the end if the moment does not occur."""
    time = KINDS[question.query.kind].time(question.query, study)
    return any(event.kind == "slack" for event in events_before(study.trace.events, inf if time is None else time))


def depends_on_start(query: Query, study: SimulatedScene) -> bool:
    """Return whether the answer to a query depends on the initial motion or the initial strain of springs.

    Springs between two walls exert forces in equilibrium, too. These depend on the natural lengths, which a text tells
    by the initial strain.
    """
    kind = KINDS[query.kind]
    if kind.of_motion(query):
        return True
    others = (study.with_values(values, 0.0) for values in _other_strains(study.scene))
    mine = kind.answer(query, study)
    its = (kind.answer(query, other) for other in others if other is not None)
    return not all(isclose(mine or 0.0, answer or 0.0, rel_tol=ANSWER_RTOL, abs_tol=ANSWER_RTOL) for answer in its)


def _other_strains(scene: Scene) -> Iterator[dict[str, float]]:
    """Yield other initial strains of each spring, by address."""
    for parameter in scene.parameters:
        if parameter.path.endswith(STRAIN):
            values = (SHIFTED * parameter.value,) if parameter.value else FROM_NONE
            yield from ({parameter.path: value} for value in values)


def _depends_on_start(question: Question, study: SimulatedScene) -> bool:
    """Return whether the answer to a question depends on the initial motion."""
    return depends_on_start(question.query, study)


MATTERS: dict[Topic, Callable[[Question, SimulatedScene], bool]] = {
    "axes": _uses_axes,
    "slack": _slackens,
    "start": _depends_on_start,
}
"""By topic, whether a question has to do with it, given the motion that it is about."""
