"""The tension of a string is taken to be the weight that hangs from it."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import with_lines
from sim2reason.dsl.mechanism import ConstantTension, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.hanging import hanging
from sim2reason.questions.study import Study


@simplification
class WeightAsTension(ChangedMechanism):
    """What hangs from a string is taken to pull with its weight, as if it were at rest."""

    name = "weight as tension"
    reason = "the tension in a string is taken to balance the weight that hangs from it"
    sound_if_same = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Whatever hangs."""
        del query
        return hanging(study.mechanism)

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With that tension in what holds it, shared by as many pieces as run up from it."""
        held = hanging(mechanism)[subject]
        law = ConstantTension(held.mass * -mechanism.gravity[2] / held.runs)
        return with_lines(mechanism, held.strings, lambda line: replace(line, law=law))
