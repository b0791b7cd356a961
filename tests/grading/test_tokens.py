r"""Tests of names with primes and subscripts, of spaces between factors, and of what has no meaning."""

import pytest

from sim2reason.grading import Outcome, formula, number
from sim2reason.grading.tokens import canonical, tokenize

NAMES = ["g", "m", "v", "v'", "v_1", "v'_1", "v'_max", "t_12", "t_1"]
"""The symbols of a problem."""


@pytest.mark.parametrize(
    ("name", "spelling"),
    [
        (" v ", "v"),
        ("v'", "v'"),
        ("v′′_0", "v''_0"),
        ("v'_{0}", "v'_0"),
        (r"v'_{\text{A}}", "v'_A"),
        (r"\omega'", "omega'"),
        ("ω'_1", "omega'_1"),
        (r" \theta", "theta"),
        ("v_10", "v_10"),
        ("v_{max}", "v_max"),
        ("speed", "speed"),
        ("pi", "pi"),
    ],
)
def test_each_symbol_has_one_spelling(name: str, spelling: str) -> None:
    assert canonical(name) == spelling


@pytest.mark.parametrize("name", ["", "2", "x+y", "two words", "v'_12", r"\mathrm{Re}"])
def test_other_texts_are_no_symbols(name: str) -> None:
    with pytest.raises(ValueError, match=r"is no symbol|no meaning"):
        canonical(name)


@pytest.mark.parametrize(
    ("text", "tokens"),
    [
        ("v'", ["v'"]),
        ("2v'g", ["2", "v'", "g"]),
        ("v'_1g", ["v'_1", "g"]),
        ("v'_{1}g", ["v'_1", "g"]),
        (r"v'_\text{1}g", ["v'_1", "g"]),
        ("v'_12", ["v'_1", "2"]),
        ("v' _ {max}", ["v'_max"]),
        ("v_12", ["v_1", "2"]),
        ("v_1g", ["v_1", "g"]),
        ("t_12", ["t_12"]),
        ("t_123", ["t_12", "3"]),
        ("t_1g", ["t_1", "g"]),
        ("t1", ["t_1"]),
        ("t₁g", ["t_1", "g"]),
    ],
)
def test_a_prime_and_a_subscript_belong_to_the_letter_before_them(text: str, tokens: list[str]) -> None:
    """As TeX prints it, a subscript without braces is one character, unless the problem has a longer name."""
    assert [token.text for token in tokenize(text, NAMES)] == tokens


@pytest.mark.parametrize(
    ("answer", "reward"),
    [
        ("m v'_{1}", 1.0),
        ("v'_1m", 1.0),
        ("m v'", 0.0),
        ("m v", 0.0),
        ("m v_1", 0.0),
        ("m v'_{2}", 0.0),
        ("m v''_{1}", 0.0),
        ("m' v'_1", 0.0),
    ],
)
def test_a_quantity_after_a_collision_is_another_one(answer: str, reward: float) -> None:
    assert formula(rf"\boxed{{{answer}}}", "m v'_1", symbols=["m", "v", "v'", "v_1", "v'_1"]).reward == reward


@pytest.mark.parametrize(
    ("answer", "shown"),
    [("3!", "a factorial"), ("3§", "'§'"), ("3\u200b4", r"U\+200B"), ("3\x07", r"U\+0007")],
)
def test_a_character_without_meaning_is_shown(answer: str, shown: str) -> None:
    score = number(rf"\boxed{{{answer}}}", 3.0)
    assert score.outcome is Outcome.UNREADABLE
    assert score.why.startswith(shown.replace("\\", ""))
