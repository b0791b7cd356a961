"""Tests that tables whose cells are symbols are read with the numbers of each binding."""

import numpy as np
import pytest

from sim2reason.generation.make import make
from sim2reason.generation.request import Request
from sim2reason.questions.prompt import parse_prompt


def test_a_table_of_symbols_leads_back_to_the_answer_at_every_binding() -> None:
    """The engine's answers match for carts on a smooth slope, each row with its mass, place and velocity.

    Only events after the time for which a text is followed, that of the scene's own numbers, are left out.
    """
    first = 12  # with such a table
    drawn = (make(Request("collision", "medium", "symbolic", 3, index)).item for index in range(first, 30))
    row = "| A | $m_A$ | $x_A$ | $v_A$ |"
    item = next(found for found in drawn if found is not None and row in found.prompt)
    assert item.answer.formula is not None
    met = 0
    for number, binding in enumerate(item.answer.formula.bindings):
        read = parse_prompt(item.prompt, np.random.default_rng(0), item.answer.formula.given(number))
        if read.answer is not None:
            assert read.answer == pytest.approx(binding.answer, rel=1e-9)
            met += 1
    assert met >= 6
