"""Tests of solutions of several parts, and of problems with options."""

from dataclasses import replace

import pytest

from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.multipart.recall import recall_results
from sim2reason.solutions.solution import Relation, Solution, Step, choice_solution


def test_the_letter_of_an_option_stands_in_a_paragraph_of_its_own() -> None:
    text = choice_solution(Solution("", goal="v", answer=2.0, values={"v": 2.0}), "C").text
    assert text.split("\n\n") == [r"Answer: $v \approx 2.00$.", r"That is option $\boxed{\text{C}}$."]


def displaced(v: float) -> Solution:
    """Return a solution for the displacement x = v/2 of B relative to A."""
    x, speed = Symbol("x"), Symbol("v")
    steps = (
        Step(0, "givens", f"Given: $v = {v}$.", (Relation(speed, Number(v), "given"),), ("v",), ()),
        Step(1, "names", "Let $x$ be the displacement of B relative to A.", (), (), ()),
        Step(2, "place", "It is $x = v/2$.", (Relation(x, speed / Number(2.0), "law"),), ("x",), (0,)),
    )
    return Solution("", steps, {"v": v, "x": v / 2.0}, "x", v / 2.0)


def compressed(v: float) -> Solution:
    """Return a solution for the compression e = -x."""
    found, e = displaced(v), Symbol("e")
    step = Step(3, "answer", "The compression is $e = -x$.", (Relation(e, -Symbol("x"), "law"),), ("e",), (2,))
    values = {**found.values, "e": -v / 2.0}
    return replace(found, steps=(*found.steps, step), values=values, goal="e", answer=-v / 2.0)


def moved(v: float) -> Solution:
    """Return a solution for the displacement y = 3 x."""
    found, y = displaced(v), Symbol("y")
    step = Step(3, "answer", "So $y = 3 x$.", (Relation(y, Number(3.0) * Symbol("x"), "law"),), ("y",), (2,))
    return replace(found, steps=(*found.steps, step), values={**found.values, "y": 1.5 * v}, goal="y", answer=1.5 * v)


def test_a_later_part_does_not_call_a_compression_a_displacement() -> None:
    """The x of the later part is positive and equals the compression found in the earlier part, not its x."""
    opposite = recall_results(moved(2.0), [("a", compressed(-2.0))], whole=True)
    assert "From part (a)" not in opposite.text


@pytest.mark.parametrize("whole", [False, True])
def test_a_later_part_defines_what_it_recalls_unless_that_was_said(whole: bool) -> None:
    text = recall_results(moved(2.0), [("a", displaced(2.0))], whole=whole).text
    assert "From part (a), $x = 1.0000$." in text
    assert ("Let $x$ be the displacement" in text) == (not whole)
