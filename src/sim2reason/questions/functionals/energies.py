"""Extreme values of energies, works and energies dissipated."""

from collections.abc import Mapping
from math import isfinite

import numpy as np

from sim2reason.questions.functionals import Functional, functional
from sim2reason.questions.functionals.aggregates import Extreme, Integral, is_smooth
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.occurrence import slip_velocity
from sim2reason.questions.moments.reached import DistanceThreshold
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Push, Resistance
from sim2reason.scenes.dsl.mechanism import ConstantTension, Elastic, Force, Inextensible, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import dot, subtract_triples
from sim2reason.simulation.quantities.energy import KineticEnergy
from sim2reason.simulation.quantities.force_laws import ExtensionRate, SpringEnergy
from sim2reason.simulation.quantities.forces import FrictionForce, StringLength, Tension
from sim2reason.simulation.quantities.kinematics import Displacement, Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies, moves_on_slider
from sim2reason.simulation.quantities.subjects.interactions import Contacts, Hands, Springs, strings
from sim2reason.simulation.trace import Channel, Trace


@functional
class DashpotHeat(Integral):
    """The energy that the dashpot beside a spring dissipates."""

    name, unit, least = "energy dissipated by a dashpot", "J", 1e-3
    of = Springs()
    phrase = "the energy that the dashpot beside {spring} dissipates"
    how = "how much energy does the dashpot beside {spring} dissipate {when}?"
    indirect = "how much energy the dashpot beside {spring} dissipates"
    weight = 5.0

    def rate(self, state: State, name: str) -> Array:
        """Return the power of the damping force, c·(dl/dt)², in W, (n,)."""
        return _damping(state.mechanism, name) * ExtensionRate.evaluate(state, name) ** 2

    def present(self, words: Words, name: str) -> bool:
        """Return whether the line is a damped spring that can push and pull."""
        return _damping(words.mechanism, name) > 0.0

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channel of the rate of change of the spring's length."""
        del mechanism
        return (Channel(name, ExtensionRate.name),)


def _damping(mechanism: Mechanism, name: str) -> float:
    law = mechanism.line[name].law
    return law.damping if isinstance(law, Elastic) and not law.side else 0.0


@functional
class DragHeat(Integral):
    """The energy that a body loses to the resistance of an unbounded medium."""

    name, unit, least = "energy lost to drag", "J", 1e-6
    of, needs = Bodies(), ("mass",)
    phrase = "the energy that {body} loses to the resistance of the medium"
    how = "how much energy does {body} lose to the resistance of the medium {when}?"
    indirect = "how much energy {body} loses to the resistance of the medium"
    weight = 5.0

    def rate(self, state: State, name: str) -> Array:
        """Return the power −F·v of the resistance, W, (n,)."""
        point, total = state.frames.center(name), np.zeros(len(state.times))
        for force in state.mechanism.forces:
            if force.body == name and isinstance(force.law, Resistance):
                pull = force.law.force(point.place, point.velocity, state.times, np)
                total = total - dot(pull, point.velocity)
        return total

    def present(self, words: Words, name: str) -> bool:
        """Return whether an unbounded medium resists the body."""
        drags = [f for f in words.mechanism.forces if f.body == name and isinstance(f.law, Resistance)]
        return bool(drags) and all(force.region is None for force in drags)

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channel of the body's velocity."""
        del mechanism
        return (Channel(name, Velocity.name),)


@functional
class FieldWork(Integral):
    """The work of the electric force on a charge; only positive work is asked for."""

    name, unit, least = "work of an electric field", "J", 1e-6
    of, needs = Bodies(), ("charge",)
    phrase = "the work that the electric field does on {body}"
    how = "how much work does the electric field do on {body} {when}?"
    indirect = "how much work the electric field does on {body}"
    weight = 1.5

    def rate(self, state: State, name: str) -> Array:
        """Return the power F·v of the electric force inside the field, W, (n,)."""
        point, total = state.frames.center(name), np.zeros(len(state.times))
        for force in _push_forces(state.mechanism, name):
            pull = force.law.force(point.place, point.velocity, state.times, np)
            power = dot(pull, point.velocity) + 0.0 * state.times
            if force.region is not None:
                margins = [margin + 0.0 * state.times for margin in force.region.margins(point.place, np)]
                power = np.where(np.min(margins, axis=0) > 0.0, power, 0.0)
            total = total + power
        return total

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the work, J; None if it is not positive."""
        work = super().value(trace, name, end)
        return work if work is not None and work > 0.0 else None

    def present(self, words: Words, name: str) -> bool:
        """Return whether the body is a charge in an electric field."""
        return bool(_push_forces(words.mechanism, name))

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channels of the body's velocity and displacement."""
        del mechanism
        return (Channel(name, Velocity.name), Channel(name, Displacement.name))


def _push_forces(mechanism: Mechanism, name: str) -> list[Force]:
    return [force for force in mechanism.forces if force.body == name and isinstance(force.law, Push)]


