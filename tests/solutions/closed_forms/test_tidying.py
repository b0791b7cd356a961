import pytest

from sim2reason.solutions.algebra.expressions import ONE, Expression, Number, Quotient, Symbol
from sim2reason.solutions.algebra.functions import PI, Absolute, Call, Pi, Power, Root
from sim2reason.solutions.closed_forms import ClosedForm
from sim2reason.solutions.closed_forms.tidying import tidy


def test_no_square_of_a_number_is_left_of_that_of_a_product_with_a_root() -> None:
    """The square is (-ℓ √(k/m))² = ℓ² k/m."""
    length, stiffness, mass = map(Symbol, ("l", "k", "m"))
    found = tidy(Power(Number(-1.0) * length * Root(stiffness / mass), 2))
    assert found.latex() == (Power(length, 2) * (stiffness / mass)).latex()


def test_what_stands_above_and_below_goes() -> None:
    """Common factors cancel: ½ m a² k/m = ½ a² k, and m (k/(m b)) = k/b."""
    mass, stiffness, way, other = map(Symbol, ("m", "k", "a", "b"))
    half = Number(0.5)
    assert tidy(half * mass * Power(way, 2) * (stiffness / mass)).latex() == (half * Power(way, 2) * stiffness).latex()
    assert tidy(mass * (stiffness / (mass * other))).latex() == (stiffness / other).latex()
    assert tidy(mass * (stiffness / other)).latex() == ((mass * stiffness) / other).latex()


def test_a_power_of_an_exponential_is_one_of_a_multiple() -> None:
    """The square (exp(−b t/m))² is written exp(−2 b t/m), not exp²(−b t/m)."""
    drag, time, mass = map(Symbol, ("b", "t", "m"))
    squared = Power(Call("exp", -(drag * time) / mass), 2)
    assert "exp^" not in squared.latex()
    found = tidy(squared)
    assert found.latex() == Call("exp", (-2.0 * drag * time) / mass).latex()
    at = {"b": 0.3, "t": 2.0, "m": 1.5}
    assert found.value(at) == pytest.approx(squared.value(at))


A, B, C, M = map(Symbol, ("a", "b", "c", "M"))


@pytest.mark.parametrize(
    ("held", "written"),
    [
        (2.0 * Root(Power(A, 3) / (4.0 * M)), r"\sqrt{\frac{a^{3}}{M}}"),
        (2.0 * Root(Power(Quotient(ONE, A - B), 3) / (4.0 * M)), r"\frac{1}{\sqrt{\left(a - b\right)^{3} M}}"),
        (2.0 * Pi() * Root(ONE / (4.0 * Power(Pi(), 2) * M)), r"\frac{1}{\sqrt{M}}"),
        (Root(Power(Pi(), 4) * M), r"\pi^{2} \sqrt{M}"),
        (Root(Pi() * M), r"\sqrt{\pi M}"),
        (-(A * ((B - C) / M)) * C, r"\frac{a c \left(c - b\right)}{M}"),
        (-((A - B) * C / M), r"\frac{\left(b - a\right) c}{M}"),
        (-((A + B) * C / M), r"-\frac{\left(a + b\right) c}{M}"),
        (Quotient(A * B, B * C), r"\frac{a}{c}"),
    ],
)
def test_no_number_stands_before_a_root_nor_a_sign_before_a_difference_that_takes_it(
    held: Expression, written: str
) -> None:
    found = tidy(held)
    assert found.latex() == written
    at = {"a": 0.7, "b": 0.4, "c": 1.3, "M": 2.1}
    assert found.value(at) == pytest.approx(held.value(at))


def test_two_sums_that_are_negative_are_reversed_together() -> None:
    """For example (5 µ cos θ − 2 sin θ)/(µ cos θ − sin θ) is positive if both sums are negative."""
    points = [{"a": 0.2, "b": 0.4, "c": 1.3, "M": 2.1}, {"a": 0.1, "b": 0.5, "c": 1.9, "M": 2.1}]
    held = Quotient(M * (A - B), A - C)
    found = ClosedForm(held, held.latex(), ("M", "a", "b", "c")).with_positive_factors(points)
    assert found.latex == r"\frac{M \left(b - a\right)}{c - a}"
    assert found.value(points[0]) == pytest.approx(held.value(points[0]))
    alone = Quotient(M * (A - B), C)
    assert ClosedForm(alone, alone.latex(), ("M",)).with_positive_factors(points).expression == alone


def test_multiples_of_pi_are_no_part_of_the_argument_of_a_cosine() -> None:
    angle = Symbol("a") * Symbol("t")
    assert tidy(Absolute(Call("cos", angle - PI))).latex() == r"\left|\cos\left(a t\right)\right|"
    assert tidy(Call("cos", angle - 2.0 * PI)).latex() == r"\cos\left(a t\right)"
    assert tidy(Call("sin", angle + PI)).latex() == r"-\sin\left(a t\right)"
