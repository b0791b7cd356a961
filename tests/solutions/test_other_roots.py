"""Tests of the reasons why the second root of an equation is excluded."""

import pytest

from sim2reason.solutions.algebra.evaluated import Chain
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Power, Root
from sim2reason.solutions.other_roots import OtherRoots, Sides
from sim2reason.solutions.solution import Relation
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError, why_this_time

X, A = Symbol("x"), Symbol("a")


def told(
    value: float, found: Expression, others: list[float], written: list[Sides], *before: Relation, **known: float
) -> tuple[str, tuple[Relation, ...]]:
    """Return the sentence about the other root of x and the relations of that step."""
    book = SolutionBuilder()
    for name, number in {"x": value, **known}.items():
        book.set_value(name, number)
    step = book.begin_step("verify")
    step.relations += before
    step.add_text("Before.")
    step.close()
    step = book.begin_step("solve")
    OtherRoots(book, "x", lambda name: Chain(((name, X),))).write_exclusions(step, "x", found, others, written)
    step.close()
    last = book.steps[-1]
    return (last.text, last.relations) if len(book.steps) > 1 else ("", ())


def test_a_root_that_squaring_brought_in_does_not_satisfy_the_equation_before() -> None:
    """Squaring √(x + 6) = x gives x² − x = 6, which also has the root −2; with y = −x that root is positive."""
    shown = (Power(X, 2) + X, Number(6.0))
    text, relations = told(-3.0, X, [], [shown, (Root(Number(6.0) - X), -X)])
    assert text == "The other root, $2.0000$, does not satisfy the equation before it is squared."
    ((left, right),) = [(r.left, r.right) for r in relations if r.role == "exceeds"]
    assert left.value({}).real == pytest.approx(4.0)
    assert right == Number(0.0)


def test_a_negative_root_of_the_equation_that_is_shown_is_told() -> None:
    shown = (Power(X, 2) - X, Number(6.0))
    text, _ = told(3.0, X, [], [shown, (X, Root(X + Number(6.0)))])
    assert text == "The other root, $-2.0000$, is negative, but $x$ is positive."


def test_a_root_that_contradicts_a_comparison_is_told() -> None:
    """A stage that was stated to end before 4 s can't last for 5 s."""
    text, relations = told(3.0, X, [5.0], [(X, X)], Relation(A, X, "exceeds"), a=4.0)
    assert text == "With the other root, $5.0000$, $a$ would not be greater than $x$."
    assert [(r.left, r.right) for r in relations] == [(Number(5.0), A)]


@pytest.mark.parametrize(("bound", "told_of"), [(2.5, "would not be"), (3.5, "")])
def test_a_second_positive_root_is_excluded_by_a_comparison_or_nothing_is_solved(bound: float, told_of: str) -> None:
    """The roots of x² − 5 x = −6 are 2 and 3; b > x rules out 3 for b = 2.5, but not for b = 3.5."""
    book = SolutionBuilder()
    book.set_value("x", 2.0)
    book.set_value("b", bound)
    step = book.begin_step("verify")
    step.relations.append(Relation(Symbol("b"), X, "exceeds"))
    step.add_text("Before.")
    step.close()
    shown = (Power(X, 2) - Number(5.0) * X, Number(-6.0))
    step = book.begin_step("solve")
    OtherRoots(book, "x", lambda name: Chain(((name, X),))).write_exclusions(step, "x", X, [], [shown, shown])
    step.close()
    (check,) = book.checks.values()
    if told_of:
        check()
        assert told_of in book.steps[-1].text
    else:
        with pytest.raises(UnsolvedError, match="excludes the other root, 3"):
            check()


def test_nothing_is_said_where_there_is_no_other_root() -> None:
    assert told(3.0, X, [], [(Number(2.0) * X, Number(6.0))]) == ("", ())


@pytest.mark.parametrize(
    ("other", "said"), [(-1.0, "; the other root is negative"), (4.0, "; the other root is later")]
)
def test_of_two_times_the_first_positive_one_counts(other: float, said: str) -> None:
    book = SolutionBuilder()
    book.set_value("t", 2.0)
    step = book.begin_step("time")
    assert why_this_time(book, step, Symbol("t"), Number(other)) == said
    assert [relation.role for relation in step.relations] == ["exceeds"]


def test_another_positive_value_of_the_unknown_is_excluded_in_the_end() -> None:
    """With a = 4 − x, stated to be positive before, x is not 5 but 3."""
    book = SolutionBuilder()
    book.set_value("x", 3.0)
    book.set_value("a", 1.0)
    book.formulas["a"] = Number(4.0) - X
    step = book.begin_step("verify")
    step.add_text("Even then $a$ is positive.")
    step.relations.append(Relation(A, Number(0.0), "exceeds"))
    step.close()
    OtherRoots(book, "x", lambda name: Chain(((name, X),))).schedule_exclusion([5.0])
    for write in book.checks.values():
        write()
    assert book.steps[-1].text == "With the other root for $x$, $5.0000$, $a$ would not be positive."
    (relation,) = book.steps[-1].relations
    assert relation.left == Number(0.0)
    assert relation.right.value({}).real == pytest.approx(-1.0)
