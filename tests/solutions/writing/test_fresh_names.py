"""Tests of names that are still free."""

from itertools import islice

import pytest

from sim2reason.grading.tokens import canonical, tokenize
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.writing.notation import NameAllocator, numbered_names, with_primes


@pytest.mark.parametrize(
    ("name", "following"),
    [
        ("t", ["t_1", "t_2"]),
        ("m_1", ["m_2", "m_3"]),
        (r"\omega_0", [r"\omega_1", r"\omega_2"]),
        ("s_x", ["s_{x,1}", "s_{x,2}"]),
        ("s_{x,1}", ["s_{x,2}", "s_{x,3}"]),
        ("a_{1,2}", ["a_{1,2,1}", "a_{1,2,2}"]),
        (r"u_{\text{n}}", [r"u_{\text{n},1}", r"u_{\text{n},2}"]),
    ],
)
def test_the_next_number_follows_without_a_second_one_below(name: str, following: list[str]) -> None:
    assert [*islice(numbered_names(name), 2)] == following


def test_a_name_is_given_once() -> None:
    names = NameAllocator()
    names.reserve("m_0", "m_1")
    assert [names.fresh("m", "1").name for _ in range(2)] == ["m_2", "m_3"]
    assert names.fresh("m").name == "m"


def test_values_after_impacts_have_primes() -> None:
    names = NameAllocator()
    names.reserve("v_{x,C}")
    found = [names.name_after_impact("v", "x,C").name for _ in range(5)]
    assert found == ["v'_{x,C}", "v''_{x,C}", "v'''_{x,C}", "v'_{x,C,1}", "v'_{x,C,2}"]
    assert {canonical(name) for name in found} == {name.replace("{", "").replace("}", "") for name in found}


def test_a_power_of_a_primed_name_is_no_double_superscript() -> None:
    assert Power(Symbol(with_primes("v_A")), 2).latex() == "{v'_A}^{2}"
    assert Power(Symbol("v_A"), 2).latex() == "v_A^{2}"


def test_primes_belong_to_names_that_a_table_has() -> None:
    """Names outside the table have no primes, which might denote a derivative there."""
    assert [token.text for token in tokenize("v'_A + v", {"v'_A", "v"})] == ["v'_A", "+", "v"]
    assert [token.kind for token in tokenize("v' + v", {"v"})] == ["symbol", "mark", "plus", "symbol"]
