"""Tests that the texts of solutions have none of the phrases that readers found unclear."""

import ast
import re
from functools import cache
from pathlib import Path

import pytest

import sim2reason.solutions
from sim2reason.solutions.algebra.rounded_numbers import rounded_latex
from sim2reason.solutions.solution import Solution

ODD = (
    "square to the",
    r"lacks on",
    r"\bcounts\b",
    r"driven? back",
    r"drives it back",
    r"has come as far|comes as far",
    r"is kept\b",
    r"so far away when",
    r"at first it recedes|there it recedes",
    r"what turns of",
    r"bends? (the|its) path",
    r"all (its )?energy is of",
    r"arithmetic and geometric means|landen",
    r"there may be",
    r"place of balance",
    r"all forces balance",
    r"it has risen or sunk",
    r"by then\b",
    r"^then the",
    r"put together, th",
    r"up to then",
    r"till then",
    r"how far .* has moved",
    r"grown by",
    r"holds what",
    r"^after this time",
    r"this happens at the time",
    r"this amount of fuel",
    r"towards the equilibrium position",
    r"its extension is",
    r"turns it clockwise",
    r"in numbers they come to",
    r"being positive",
    r"what hangs from it",
    r"with the rate .* of\b",
    r"\bordered:",
    r"^(displacements?|velocit(y|ies)|times?):",
    r"gives it the acceleration",
    r"integrating the velocity over time",
    r"the initial velocity gives the amplitude",
    r"^its (equilibrium is at|(second )?derivative is the)",
    r"\bforward\b",
    r"move at .* against it",
)
FOLDER = Path(sim2reason.solutions.__file__).parent


@cache
def sentences() -> list[tuple[str, str]]:
    """Return all string constants of several words in the code, except docstrings, with their files."""
    found = list[tuple[str, str]]()
    for path in sorted(FOLDER.rglob("*.py")):
        tree = ast.parse(path.read_text())
        docs = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
        for node in ast.walk(tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docs:
                found += [(str(path.relative_to(FOLDER)), node.value)] if " " in node.value.strip() else []
    return found


@pytest.mark.parametrize("phrase", ODD)
def test_no_sentence_has_a_turn_of_phrase_that_no_textbook_has(phrase: str) -> None:
    assert len(sentences()) > 100
    assert not [(path, text) for path, text in sentences() if re.search(phrase, text, re.IGNORECASE)]


@pytest.mark.parametrize(
    ("value", "digits", "expected"),
    [
        (170358.0, 3, r"1.70 \times 10^{5}"),
        (1234.0, 3, r"1.23 \times 10^{3}"),
        (123.4, 3, "123"),
        (0.0012344, 3, "0.00123"),
        (99999.0, 5, "99999"),
        (123456.0, 5, r"1.2346 \times 10^{5}"),
    ],
)
def test_a_number_shows_no_digits_that_are_not_asked_for(value: float, digits: int, expected: str) -> None:
    assert rounded_latex(value, digits) == expected


def test_a_count_is_boxed_as_a_whole_number() -> None:
    """A count of 12 is neither 12.0 nor 1.2 · 10."""
    found = Solution("", goal="X", answer=12.0, values={"X": 12.0}, whole=True)
    assert found.text == r"Answer: $X = \boxed{12}$."
