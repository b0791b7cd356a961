"""Tests of renamed symbols in texts and formulas."""

import pytest

from sim2reason.solutions.algebra.evaluated import Chain, NumericFormula, NumericRoot
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.multipart.names import names_in_text, rename_in_formula, rename_in_text, rename_solution
from sim2reason.solutions.solution import Relation, Solution, Step

T, U = Symbol("t"), Symbol("t_1")


@pytest.mark.parametrize(
    ("text", "names", "found"),
    [
        (r"at t, $t = 2\ \text{s t}$", {"t": "t_1"}, r"at t, $t_1 = 2\ \text{s t}$"),
        (r"$t_1 = t_{\text{out}} + t$", {"t": "t_1", "t_1": "t_2"}, r"$t_2 = t_{\text{out}} + t_1$"),
        (r"$\frac{x_{A}}{x}$", {"x_A": "x_B", "x": "y"}, r"$\frac{x_B}{y}$"),
        (r"$a_x = \dot{v}_{x}$, $v = \dot{x}$", {"v_x": "v_{x,1}", "x": "y"}, r"$a_x = \dot{v}_{x,1}$, $v = \dot{y}$"),
        (r"$v'_{x,C} = v_{x,C}$", {"v'_{x,C}": "v''_{x,C}"}, r"$v''_{x,C} = v_{x,C}$"),
        (r"$\int_0^{\psi} d\vartheta$", {"d": "d_1", r"\psi": r"\psi_1"}, r"$\int_0^{\psi_1} d\vartheta$"),
        (r"$\operatorname{F}(\phi)$", {"F": "G", r"\phi": r"\phi_2"}, r"$\operatorname{F}(\phi_2)$"),
    ],
)
def test_only_whole_names_in_formulas_are_exchanged(text: str, names: dict[str, str], found: str) -> None:
    assert rename_in_text(text, names) == found
    assert rename_in_text(found, {new: old for old, new in names.items()}) in (text, text.replace("x_{A}", "x_A"))


def test_equations_are_written_as_they_are_with_the_new_names() -> None:
    """A thin space follows a name that ends in a subscript with a number."""
    relation = Relation(Symbol("s"), Symbol("p") * Symbol("t"), "law")
    assert rename_in_text("So $s = p t$.", {"p": "p_1"}, [relation]) == r"So $s = p_1\,t$."


@pytest.mark.parametrize(
    "held",
    [T * Number(2.0), NumericFormula(T, 3.0), NumericRoot(T * Symbol("u") - 1.0, "u", 0.3), Chain((("w", T * 2.0),))],
    ids=lambda held: type(held).__name__,
)
def test_formulas_keep_their_values(held: Expression) -> None:
    other = rename_in_formula(held, {"t": "t_1"})
    assert {*other.symbols()} == {"t_1"}
    assert other.value({"t_1": 3.0}) == held.value({"t": 3.0})


def test_a_solution_is_the_same_under_other_names() -> None:
    step = Step(0, "time", "It takes $t = 2 t_1$.", (Relation(T, Number(2.0) * U, "law"),), ("t",), ())
    solution = Solution("", (step,), {"t": 4.0, "t_1": 2.0}, "t", 4.0, stated=("t_1",))
    swapped = rename_solution(solution, {"t": "t_1", "t_1": "t"})
    assert (swapped.goal, swapped.stated, swapped.values) == ("t_1", ("t",), {"t_1": 4.0, "t": 2.0})
    assert swapped.steps[0].text == r"It takes $t_1 = 2 t$."
    assert rename_solution(swapped, {"t": "t_1", "t_1": "t"}).steps[0].relations == solution.steps[0].relations


def test_the_names_of_a_text_are_those_in_formulas() -> None:
    assert {"t", "v_x", r"\phi_1"} <= names_in_text(r"At s, $t = \dot{v}_{x} \sin\phi_1\ \text{m}$") - {"s", "m"}
    assert names_in_text("no $1 = 1$ name") == frozenset()
