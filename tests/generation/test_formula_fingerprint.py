"""Tests that formulas are equal by their values, not by their text."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim2reason.generation.splits import fingerprint

MASSES = {"m_A": "kg", "m_B": "kg", "m_C": "kg", "g": "m/s^2", "h": "m", r"\theta": "rad", "v": "m/s", r"\mu": ""}


def of(latex: str, **renamed: str) -> str:
    units = {renamed.get(name, name): unit for name, unit in MASSES.items()}
    return fingerprint(latex, tuple(units), tuple(units.values()))


SAME = [
    (r"\sqrt{2 g h}", r"\sqrt{g h}"),
    (r"\frac{m_A g}{m_A + m_B}", r"-\frac{m_B g}{m_A + m_B}"),
    (r"\frac{\left(m_A - m_B\right) g}{m_A + m_B}", r"g \frac{m_C - m_A}{m_A + m_C}"),
    (r"\frac{\left|m_A - m_B\right| g}{m_A + m_B}", r"3 g \left|\frac{m_C - m_A}{m_A + m_C}\right|"),
    (r"g \sin\theta", r"g \sqrt{1 - \cos^{2}\theta}"),
    (r"\sqrt{v^{2} - 2 g h}", r"2 \sqrt{\frac{v^{2}}{2} - g h}"),
    (r"v^{2} \sin 2\theta / g", r"\frac{v^{2} \sin\theta \cos\theta}{g}"),
]
OTHER = [
    (r"\sqrt{2 g h}", r"\sqrt{2 g h + v^{2}}"),
    (r"\frac{m_A g}{m_A + m_B}", r"\frac{m_A g}{m_A + m_B + m_C}"),
    (r"\frac{\left(m_A - m_B\right) g}{m_A + m_B}", r"\frac{m_A m_B g}{m_A + m_B}"),
    (r"\frac{\left|m_A - m_B\right| g}{m_A + m_B}", r"\frac{\left(m_A - m_B\right) g}{m_A + m_B}"),
    (r"g \left(\sin\theta - \mu \cos\theta\right)", r"g \left(\sin\theta + \mu \cos\theta\right)"),
    (r"g \left(\sin\theta - \mu \cos\theta\right)", r"g \left(\sin\theta - 2 \mu \cos\theta\right)"),
    (r"m_A g", r"m_A v"),
    (r"\frac{m_A}{m_B} + \frac{m_B}{m_C}", r"\frac{m_A}{m_B} + \frac{m_C}{m_B}"),
    (r"v", r"h"),
]


@pytest.mark.parametrize(("one", "other"), SAME)
def test_a_factor_a_sign_and_names_make_no_other_formula(one: str, other: str) -> None:
    assert of(one) == of(other)


@pytest.mark.parametrize(("one", "other"), OTHER)
def test_what_differs_at_common_numbers_is_another(one: str, other: str) -> None:
    assert of(one) != of(other)


@settings(max_examples=40)
@given(st.permutations(["m_A", "m_B", "m_C"]), st.sampled_from([-3.0, 0.25, 2.0]), st.data())
def test_it_is_the_same_whatever_symbols_are_called(names: list[str], factor: float, data: st.DataObject) -> None:
    """Sums of products of powers are tested."""
    powers = st.tuples(*[st.integers(-2, 2)] * 5)
    terms = data.draw(st.lists(st.tuples(st.integers(1, 4), powers), min_size=1, max_size=3))

    def formula(masses: list[str], times: float) -> str:
        symbols = *masses, "g", "h"
        each = [
            f"{times * size} " + " ".join(f"{name}^{{{n}}}" for name, n in zip(symbols, held, strict=True))
            for size, held in terms
        ]
        return " + ".join(each).replace("+ -", "- ")

    assert of(formula(["m_A", "m_B", "m_C"], 1.0)) == of(formula(names, factor))


def test_where_a_formula_has_no_values_its_text_counts() -> None:
    assert of(r"\arcsin\left(2 + m_A^{2}\right)") != of(r"\arcsin\left(2 + m_B^{2}\right)")
    assert of("no formula") == "no formula"
