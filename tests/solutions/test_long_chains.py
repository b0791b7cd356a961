"""Texts of long chains of hits: what is told in rows is told in full, and after what it hangs on."""

import pytest

from sim2reason.datasets.item_search import ItemSearch
from sim2reason.datasets.plan import Request
from sim2reason.solutions import solve
from sim2reason.solutions.check import WORDS, faults, words
from sim2reason.solutions.expressions import Number, Symbol
from sim2reason.solutions.long_chains import LONG, in_rows
from sim2reason.solutions.reading import read
from sim2reason.solutions.reverse import forward
from sim2reason.solutions.solution import Relation, Step


def velocity(number: int, *needs: int) -> Step:
    name = f"v_{number}"
    relation = Relation(Symbol(name), Number(2.0), "law")
    text = f"Then the velocity of ball A is {relation.latex()}."
    return Step(number, "velocity", text, (relation,), (name,), needs)


def test_few_sentences_stay_as_they_are() -> None:
    steps = [velocity(number) for number in range(LONG - 1)]
    assert in_rows(steps) == steps


def test_a_row_holds_what_follows_from_what_was_told() -> None:
    """The eleventh rests on a law between, so that it comes later."""
    law = Step(LONG, "law", "A law.", (), ("x",), (0,))
    steps = [*(velocity(number) for number in range(LONG)), law, velocity(LONG + 1, LONG), velocity(LONG + 2, 3)]
    row, between, last = in_rows(steps)
    assert row.text.startswith("Velocities: $v_0 = 2$, ")
    assert row.gives == (*(f"v_{number}" for number in range(LONG)), f"v_{LONG + 2}")
    assert len(row.relations) == LONG + 1
    assert (row.needs, between.needs, last.needs) == ((), (0,), (LONG,))
    assert last.text == steps[-2].text


@pytest.mark.parametrize(("difficulty", "seed", "index"), [("medium", 804, 4), ("hard", 905, 29)])
def test_long_chains_are_told_in_few_words(difficulty: str, seed: int, index: int) -> None:
    found = ItemSearch(Request("collision", difficulty, "reverse", seed, index)).found()
    assert found is not None
    solution, answer = solve(found.setting), forward(found.setting).answer
    assert answer is not None
    assert "Velocities:" in solution.text
    assert not faults(solution, answer)
    assert not read(solution.text).broken
    assert words(solution.text) <= WORDS[difficulty]
