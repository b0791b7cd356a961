"""A bar or a cylinder is taken as a thin rod."""

from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.figures import OtherFigure


@simplification
class ThinRod(OtherFigure):
    """The moment of inertia is taken to be that of a thin rod of the same length."""

    name = "body taken as a thin rod"
    reason = "the moment of inertia of {subject} is taken to be that of a thin rod"
    overlooked = "section"
