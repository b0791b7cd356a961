"""Tests that shortened formulas keep their value, and that intermediate numbers are not taken for formulas."""

from dataclasses import replace
from math import acos, asin, atan, cos, isclose, pi, sin, tan

import pytest

from sim2reason.solutions.algebra.evaluated import NumericFormula, NumericRoot
from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Quotient, Sum, Symbol
from sim2reason.solutions.algebra.functions import PI, Absolute, Call, Function, Power, Root
from sim2reason.solutions.closed_forms import ClosedFormError, closed_form, combined_formula, is_too_complex
from sim2reason.solutions.closed_forms.rewriting import latex_length, shortest_form
from sim2reason.solutions.closed_forms.tidying import tidy
from sim2reason.solutions.solution import Relation, Solution, Step

a, b, c, t = (Symbol(name) for name in ("p", "q", "s", r"\theta"))
AT = {"p": 1.3, "q": 0.7, "s": 2.1, r"\theta": 0.4}
BESIDE = Root(Number(1.0) - Power(Call("sin", t) - b, 2))
FORMULAS: list[Expression] = [
    BESIDE * Root((BESIDE - Call("cos", t)) / (c - a * Power(BESIDE, 2))),  # before and after the cosine is met
    Quotient(a * b + a * c, a * b - a * c),
    Sum((Quotient(a, b), Quotient(b, a))),
    Root(Sum((Power(Product((a, Call("sin", t))), 2), Power(b, 2)))),
    Product((Root(a + b), Root(a + b), c)),
    Quotient(Root(a + b) * Root(a + b) * Root(a + b), a + b),
    Call("ln", Quotient(a * a, a * b)),
    Power(Quotient(a - c, b), 3),
    -Quotient(-a - b, c),
    Call("arctan", Quotient(a * Call("sin", t), a * Call("cos", t) + b)),
]


@pytest.mark.parametrize("held", FORMULAS, ids=lambda held: held.latex())
def test_what_is_rewritten_has_the_same_value_and_is_no_longer(held: Expression) -> None:
    found = shortest_form(held)
    assert isclose(found.value(AT).real, held.value(AT).real, rel_tol=1e-12)
    assert latex_length(found) <= latex_length(held)


def test_what_cancels_is_gone() -> None:
    assert shortest_form(Quotient(a * b + a * c, a * b)).latex() == r"\frac{q + s}{q}"
    assert shortest_form(Root(a + b) * Root(a + b)).latex() == "p + q"
    assert shortest_form(Quotient(a * a - b * b, a - b)).latex() == "p + q"


def test_squares_of_sine_and_cosine_add_up() -> None:
    squares = Power(Product((a, Call("sin", t))), 2) + Power(Product((a, Call("cos", t))), 2)
    assert shortest_form(Quotient(squares + b, c)).latex() == r"\frac{p^{2} + q}{s}"
    assert shortest_form(Root(squares)).latex() in (r"\sqrt{p^{2}}", "p")


def test_pi_and_constants_of_nature_stay_as_they_are() -> None:
    assert shortest_form(Quotient(Product((Number(2.0), PI, a, b)), b)).latex() == r"2\,\pi p"
    found = closed_form(
        replace(solution(("x", Symbol("G") * a)), constants={"G": Product((Number(4.0), Power(PI, 2)))})
    )
    assert found.expression.value(AT) == pytest.approx(4.0 * pi**2 * AT["p"])
    assert found.symbols == ("p",)


def solution(*definitions: tuple[str, Expression]) -> Solution:
    given = tuple(Relation(Symbol(name), Number(value), "given") for name, value in AT.items())
    steps = [Step(0, "givens", "", given, (), ())]
    for name, right in definitions:
        relation = Relation(Symbol(name), right, "result")
        steps.append(Step(len(steps), "work", "", (relation,), (name,), ()))
    return Solution("some", tuple(steps), AT, definitions[-1][0], 1.0, stated=("s",))


@pytest.mark.parametrize(
    ("held", "latex"),
    [
        (Power(-a - b, 2) + c, r"\left(p + q\right)^{2} + s"),
        (Power(-a - b, 3), r"\left(-p - q\right)^{3}"),
        (Root(Power(-a, 2) + b), r"\sqrt{p^{2} + q}"),
        (Absolute(-a - b), r"\left|p + q\right|"),
        (Call("cos", (-a) / b), r"\cos\left(\frac{p}{q}\right)"),
        (Call("sin", -(a / b)), r"-\sin\left(\frac{p}{q}\right)"),
        (Quotient(Number(2.0), Root(Quotient(a, b))), r"2\,\sqrt{\frac{q}{p}}"),
        (Quotient(a, Root(b)), r"\frac{p}{\sqrt{q}}"),
    ],
)
def test_signs_and_fractions_stand_where_one_would_write_them(held: Expression, latex: str) -> None:
    assert tidy(held).latex() == latex
    assert isclose(tidy(held).value(AT).real, held.value(AT).real, rel_tol=1e-12)


