"""Tests of the filter for answers that nobody could derive."""

import pytest

from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.questions import KINDS, Query, Question, Target
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.kinds.optimum import OptimumQuery
from sim2reason.questions.moments.bounces import Landed
from sim2reason.questions.prompt import words_of
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.text.prose.description import describe

DERIVABLE = FILTERS["derivable"]


@pytest.mark.parametrize("place", [True, False])
def test_a_greatest_range_is_derived_with_the_number_that_the_text_hides(place: bool) -> None:
    """The text has no number for the angle; without words for the laws, nothing is derived."""
    entity = Projectile(ball=Ball(mass=0.5), height=3.0, speed=8.0, angle=25.0)
    scene = Scene(entities=(Named(name="throw", entity=entity),))
    study, moment = simulate_scene(scene).study, Landed("throw.ball")
    distance = Target("displacement", "throw.ball")
    query = OptimumQuery("optimum", distance, moment, Query("event"), "throw.angle", "deg", asks_place=place)
    answer = KINDS["optimum"].answer(query, study)
    assert answer is not None
    found = Candidate(study, Question("numeric", query, "?", answer, ""), "", words=words_of(describe(scene)))
    assert not DERIVABLE.reason(found)
    assert list(DERIVABLE.findings(found)) == ["it is derived by: greatest range"]
