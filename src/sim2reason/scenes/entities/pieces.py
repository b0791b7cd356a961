"""Pieces of a rigid body on an arm: bodies with their positions and orientations.

In an arm's own axes x points along the arm, away from the axle, y along the axle, and z at right angles to both.
"""

from collections.abc import Sequence
from math import cos, radians, sin
from typing import Annotated, Literal, Self

from annotated_types import Gt, Le, Lt
from pydantic import model_validator

from sim2reason.scenes.authoring import LEAST, Chance, Measure, Part, Range, Word, X, Y, Z, either, outer, scale
from sim2reason.scenes.bodies.blocks import PolygonalPrism
from sim2reason.scenes.bodies.eccentric_bodies import (
    Bowl,
    Hemisphere,
    HollowSphereWithHole,
    SphereWithHole,
    SphericalCap,
)
from sim2reason.scenes.bodies.oscillators import Bar, FixedBall, UniformRod
from sim2reason.scenes.bodies.round_bodies import Cylinder, Disc, HollowSphere, Hoop, Sphere, SphericalShell
from sim2reason.scenes.dsl.solids import Axes, Shape, axes_along, in_own_axes

Distance = Annotated[float, LEAST, Le(1e3), Measure("distance", "m", "d", sought=0.5), Range(0.15, 1.2)]
Side = Literal[
    "from the axle",
    "on the same side",
    "on the other side",
    "on the same side as the first body",
    "on the opposite side from the first body",
]
FIRST: Side = "from the axle"
SAME_SIDE: Side = "on the same side"
OTHER_SIDE: Side = "on the other side"
LIKE_FIRST: Side = "on the same side as the first body"
UNLIKE_FIRST: Side = "on the opposite side from the first body"
Tilt = Annotated[float, Gt(0), Lt(90), Measure("tilt", "deg", r"\beta", decimals=0), Range(15.0, 75.0)]
Edge = Literal["length", "width", "thickness"]
Axial = UniformRod | Cylinder | Disc | Hoop | PolygonalPrism
WAYS = {"along the arm": X, "parallel to the axle": Y, "at right angles to both arm and axle": Z}


class WeldedPiece(Part):
    """Base class of bodies on an arm; `distance` is that of the centre named in the text."""

    words = {"where": Word("side", {FIRST: FIRST}, f"{FIRST}, {{side}}")}

    distance: Distance
    side: Annotated[Side, Chance(0.3)] = FIRST
    """The piece that defines the side: the first one on the arm, or the other one."""

    @property
    def shape(self) -> Shape:
        """Return the body."""
        raise NotImplementedError

    @property
    def axes(self) -> Axes:
        """Return the orientation of the body in the axes of the arm."""
        raise NotImplementedError

    @property
    def place(self) -> float:
        """Return the position along the arm, m; negative on the other side of the axle."""
        return -self.distance if self.side in (OTHER_SIDE, UNLIKE_FIRST) else self.distance

    def told_after(self, earlier: Sequence["WeldedPiece"]) -> Self:
        """Return the piece with words for its side that are unambiguous after the `earlier` pieces."""
        opposite = self.place < 0.0
        if any(piece.place < 0.0 for piece in earlier):
            side = UNLIKE_FIRST if opposite else LIKE_FIRST
        else:
            side = OTHER_SIDE if opposite else SAME_SIDE if earlier else FIRST
        return self.model_copy(update={"side": side})

    @property
    def span(self) -> tuple[float, float]:
        """Return the least and greatest position along the arm, m."""
        ahead, behind = in_own_axes(X, self.axes), in_own_axes(scale(-1.0, X), self.axes)
        return self.place - self.shape.reach(behind), self.place + self.shape.reach(ahead)

    def outwards(self, *, away: bool) -> Axes:
        """Return axes with z pointing away from the axle, or towards it."""
        return axes_along(scale(1.0 if away == (self.place > 0.0) else -1.0, X))


class BallPiece(WeldedPiece):
    """A small ball, whose distance is all that matters."""

    body: FixedBall

    says = (
        either(
            "{body} is fixed to the arm, {distance} {where}.",
            "rigidly attached to the arm is {body}, {distance} {where}.",
            "the arm carries {body}, fixed to it at {distance} {where}.",
        ),
    )

    @property
    def shape(self) -> Shape:
        """Return the ball."""
        return self.body

    @property
    def axes(self) -> Axes:
        """Return arbitrary axes, as the ball is symmetric."""
        return axes_along(X)


class RoundPiece(WeldedPiece):
    """A sphere or a shell, which looks the same however it is turned."""

    body: Sphere | SphericalShell | HollowSphere

    says = (
        either(
            "{body} is fixed with its centre on the arm, {distance} {where}.",
            "rigidly attached to the arm is {body}, centred {distance} {where}.",
            "the arm carries {body}, welded to it and centred {distance} {where}.",
        ),
    )

    @property
    def shape(self) -> Shape:
        """Return the sphere."""
        return self.body

    @property
    def axes(self) -> Axes:
        """Return arbitrary axes, as the sphere is symmetric."""
        return axes_along(X)


class AxialPiece(WeldedPiece):
    """A body with an axis, which points along the arm, along the axle, or across both."""

    body: Axial
    axis: Literal["along the arm", "parallel to the axle", "at right angles to both arm and axle"]

    says = (
        either(
            "{body} is fixed with its centre on the arm, {distance} {where}, and its {body.axis} {axis}.",
            "rigidly attached to the arm is {body}, centred {distance} {where}, its {body.axis} {axis}.",
            "the arm carries {body}, welded to it and centred {distance} {where}, its {body.axis} {axis}.",
        ),
    )

    @property
    def shape(self) -> Shape:
        """Return the body."""
        return self.body

    @property
    def axes(self) -> Axes:
        """Return axes with z along the body's axis of symmetry."""
        return axes_along(WAYS[self.axis])


