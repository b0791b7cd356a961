"""The last algebra of an answer in symbols: what the quantities in its formula come to, in terms of what is given."""

from dataclasses import replace

import pytest

from sim2reason.solutions.algebra.expressions import Expression, Number, Quotient, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Power
from sim2reason.solutions.closed_forms.ingredients import with_ingredients
from sim2reason.solutions.solution import Relation, Solution, Step

M, V, G, H = map(Symbol, ("m", "v", "g", "h"))


def solution(goal: str, **formulas: Expression) -> Solution:
    """A solution with a law for each name, in order, all of whose other symbols are given."""
    given = tuple(Relation(held, Number(2.0), "given") for held in (M, V, G, H))
    steps = [Step(0, "givens", "", given, (), ())]
    for number, (name, formula) in enumerate(formulas.items(), start=1):
        relation = Relation(Symbol(name), formula, "law")
        steps.append(Step(number, "law", f"{relation.latex()}.", (relation,), (name,), ()))
    return Solution("", tuple(steps), {}, goal, answer=1.0, formula="x")


def test_what_an_answer_is_made_of_is_told() -> None:
    """Of Q = Q1 + Q2 each, with the speed put in, where it cancels."""
    square = Power(V, 2) + 2.0 * G * H
    found = with_ingredients(
        solution("Q", w=square, one=M * Symbol("w"), two=0.5 * M * Symbol("w"), Q=Symbol("one") + Symbol("two"))
    )
    last = found.steps[-1]
    assert [relation.left.latex() for relation in last.relations] == ["one", "two"]
    assert all(set(relation.right.symbols()) <= {"m", "v", "g", "h"} for relation in last.relations)
    assert last.text.startswith("In terms of the given quantities, ")
    assert {relation.role for relation in last.relations} == {"derived"}


def test_one_quantity_alone_is_looked_through() -> None:
    """Of U = |s| what s is made of."""
    found = with_ingredients(
        solution(
            "U", a=G * H, b=V * Symbol("a"), c=M * Symbol("a"), s=Symbol("b") + Symbol("c"), U=Absolute(Symbol("s"))
        )
    )
    assert [relation.left.latex() for relation in found.steps[-1].relations] == ["b", "c"]


def test_of_a_sum_below_a_fraction_the_sum_is_told() -> None:
    one, other = Quotient(M * Symbol("c"), H), Quotient(G * Symbol("c"), H)
    found = with_ingredients(solution("t", c=V * H, a=one, b=other, t=Quotient(V, Symbol("a") + Symbol("b"))))
    (relation,) = found.steps[-1].relations
    assert relation.left.latex() == "a + b"
    at = {"m": 0.3, "v": 1.7, "g": 2.2, "h": 0.9}
    assert relation.right.value(at) == pytest.approx((0.3 + 2.2) * 1.7)


def test_nothing_is_repeated_that_one_formula_gives() -> None:
    plain = solution("K", w=V * G, K=M * Symbol("w"))
    assert with_ingredients(plain) == plain


def test_what_the_text_has_is_not_repeated() -> None:
    """A comparison puts all steps together itself before it changes a number."""
    w, p = Symbol("w"), Symbol("p")
    held = solution("Q", w=Power(V, 2) + 2.0 * G * H, p=M * w, Q=Quotient(p, H * w))
    told = with_ingredients(held).steps[-1]
    assert "p" in [relation.left.latex() for relation in told.relations]
    whole = next(relation for relation in told.relations if relation.left == p)
    combined = Step(len(held.steps), "combine", f"Combined, these equations give {whole.latex()}.", (), (), ())
    again = with_ingredients(replace(held, steps=(*held.steps, combined)))
    assert whole.latex() not in " ".join(step.text for step in again.steps if step.kind == "ingredients")
