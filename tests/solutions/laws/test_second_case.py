"""Tests of comparisons of two cases: the second case doesn't derive the laws of the first again."""

import re

import pytest

from sim2reason.solutions import solve
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import words
from worked import settings_of, solution_text

LONGEST = 170  # words of a solution to an easy problem, about 20 of which say that strings stay taut


@pytest.mark.parametrize(("recipe", "index"), [("pulley", 4), ("box", 5)])
def test_the_second_case_names_what_is_new_and_sets_up_no_law_again(recipe: str, index: int) -> None:
    (setting,) = settings_of(f"{recipe}-easy-numeric-77-{index}-comparison")
    found = solve(setting)
    assert found.strategy == "comparison of two cases"
    text = found.text
    assert re.search(r"The same laws hold, with \$\w+_\{[^}]*\\text\{new\}\}\$ for \$", text)
    assert " and $a_" in text or ", $a_" in text
    assert text.count("(1) ") == 1 + text.count("(1) +") + text.count("(1) −")
    assert not read(text).unread
    assert not read(text).broken
    assert words(text) <= LONGEST + (45 if recipe == "pulley" else 0)  # there each case has two unknowns and two ways


def test_what_the_changed_number_does_not_affect_is_not_computed_again() -> None:
    """The acceleration is independent of the speed and the time is the same; only the turning is checked again."""
    text = solution_text("rolling-easy-numeric-77-2-comparison")
    assert "t_1" not in text
    assert "a_1" not in text
    assert "The same laws hold" not in text
    after = text.split(r"With $v$ doubled", 1)[1]
    assert r"After the time $t$, $s_2 = v_{\text{new}} t + \tfrac{1}{2} a t^{2} = 2.0661\ \text{m}$." in after
    late = r"$t_{\text{turn},1} = -\frac{v_{\text{new}}}{a} = 1.6707\ \text{s}$, which is more than $t$"
    assert f"It would turn back only after {late}, so this is the distance." in after
    assert not read(text).broken


def test_a_sum_of_equations_begins_with_one_that_is_added() -> None:
    text = solution_text("pulley-easy-numeric-77-4-comparison")
    assert "(4) − 2·(3), with (1): " in text
    assert "-2·" not in text
