"""Tests that no slope lies below the floor on which another body stands."""

import pytest

from sim2reason.generation.recipes.growth import leads_below_floor
from sim2reason.scenes.files import load

SCENE = """
scene:
  name: joined
  entities:
  - name: weight
    type: MassWithFixedPulley
    parameters:
      system: {system}
      pulley: {{mass: 0.0}}
  - name: prism
    type: MassPrismPlane
    parameters:
      prism: {{mass: 3.8, left: 48.0, right: 40.0, friction: 0.0}}
      left_blocks: [{{mass: 3.6}}]
      right_blocks: [{{mass: 2.6}}]
  connections:
  - tendon: [{{entity: weight, direction: tail}}, {{entity: prism, direction: right}}]
"""
SLOPE = "{kind: on_plane, plane: {angle: 14.0, friction: 0.0}, blocks: [{mass: 2.0}]}"
LEVEL = "{kind: on_plane, plane: {angle: 0.0, friction: 0.0}, blocks: [{mass: 2.0}]}"
WEDGE = "{kind: on_wedge, wedge: {mass: 3.0, angle: 30.0, friction: 0.0}, blocks: [{mass: 2.0}]}"
HANGING = "{kind: hanging, blocks: [{mass: 2.0}]}"
STRAIGHT = """
scene:
  name: straight
  entities:
  - name: ramp
    type: TwoSideMassPlane
    parameters: {plane: {angle: 20.0, friction: 0.0}, blocks: [{mass: 2.0}]}
  - name: weight
    type: MassWithFixedPulley
    parameters: {system: {kind: hanging, blocks: [{mass: 1.0}]}, pulley: {mass: 0.0}}
  connections:
  - tendon: [{entity: weight, direction: tail}, {entity: ramp, direction: right}]
"""


@pytest.mark.parametrize(("system", "low"), [(SLOPE, True), (WEDGE, True), (LEVEL, False), (HANGING, False)])
def test_a_slope_whose_top_is_at_the_floor_is_below_it(system: str, low: bool) -> None:
    scene = load(SCENE.format(system=system))
    assert [leads_below_floor(scene, joint) for joint in scene.joints.values()] == [low]


def test_where_no_floor_is_told_none_is_missed() -> None:
    scene = load(STRAIGHT)
    assert not any(leads_below_floor(scene, joint) for joint in scene.joints.values())
