"""Tests of path lengths that have a forward and a backward part."""

import pytest

from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.bodies.blocks import Glider
from sim2reason.scenes.bodies.simple_machines import Track
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.track_collisions import ComplexCollisionPlane
from worked import derived, solution_text


def test_the_parts_of_a_path_are_told_before_they_are_added() -> None:
    """A light glider at 1.2 m/s rebounds from a heavy one at rest, 0.9 m away, with v' = −(M − m) v/(M + m)."""
    held = (Glider(mass=1.0, x=0.0, v=1.2), Glider(mass=3.0, x=0.9, v=0.0))
    entity = ComplexCollisionPlane(track=Track(), gliders=held, restitution=1.0)
    scene = Scene(entities=(Named(name="track", entity=entity),))
    found = derived(scene, StretchQuery("sum", None, AtTime(2.0), "distance travelled", "track.gliders.0"))
    assert found.answer == pytest.approx(0.9 + 0.6 * (2.0 - 0.75))
    assert "Part by part, the path of cart A is $s_A$ and $s_A - s_{A,1}$ long, so the distance that" in found.text


def test_a_part_of_no_length_is_no_part_of_a_path() -> None:
    """A free flight that begins at the end of the path contributes no part."""
    text = solution_text("collision-hard-multipart-301928-0")
    assert "the path of block B is $s_B$, $s_B - s_{B,1}$ and $s_{B,2} - s_{B,1}$ long, so" in text
