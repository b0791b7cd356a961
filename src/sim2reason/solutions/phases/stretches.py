"""Stretches of a motion between the events that change its equations, up to the moment asked."""

from dataclasses import dataclass

from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.moments import Happening
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.simulation.trace import Event
from sim2reason.solutions.phases.extremes import top
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.writing.steps import UnsolvedError

MOST_PHASES = 8  # a longer solution would not be read
SAME_TIME = 1e-9  # relative: an event so close to the moment asked is that moment


@dataclass(frozen=True, slots=True)
class Stretch:
    """A segment of the motion with the time, s, and the events that end it."""

    segment: Segment
    ends: float
    events: tuple[Event, ...]


def asked_time(setting: Setting) -> float:
    """Return the time, s, at which the answer is decided; for an extreme value only about."""
    query = setting.query
    if query.kind == "extremum" and isinstance(query, StretchQuery):
        return top(setting.motion, query.functional, query.name, setting.time)
    return query.moment.side(setting.time) if query.moment is not None else setting.time


def stretches(setting: Setting, time: float) -> list[Stretch]:
    """Return the stretches up to a time, s.

    Raises:
        UnsolvedError: there is none, there are too many, or one ends without an event.
    """
    motion, moment = setting.motion, setting.query.moment
    segments = [s for s in motion.segments if s.start < time or s.start == 0.0]
    ends_at_event = moment is not None and moment.event and setting.query.kind != "extremum"
    found: list[Stretch] = []
    for segment, following in zip(segments, [*segments[1:], None], strict=True):
        ends = following.start if following is not None else time
        near = SAME_TIME * max(ends, SAME_TIME)
        events = tuple(e for e in motion.events if e.changes_motion and abs(e.time - ends) <= near)
        if following is None and not ends_at_event:
            events = ()
        if following is not None and not events:
            raise UnsolvedError("the equations change where no event is recorded")
        found.append(Stretch(segment, ends, events))
    if not found or len(found) > MOST_PHASES:
        raise UnsolvedError(f"the motion has {len(found)} phases")
    return found


def moment_words(setting: Setting) -> str:
    """Return what happens at the moment asked about, as a statement; empty if the question has no words for it."""
    moment = setting.query.moment
    if setting.query.kind == "extremum" or not isinstance(moment, Happening):
        return ""
    clause = moment.clause(setting.words)
    return clause.statement if clause is not None else ""
