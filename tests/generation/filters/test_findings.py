"""Tests of the numbers in the findings of filters about kept problems."""

import numpy as np
import pytest

from plain_scenes import atwood
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.request import Request
from sim2reason.questions import KINDS, Query, Question, SimulatedScene
from sim2reason.questions.moments.distances import Moved


@pytest.mark.parametrize(
    ("recipe", "mode", "filters"),
    [
        ("pulley", "numeric", ("degenerate", "taut", "jerk", "hidden numbers")),
        ("pulley", "symbolic", ("few symbols",)),
        ("springs", "reverse", ("identifiable",)),
    ],
)
def test_numbers_come_with_the_verdict(recipe: str, mode: str, filters: tuple[str, ...]) -> None:
    found = ItemSearch(Request(recipe, "easy", mode, 3, 0)).find()
    assert found is not None
    for name in filters:
        told = list(FILTERS[name].findings(found.candidate))
        assert any(letter.isdigit() for line in told for letter in line), name


def test_effects_are_reported_with_their_subjects() -> None:
    """3 kg and 2 kg move 0.5 m from rest in √(2 · 0.5 m · 5/g); 3 kg alone falls so far in √(2 · 0.5 m/g).

    Without gravity nothing moves, and half of the time is 1/√2 of it if the ½ of ½ a t² is forgotten.
    """
    study = SimulatedScene.of(atwood(), np.linspace(0.0, 2.0, 41))
    query = Query("time_to_event", None, Moved("one.system.blocks.0", 0.5))
    answer = KINDS[query.kind].answer(query, study)
    assert answer == pytest.approx((5.0 / 9.8) ** 0.5)
    found = Candidate(study, Question("numeric", query, "?", answer, "s"), "a b c")
    assert list(FILTERS["shortcut"].findings(found)) == [
        "body held (other.system.blocks.0): there is no answer any more",
        "body left out (other.system.blocks.0): 0.3194, 0.55 of the answer away",
    ]
    lines = list(FILTERS["simplification"].findings(found))
    assert "gravity left out: there is no answer any more" in lines
    assert "half forgotten: 0.5051, 0.29 of the answer away" in lines
