"""Tests of scenes without gravity, which their texts state and the parser reads."""

import pytest

from plain_scenes import atwood, ramp, swing
from sim2reason.scenes.dsl.scene import Scene, World
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose.description import describe


@pytest.mark.parametrize("scene", [ramp(angle=0.0, friction=0.0, speed=7.0), ramp(speed=2.0), atwood(), swing(60.0)])
def test_that_there_is_none_is_said_and_read(scene: Scene) -> None:
    """A text states g = 0 if gravity could matter."""
    weightless = scene.model_copy(update={"world": World(gravity=0.0)})
    text = describe(weightless).text
    assert "0 m/s²" in text
    assert parse_scene(text).scene.world.gravity == 0.0
