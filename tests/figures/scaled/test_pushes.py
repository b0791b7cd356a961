"""Tests of a user's entity with a constant force: an arrow at its body, solved, and asked about in symbols."""

from math import cos, radians, sin
from typing import Annotated

import pytest

from sim2reason.authoring import Angle, Entity, Force, Frame, Profile, Push, Range, add, either, scale
from sim2reason.datasets.scene_questions import ask, solve
from sim2reason.figures.drawing import drawing
from sim2reason.figures.shapes import LineShape
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.string_ends import FRICTION_ON_PLANE
from sim2reason.testing import check_entity
from sim2reason.text.prose import describe
from spoiled import registered

G, SLOPE, FRICTION, MASS, FORCE, TILT = 9.8, radians(20.0), 0.2, 2.0, 15.0, radians(25.0)


class PushedBlock(Entity):
    """Block on a slope, pushed at an angle to it."""

    plane: Plane
    block: Block
    force: Force
    tilt: Annotated[Angle, Range(5.0, 40.0)]

    says = (
        either("{block} lies on {plane}.", "on {plane} lies {block}.", "{plane} carries {block}."),
        FRICTION_ON_PLANE,
        either(
            "a hand pushes {block} with a constant force of {force} that points {tilt} above the way up the plane.",
            "a constant force of {force}, at {tilt} above the way up the plane, pushes {block}.",
            "{block} is pushed by a constant force of {force} at {tilt} above the way up the plane.",
        ),
    )

    def build(self, room: Frame) -> None:
        uphill, normal = self.plane.directions()
        tilt = radians(self.tilt)
        body = room.body("block", self.block.mass)
        body.rest(uphill, normal, self.plane.friction, static=self.plane.static_friction)
        body.force("push", Push(add(scale(cos(tilt), uphill), scale(sin(tilt), normal)), Profile(self.force)))


PUSHED = Scene(
    entities=(
        Named(
            name="it",
            entity=PushedBlock(
                plane=Plane(angle=20.0, friction=FRICTION), block=Block(mass=MASS), force=15.0, tilt=25.0
            ),
        ),
    )
)


def test_it_is_an_arrow_with_its_size_and_its_angle() -> None:
    """There is one arrow, from the block, at 25° + 20° = 45° to the horizontal."""
    shown = drawing(PUSHED, describe(PUSHED))
    assert {"15 N", "25°", "20°"} <= {label.text for label in shown.labels}
    assert not any("field" in label.text for label in shown.labels)
    (arrow,) = (s.points for s in shown.shapes if isinstance(s, LineShape) and s.arrow)
    way = arrow[1] - arrow[0]
    assert way.imag == pytest.approx(way.real)


def test_it_is_solved_by_formulas() -> None:
    """The acceleration is (F cos β + µ F sin β − m g sin θ − µ m g cos θ)/m."""
    found = solve(PUSHED, find="acceleration")
    up = FORCE * (cos(TILT) + FRICTION * sin(TILT)) - MASS * G * (sin(SLOPE) + FRICTION * cos(SLOPE))
    assert found.answer == pytest.approx(up / MASS, rel=1e-12)
    assert found.solution.strategy == "constant acceleration"


@pytest.mark.parametrize("mode", ["symbolic", "reverse"])
def test_it_is_asked_about_in_every_mode(mode: str) -> None:
    """The force has a name of its own in the mechanism, which is not a field of the entity."""
    with registered(PushedBlock):
        assert len(ask(PUSHED, mode=mode, items=2)) == 2


def test_it_conforms() -> None:
    with registered(PushedBlock):
        check_entity(PushedBlock, seeds=range(2))
