"""Bodies that move are taken not to attract each other."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.mechanism import Attraction, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class NoMutualAttraction(ChangedMechanism):
    """Bodies that move are taken not to attract each other, as planets of one star."""

    name = "no mutual attraction"
    reason = "the attraction between the moving bodies is left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where a fixed body attracts them as well."""
        del query
        mechanism = study.mechanism
        mutual = [_is_mutual(mechanism, pull) for pull in mechanism.attractions]
        return [""] if any(mutual) and not all(mutual) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Without it."""
        del subject
        kept = tuple(pull for pull in mechanism.attractions if not _is_mutual(mechanism, pull))
        return replace(mechanism, attractions=kept)


def _is_mutual(mechanism: Mechanism, pull: Attraction) -> bool:
    return all(mechanism.body[name].coordinates for name in (pull.a, pull.b))
