"""Moments at which something is the greatest that it gets."""

from abc import abstractmethod
from dataclasses import dataclass, replace
from math import inf
from typing import ClassVar, Self

from sim2reason.dsl.state import Array, State
from sim2reason.questions.crossing import begins_beyond, crossings, jumps
from sim2reason.questions.moments.parts.passage import Passage
from sim2reason.simulation.trace import Trace

SAME = 1e-6  # of the way between its least and its greatest value


@dataclass(frozen=True, slots=True)
class Peak(Passage):
    """The first time that something is the greatest that it gets while the motion is followed.

    A motion that begins there has none that anybody would call the first.

    Class data:
        above: what it must exceed there, as an extension must zero.
    """

    above: ClassVar[float] = -inf

    exceeded: bool = False  # whether it may be, later

    def first(self) -> Self:
        """The first time that it turns back, even if it gets beyond that later, and if the motion begins so."""
        return replace(self, exceeded=True)

    @abstractmethod
    def extent(self, state: State) -> Array:
        """What is greatest then, (n,); `excess` is the rate at which it sinks."""

    def time(self, trace: Trace) -> float | None:
        """When it first turns back, if it never gets beyond, and nothing has struck it back at once before."""
        if begins_beyond(trace, self.excess) and not self.exceeded:
            return None
        reached = ((time, float(self.extent(trace.at(time))[0])) for time in crossings(trace, self.excess))
        first = next(((time, value) for time, value in reached if value > self.above), None)
        turned = first[0] if first is not None else inf
        struck = (at for at in jumps(trace, self.excess) if float(self.extent(trace.at(at))[0]) > self.above)
        earliest = min(turned, next(struck, inf))
        if first is None or self.exceeded or earliest < turned:
            return earliest if self.exceeded and earliest < inf else None
        everywhere = self.extent(trace.scan)
        greatest, least = float(everywhere.max()), float(everywhere.min())
        return first[0] if first[1] >= greatest - SAME * (greatest - least) else None
