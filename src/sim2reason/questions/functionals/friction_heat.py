"""The energy that friction on a face dissipates."""

from math import isfinite

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.contact import FrictionForce
from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.contacts import Contacts
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.integral import Integral
from sim2reason.questions.functionals.parts.jump import is_smooth
from sim2reason.questions.moments.parts.slip_change import slip
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@functional
class FrictionHeat(Integral):
    """The energy that friction between a body and its face dissipates: friction times the speed of slip, over time."""

    name, unit, least = "energy dissipated by friction", "J", 1e-3
    of, needs = Contacts(), ("mass",)
    phrase = "the energy that friction between {body} and {surface} dissipates"
    how = "how much energy does friction between {body} and {surface} dissipate {when}?"
    indirect = "how much energy friction between {body} and {surface} dissipates"
    weight = 2.5

    def rate(self, state: State, name: str) -> Array:
        """−f·u, W, (n,), never negative."""
        return -FrictionForce.evaluate(state, name) * slip(state, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """None after an impact, at which a face may rub with an impulse."""
        return super().value(trace, name, end) if is_smooth(trace, end) else None

    def present(self, words: Words, name: str) -> bool:
        """Only where something rough can slip."""
        return words.mechanism.contacts[name].friction > 0.0 and isfinite(words.mechanism.contacts[name].friction)

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """The force, and how fast the body and what it lies on move."""
        moving = (name, mechanism.body[name].parent)
        return (Channel(name, FrictionForce.name), *(Channel(body, Velocity.name) for body in moving if body))
