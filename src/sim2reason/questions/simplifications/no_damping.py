"""Dashpots are left out."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import with_lines
from sim2reason.dsl.mechanism import Elastic, Line, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class NoDamping(ChangedMechanism):
    """All dashpots are left out."""

    name = "no damping"
    reason = "damping is left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where anything is damped."""
        del query
        return [""] if _damped(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With springs alone."""
        del subject
        return with_lines(mechanism, _damped(mechanism), _undamped)


def _damped(mechanism: Mechanism) -> list[str]:
    return [line.name for line in mechanism.lines if isinstance(line.law, Elastic) and line.law.damping]


def _undamped(line: Line) -> Line:
    assert isinstance(line.law, Elastic)
    return replace(line, law=replace(line.law, damping=0.0))
