"""A regular prism that tumbles down a plane from face to face, as a pencil does."""

from math import pi
from typing import Annotated, Self

from pydantic import model_validator

from sim2reason.authoring import AngularVelocity, Entity, Frame, Range, Y, either, entity, inner, outer, scale
from sim2reason.bodies.incline import Incline
from sim2reason.bodies.polygonal_prism import LongPrism

TUMBLES, LONGEST = 5, 2.0  # for which the motion is followed, and s
FEWEST = 5  # sides: with four, a landing leaves a sixteenth of the energy, with three it stops all motion


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
        if self.prism.sides < FEWEST:
            problem = f"a {self.prism.shape} prism does not tumble on: its first landing takes nearly all its energy"
            raise ValueError(f"prism.shape: {problem}; give at least {FEWEST} sides")
        if self.rate is None and self.plane.angle <= 180.0 / self.prism.sides:
            raise ValueError("rate: the prism stays on its face on so gentle a slope; say how fast it tips at first")
        return self

    def horizon(self, gravity: float) -> float:
        """As long as it would take to turn from face to face five times with its first angular velocity, s."""
        del gravity
        return min(LONGEST, TUMBLES * 2.0 * pi / self.prism.sides / self.rate) if self.rate else 0.5 * LONGEST

    def build(self, room: Frame) -> None:
        """A body free in the plane of the motion, its edges the feet on which it may stand."""
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
