"""Tests of the final algebra of symbolic answers, which expresses quantities by the given ones."""

from dataclasses import replace

import pytest

from sim2reason.solutions.algebra.expressions import Expression, Number, Quotient, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Power, Root
from sim2reason.solutions.closed_forms import closed_form
from sim2reason.solutions.closed_forms.symbolic_answers import with_final_algebra
from sim2reason.solutions.solution import Relation, Solution, Step

M, V, G, H = map(Symbol, ("m", "v", "g", "h"))


def solution(goal: str, **formulas: Expression) -> Solution:
    """Return a solution with a law for each name in order; all other symbols are given."""
    given = tuple(Relation(held, Number(2.0), "given") for held in (M, V, G, H))
    steps = [Step(0, "givens", "", given, (), ())]
    for number, (name, formula) in enumerate(formulas.items(), start=1):
        relation = Relation(Symbol(name), formula, "law")
        steps.append(Step(number, "law", f"{relation.latex()}.", (relation,), (name,), ()))
    values = {held.name: 2.0 for held in (M, V, G, H)}
    found = Solution("", tuple(steps), values, goal, answer=1.0)
    return replace(found, formula=closed_form(found).latex)


def test_what_an_answer_is_made_of_is_told() -> None:
    """For Q = Q1 + Q2 both terms are stated, with the speed inserted, which cancels."""
    square = Power(V, 2) + 2.0 * G * H
    found = with_final_algebra(
        solution("Q", w=square, one=M * Symbol("w"), two=0.5 * M * Symbol("w"), Q=Symbol("one") + Symbol("two"))
    )
    last = found.steps[-1]
    assert [relation.left.latex() for relation in last.relations] == ["one", "two", "Q"]
    assert all(set(relation.right.symbols()) <= {"m", "v", "g", "h"} for relation in last.relations)
    assert last.text.startswith("In terms of the given quantities, ")
    assert {relation.role for relation in last.relations} == {"derived"}


def test_one_quantity_alone_is_looked_through() -> None:
    """For U = |s| the terms of s are stated."""
    found = with_final_algebra(
        solution(
            "U", a=G * H, b=V * Symbol("a"), c=M * Symbol("a"), s=Symbol("b") + Symbol("c"), U=Absolute(Symbol("s"))
        )
    )
    assert [relation.left.latex() for relation in found.steps[-1].relations] == ["b", "c"]


def test_of_a_sum_below_a_fraction_the_sum_is_told() -> None:
    one, other = Quotient(M * Symbol("c"), H), Quotient(G * Symbol("c"), H)
    found = with_final_algebra(solution("t", c=V * H, a=one, b=other, t=Quotient(V, Symbol("a") + Symbol("b"))))
    relation, *_ = found.steps[-1].relations
    assert relation.left.latex() == "a + b"
    at = {"m": 0.3, "v": 1.7, "g": 2.2, "h": 0.9}
    assert relation.right.value(at) == pytest.approx((0.3 + 2.2) * 1.7)


def test_nothing_is_repeated_that_one_formula_gives() -> None:
    plain = solution("K", w=V * G, K=M * Symbol("w"))
    assert with_final_algebra(plain) == plain


def test_what_the_text_has_is_not_repeated() -> None:
    """A formula that an earlier step already states is omitted."""
    w, p = Symbol("w"), Symbol("p")
    held = solution("Q", w=Power(V, 2) + 2.0 * G * H, p=M * w, Q=Quotient(p, H * w))
    told = with_final_algebra(held).steps[-1]
    assert "p" in [relation.left.latex() for relation in told.relations]
    whole = next(relation for relation in told.relations if relation.left == p)
    combined = Step(len(held.steps), "combine", f"Combined, these equations give {whole.latex()}.", (), (), ())
    again = with_final_algebra(replace(held, steps=(*held.steps, combined)))
    assert whole.latex() not in " ".join(step.text for step in again.steps if step.kind == "ingredients")


def test_it_is_said_what_is_inserted_into_what_and_what_that_gives() -> None:
    """The example E = m g x + h (v² − (v + x)²) with x = (m g − v h) / h simplifies."""
    x = Symbol("x")
    energy = M * G * x + H * (Power(V, 2) - Power(V + x, 2))
    held = solution("E", x=Quotient(M * G - V * H, H), E=energy)
    last = with_final_algebra(held).steps[-1]
    assert "Inserting $x$ into the formula for $E$ gives $E = " in last.text
    assert last.text.endswith("which simplifies to the result.")
    (relation,) = last.relations
    at = {"m": 0.3, "v": 1.7, "g": 2.2, "h": 0.9}
    assert "x" not in relation.right.symbols()
    assert relation.right.value(at) == pytest.approx(energy.value({**at, "x": (0.3 * 2.2 - 1.7 * 0.9) / 0.9}))


def test_a_quantity_between_the_start_and_the_last_formula_is_told() -> None:
    """For K = m u² with u = h w and w = v s, s = √(v² + g h), w is stated too."""
    s, w, u = map(Symbol, ("s", "w", "u"))
    root = Power(V, 2) + G * H
    held = solution("K", s=Root(root), w=V * s, u=H * w, K=M * Power(u, 2) + M * root)
    told = [relation.left.latex() for relation in with_final_algebra(held).steps[-1].relations]
    assert told[:2] == ["w", "u"]


def test_a_product_in_another_order_is_no_simplification() -> None:
    held = solution("p", a=G * (M + H), p=Symbol("a") * V)
    assert with_final_algebra(held) == held
