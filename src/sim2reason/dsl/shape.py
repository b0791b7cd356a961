"""Rigid bodies with extent: what a text says of their size tells how their mass is spread."""

from collections.abc import Mapping
from math import exp, log
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from annotated_types import Ge, Le

from sim2reason.dsl.body import Body
from sim2reason.dsl.builder import Frame
from sim2reason.dsl.looks import Axial, Capped, Rectangular, Spherical
from sim2reason.dsl.measures import LEAST, Mass, Measure, Range
from sim2reason.dsl.model import as_said, field_types
from sim2reason.dsl.solids import UPRIGHT, Axes, Solid, composed
from sim2reason.dsl.template import Word
from sim2reason.dsl.vectors import Vector

SMALL = Le(1e2)
Radius = Annotated[float, LEAST, SMALL, Measure("radius", "m", "R", sought=0.3), Range(0.05, 0.15)]
HoleRadius = Annotated[float, LEAST, SMALL, Measure("hole radius", "m", "r"), Range(0.02, 0.05)]
HoleOffset = Annotated[float, Ge(0), SMALL, Measure("offset", "m", "d", called="distance"), Range(0.02, 0.05)]
Thickness = Annotated[float, LEAST, SMALL, Measure("thickness", "m", "t"), Range(0.01, 0.03)]
Extent = Annotated[float, LEAST, SMALL, Measure("height", "m", "h"), Range(0.05, 0.3)]

Overlooked = Literal["hole", "wall", "section", "height"]
"""A hole, the thickness of a wall, what makes a bar or cylinder more than a thin rod, or more than a thin disc."""


DRAWN = Range(150.0, 9000.0)  # kg/m³, of what is drawn


class Shape(Body):
    """A uniform rigid body, in axes of its own.

    Their origin is what a text calls its centre, z its axis, or the way to its pole or to its hole. `axis` is the word
    for what points along z.
    """

    mass: Mass

    bulky: ClassVar[bool] = False  # whether the text says all its sizes, so that `solid` is one of three dimensions
    seen: ClassVar[Axes] = UPRIGHT  # where the axes of its look point, in its own
    words: ClassVar[dict[str, Word]] = {"axis": Word("mass", {}, "axis")}

    @property
    def solid(self) -> Solid:
        """How its mass is spread."""
        raise NotImplementedError

    @property
    def density(self) -> float | None:
        """Its mass over its volume."""
        return self.mass / self.solid.size if self.bulky else None

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Give it a mass that suits its size, within the range of masses if it can be."""
        if not cls.bulky:
            return {}
        mass = field_types(cls)["mass"].drawn or Range(drawn["mass"], drawn["mass"])
        volume = cls(**drawn).solid.size
        low, high = (min(max(end / volume, DRAWN.low), DRAWN.high) for end in (mass.low, mass.high))
        if low <= drawn["mass"] / volume <= high:
            return {}
        density = exp(rng.uniform(log(low), log(max(high, min(2.0 * low, DRAWN.high)))))
        return {"mass": as_said(cls, "mass", density * volume)}

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """Figures of the same mass and centre that a reader may take it for, by what is overlooked then."""
        return {}

    def reach(self, way: Vector) -> float:
        """How far it extends from its origin along a unit vector, m."""
        look = self.look
        if self.seen != UPRIGHT or not isinstance(look, Axial | Capped | Rectangular | Spherical):
            raise NotImplementedError
        return look.reach(way)

    def put(self, carrier: Frame, name: str, at: Vector, axes: Axes = UPRIGHT) -> Frame:
        """The body on what carries it, its origin at a point there and turned so."""
        turned = self.solid.turned(axes)
        frame = carrier.body(name, self.mass, at=at, center=turned.center, inertia=turned.inertia(self.mass))
        return frame.turned(composed(self.seen, axes))
