"""A hand that draws a string is left out."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import with_lines
from sim2reason.dsl.mechanism import ConstantTension, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class HandLeftOut(ChangedMechanism):
    """The pull of a hand on a string is left out."""

    name = "hand left out"
    reason = "the pull of the hand is left out"
    part = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The lines that are drawn in."""
        del query
        return [line.name for line in study.mechanism.pulls]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With a force of zero."""
        return with_lines(mechanism, [subject], lambda line: replace(line, law=ConstantTension(0.0)))
