"""How far a body in fields gets from an axis of the text, on which it starts."""

from typing import ClassVar

from sim2reason.dsl.fields import Push
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.coordinates import XCoordinate, YCoordinate
from sim2reason.quantities.subjects.bodies import AXES
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.parts.charged import acting_on
from sim2reason.questions.moments.whole_motion import WholeMotion
from sim2reason.questions.words import Words


class AxisDistance(Extreme):
    """The greatest size of one coordinate of a body in fields.

    Class data:
        along: the number of the coordinate; the other one is that of the axis from which the distance counts.
    """

    along: ClassVar[int]

    def height(self, state: State, name: str) -> Array:
        """Return the size of the coordinate, m, (n,)."""
        return abs(self.quantity.evaluate(state, name))

    def present(self, words: Words, name: str) -> bool:
        """Return whether fields act on the body, and an electric one only along the coordinate: else it drifts."""
        acts = acting_on(words.mechanism, name)
        if acts is None or acts.medium or not self.quantity().fits(words.mechanism, name):
            return False
        return all(self._is_along(law) for law in acts.electric)

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return phrases also for a motion that repeats itself displaced: this coordinate does not drift."""
        return moment.phrases(words) if isinstance(moment, WholeMotion) else super().when(moment, words, name)

    def _is_along(self, law: Push) -> bool:
        return law.profile.steady and abs(law.direction[self.along]) == max(map(abs, law.direction))


@functional
class GreatestXAxisDistance(AxisDistance):
    """The greatest distance of a body from the x axis."""

    name = "greatest distance from the x axis"
    quantity = YCoordinate
    along = AXES.index("y")
    phrase = "the greatest distance of {body} from the x axis"


@functional
class GreatestYAxisDistance(AxisDistance):
    """The greatest distance of a body from the y axis."""

    name = "greatest distance from the y axis"
    quantity = XCoordinate
    along = AXES.index("x")
    phrase = "the greatest distance of {body} from the y axis"
