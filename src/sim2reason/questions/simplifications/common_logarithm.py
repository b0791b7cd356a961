"""The logarithm to base ten is taken for the natural one."""

from collections.abc import Iterable
from dataclasses import replace
from math import log

from sim2reason.dsl.mechanism import Burn, Mechanism
from sim2reason.dsl.mobility import weighs
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.burning import BurningSlip
from sim2reason.questions.study import Study


@simplification
class CommonLogarithm(BurningSlip):
    """The velocity is the exhaust speed times the logarithm to base ten of the ratio of the masses."""

    name = "common logarithm"
    reason = "the logarithm to base ten is taken for the natural one"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return the bodies that burn fuel if their thrust is the only force; else none."""
        mechanism = study.mechanism
        return [] if weighs(mechanism) or mechanism.attractions else super().subjects(query, study)

    def burnt(self, mechanism: Mechanism, burn: Burn) -> Burn:
        """Return a burn whose exhaust is slower by ln 10, which has the same effect on the velocity."""
        del mechanism
        return replace(burn, exhaust=burn.exhaust / log(10.0))
