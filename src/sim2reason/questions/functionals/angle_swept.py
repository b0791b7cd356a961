"""Through what angle a body turns in all, to and fro."""

from math import degrees

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.rotation import AngleTurned, AngularVelocity
from sim2reason.quantities.subjects.turners import TurningBodies
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.circles import is_told_by_angles
from sim2reason.questions.functionals.parts.integral import Integral
from sim2reason.questions.moments import Moment
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel

DIFFERS = 0.02  # of the angle: what is less larger than the angle between start and end is not worth asking


@functional
class AngleSwept(Integral):
    """The sum of all angles, whatever their sense, through which a body turns about one axle."""

    name, unit, least = "total angle", "deg", 0.1
    of = TurningBodies()
    phrase = "the total angle through which {body} turns"
    how = "through what angle does {body} turn altogether, to and fro, {when}?"

    def rate(self, state: State, name: str) -> Array:
        """|ω|, degrees per second, (n,)."""
        return degrees(1.0) * np.linalg.norm(AngularVelocity.evaluate(state, name), axis=1)

    def present(self, words: Words, name: str) -> bool:
        """What turns by one hinge and does not roll, so that the engine says when it turns back."""
        mechanism = words.mechanism
        hinges = [c for c in mechanism.body[name].coordinates if c.kind == "hinge"]
        return len(hinges) == 1 and mechanism.body[name].parent is None and name in AngleTurned().subjects(mechanism)

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Not where geometry alone gives the angle."""
        return () if is_told_by_angles(moment, words) else super().when(moment, words, name)

    def worth(self, study: Study, name: str, end: float) -> bool:
        """Whether it turns back."""
        total = self.value(study.trace, name, end) or 0.0
        net = abs(float(AngleTurned.evaluate(study.trace.at(end), name)[0]))
        return total - net > DIFFERS * total and super().worth(study, name, end)

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """How fast it turns."""
        del mechanism
        return (Channel(name, AngularVelocity.name),)
