"""Extreme values of forces and of the extension of springs, and impulses of forces."""

import numpy as np

from sim2reason.questions.choices import only_falls
from sim2reason.questions.functionals import Functional, functional
from sim2reason.questions.functionals.aggregates import Extreme, Integral, energies, energy_lost, is_smooth
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.strings import WentTaut
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities.force_laws import Extension, SpringForce
from sim2reason.simulation.quantities.forces import AxleForce, NormalForce, RodForce, RodPull, Tension
from sim2reason.simulation.quantities.momentum import Momentum
from sim2reason.simulation.quantities.subjects.bodies import Bodies, is_welded_part
from sim2reason.simulation.quantities.subjects.interactions import Strings
from sim2reason.simulation.quantities.subjects.rotating_parts import line_pointer
from sim2reason.simulation.trace import Channel, Trace


@functional
class GreatestAxleForce(Extreme):
    """The greatest magnitude of the force that a fixed axle exerts on the body that turns about it."""

    name = "greatest axle force"
    quantity = AxleForce
    impulsive = True
    phrase = "the greatest magnitude of the force that the axle exerts on {body}"
    weight = 3.0


@functional
class GreatestExtension(Extreme):
    """The greatest extension of a spring."""

    name = "greatest extension"
    quantity = Extension
    phrase = "the greatest extension of {spring}"
    weight = 3.0

    def height(self, state: State, name: str) -> Array:
        """Return the extension, m, (n,)."""
        return Extension.evaluate(state, name)


@functional
class GreatestCompression(Extreme):
    """The greatest compression of a spring."""

    name = "greatest compression"
    quantity = Extension
    phrase = "the greatest compression of {spring}"
    weight = 3.0

    def height(self, state: State, name: str) -> Array:
        """Return the compression, m, (n,)."""
        return -Extension.evaluate(state, name)


@functional
class GreatestNormalForce(Extreme):
    """The greatest normal force that a face exerts on a body."""

    name = "greatest normal force"
    quantity = NormalForce
    impulsive = True
    phrase = "the greatest normal force exerted on {body} by {surface}"
    weight = 2.0


@functional
class LeastNormalForce(Extreme):
    """The least normal force that a face exerts on a body."""

    name = "least normal force"
    quantity = NormalForce
    sign = -1.0
    phrase = "the least normal force exerted on {body} by {surface}"


@functional
class GreatestRodForce(Extreme):
    """The greatest magnitude of the force in a light rod, be it a pull or a push."""

    name = "greatest rod force"
    quantity = RodForce
    impulsive = True
    phrase = "the greatest magnitude of the force in {rod}"
    weight = 5.0


@functional
class GreatestRodPull(Extreme):
    """The greatest magnitude of the force in a light rod on a moving axle; never drawn by recipes."""

    name = "greatest rod pull"
    quantity = RodPull
    impulsive = True
    drawn_by_recipes = False
    phrase = "the greatest magnitude of the force in {rod}"


@functional
class GreatestSpringForce(Extreme):
    """The greatest magnitude of the force of a spring, N, whether it pulls or pushes; never drawn by recipes."""

    name = "greatest spring force"
    quantity = SpringForce
    phrase = "the greatest force exerted by {spring}"
    drawn_by_recipes = False


@functional
class GreatestTension(Extreme):
    """The greatest tension in a string."""

    name = "greatest tension"
    quantity = Tension
    impulsive = True
    phrase = "the greatest tension in {string}"
    weight = 5.0


@functional
class LeastTension(Extreme):
    """The least tension in a string that never goes slack."""

    name = "least tension"
    quantity = Tension
    sign = -1.0
    phrase = "the least tension in {string}"


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


MIN_MOMENTUM_EXCESS = 0.02  # of the final momentum: least difference of the impulse from it


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
        return all(abs(change - size) > MIN_MOMENTUM_EXCESS * size for size in sizes)

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
