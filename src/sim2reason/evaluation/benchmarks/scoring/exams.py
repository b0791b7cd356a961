"""Scoring rules of the exam benchmarks HiPhO, JEEBench and OlympiadBench."""

import re
from collections.abc import Mapping
from fractions import Fraction
from typing import Final, NamedTuple, cast

from pydantic import JsonValue

from sim2reason.evaluation.benchmarks.scoring import SCORINGS, Award, Reference, Scoring
from sim2reason.evaluation.benchmarks.scoring.answers import (
    chosen,
    equal_expressions,
    equivalent_equations,
    find_boxes,
    has_perfect_matching,
    is_equation,
    parts,
    read,
    same_text,
    unboxed_options,
    unit_or_none,
    value_name,
    wrap_in_box,
)
from sim2reason.grading import number

__all__ = ["HiPhO", "JEEBench", "OlympiadBench", "expected_parts"]

HIPHO_RTOL = 0.05


class HiPhO(Scoring):
    """Scoring by the points of each question of a problem; the last boxes are the answers, in order."""

    def award(self, response: str, reference: Reference) -> Award:
        """Return the award from the reference's `parts`, each with `answer`, `unit` and `points`."""
        wanted = cast("list[Mapping[str, JsonValue]]", reference["parts"])
        contents = find_boxes(response)[-len(wanted) :]
        if not contents:
            return Award.unreadable("there is no box")
        if len(contents) < len(wanted):
            return Award(0.0, parsed=", ".join(contents), why=f"{len(contents)} boxes where {len(wanted)} are asked")
        worth = [float(cast("float", part["points"])) for part in wanted]
        good = [_right(part, submitted) for part, submitted in zip(wanted, contents, strict=True)]
        earned = sum(points for points, right in zip(worth, good, strict=True) if right) / sum(worth)
        return Award(earned, parsed=", ".join(contents), why=f"right: {sum(good)} of {len(good)}")


def _right(part: Mapping[str, JsonValue], submitted: str) -> bool:
    answer, unit = str(part["answer"]), unit_or_none(part.get("unit"))
    if same_text(answer, submitted):
        return True
    if is_equation(answer):
        return bool(equivalent_equations(answer, submitted))
    value = read(answer, unit)
    if value is not None:
        return number(wrap_in_box(submitted), value, unit, tolerance=HIPHO_RTOL).reward == 1.0
    return bool(equal_expressions(answer, submitted))


SCORINGS.add("hipho", HiPhO())


WITHIN = Fraction(1, 100)
PARTIAL_POINTS = 0.25
JEEBENCH_ROUNDING = Fraction(1, 10**9)  # tolerance of floating-point numbers from fractions and roots
ONE, SEVERAL, INTEGER, NUMERIC = "MCQ", "MCQ(multiple)", "Integer", "Numeric"
TYPES = ONE, SEVERAL, INTEGER, NUMERIC


class JEEBench(Scoring):
    """Scoring by JEEBench's own rule for its four types of questions, with partial credit."""

    def award(self, response: str, reference: Reference) -> Award:
        """Return the award from the reference's `type` and `answer`."""
        answer = str(reference["answer"])
        if reference["type"] in {ONE, SEVERAL}:
            return _options(response, frozenset(answer), partial=reference["type"] == SEVERAL)
        return _number(response, answer, exact=reference["type"] == INTEGER)


def _options(response: str, right: frozenset[str], *, partial: bool) -> Award:
    contents = find_boxes(response)
    submitted = chosen(contents[-1]) if contents else unboxed_options(response)
    if submitted is None:
        return Award.unreadable("no options in the box" if contents else "no box and no answer in words")
    named = "".join(sorted(submitted))
    if submitted == right:
        return Award(1.0, parsed=named)
    if partial and submitted <= right:
        return Award(
            PARTIAL_POINTS * len(submitted),
            parsed=named,
            why=f"{len(submitted)} of {len(right)} right options, none wrong",
        )
    return Award(0.0, parsed=named, why=f"the right options are {''.join(sorted(right))}")


def _number(response: str, answer: str, *, exact: bool) -> Award:
    contents = find_boxes(response)
    score = number(wrap_in_box(contents[-1]) if contents else response, float(answer), lenient=True)
    if not isinstance(score.parsed, float):
        return Award.unreadable(score.why)
    # Decimals as they are written: in floats 0.76 is farther than 0.01 from 0.75.
    submitted, right = Fraction(repr(score.parsed)), Fraction(answer)
    good = abs(submitted - right) <= (JEEBENCH_ROUNDING * max(1, abs(right)) if exact else WITHIN + JEEBENCH_ROUNDING)
    return Award.all_or_nothing(good, f"{score.parsed:g}", "" if good else f"the right number is {answer}")


SCORINGS.add("jeebench", JEEBench())


DEFAULT_ERROR: Final = 1e-8
ERROR_FACTOR: Final = 1.01  # factor on the error, as published
DEFAULT_RTOL: Final = 0.01  # relative tolerance where an item states no error
OLYMPIADBENCH_ROUNDING: Final = 1e-12  # relative, of floats
MAX_ANSWERS: Final = 12  # answers to one problem
_PERCENT: Final = re.compile(r"%|(?<![A-Za-z])per ?cent", re.IGNORECASE)
_CALLED: Final = re.compile(r"^[^=]*=\s*(?=[(\[])|^.*\\in(?![A-Za-z])\s*")
_SIZE: Final = re.compile(r"\\(?:left|right)(?![A-Za-z])")
_CUP: Final = re.compile(r"\\cup(?![A-Za-z])|∪")


