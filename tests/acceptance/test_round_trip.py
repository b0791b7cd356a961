"""Tests that a prompt alone gives its answer: it contains every given, and means one scene and one question."""

import numpy as np
import pytest

from shared_items import SharedItems
from sim2reason.errors import TextError
from sim2reason.generation.item_search import sample
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.questions.prompt import FORMATS, parse_prompt
from sim2reason.text.prose import describe

ITEMS = [2, pytest.param(6, marks=pytest.mark.slow)]  # of each cell; benchmarks/round_trip.py takes 500 in all


@pytest.mark.parametrize("count", ITEMS)
@pytest.mark.parametrize("difficulty", DIFFICULTIES)
@pytest.mark.parametrize("recipe", RECIPES)
def test_the_answer_follows_from_the_text(recipe: str, difficulty: str, count: int, numeric_items: SharedItems) -> None:
    """The scene is rebuilt from the text, its hidden numbers are redrawn, and the question is answered again."""
    items = numeric_items.of((recipe, difficulty), count)
    assert len(items) == count
    for index, item in enumerate(items):
        understood = parse_prompt(item.prompt, np.random.default_rng(index))
        assert understood.answer == pytest.approx(item.answer.value, rel=0.01), item.prompt
        assert understood.query.kind == item.kind


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("What?", "does not say how to answer"),
        ("How far? Give your answer in m, to three significant figures, inside \\boxed{}.", "no question"),
    ],
)
def test_what_is_no_prompt_is_refused(text: str, says: str) -> None:
    with pytest.raises(TextError, match=says):
        parse_prompt(text)


def test_a_question_that_is_not_ours_is_refused() -> None:
    description = describe(sample("pulley", "easy", seed=31))
    with pytest.raises(TextError, match="no question is asked"):
        parse_prompt(f"{description.text} Why is the sky blue? {FORMATS[0].format(unit='m')}")
