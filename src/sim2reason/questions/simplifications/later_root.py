"""The second time that something happens is taken for the first."""

from collections.abc import Iterable
from math import inf, isfinite

from sim2reason.questions.crossing import crossings
from sim2reason.questions.moments.parts.passage import Passage
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import OtherReading, simplification
from sim2reason.questions.study import Study, Timed


@simplification
class LaterRoot(OtherReading):
    """Where an equation for the time has two roots, the later one is taken."""

    name = "later root"
    reason = "the second time at which this happens is taken for the first"
    sound_if_same = True  # then what is asked hangs on the place alone, and who takes energies never asks for the time

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where a passage is asked about, which can come twice."""
        del study
        return [""] if _is_passage(query.moment) else []

    def read(self, study: Study) -> Study:
        """The same motion, in which passages are what they are the second time."""
        return _Later(study.scene, study.trace)


def _is_passage(moment: object) -> bool:
    return isinstance(moment, Passage) and type(moment).time is Passage.time


class _Later(Study):
    """A motion in which whatever is passed for the first time counts when it is passed again."""

    def time(self, moment: Timed) -> float | None:
        """When a passage comes for the second time, from either side; of all else the first time."""
        first = super().time(moment)
        if first is None or not (isinstance(moment, Passage) and _is_passage(moment)):
            return first
        back = crossings(self.trace, lambda state: -moment.excess(state))
        again = (
            next((time for time in side if time > first), inf) for side in (crossings(self.trace, moment.excess), back)
        )
        later = min(again)
        return later if isfinite(later) else None