class _ExpectedAnswer(NamedTuple):
    """One correct answer with its error and unit."""

    text: str
    error: float | None
    """Absolute; None where the item says none."""
    unit: str | None
    percent: bool
    """Whether it is in per cent."""
    alone: bool
    """Whether it is the only one, so that its name tells nothing."""


class OlympiadBench(Scoring):
    """Scoring by OlympiadBench's own rule: numbers within an absolute error, everything else by equality."""

    def award(self, response: str, reference: Reference) -> Award:
        """Return the award from the reference's `answer`, `unit` and `error`, as texts of the file."""
        right = expected_parts(reference)
        contents = find_boxes(response)
        if not contents:
            return Award.unreadable("there is no box")
        submitted = _said(contents, len(right))
        shown = ", ".join(submitted)
        if len(submitted) != len(right):
            return Award(0.0, parsed=shown, why=f"{len(submitted)} answers where {len(right)} are asked")
        good = has_perfect_matching(right, submitted, _is_equal)
        return Award.all_or_nothing(good, shown, "" if good else f"the answer is {reference['answer']}")


def expected_parts(reference: Reference) -> list[_ExpectedAnswer]:
    """Return the correct answers, each with its own error and unit."""
    answers = _signs(parts(str(reference["answer"])))
    errors = _spread(reference.get("error"), len(answers))
    units = _spread(reference.get("unit"), len(answers))
    return [
        _ExpectedAnswer(
            text,
            float(error) if error else None,
            unit_or_none(unit),
            percent=_PERCENT.search(f"{text} {unit}") is not None,
            alone=len(answers) == 1,
        )
        for text, error, unit in zip(answers, errors, units, strict=True)
    ]


def _spread(text: object, count: int) -> list[str]:
    """Return one entry of a comma-separated text per answer; a single entry is repeated for all answers."""
    entries = [part.strip() for part in text.split(",")] if isinstance(text, str) else [""]
    return entries if len(entries) == count else entries[:1] * count


def _said(contents: list[str], count: int) -> list[str]:
    """Return the answers in the last box, or in as many last boxes as there are correct answers."""
    last = _signs(parts(contents[-1]))
    separated = _signs(parts(contents[-1], thousands=False))
    several = _signs([part for content in contents[-count:] for part in parts(content)])
    return next((answers for answers in (last, separated, several) if len(answers) == count), last[: MAX_ANSWERS + 1])


def _signs(answers: list[str]) -> list[str]:
    """Return the answers with each ± replaced by two answers, one with plus and one with minus."""
    return [text for answer in answers for text in _two(answer)]


def _two(answer: str) -> tuple[str, ...]:
    text = answer.replace("±", r"\pm")
    return (text.replace(r"\pm", "+"), text.replace(r"\pm", "-")) if r"\pm" in text else (answer,)


def _is_equal(right: _ExpectedAnswer, submitted: str) -> bool:
    if same_text(right.text, submitted):
        return True
    ours, theirs = value_name(right.text), value_name(submitted)
    if ours and theirs and not right.alone and not same_text(ours, theirs):
        return False
    one, other = (_CALLED.sub("", _SIZE.sub("", text)).strip() for text in (right.text, submitted))
    if _is_list(one):
        return _is_list(other) and _intervals(one, other, right)
    if is_equation(right.text):
        return bool(equivalent_equations(right.text, submitted))
    value = read(right.text, right.unit)
    return _near(right, value, submitted) if value is not None else bool(equal_expressions(right.text, submitted))


def _near(right: _ExpectedAnswer, value: float, submitted: str) -> bool:
    """Return whether a value is within the error; a fraction may replace a percentage."""
    submitted_value = read(submitted, right.unit, expected=value)
    if submitted_value is None:
        return False
    if "%" in right.text:
        value *= 100.0  # it was read as a share, and its error is in per cent
    error = min(DEFAULT_ERROR, DEFAULT_RTOL * abs(value)) if right.error is None and value else right.error or 0.0
    scales = (1.0, 100.0) if right.percent else (1.0,)
    return any(
        abs(submitted_value * scale - value) <= ERROR_FACTOR * error + OLYMPIADBENCH_ROUNDING * abs(value)
        for scale in scales
    )


def _is_list(text: str) -> bool:
    """Return whether an answer is an interval, a union of them, or a tuple."""
    return bool(text) and text[0] in "([" and text[-1] in ")]" and all(len(parts(p[1:-1])) > 1 for p in _pieces(text))


def _pieces(text: str) -> list[str]:
    return [piece.strip() for piece in _CUP.split(text) if piece.strip()]


def _intervals(one: str, other: str, right: _ExpectedAnswer) -> bool:
    """Return whether two intervals have the same brackets and equal ends."""
    ours, theirs = _pieces(one), _pieces(other)
    return len(ours) == len(theirs) and all(
        (a[0], a[-1]) == (b[0], b[-1]) and _ends(parts(a[1:-1]), parts(b[1:-1]), right)
        for a, b in zip(ours, theirs, strict=True)
    )


def _ends(ours: list[str], theirs: list[str], right: _ExpectedAnswer) -> bool:
    return len(ours) == len(theirs) and all(
        _is_equal(right._replace(text=a), b) for a, b in zip(ours, theirs, strict=True)
    )


SCORINGS.add("olympiadbench", OlympiadBench())
