"""Extreme values that a body in free flight takes at the top of its path."""

from dataclasses import replace

from sim2reason.questions import KINDS, Query
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.moments.highest_point import HighestPoint
from sim2reason.questions.targets import Target
from sim2reason.solutions.setting import Setting

AT_TOP = frozenset({"greatest height", "least speed"})
SAME = 1e-6  # relative: the value at the top is the extreme one


def at_top(setting: Setting) -> Setting | None:
    """Return the question about the value at the top of the path; None if that is not the extreme value asked for."""
    query, study = setting.query, setting.study
    if not isinstance(query, StretchQuery) or query.functional not in AT_TOP:
        return None
    functional, moment = FUNCTIONALS[query.functional], HighestPoint(query.name)
    assert isinstance(functional, Extreme)
    asked = Query("event", Target(functional.quantity.name, query.name, functional.sense), moment)
    time = study.time(moment)
    if time is None or time > setting.time:
        return None
    value, extreme = KINDS["event"].answer(asked, study), KINDS[query.kind].answer(query, study)
    if value is None or extreme is None or abs(value - extreme) > SAME * abs(extreme):
        return None
    return replace(setting, query=asked)
