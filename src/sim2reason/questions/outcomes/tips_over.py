"""The outcome that a body that stands on an edge tips over the edge, and does not fall back."""

from dataclasses import dataclass

import numpy as np

from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.outcomes import OUTCOMES, Swinging
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

STANDS = 1e-9  # m: the height above the plane of an edge that stands on it


@OUTCOMES.register("tips_over")
@dataclass(frozen=True, slots=True)
class TipsOver(Swinging):
    """A body that is set turning about its edge lands on its next face; only people ask about it."""

    of = Bodies()
    drawn_by_recipes = False

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that stand on edges and are set moving, by name."""
        mechanism = words.mechanism
        standing = {mechanism.site[foot.site].body for foot in mechanism.feet if not words.released}
        return {name: said for name, said in words.called(cls.of).items() if name in standing}

    def happens(self, trace: Trace) -> bool | None:
        """Return whether the first edge to land is one that did not stand on the plane at the start."""
        first = next((event for event in trace.events if event.kind in ("land", "leave")), None)
        if first is None or first.kind == "leave":  # so fast that its edge leaves the plane: it does not fall back
            return None if first is None else True
        landed = first.subjects[0]
        foot = next(foot for foot in trace.mechanism.feet if foot.name == landed)
        began = trace.at(0.0)
        place = began.vector(began.frames.site(foot.site).place)[0]
        return float(np.dot(foot.normal, place)) - foot.height > STANDS

    def excess(self, trace: Trace) -> float:
        """Return the square of the least rate of turning until the first edge lands, rad²/s²."""
        landed = next((event.time for event in trace.events if event.kind == "land"), float(trace.state.times[-1]))
        hinges = [n for n, c in enumerate(trace.mechanism.coordinates) if c.kind == "hinge" and c.body == self.name]
        scan = trace.until(float(np.nextafter(landed, 0.0))).scan
        return float(np.square(scan.v[:, hinges].sum(axis=1)).min())

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the prism tips over*."""
        return (f"{self.subject(words)} tips over its edge",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the prism does not tip over*."""
        return (f"{self.subject(words)} does not tip over its edge",)
