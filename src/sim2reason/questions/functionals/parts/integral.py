"""What adds up over time: the integral of a rate."""

from abc import abstractmethod
from collections.abc import Iterable

import numpy as np

from sim2reason.dsl.state import Array, State
from sim2reason.questions.functionals import Functional
from sim2reason.questions.quadrature import integral
from sim2reason.questions.study import Study
from sim2reason.simulation.trace import Trace

LATE, NOTHING = 0.9, 1e-6  # of the stretch; of the greatest rate


class Integral(Functional):
    """The integral of a rate, which has no impulses, from the start to a moment."""

    kind = "sum"

    @abstractmethod
    def rate(self, state: State, name: str) -> Array:
        """What is integrated, (n,), in the unit per second."""

    def corners(self, trace: Trace, name: str) -> Iterable[float]:
        """When the rate has a corner though nothing happens, s; by default never."""
        del trace, name
        return ()

    def worth(self, study: Study, name: str, end: float) -> bool:
        """Whether it still grows shortly before the end of the stretch: else that end decorates the question."""
        scan = study.trace.scan
        rates, within = np.abs(self.rate(scan, name)), scan.times <= end
        late = rates[within & (scan.times >= LATE * end)]
        return float(late.max(initial=0.0)) > NOTHING * float(rates[within].max(initial=0.0))

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """By Gauss's rule on the engine's steps."""
        return integral(trace, lambda state: self.rate(state, name), end, self.corners(trace, name))
