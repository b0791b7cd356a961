"""The page on questions: made from the registries, with an example of everything that people can ask."""

import re
from pathlib import Path

import pytest

from sim2reason.datasets.question_page import COMMAND, format_page
from sim2reason.dsl.connection import CONNECTIONS
from sim2reason.quantities import QUANTITIES
from sim2reason.questions import KINDS, MOMENTS
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.outcomes import OUTCOMES

PAGE = Path(__file__).parents[2] / "docs" / "questions.md"
RARE = {"least normal force", "left face", "lifted off", "circles", "lifts off", "sinks", "tips over"}
"""What no scene of the page has an example of."""


@pytest.fixture(scope="module")
def page() -> str:
    """The page as it is made now."""
    return format_page()


def test_the_page_is_up_to_date(page: str) -> None:
    """Whoever adds a quantity, a moment or a kind writes it anew."""
    assert PAGE.read_text(encoding="utf-8") == page, f"run: {COMMAND}"


def test_every_member_has_a_row_with_an_example(page: str) -> None:
    """The page covers every registry that questions are made from."""
    for registry in (QUANTITIES, FUNCTIONALS, MOMENTS, KINDS, OUTCOMES):
        for name in registry:
            said = name.replace("_", " ")
            rows = re.findall(rf"^\| {re.escape(said)} \| .* \|$", page, re.MULTILINE)
            assert rows, said
            assert any("`--find " in row for row in rows) or said in RARE, said


def test_every_connection_has_an_example(page: str) -> None:
    """The example is written as in a scene file."""
    assert all(f"connections:\n- {name}:\n" in page for name in CONNECTIONS)
