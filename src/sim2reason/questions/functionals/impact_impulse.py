"""The impulse that a wall or the ground exerts on a body."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.momentum import Momentum
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.functionals import Functional, functional
from sim2reason.questions.functionals.parts.encounter import encounter
from sim2reason.questions.functionals.parts.jump import hits, is_loose, jumps
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.bounced import WALLS, struck
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace

FEWEST = 2  # impacts in a sum of them


class FromFixed(Functional):
    """What something fixed does to a body that bounces from it."""

    unit, kind, least = "N s", "sum", 1e-3
    of, needs = Bodies(), ("mass",)

    def present(self, words: Words, name: str) -> bool:
        """A loose body that can meet the ground, or one wall."""
        return struck(words, name) not in {"", WALLS} and is_loose(words.mechanism, name)

    def own(self, words: Words, name: str) -> dict[str, str]:
        """What it meets."""
        return {"what": struck(words, name)}

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Its momentum."""
        del mechanism
        return (Channel(name, Momentum.name),)

    def sum(self, trace: Trace, name: str, times: list[float]) -> float | None:
        """|Σ mΔv|; None if anything else strikes the body at one of these instants."""
        others = hits(trace, times[-1], lambda e: name in e.subjects and len(e.subjects) > 1) if times else []
        if not times or set(others) & set(times):
            return None
        return float(np.linalg.norm(np.sum(jumps(trace, lambda s: Momentum.evaluate(s, name), times), axis=0)))


@functional
class ImpactImpulse(FromFixed):
    """The size of the impulse of one impact."""

    name = "impulse of an impact"
    phrase = "the magnitude of the impulse that {what} exerts on {body}"
    how = "how large is the impulse that {what} exerts on {body} {when}?"
    weight = 3.0

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """As in: in their second collision."""
        return encounter(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """m|Δv|."""
        return self.sum(trace, name, [end])


@functional
class TotalImpactImpulse(FromFixed):
    """The size of the impulse of several impacts, which all have one direction."""

    name = "total impulse of impacts"
    phrase = "the magnitude of the total impulse that {what} exerts on {body}"
    how = "how large is the total impulse that {what} exerts on {body} {when}?"

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """|Σ mΔv|."""
        return self.sum(trace, name, hits(trace, end, lambda event: event.subjects == (name,)))

    def worth(self, study: Study, name: str, end: float) -> bool:
        """Whether there are several."""
        return len(hits(study.trace, end, lambda event: event.subjects == (name,))) >= FEWEST
