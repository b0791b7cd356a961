"""A body is left out."""

from collections.abc import Iterable

from sim2reason.dsl.ablation import left_out
from sim2reason.dsl.constancy import bending
from sim2reason.dsl.frames import start
from sim2reason.dsl.mechanism import Elastic, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import others
from sim2reason.questions.study import Study


@simplification
class BodyLeftOut(ChangedMechanism):
    """A body is left out: it has no mass, and nothing meets it."""

    name = "body left out"
    reason = "all is taken to move as if {subject} were not there"
    part = True
    misleads = False

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """All of several with mass but what would tremble without it: on springs, across strings, as a pivot."""
        del query
        mechanism = study.mechanism
        elastic = [line for line in mechanism.lines if isinstance(line.law, Elastic)]
        sprung = {mechanism.site[site].body for line in elastic for site in line.through}
        sprung |= {body for line in elastic for body in line.circle or ()}
        frames = start(mechanism)
        turning = [line for line in mechanism.lines if bending(line, frames)]
        held = {mechanism.site[site].body for line in turning for site in (line.through[0], line.through[-1])}
        pivots = {body.parent for body in mechanism.bodies if any(c.kind == "hinge" for c in body.coordinates)}
        return [name for name in others(mechanism) if name not in sprung | held | pivots]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """All but without it."""
        return left_out(mechanism, subject)
