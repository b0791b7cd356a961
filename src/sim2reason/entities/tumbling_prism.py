"""A regular prism that tumbles down a plane from face to face, as a pencil does."""

from math import cos, pi, sin
from typing import Annotated, Self

from annotated_types import Le
from pydantic import model_validator

from sim2reason.bodies.incline import Incline
from sim2reason.bodies.polygonal_prism import LongPrism
from sim2reason.dsl.builder import Frame
from sim2reason.dsl.entity import Entity, entity
from sim2reason.dsl.measures import LEAST, Measure, Range
from sim2reason.dsl.mechanism import Y
from sim2reason.dsl.template import either
from sim2reason.dsl.vectors import add, outer, scale

TipRate = Annotated[float, LEAST, Le(1e3), Measure("angular velocity", "rad/s", r"\omega_0"), Range(1.0, 5.0)]
TUMBLES, LONGEST = 5, 2.0  # for which the motion is followed, and s
FEWEST = 5  # sides: with four, a landing leaves a sixteenth of the energy, with three it stops all motion


@entity
class TumblingPrism(Entity):
    """A prism on one of its faces that tips over an edge; where the next edge lands it stays, and turns on about it."""

    prism: LongPrism
    plane: Incline
    rate: TipRate | None = None

    says = (
        either(
            "{prism} lies on {plane} with its axis horizontal.",
            "on {plane}, its axis horizontal, lies {prism}.",
            "{plane} carries {prism}, whose axis is horizontal.",
        ),
        either(
            "its edges never slip on the plane, and an edge that lands on it does not rebound.",
            "no edge slips on the plane, and none rebounds when it lands there.",
            "whenever an edge lands on the plane it neither rebounds nor slips.",
        ),
        either(
            "at t = 0 it is tipping over its {plane.edge} at {rate}.",
            "it is sent off with an angular velocity of {rate} about its {plane.edge}, over which it tips.",
            "a sudden push makes it tip over its {plane.edge}, at first at {rate}.",
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

    @property
    def horizon(self) -> float:
        """As long as it would take to turn from face to face five times with its first angular velocity, s."""
        return min(LONGEST, TUMBLES * 2.0 * pi / self.prism.sides / self.rate) if self.rate else 0.5 * LONGEST

    def build(self, room: Frame) -> None:
        """A body free in the plane of the motion, its edges the feet on which it may stand."""
        uphill, normal = self.plane.directions()
        sides, radius, sense = self.prism.sides, self.prism.radius, 1.0 if self.plane.angle == 0.0 else -1.0
        half, rate = pi / sides, sense * (self.rate or 0.0)  # the rate is positive if it tips to the right
        apothem, side = radius * cos(half), radius * sin(half)
        edge = add(scale(sin(half), uphill), scale(-cos(half), normal))
        frame = self.prism.put(room, "prism", scale(apothem, normal), (edge, outer(Y, edge), Y))
        frame.slide(uphill, rate * apothem).slide(normal, rate * sense * side, name="rise").hinge(Y, rate)
        for number in range(sides):
            turn = (2 * number + 1) * half
            place = add(scale(radius * sin(turn), uphill), scale(-radius * cos(turn), normal))
            frame.stand(f"edge{number}", place, uphill, normal, on=scale(-apothem, normal))
