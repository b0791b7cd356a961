"""The length of a spring is taken for its extension."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import with_lines
from sim2reason.dsl.mechanism import Elastic, Line, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class LengthAsExtension(ChangedMechanism):
    """The natural length of springs is forgotten."""

    name = "length as extension"
    reason = "the length of a spring is taken for its extension"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where a spring acts both ways."""
        del query
        return [""] if _springs(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With springs of no natural length."""
        del subject
        return with_lines(mechanism, _springs(mechanism), _short)


def _springs(mechanism: Mechanism) -> list[str]:
    straight = (line for line in mechanism.lines if line.circle is None)
    return [line.name for line in straight if isinstance(line.law, Elastic) and not line.law.side]


def _short(line: Line) -> Line:
    assert isinstance(line.law, Elastic)
    return replace(line, law=replace(line.law, length=0.0))
