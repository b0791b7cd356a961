"""Tests that no question depends on a mass that the text does not state."""

import numpy as np
import pytest

from plain_scenes import ramp
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import MODES
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import targets
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.builder import Frame
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import either
from sim2reason.text.prose.description import describe

MASSY = ("momentum", "energy", "force")


class Sledge(Body):
    """Body whose mass does not matter and is not stated."""

    nouns = ("sledge",)
    lone = ("a {noun}", "a loaded {noun}")
    named = ("{noun} {letter}", "loaded {noun} {letter}")


class SledgeOnSlope(Entity):
    """Sledge that slides down a plane."""

    sledge: Sledge
    plane: Plane

    says = (
        either("{sledge} lies on {plane}.", "on {plane} lies {sledge}.", "{plane} carries {sledge}."),
        either(
            "friction on this plane, static and kinetic, has the coefficient {plane.friction}.",
            "the coefficient of friction (static and kinetic) on this plane is {plane.friction}.",
            "on this plane static and kinetic friction have the coefficient {plane.friction}.",
        ),
    )

    def build(self, room: Frame) -> None:
        uphill, normal = self.plane.directions()
        room.body("sledge", 1.0).rest(uphill, normal, self.plane.friction)


SLOPE = Scene(
    entities=(Named(name="slope", entity=SledgeOnSlope(sledge=Sledge(), plane=Plane(angle=30.0, friction=0.2))),)
)


def asked(scene: Scene) -> set[str]:
    """Return the questions that pass the filter against dependence on hidden numbers."""
    search = QuestionSearch(scene, 1)
    study, words = search.study, search.words
    drawn = (MODES["numeric"].ask(study, words, "", np.random.default_rng(seed)) for seed in range(60))
    found = (Candidate(study, question, question.text, words=words) for question in drawn if question is not None)
    return {candidate.question.text for candidate in found if not FILTERS["hidden numbers"].reason(candidate)}


def test_no_question_needs_a_mass_that_is_not_said() -> None:
    said = asked(SLOPE)
    assert any("the sledge" in text for text in said)
    assert not [text for text in said if any(word in text for word in MASSY)]
    assert [text for text in asked(ramp(friction=0.2)) if any(word in text for word in MASSY)]


@pytest.mark.parametrize("word", MASSY)
def test_it_is_not_offered_either(word: str) -> None:
    for scene, offers in ((SLOPE, False), (ramp(mass=2.0, friction=0.2), True)):
        nouns = targets(words_of(describe(scene))).values()
        assert any(word in noun.phrase for noun in nouns) == offers
