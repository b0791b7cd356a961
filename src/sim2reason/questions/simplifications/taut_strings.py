"""Strings are taken to stay taut."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import with_lines
from sim2reason.dsl.mechanism import Inextensible, Line, Mechanism, Rigid
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.asked import asked_until
from sim2reason.questions.study import Study


@simplification
class TautStrings(ChangedMechanism):
    """Strings are taken to stay taut, and would push where they should go slack."""

    name = "taut strings"
    reason = "a string that goes slack is taken as taut"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where one is slack before the moment."""
        state = study.trace.state
        before = state.times <= asked_until(query, study)
        slack = any((state.tension[line.name][before] <= 0.0).any() for line in _plain(study.mechanism))
        return [""] if slack else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With rods in their place."""
        del subject
        names = [line.name for line in _plain(mechanism)]
        return with_lines(mechanism, names, lambda line: replace(line, law=Rigid()))


def _plain(mechanism: Mechanism) -> list[Line]:
    """The strings that are taut from the start and not drawn in."""
    law = Inextensible()
    return [line for line in mechanism.strings if line.law == law]
