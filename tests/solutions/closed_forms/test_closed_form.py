"""Tests of the answers of solutions as closed-form formulas."""

from sim2reason.datasets.items import item


def test_a_modulus_stays_where_the_sign_of_what_is_given_is_not_told() -> None:
    """The distance of a block from its start depends on velocities along x, which may be negative."""
    found = item(recipe="collision", difficulty="easy", mode="symbolic", seed=301929, index=0)
    assert found.answer.formula is not None
    assert found.answer.formula.latex.startswith(r"\left|")
