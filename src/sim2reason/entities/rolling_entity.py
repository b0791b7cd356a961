"""A round body that rolls on a plane, perhaps with a hole that puts its centre of mass off its axis."""

from math import inf
from typing import Self

from pydantic import model_validator

from sim2reason.authoring import ZERO, End, Entity, Frame, Y, either, entity, lines_of, outer
from sim2reason.bodies.bored_cylinder import BoredCylinder
from sim2reason.bodies.cylinder import Roller
from sim2reason.bodies.disc import Disc
from sim2reason.bodies.holed_sphere import SphereWithHole
from sim2reason.bodies.hollow_sphere import HollowSphere, SphericalShell
from sim2reason.bodies.hoop import Hoop
from sim2reason.bodies.incline import Incline
from sim2reason.bodies.pipe import Pipe, ThickPipe
from sim2reason.bodies.sphere import Sphere
from sim2reason.dsl.solids import axes_along
from sim2reason.entities.parts.rolling import Hole, NoSlipping, Rolling, Rough, Sliding, Spinning

Holed = BoredCylinder | SphereWithHole
Centred = Sphere | HollowSphere | SphericalShell | Roller | Pipe | ThickPipe | Disc | Hoop


@entity
class RollingEntity(Entity):
    """A sphere, cylinder or hoop on a plane: it rolls, or slides till it rolls; a string may draw it by its axle."""

    body: Centred | Holed
    plane: Incline
    hole: Hole | None = None
    grip: NoSlipping | Rough
    start: Rolling | Sliding | Spinning | None = None

    says = (
        either(
            "{body} is placed on {plane} and can roll {plane.path}.",
            "on {plane} there is {body}, free to roll {plane.path}.",
            "{plane} carries {body}, which can roll {plane.path}.",
        ),
        lines_of("hole"),
        lines_of("grip"),
        lines_of("start"),
    )
    axle = End(
        sites=("axle",),
        tied="the axle of {body}",
        leaves="runs {plane.uphill}",
        arrives="reaches the axle of {body} {plane.above}",
    )

    @model_validator(mode="after")
    def _fits(self) -> Self:
        level = self.plane.angle == 0.0
        if (self.hole is not None) != isinstance(self.body, Holed):
            raise ValueError("hole: say where it is at the start if the body has one, and only then")
        if self.hole is not None and not self.hole.fits(level=level):
            raise ValueError("hole.towards: it is right on a level plane, uphill or downhill on a slope")
        if self.start is not None and level != (self.start.way == "to the right"):
            raise ValueError("start.way: it is to the right on a level plane, up or down the slope on another")
        if self.grip.coefficient == inf and isinstance(self.start, Sliding | Spinning):
            raise ValueError("start: what never slips can't slide or spin on the spot; let it roll, or give a friction")
        return self

    def build(self, room: Frame) -> None:
        """It slides along the plane and turns about its axis; its centre of mass may lie beside that."""
        uphill, normal = self.plane.directions()
        axes = axes_along(Y) if self.hole is None else (outer(Y, self.hole.way), Y, self.hole.way)
        speed, spin = (0.0, 0.0) if self.start is None else self.start.motion(self.body.radius)
        frame = self.body.put(room, "body", ZERO, axes)
        frame.roll(uphill, normal, self.body.radius, self.grip.coefficient, speed, spin, static=self.grip.static)
        frame.site("axle", faces=uphill)