@functional
class FrictionHeat(Integral):
    """The energy dissipated by friction between a body and its face: the integral of force times slip speed."""

    name, unit, least = "energy dissipated by friction", "J", 1e-3
    of, needs = Contacts(), ("mass",)
    phrase = "the energy that friction between {body} and {surface} dissipates"
    how = "how much energy does friction between {body} and {surface} dissipate {when}?"
    indirect = "how much energy friction between {body} and {surface} dissipates"
    weight = 2.5

    def rate(self, state: State, name: str) -> Array:
        """Return the power −f·u of friction, W, (n,), which is never negative."""
        return -FrictionForce.evaluate(state, name) * slip_velocity(state, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the energy, J; None after an impact, in which friction may act as an impulse."""
        return super().value(trace, name, end) if is_smooth(trace, end) else None

    def present(self, words: Words, name: str) -> bool:
        """Return whether the contact has finite, nonzero friction."""
        return words.mechanism.contacts[name].friction > 0.0 and isfinite(words.mechanism.contacts[name].friction)

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channels of the friction force and of the velocities of the body and its carrier."""
        moving = (name, mechanism.body[name].parent)
        return (Channel(name, FrictionForce.name), *(Channel(body, Velocity.name) for body in moving if body))


@functional
class GreatestKineticEnergy(Extreme):
    """The greatest kinetic energy of a body, including its rotation."""

    name = "greatest kinetic energy"
    quantity = KineticEnergy
    phrase = "the greatest kinetic energy of {body}{ground}"
    weight = 0.2  # rather its greatest speed


@functional
class PullWork(Functional):
    """The work of a hand that draws in a string with a constant force."""

    name, unit, kind, least = "work of a hand", "J", "sum", 1e-3
    of = Hands()
    phrase = "the work that {hand} does"
    how = "how much work does {hand} do {when}?"
    indirect = "how much work {hand} does"
    weight = 1.5

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return phrases for the interval; none up to a stated distance, as force times distance is trivial."""
        return () if isinstance(moment, DistanceThreshold) else super().when(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the force times the length drawn in, J; None if it is not positive."""
        line = trace.mechanism.line[name]
        assert isinstance(line.law, ConstantTension)
        start, here = (float(trace.at(time).free_length(line)[0][0]) for time in (0.0, end))
        work = line.law.force * (start - here)
        return work if work > 0.0 else None

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channel of the string's length."""
        del mechanism
        return (Channel(name, StringLength.name),)


@functional
class GreatestSpringEnergy(Extreme):
    """The greatest energy stored in a spring."""

    name = "greatest spring energy"
    quantity = SpringEnergy
    phrase = "the greatest energy stored in {spring}"


@functional
class StringWork(Integral):
    """The work of the only string that is tied to a body; only positive work is asked for."""

    name, unit, least = "work of a tension", "J", 1e-3
    of, needs = Bodies(), ("mass",)
    phrase = "the work that the tension in {string} does on {body}"
    how = "how much work does the tension in {string} do on {body} {when}?"
    indirect = "how much work the tension in {string} does on {body}"
    weight = 0.2  # rather the tension itself

    def placeholders(self, words: Words, name: str) -> dict[str, str]:
        """Return the placeholder for the text's phrase for the string."""
        return {"string": _string_phrases(words)[_tied(words.mechanism, name)[0][0]]}

    def present(self, words: Words, name: str) -> bool:
        """Return whether one string, which the text names, is tied to the body, and nothing rides on the body."""
        tied = _tied(words.mechanism, name)
        ridden = any(body.parent == name for body in words.mechanism.bodies) or moves_on_slider(words.mechanism, name)
        return len(tied) == 1 and not ridden and tied[0][0] in _string_phrases(words)

    def rate(self, state: State, name: str) -> Array:
        """Return the power T·v of the tension, W, (n,)."""
        line, own, other = _tied(state.mechanism, name)[0]
        here, there = state.frames.site(own), state.frames.site(other)
        separation = subtract_triples(there.place, here.place)
        length: Array = np.sqrt(dot(separation, separation)) + 0.0 * state.times
        along = dot(separation, here.velocity) / np.where(length > 0.0, length, 1.0)  # no way, where it has no length
        return Tension.evaluate(state, line) * along

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the work, J; None after an impact, which may jerk the string, or if the work is not positive."""
        known = is_smooth(trace, end) and _tied(trace.mechanism, name)  # the string may have been left out
        work = super().value(trace, name, end) if known else None
        return work if work is not None and work > 0.0 else None

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channels of the tension and the body's velocity."""
        return (Channel(_tied(mechanism, name)[0][0], Tension.name), Channel(name, Velocity.name))


def _string_phrases(words: Words) -> Mapping[str, str]:
    return strings(words.mechanism, words.mentions)


def _tied(mechanism: Mechanism, name: str) -> list[tuple[str, str, str]]:
    """Return the strings that end at a body, each with its point of attachment there and the next point along it."""
    attachments = list[tuple[str, str, str]]()
    for line in mechanism.lines:
        if isinstance(line.law, Inextensible):
            for own, other in ((line.through[0], line.through[1]), (line.through[-1], line.through[-2])):
                if mechanism.site[own].body == name:
                    attachments.append((line.name, own, other))
    return attachments
