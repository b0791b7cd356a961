"""Tests of multiple choice: one right option, all distinct, formatted alike, in an order set by the id alone."""

from collections import Counter
from itertools import pairwise
from math import isclose
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from sim2reason import rewards
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.exports import EXPORTS, RowPosition
from sim2reason.generation.item import Answer, Distractor, Item
from sim2reason.generation.options import OPTION_RTOL, REQUIRED_DISTRACTORS, item_options, values
from sim2reason.grading import number
from sim2reason.questions.prompt_formats import LETTERS, ChoicePrompt, format_numbers

CHOICE, HERE = EXPORTS["multiple-choice"], RowPosition("train", 0)
NUMBERS = st.floats(1e-8, 1e8).flatmap(lambda x: st.sampled_from((x, -x)))


def value_of(text: str) -> float:
    """Return the number of an option without its unit."""
    plain = text.removesuffix(" N").replace("\N{MINUS SIGN}", "-")
    return float(plain.replace(" × 10^", "e"))


def told_options(item: Item) -> dict[str, Distractor | None] | None:
    """Return the options of an item by their texts."""
    chosen = item_options(item)
    if chosen is None:
        return None
    told = ChoicePrompt.of("", values(item.answer, chosen), item.answer.unit).options
    return dict(zip(told, chosen, strict=True))


def template(problems: Path) -> Item:
    return next(item for item in Dataset(problems) if item.answer.unit == "N" and item.answer.formula is None)


def test_each_row_has_one_right_letter_and_its_reasons(problems: Path) -> None:
    found = [row for item in Dataset(problems) if (row := CHOICE.row(item, HERE)) is not None]
    assert len(found) > 20
    for row in found:
        assert REQUIRED_DISTRACTORS < len(row["choices"]) <= len(LETTERS)
        assert LETTERS[row["label"]] == row["answer"]
        assert [not reason for reason in row["reasons"]] == [n == row["label"] for n in range(len(row["choices"]))]
        for letter in LETTERS[: len(row["choices"])]:
            paid = rewards.score(row["ground_truth"], rf"\boxed{{{letter}}}").reward
            assert paid == (letter == row["answer"])
        (message,) = row["prompt"]
        assert message["content"].startswith(row["question"])
        assert message["content"].count("boxed") == 1
    assert {len(row["choices"]) for row in found} == {4, 5}


def test_formulas_and_items_with_few_wrong_answers_are_left_out(problems: Path) -> None:
    for item in Dataset(problems):
        if item.answer.formula is not None or len(item.distractors) < REQUIRED_DISTRACTORS:
            assert CHOICE.row(item, HERE) is None


@given(value=NUMBERS, factors=st.lists(st.floats(-30.0, 30.0), min_size=3, max_size=9), name=st.text(max_size=9))
def test_options_are_apart_and_only_the_right_one_passes(
    problems: Path, value: float, factors: list[float], name: str
) -> None:
    wrong = tuple(Distractor(value=value * f, simplification="x", reason="X.") for f in factors if abs(f - 1) > 0.05)
    changes = {"id": name, "answer": Answer(value=value, unit="N"), "distractors": wrong}
    told = told_options(template(problems).model_copy(update=changes))
    if told is None:
        return
    assert list(told.values()).count(None) == 1
    rewarded = [number(rf"\boxed{{{text}}}", value, "N").reward for text in told]
    assert rewarded == [float(slip is None) for slip in told.values()]
    numbers = sorted(map(value_of, told))
    assert all(abs(a - b) > OPTION_RTOL * max(abs(a), abs(b)) for a, b in pairwise(numbers))


@given(st.lists(NUMBERS, min_size=1, max_size=5))
def test_numbers_are_told_in_three_digits_and_in_one_style(numbers: list[float]) -> None:
    texts = format_numbers(numbers)
    assert len({"10^" in text for text in texts}) == 1
    for value, text in zip(numbers, texts, strict=True):
        assert isclose(value_of(text), value, rel_tol=5.001e-3)


def test_styles() -> None:
    assert format_numbers([3.0, 12.0, 7.0]) == ["3", "12", "7"]
    assert format_numbers([4.9, 12.345, 0.5]) == ["4.90", "12.3", "0.500"]
    assert format_numbers([9.999, 10.0]) == ["10.0", "10.0"]
    assert format_numbers([12345.0, -0.00123]) == ["12300", "-0.00123"]
    assert format_numbers([123456.0, 2.5]) == ["1.23 × 10^5", "2.50 × 10^0"]


def test_no_letter_is_right_more_often_than_others(problems: Path) -> None:
    """Among 600 items each of five letters is right 120 times on average; five standard deviations are 49."""
    item = next(item for item in Dataset(problems) if (row := CHOICE.row(item, HERE)) and len(row["choices"]) == 5)
    rows = [CHOICE.row(item.model_copy(update={"id": f"item-{n}"}), HERE) for n in range(600)]
    counts = Counter(row["answer"] for row in rows if row)
    assert set(counts) == set(LETTERS)
    assert all(71 < count < 169 for count in counts.values())
