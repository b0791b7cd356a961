"""A thick wall is taken as thin."""

from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.figures import OtherFigure


@simplification
class ThinWall(OtherFigure):
    """The moment of inertia is taken to be that of a thin shell or pipe of the same radius."""

    name = "wall taken as thin"
    reason = "the wall of {subject} is taken as thin"
    overlooked = "wall"
