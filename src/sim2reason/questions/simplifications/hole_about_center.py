"""A hole is forgotten in the moment of inertia about the centre of the figure."""

from dataclasses import replace

from sim2reason.dsl.mechanism import RigidBody
from sim2reason.dsl.solids import Solid
from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.figures import OtherFigure


@simplification
class HoleAboutCenter(OtherFigure):
    """The moment of inertia about the geometric centre is taken to be that of the body without the hole.

    The one about the centre of mass then follows by the parallel-axis theorem.
    """

    name = "hole left out of the inertia about the centre"
    reason = "the moment of inertia of {subject} about its geometric centre is taken to be that without the hole"
    overlooked = "hole"

    def taken_for(self, body: RigidBody, figure: Solid) -> RigidBody:
        """With that inertia less m(c² 1 − c cᵀ), of its own centre of mass."""
        x, y, z = body.center
        about = figure.inertia(body.mass)
        steiner = (y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z)
        xx, yy, zz, xy, xz, yz = (a - body.mass * b for a, b in zip(about, steiner, strict=True))
        return replace(body, inertia=(xx, yy, zz, xy, xz, yz))