class TiltedPiece(WeldedPiece):
    """A body with an axis that is tilted from the arm towards the axle; to which side does not matter.

    Turned in the plane of the swing it would be no other body: about the axle I⊥ stays. Here it is I⊥ cos²β + I∥ sin²β.
    """

    body: Axial
    tilt: Tilt

    says = (
        either(
            "{body} is fixed with its centre on the arm, {distance} {where}, and its {body.axis} at {tilt} to the arm, in the plane of arm and axle.",
            "rigidly attached to the arm is {body}, centred {distance} {where}, its {body.axis} at {tilt} to the arm, in the plane of arm and axle.",
            "the arm carries {body}, welded to it and centred {distance} {where}, its {body.axis} in the plane of arm and axle, at {tilt} to the arm.",
        ),
    )

    @property
    def shape(self) -> Shape:
        """Return the body."""
        return self.body

    @property
    def axes(self) -> Axes:
        """Return axes with z along the body's tilted axis of symmetry."""
        return axes_along((cos(radians(self.tilt)), sin(radians(self.tilt)), 0.0))


class CappedPiece(WeldedPiece):
    """A part of a sphere, its axis on the arm; its centre is that of its flat face or opening."""

    body: Hemisphere | SphericalCap | Bowl
    faces: Literal["the axle", "away from the axle"]

    says = (
        either(
            "{body} is fixed to the arm so that its axis of symmetry lies along the arm; its {body.front} faces {faces} and is centred {distance} {where}.",
            "rigidly attached to the arm is {body}, whose axis of symmetry lies along the arm; its {body.front} faces {faces} and is centred {distance} {where}.",
            "the arm carries {body}, welded to it with its axis of symmetry along the arm, its {body.front} facing {faces} and centred {distance} {where}.",
        ),
    )

    @property
    def shape(self) -> Shape:
        """Return the cap."""
        return self.body

    @property
    def axes(self) -> Axes:
        """Return axes with z towards the pole, opposite to the flat face."""
        return self.outwards(away=self.faces == "the axle")


class HoledPiece(WeldedPiece):
    """A sphere with a hole, centred on the arm as the hole is."""

    body: SphereWithHole | HollowSphereWithHole
    hole: Literal["nearer to the axle", "farther from the axle"]

    says = (
        either(
            "{body} is fixed to the arm, its own centre {distance} {where}; the {body.gap} lies on the line of the arm, {hole}.",
            "{body} is welded to the arm with its own centre {distance} {where} and its {body.gap} on the line of the arm, {hole}.",
            "the arm carries {body}, welded to it and centred {distance} {where}, with its {body.gap} on the line of the arm and {hole}.",
        ),
    )

    @property
    def shape(self) -> Shape:
        """Return the sphere."""
        return self.body

    @property
    def axes(self) -> Axes:
        """Return axes with z from the centre to the hole."""
        return self.outwards(away=self.hole == "farther from the axle")


class BarPiece(WeldedPiece):
    """A rectangular bar: one of its edges along the arm, another parallel to the axle."""

    body: Bar
    along: Edge
    across: Edge

    says = (
        either(
            "{body} is fixed to the arm with its centre {distance} {where}, its {along} along the arm and its {across} parallel to the axle.",
            "welded to the arm, with its centre {distance} {where}, is {body}: its {along} is along the arm, its {across} parallel to the axle.",
            "the arm carries {body}, welded to it and centred {distance} {where}, its {along} along the arm, its {across} parallel to the axle.",
        ),
    )

    @model_validator(mode="after")
    def _has_two_edges(self) -> Self:
        if self.along == self.across:
            raise ValueError("along, across: they name the same edge; name two")
        return self

    @property
    def shape(self) -> Shape:
        """Return the bar."""
        return self.body

    @property
    def axes(self) -> Axes:
        """Return axes along width, thickness and length; the third follows from the other two."""
        order = ("width", "thickness", "length")
        along, across = order.index(self.along), order.index(self.across)
        ways = {along: X, across: Y, 3 - along - across: Z}
        if (across - along) % 3 == 1:
            return (ways[0], ways[1], ways[2])
        ways[3 - along - across] = outer(Y, X)
        return (ways[0], ways[1], ways[2])


AnyPiece = BallPiece | RoundPiece | AxialPiece | TiltedPiece | CappedPiece | HoledPiece | BarPiece


def overlap(one: WeldedPiece, other: WeldedPiece) -> bool:
    """Return whether two pieces overlap.

    A thin rod may cross another, or be beside a small body; one along the arm may end in a thick body on its own side
    of the axle. Two small bodies may not have the same position.
    """
    spans = one.span, other.span
    thin, point = list[bool](), list[bool]()
    for piece, (low, high) in zip((one, other), spans, strict=True):
        if isinstance(piece.shape, UniformRod):
            thin.append(low < high)
        else:
            point.append(low == high)
    if len(thin) == 2 or (thin and any(point)):
        return False
    if all(point) and not thin:
        return spans[0] == spans[1]
    if any(thin) and one.place * other.place > 0.0:
        return False
    return spans[0][0] < spans[1][1] and spans[1][0] < spans[0][1]
