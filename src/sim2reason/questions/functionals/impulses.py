"""Impulses of strings and of the net force, and the energy lost when a string becomes taut."""

import numpy as np

from sim2reason.questions.choices import only_falls
from sim2reason.questions.functionals import Functional, functional
from sim2reason.questions.functionals.parts.integral import Integral, energies, energy_lost, is_smooth
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.strings import WentTaut
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.quantities.forces import Tension
from sim2reason.simulation.quantities.momentum import Momentum
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.simulation.quantities.subjects.lines import Strings
from sim2reason.simulation.quantities.subjects.paths import is_welded_part
from sim2reason.simulation.quantities.subjects.rods import line_pointer
from sim2reason.simulation.trace import Trace


@functional
class JerkLoss(Functional):
    """The kinetic energy lost in the jerk with which a string becomes taut."""

    name, unit, kind, least = "energy lost in a jerk", "J", "sum", 1e-3
    of, needs = Strings(), ("mass",)
    phrase = "the total kinetic energy lost"
    how = "how much kinetic energy is lost {when}?"
    weight = 5.0

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *when the string first becomes taut again*."""
        if not (isinstance(moment, WentTaut) and moment.after and moment.name == name):
            return ()
        return moment.does(words).phrases(moment.subject(words), moment.number)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the kinetic energy lost by all bodies, J."""
        del name
        return energy_lost(trace, [end])

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channels of all kinetic energies."""
        del name
        return energies(mechanism)


DIFFERS = 0.02  # of the final momentum: least difference of the impulse from it


@functional
class NetImpulse(Functional):
    """The magnitude of the impulse of the net force, which is the change of momentum as a vector."""

    name, unit, kind, least = "impulse of the net force", "N s", "sum", 1e-3
    of, needs, center = Bodies(), ("mass",), False
    phrase = "the magnitude of the impulse of the net force on {body}"
    weight = 0.02

    def present(self, words: Words, name: str) -> bool:
        """Return whether a body has constant mass and is not part of a larger rigid body."""
        mechanism = words.mechanism
        return all(burn.body != name for burn in mechanism.burns) and not is_welded_part(mechanism, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return |p − p₀|, in N s."""
        return float(np.linalg.norm(_momentum(trace, name, end) - _momentum(trace, name, 0.0)))

    def worth(self, study: SimulatedScene, name: str, end: float) -> bool:
        """Return whether the value differs from the final and initial momentum and from a weight times a time."""
        if only_falls(study.mechanism) and is_smooth(study.trace, end):
            return False
        change = self.value(study.trace, name, end) or 0.0
        sizes = [float(np.linalg.norm(_momentum(study.trace, name, time))) for time in (0.0, end)]
        return all(abs(change - size) > DIFFERS * size for size in sizes)

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channel of the body's momentum."""
        del mechanism
        return (Channel(name, Momentum.name),)


def _momentum(trace: Trace, name: str, time: float) -> np.ndarray:
    return Momentum.evaluate(trace.at(time), name)[0]


@functional
class StringImpulse(Integral):
    """The impulse of the tension in a string that keeps its direction."""

    name, unit, least = "impulse of a tension", "N s", 1e-3
    of, needs = Strings(), ("mass",)
    weight = 0.2  # where its force is constant, that is asked for instead
    phrase = "the impulse of the tension in {string}"
    how = "how large is the impulse of the tension in {string} {when}?"

    def rate(self, state: State, name: str) -> Array:
        """Return the tension, N, (n,)."""
        return Tension.evaluate(state, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the impulse, N s; None after an impact, in which a string may jerk."""
        return super().value(trace, name, end) if is_smooth(trace, end) else None

    def present(self, words: Words, name: str) -> bool:
        """Return whether the string keeps its direction."""
        return line_pointer(words.mechanism, words.mechanism.line[name]) is None

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channel of the tension."""
        del mechanism
        return (Channel(name, Tension.name),)
