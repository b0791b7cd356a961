"""A hole is forgotten in the moment of inertia."""

from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.figures import OtherFigure


@simplification
class HoleInInertia(OtherFigure):
    """The moment of inertia about the centre of mass is taken to be that of the body without the hole."""

    name = "hole left out of the inertia"
    reason = "the moment of inertia of {subject} about its centre of mass is taken to be that without the hole"
    overlooked = "hole"
    common = True
