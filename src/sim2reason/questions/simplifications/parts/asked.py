"""How much of a motion a query is about."""

from sim2reason.questions.kinds import KINDS
from sim2reason.questions.query import Query
from sim2reason.questions.study import Study


def asked_until(query: Query, study: Study) -> float:
    """Return the time of the moment that is asked about, s; the end of the motion where there is none."""
    time = study.time(query.moment) if query.moment is not None else None
    return float(study.trace.state.times[-1]) if time is None else time


def asked_name(query: Query) -> str:
    """Return what is asked for: the name of a quantity or of a functional, as that of an item's answer."""
    return KINDS[query.kind].measured(query).name
