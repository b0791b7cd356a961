"""Tests of corners, numbers at the ends of ranges at which a margin is negative while others stay positive."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import pytest

from plain_scenes import ramp
from sim2reason.generation.modes.corners import find_corner
from sim2reason.generation.modes.problem_formula import ProblemSymbol, Variation
from sim2reason.generation.modes.variations import Variations
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import Query, SimulatedScene, Words
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.regimes import Regime
from sim2reason.simulation.quantities.subjects.bodies import Bodies

WIDTH = 1.1


@pytest.fixture(scope="module")
def varied() -> Variations:
    """Return variations of the time in which a block of 2 kg goes 0.5 m down a slope."""
    symbols = [ProblemSymbol("m", "kg", 2.0, "ramp.blocks.0.mass"), ProblemSymbol("d", "m", 0.5)]
    return Variations(
        QuestionSearch(ramp(), 0).study, Query("time_to_event", None, Moved("ramp.blocks.0", 0.5)), symbols
    )


@dataclass(frozen=True, slots=True)
class LightBlock(Regime):
    """The assumption that a block has less than 5 kg."""

    of = Bodies()

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return none, as no text states it."""
        del study, words
        return []

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether the mass is less than 5 kg."""
        del until
        return study.mechanism.body[self.name].mass < 5.0

    def clause(self, words: Words) -> str:
        """Return no clause."""
        del words
        return ""


def heavy_and_near(other: Variation) -> float:
    """Return an arbitrary margin, smaller for heavy blocks and short distances."""
    return other.values["d"] / other.values["m"]


def test_the_least_margin_is_at_a_corner(varied: Variations) -> None:
    known = list(varied.vary_one_by_one(WIDTH, []))
    found = find_corner(varied, heavy_and_near, [], known)
    assert found is not None
    assert found.values["m"] == max(other.values["m"] for other in known)
    assert found.values["d"] == min(other.values["d"] for other in known)


def test_what_is_told_is_kept(varied: Variations) -> None:
    """The mass must be less than 5 kg, which the end of its range, 6 kg, is not."""
    known = list(varied.vary_one_by_one(WIDTH, []))
    found = find_corner(varied, heavy_and_near, [LightBlock("ramp.blocks.0")], known)
    assert found is not None
    assert found.values["m"] < 5.0
    assert found.values["d"] == min(other.values["d"] for other in known)


def test_nothing_leads_out_of_what_no_margin_tells(varied: Variations) -> None:
    assert find_corner(varied, lambda _: None, [], []) is None
