"""A spring is left out."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import with_lines
from sim2reason.dsl.mechanism import Elastic, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class SpringLeftOut(ChangedMechanism):
    """A spring is left out, and with it the energy that it stores."""

    name = "spring left out"
    reason = "{subject} is left out"
    part = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """All springs."""
        del query
        return [line.name for line in study.mechanism.lines if isinstance(line.law, Elastic)]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With a spring that pulls at nothing."""
        return with_lines(mechanism, [subject], lambda line: replace(line, law=Elastic(0.0, 0.0)))
