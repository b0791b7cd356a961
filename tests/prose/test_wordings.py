"""Sentences that readers stumbled over, as they are now."""

import re

import pytest

from sim2reason.datasets.random_scenes import sample
from sim2reason.parsing.scene_parser import parse_scene
from sim2reason.prose.description import describe
from sim2reason.questions.moments.closest import Closest
from sim2reason.questions.moments.farthest import Farthest
from sim2reason.questions.prompt import words_of
from sim2reason.scene_files import load

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
    """No *another smooth plane* after a rough one; and no horizontal has a surface."""
    told = describe(load(TWO_SLOPES), wording).text
    assert re.search(
        r"nother fixed plane (with a|whose) (smooth|rough) surface (is )?inclined at \d+° to the horizontal", told
    )
    assert parse_scene(told).scene.joints


def test_one_body_is_far_from_another_that_is_fixed() -> None:
    """The star moves nowhere, so that they do not *reach a distance from each other*; two planets do."""
    words = words_of(describe(sample("orbital", "hard", seed=3)))
    assert Farthest.candidates(words).keys() == Closest.candidates(words).keys()
    for name, said in Farthest.candidates(words).items():
        clause = Farthest(name).clause(words)
        assert clause is not None
        fixed = "star" in name
        assert clause.statement.endswith("from the star" if fixed else "from each other"), said
        assert clause.auxiliary == ("does" if fixed else "do")