def test_names_are_put_in_until_only_what_is_given_stays() -> None:
    """With x = p q, y = x s, the result is y = p q d, where s is a number of the question called d."""
    found = closed_form(solution(("x", a * b), ("y", Symbol("x") * c)), ["d"])
    assert found.latex == "d p q"
    assert found.symbols == ("d", "p", "q")
    assert found.value({"p": 2.0, "q": 3.0, "d": 5.0}) == 30.0


def test_a_number_that_was_worked_out_stands_for_its_formula() -> None:
    assert closed_form(solution(("x", NumericFormula(a + b, 2.0) * c)), ["c"]).symbols == ("c", "p", "q")


@pytest.mark.parametrize(
    ("held", "why"),
    [
        (NumericRoot(a - Symbol("x"), "x", 1.3), "numerically"),
        (a * Number(0.12345), "no simple one"),
        (a * Symbol("unknown"), "comes from no formula"),
    ],
)
def test_there_is_no_formula_where_a_number_hides_one(held: Expression, why: str) -> None:
    with pytest.raises(ClosedFormError, match=why):
        closed_form(solution(("x", held)))


def test_a_formula_that_nobody_would_write_is_none() -> None:
    long = Sum(tuple(Quotient(Power(a, n), b + Power(c, n)) for n in range(1, 12)))
    with pytest.raises(ClosedFormError, match="characters"):
        closed_form(solution(("x", long)))


def test_what_has_many_roots_is_given_up_before_it_is_made_shorter() -> None:
    """Three independent roots do not cancel; two may, unless their formula is very long."""
    three = Sum(tuple(Quotient(Root(Power(a, n) + b), b + Power(c, n) + Power(t, n)) for n in range(2, 5)))
    assert not is_too_complex(three)
    assert is_too_complex(three * (three + c))
    assert not is_too_complex(Sum(tuple(Power(a, n) for n in range(200))))
    with pytest.raises(ClosedFormError, match="too many roots"):
        combined_formula(solution(("x", three * (three + c))))


def test_a_formula_that_grows_from_step_to_step_is_given_up() -> None:
    steps = [(f"x_{n}", Symbol(f"x_{n - 1}") * (Symbol(f"x_{n - 1}") + b)) for n in range(1, 9)]
    with pytest.raises(ClosedFormError, match="grows too long"):
        closed_form(solution(("x_0", a + c), *steps))


INVERSES: list[Function] = ["arcsin", "arccos", "arctan"]


@pytest.mark.parametrize("inverse", INVERSES)
@pytest.mark.parametrize("function", ["sin", "cos", "tan"])
def test_a_function_of_an_inverse_one_has_neither(function: Function, inverse: Function) -> None:
    """One of the identities is sin arccos x = √(1 − x²)."""
    found = closed_form(solution(("x", Call(function, Call(inverse, Quotient(b, c))))))
    assert "arc" not in found.latex
    ratio = AT["q"] / AT["s"]
    angle = {"arcsin": asin, "arccos": acos, "arctan": atan}[inverse](ratio)
    assert found.value(AT) == pytest.approx({"sin": sin, "cos": cos, "tan": tan}[function](angle), rel=1e-12)


def test_factors_are_found_without_a_general_method() -> None:
    """The expanded form of (p + q)² (s + θ) is linear in s."""
    whole = (a * a + 2.0 * a * b + b * b) * Number(1.0)
    held = Sum(tuple(term * other for term in whole.parts for other in (c, t)))
    assert shortest_form(held).latex() == r"\left(p + q\right)^{2} \left(\theta + s\right)"


def test_sizes_stand_where_something_is_negative_elsewhere() -> None:
    """Magnitudes are taken of √(p − q) s with p < q, and of −p with p > 0."""
    points = [{"p": 1.0, "q": 2.0, "s": 3.0}, {"p": 2.0, "q": 1.0, "s": 3.0}]
    found = closed_form(solution(("x", Root(a - b) * c))).of_sizes(points)
    assert found.latex == r"s \sqrt{\left|p - q\right|}"
    assert found.value({"p": 1.0, "q": 5.0, "s": 3.0}) == pytest.approx(6.0)
    assert closed_form(solution(("x", a - b))).of_sizes([AT]).latex == "p - q"
    assert closed_form(solution(("x", b - a))).of_sizes([AT, {"p": 1.0, "q": 2.0}]).latex == r"\left|q - p\right|"


def test_only_factors_of_both_signs_stand_between_bars() -> None:
    """In p (q − p)/(s − q), q < p throughout, and s − q has either sign."""
    points = [{"p": 3.0, "q": 2.0, "s": 5.0}, {"p": 3.0, "q": 2.0, "s": 1.0}]
    found = closed_form(solution(("x", a * (b - a) / (c - b)))).of_sizes(points)
    assert found.latex == r"\frac{p \left(p - q\right)}{\left|q - s\right|}"
    assert all(found.value(at) > 0.0 for at in points)
