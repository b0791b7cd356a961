import pytest

from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.closed_forms.tidying import tidied


def test_no_square_of_a_number_is_left_of_that_of_a_product_with_a_root() -> None:
    """(-ℓ √(k/m))² = ℓ² k/m."""
    length, stiffness, mass = map(Symbol, ("l", "k", "m"))
    found = tidied(Power(Number(-1.0) * length * Root(stiffness / mass), 2))
    assert found.latex() == (Power(length, 2) * (stiffness / mass)).latex()


def test_what_stands_above_and_below_goes() -> None:
    """½ m a² k/m = ½ a² k, and m (k/(m b)) = k/b."""
    mass, stiffness, way, other = map(Symbol, ("m", "k", "a", "b"))
    half = Number(0.5)
    assert (
        tidied(half * mass * Power(way, 2) * (stiffness / mass)).latex() == (half * Power(way, 2) * stiffness).latex()
    )
    assert tidied(mass * (stiffness / (mass * other))).latex() == (stiffness / other).latex()
    assert tidied(mass * (stiffness / other)).latex() == (mass * (stiffness / other)).latex()


def test_a_power_of_an_exponential_is_one_of_a_multiple() -> None:
    """(exp(−b t/m))² = exp(−2 b t/m), which nobody writes exp²(−b t/m)."""
    drag, time, mass = map(Symbol, ("b", "t", "m"))
    squared = Power(Call("exp", -(drag * time) / mass), 2)
    assert "exp^" not in squared.latex()
    found = tidied(squared)
    assert found.latex() == Call("exp", (-2.0 * drag * time) / mass).latex()
    at = {"b": 0.3, "t": 2.0, "m": 1.5}
    assert found.value(at) == pytest.approx(squared.value(at))
