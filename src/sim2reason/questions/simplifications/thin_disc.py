"""A cylinder or a prism is taken as a thin disc."""

from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.figures import OtherFigure


@simplification
class ThinDisc(OtherFigure):
    """The moment of inertia is taken to be that of a thin disc of the same radius."""

    name = "body taken as a thin disc"
    reason = "the moment of inertia of {subject} is taken to be that of a thin disc"
    overlooked = "height"
    common = True
