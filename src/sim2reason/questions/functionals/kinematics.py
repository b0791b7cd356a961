"""Extreme values of positions, velocities and accelerations, and amplitudes."""

from typing import ClassVar

import numpy as np

from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.aggregates import Extreme
from sim2reason.questions.functionals.paths import circles
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.crossings import acting_on
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.questions.moments.turning_points import HighestPoint
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Push
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities.kinematics import (
    Acceleration,
    AngularAcceleration,
    AngularVelocity,
    Displacement,
    Velocity,
)
from sim2reason.simulation.quantities.positions import Deflection, OriginDistance, XCoordinate, YCoordinate
from sim2reason.simulation.quantities.relative import DistanceBetween
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.bodies import AXES, center_path
from sim2reason.simulation.trace import Trace


@functional
class GreatestAcceleration(Extreme):
    """The greatest magnitude of the acceleration of a body."""

    name = "greatest acceleration"
    quantity = Acceleration
    impulsive = True
    phrase = "the greatest magnitude of the acceleration of {body}{ground}"
    weight = 0.4


REST_SPEED_RTOL = 1e-6  # relative: a slower body is at rest


@functional
class OscillationAmplitude(Extreme):
    """Half the distance, in m, between the ends of the path of a body on a straight line; never drawn by recipes."""

    name = "amplitude"
    quantity = Displacement
    phrase = "the amplitude of the motion of {body}"
    drawn_by_recipes = False

    def present(self, words: Words, name: str) -> bool:
        """Return whether the body moves along a straight line."""
        return center_path(words.mechanism, name).straight

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return half the distance between the ends of the path, m; None unless the body is at rest at both ends."""
        direction = np.array(center_path(trace.mechanism, name).ways[0])
        turns = [event.time for event in trace.events if event.kind == "turn" and event.time <= end]
        at_turns, within = trace.sample(np.array([0.0, *turns, end])), trace.scan.times <= end
        moving, turning = (np.abs(Velocity.evaluate(state, name) @ direction) for state in (trace.scan, at_turns))
        places, ends = (Displacement.evaluate(state, name) @ direction for state in (trace.scan, at_turns))
        rests = ends[turning <= REST_SPEED_RTOL * moving[within].max()]
        places = places[within]
        span = float(np.ptp(rests)) if len(rests) else 0.0
        return 0.5 * span if span > 0.0 and span >= (1.0 - REST_SPEED_RTOL) * float(np.ptp(places)) else None

    def loose_value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return half the distance between the ends of the path, m, under the same conditions as for a question."""
        return self.value(trace, name, end)


@functional
class GreatestAngularSpeed(Extreme):
    """The greatest angular speed of a body."""

    name = "greatest angular speed"
    quantity = AngularVelocity
    phrase = "the greatest angular speed of {body}"
    weight = 2.0


@functional
class GreatestAngularAcceleration(Extreme):
    """The greatest angular acceleration of a body; never drawn by recipes."""

    name = "greatest angular acceleration"
    quantity = AngularAcceleration
    impulsive = True
    drawn_by_recipes = False
    phrase = "the greatest angular acceleration of {body}"


class AxisDistance(Extreme):
    """The greatest absolute value of one coordinate of a body in fields.

    Class data:
        along: the number of the coordinate; the other one is that of the axis from which the distance counts.
    """

    along: ClassVar[int]

    def height(self, state: State, name: str) -> Array:
        """Return the absolute value of the coordinate, m, (n,)."""
        return abs(self.quantity.evaluate(state, name))

    def present(self, words: Words, name: str) -> bool:
        """Return whether only fields act on the body, electric ones only along a coordinate that thus cannot drift."""
        acts = acting_on(words.mechanism, name)
        if acts is None or acts.medium or not self.quantity().fits(words.mechanism, name):
            return False
        return all(self._is_along(law) for law in acts.electric)

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return phrases for the interval, also if the motion repeats elsewhere, as the coordinate does not drift."""
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


class ExtremeCoordinate(Extreme):
    """The base class of extremes of a signed coordinate."""

    drawn_by_recipes = False

    def height(self, state: State, name: str) -> Array:
        """Return the coordinate, m, (n,), with a minus sign for a least value."""
        return self.sign * self.quantity.evaluate(state, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the extreme coordinate, m, anywhere in the interval."""
        return self.extreme_between(trace, name, 0.0, end)

    def present(self, words: Words, name: str) -> bool:
        """Return whether the text states the coordinate at the start."""
        return self.quantity().fits(words.mechanism, name)


