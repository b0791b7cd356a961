"""Round bodies that roll, and prisms that tumble."""

from math import inf, pi
from typing import Annotated, Self

from pydantic import model_validator

from sim2reason.scenes.authoring import (
    ZERO,
    AngularVelocity,
    End,
    Entity,
    Frame,
    Range,
    Y,
    either,
    entity,
    inner,
    lines_of,
    outer,
    scale,
)
from sim2reason.scenes.bodies.holed_bodies import BoredCylinder, SphereWithHole
from sim2reason.scenes.bodies.planes import Incline
from sim2reason.scenes.bodies.polygonal_prism import LongPrism
from sim2reason.scenes.bodies.round_bodies import (
    Disc,
    HollowSphere,
    Hoop,
    Pipe,
    Roller,
    Sphere,
    SphericalShell,
    ThickPipe,
)
from sim2reason.scenes.dsl.solids import axes_along
from sim2reason.scenes.entities.parts.rolling import Hole, NoSlipping, Rolling, Rough, Sliding, Spinning

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
        """Build the body, perhaps unbalanced, with a sliding coordinate along the plane and a hinge about its axis."""
        uphill, normal = self.plane.directions()
        axes = axes_along(Y) if self.hole is None else (outer(Y, self.hole.way), Y, self.hole.way)
        speed, spin = (0.0, 0.0) if self.start is None else self.start.motion(self.body.radius)
        frame = self.body.put(room, "body", ZERO, axes)
        frame.roll(uphill, normal, self.body.radius, self.grip.coefficient, speed, spin, static=self.grip.static)
        frame.site("axle", faces=uphill)


TUMBLES, MAX_DURATION = 5, 2.0  # face changes in the default duration, and s
MIN_SIDES = 5  # least number of sides: with four, a landing leaves a sixteenth of the energy, with three none


@entity
class TumblingPrism(Entity):
    """A prism on one of its faces that tips over an edge; where the next edge lands it stays, and turns on about it."""

    prism: LongPrism
    plane: Incline
    rate: Annotated[AngularVelocity | None, Range(1.0, 5.0)] = None

    says = (
        either(
            "{prism} lies with one face on {plane}, its axis horizontal.",
            "on {plane}, on one face and with its axis horizontal, lies {prism}.",
            "{plane} carries {prism}, which lies on one face, its axis horizontal.",
        ),
        either(
            "its edges never slip on the plane, and an edge that lands on it does not rebound.",
            "no edge slips on the plane, and none rebounds when it lands there.",
            "whenever an edge lands on the plane it neither rebounds nor slips.",
        ),
        either(
            "at t = 0 it begins to tip over its {plane.edge} with an angular velocity of {rate}.",
            "it starts with an angular velocity of {rate} about its {plane.edge}, over which it tips.",
            "a sudden push makes it tip over its {plane.edge}, with an initial angular velocity of {rate}.",
        ),
    )

    @model_validator(mode="after")
    def _tumbles(self) -> Self:
        if self.prism.sides < MIN_SIDES:
            problem = f"a {self.prism.shape} prism does not tumble on: its first landing takes nearly all its energy"
            raise ValueError(f"prism.shape: {problem}; give at least {MIN_SIDES} sides")
        if self.rate is None and self.plane.angle <= 180.0 / self.prism.sides:
            raise ValueError("rate: the prism stays on its face on so gentle a slope; say how fast it tips at first")
        return self

    def horizon(self, gravity: float) -> float:
        """Return the time of five rotations from face to face at the initial angular velocity, s."""
        del gravity
        return min(MAX_DURATION, TUMBLES * 2.0 * pi / self.prism.sides / self.rate) if self.rate else 0.5 * MAX_DURATION

    def build(self, room: Frame) -> None:
        """Build a body free in the plane of the motion, with its edges as feet."""
        uphill, normal = self.plane.directions()
        edges, apothem = self.prism.edges(uphill, normal), self.prism.apothem
        sense = 1.0 if self.plane.angle == 0.0 else -1.0
        rate = sense * (self.rate or 0.0)  # positive if it tips to the right
        edge = scale(1.0 / self.prism.radius, edges[0])
        frame = self.prism.put(room, "prism", scale(apothem, normal), (edge, outer(Y, edge), Y)).slide(
            uphill, rate * apothem
        )
        frame.slide(normal, rate * sense * inner(edges[0], uphill), name="rise").hinge(Y, rate)
        for number, place in enumerate(edges):
            frame.stand(f"edge{number}", place, uphill, normal, on=scale(-apothem, normal))
