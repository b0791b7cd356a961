"""Tests of the present wordings of sentences that readers found unclear."""

import re

import pytest

from plain_scenes import row
from sim2reason.generation.item_search import sample
from sim2reason.questions.moments.distances import Closest, Farthest
from sim2reason.questions.prompt import words_of
from sim2reason.scenes.entities.string_ends import FRICTION_ON_PLANE
from sim2reason.scenes.files import load
from sim2reason.text.parsing.scene_parser import parse_scene
from sim2reason.text.prose.closings import CLOSINGS
from sim2reason.text.prose.description import describe

TWO_SLOPES = """
scene:
  name: slopes
  entities:
  - name: rough
    type: TwoSideMassPlane
    parameters: {plane: {angle: 20.0, friction: 0.2}, blocks: [{mass: 2.0}]}
  - name: smooth
    type: MassWithFixedPulley
    parameters:
      system: {kind: on_plane, plane: {angle: 40.0, friction: 0.0}, blocks: [{mass: 1.0}]}
      pulley: {mass: 0.0}
  connections:
  - tendon: [{entity: smooth, direction: tail}, {entity: rough, direction: right}]
"""


@pytest.mark.parametrize("wording", range(6))
def test_a_second_plane_tells_nothing_of_the_first(wording: int) -> None:
    """*Another smooth plane* doesn't follow a rough one, and no horizontal has a surface."""
    told = describe(load(TWO_SLOPES), wording).text
    assert re.search(
        r"nother fixed plane of inclination \d+° (with a (smooth|rough) surface|whose surface is (smooth|rough))", told
    )
    assert parse_scene(told).scene.joints


def test_no_way_to_say_when_a_motion_begins_is_said_by_lines_and_closings_alike() -> None:
    """An example is *to begin with, the rod makes …* followed by *to begin with, everything is held at rest*."""
    closing = [wording for found in CLOSINGS for wording in found.wordings]
    assert not any("to begin with" in wording or wording.startswith("initially") for wording in closing)


def test_what_is_said_of_friction_is_said_in_different_ways() -> None:
    assert len(set(FRICTION_ON_PLANE.wordings)) == len(FRICTION_ON_PLANE.wordings)
    assert not any("friction on this plane, static and kinetic, has" in told for told in FRICTION_ON_PLANE.wordings)


def test_the_other_one_of_two_springs_is_called_so() -> None:
    """*The other one* would refer to a cart one sentence later."""
    chain = row((2.0, 3.0), (40.0, 50.0), "left", strain=0.2, speed=1.0)
    assert "the other spring is relaxed" in describe(chain).text


def test_one_body_is_far_from_another_that_is_fixed() -> None:
    """The star is at rest, so only two planets *reach a distance from each other*."""
    words = words_of(describe(sample("orbital", "hard", seed=3)))
    assert Farthest.candidates(words).keys() == Closest.candidates(words).keys()
    for name, said in Farthest.candidates(words).items():
        clause = Farthest(name).clause(words)
        assert clause is not None
        fixed = "star" in name
        assert clause.statement.endswith("from the star" if fixed else "from each other"), said
        assert clause.auxiliary == ("does" if fixed else "do")