@functional
class GreatestXCoordinate(ExtremeCoordinate):
    """The greatest x coordinate of a body."""

    name = "greatest x coordinate"
    quantity = XCoordinate
    phrase = "the greatest x coordinate of {body}"


@functional
class LeastXCoordinate(ExtremeCoordinate):
    """The least x coordinate of a body."""

    name = "least x coordinate"
    quantity = XCoordinate
    sign = -1.0
    phrase = "the least x coordinate of {body}"


@functional
class GreatestYCoordinate(ExtremeCoordinate):
    """The greatest y coordinate of a body."""

    name = "greatest y coordinate"
    quantity = YCoordinate
    phrase = "the greatest y coordinate of {body}"


@functional
class LeastYCoordinate(ExtremeCoordinate):
    """The least y coordinate of a body."""

    name = "least y coordinate"
    quantity = YCoordinate
    sign = -1.0
    phrase = "the least y coordinate of {body}"


@functional
class GreatestOriginDistance(ExtremeCoordinate):
    """The greatest distance of a body from the origin."""

    name = "greatest distance from the origin"
    quantity = OriginDistance
    phrase = "the greatest distance of {body} from the origin"


@functional
class LeastOriginDistance(ExtremeCoordinate):
    """The least distance of a body from the origin."""

    name = "least distance from the origin"
    quantity = OriginDistance
    sign = -1.0
    phrase = "the least distance of {body} from the origin"


VERTICAL_ANGLE = 1e-3  # degrees: a line that comes closer to the vertical passes it


@functional
class GreatestDeflection(Extreme):
    """The greatest angle that a line makes with the downward vertical."""

    name = "greatest deflection"
    quantity = Deflection
    phrase = "the greatest angle that {line} makes with the downward vertical"
    weight = 2.0


@functional
class LeastDeflection(Extreme):
    """The least angle that a line makes with the downward vertical, of a line that does not pass the vertical."""

    name = "least deflection"
    quantity = Deflection
    sign = -1.0
    drawn_by_recipes = False
    phrase = "the least angle that {line} makes with the downward vertical"

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the least angle, in degrees; None if the line passes the vertical."""
        angle = Extreme.value(self, trace, name, end)
        return angle if angle is not None and angle > VERTICAL_ANGLE else None


@functional
class GreatestDisplacement(Extreme):
    """The greatest distance of a body from its starting point."""

    name = "greatest displacement"
    quantity = Displacement
    phrase = "the greatest distance between {body} and its starting point{ground}"
    weight = 1.0

    def present(self, words: Words, name: str) -> bool:
        """Return whether the body does not move on a circle, where symmetry gives the distance."""
        return not circles(words.mechanism, name)


@functional
class GreatestDistance(Extreme):
    """The greatest distance between two bodies."""

    name = "greatest distance"
    quantity = DistanceBetween
    phrase = "the greatest distance between {pair}"
    weight = 2.0


@functional
class LeastDistance(Extreme):
    """The least distance between two bodies that do not touch."""

    name = "least distance"
    quantity = DistanceBetween
    sign = -1.0
    phrase = "the least distance between {pair}"
    how = "how near to each other do {pair} come {when}?"
    weight = 2.0


UPWARD = Sense("upward", (0.0, 0.0, 1.0), fixed=True)


@functional
class GreatestHeight(Extreme):
    """The greatest height of a body above its starting point."""

    name = "greatest height"
    quantity, sense = Displacement, UPWARD
    phrase = "the greatest height of {body} above its starting point"
    how = "how high above its starting point does {body} get {when}?"
    weight = 2.0

    def present(self, words: Words, name: str) -> bool:
        """Return whether the body flies or swings."""
        return name in HighestPoint.candidates(words)


@functional
class GreatestSpeed(Extreme):
    """The greatest speed of a body."""

    name = "greatest speed"
    quantity = Velocity
    phrase = "the greatest speed of {body}{ground}"
    weight = 2.0


@functional
class LeastSpeed(Extreme):
    """The least speed of a body that never stops."""

    name = "least speed"
    quantity = Velocity
    sign = -1.0
    phrase = "the least speed of {body}{ground}"
