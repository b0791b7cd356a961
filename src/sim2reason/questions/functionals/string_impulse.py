"""The impulse of a string's tension."""

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.subjects.strings import Strings
from sim2reason.quantities.subjects.swinging_lines import line_pointer
from sim2reason.quantities.tension import Tension
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.integral import Integral
from sim2reason.questions.functionals.parts.jump import is_smooth
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@functional
class StringImpulse(Integral):
    """The impulse of the tension in a string that keeps its direction."""

    name, unit, least = "impulse of a tension", "N s", 1e-3
    of, needs = Strings(), ("mass",)
    weight = 0.2  # where its force is constant, that is asked for instead
    phrase = "the impulse of the tension in {string}"
    how = "how large is the impulse of the tension in {string} {when}?"

    def rate(self, state: State, name: str) -> Array:
        """The tension, (n,)."""
        return Tension.evaluate(state, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """None after an impact, at which a string may jerk."""
        return super().value(trace, name, end) if is_smooth(trace, end) else None

    def present(self, words: Words, name: str) -> bool:
        """A string that does not swing."""
        return line_pointer(words.mechanism, words.mechanism.line[name]) is None

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """The tension."""
        del mechanism
        return (Channel(name, Tension.name),)
