"""The work that a string does on a body that is tied to it."""

from collections.abc import Mapping

import numpy as np

from sim2reason.dsl.mechanism import Inextensible, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import minus, product
from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import rides
from sim2reason.quantities.subjects.strings import strings
from sim2reason.quantities.tension import Tension
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.integral import Integral
from sim2reason.questions.functionals.parts.jump import is_smooth
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@functional
class StringWork(Integral):
    """The work of the only string that is tied to a body, where it is positive."""

    name, unit, least = "work of a tension", "J", 1e-3
    of, needs = Bodies(), ("mass",)
    phrase = "the work that the tension in {string} does on {body}"
    how = "how much work does the tension in {string} do on {body} {when}?"
    indirect = "how much work the tension in {string} does on {body}"
    weight = 0.2  # rather the tension itself

    def own(self, words: Words, name: str) -> dict[str, str]:
        """What the text calls the string."""
        return {"string": _called(words)[_tied(words.mechanism, name)[0][0]]}

    def present(self, words: Words, name: str) -> bool:
        """A body with one string, which the text can name, that rides on no other, and on which no pulley rides."""
        tied = _tied(words.mechanism, name)
        ridden = any(body.parent == name for body in words.mechanism.bodies) or rides(words.mechanism, name)
        return len(tied) == 1 and not ridden and tied[0][0] in _called(words)

    def rate(self, state: State, name: str) -> Array:
        """T·v along the string, away from the body, W, (n,)."""
        line, own, other = _tied(state.mechanism, name)[0]
        here, there = state.frames.site(own), state.frames.site(other)
        apart = minus(there.place, here.place)
        length: Array = np.sqrt(product(apart, apart)) + 0.0 * state.times
        along = product(apart, here.velocity) / np.where(length > 0.0, length, 1.0)  # no way, where it has no length
        return Tension.evaluate(state, line) * along

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """None after an impact, at which a string may jerk, and where it is against the motion on the whole."""
        known = is_smooth(trace, end) and _tied(trace.mechanism, name)  # the string may have been left out
        work = super().value(trace, name, end) if known else None
        return work if work is not None and work > 0.0 else None

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """The tension and the velocity."""
        return (Channel(_tied(mechanism, name)[0][0], Tension.name), Channel(name, Velocity.name))


def _called(words: Words) -> Mapping[str, str]:
    return strings(words.mechanism, words.mentions)


def _tied(mechanism: Mechanism, name: str) -> list[tuple[str, str, str]]:
    """The strings that pass or end at a body, each with its site there and the next site."""
    found = list[tuple[str, str, str]]()
    for line in mechanism.lines:
        if isinstance(line.law, Inextensible):
            for own, other in ((line.through[0], line.through[1]), (line.through[-1], line.through[-2])):
                if mechanism.site[own].body == name:
                    found.append((line.name, own, other))
    return found
