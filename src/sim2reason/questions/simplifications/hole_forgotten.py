"""A body with a hole treated as solid, both in its centre of mass and in its moment of inertia."""

from dataclasses import replace

from sim2reason.dsl.mechanism import RigidBody
from sim2reason.dsl.solids import Solid
from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.figures import OtherFigure


@simplification
class HoleForgotten(OtherFigure):
    """A body is taken to have no hole, so that its centre of mass is at its centre."""

    name = "hole left out"
    reason = "the hole in {subject} is left out"
    overlooked = "hole"

    def taken_for(self, body: RigidBody, figure: Solid) -> RigidBody:
        """With the inertia and the centre of mass of a body of the same mass without the hole."""
        return replace(body, center=figure.center, inertia=figure.inertia(body.mass))
