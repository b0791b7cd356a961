"""Moments at which a quantity reaches a value, expressed by a distance, an angle or a time at the same instant."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import isclose

from sim2reason.questions import Query
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.angles import Deflected, TurnedThrough
from sim2reason.questions.moments.crossings import Threshold
from sim2reason.questions.moments.distances import Away, Moved
from sim2reason.questions.moments.reached import Reached
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.query import Target
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.writing.unit_latex import DEGREES, METRES, SECONDS

SAME_TIME = 1e-9  # relative: two moments that are closer are one
UNITS: Mapping[str, str] = {"s": SECONDS, "m": METRES, "deg": DEGREES}
THRESHOLDS: Mapping[str, tuple[type[Threshold], ...]] = {
    "displacement": (Moved, Away),
    "deflection": (Deflected,),
    "angle turned": (TurnedThrough,),
}
"""By quantity, the moments at which its magnitude has a stated value for the first time."""


def number_unit(moment: Moment | None) -> str:
    """Return the unit, in LaTeX, of the time, distance or angle that defines a moment; seconds if none does."""
    stated = moment.stated if moment is not None else ()
    return UNITS.get(stated[0][1], "") if stated else SECONDS


def at_named_moment(setting: ProblemContext) -> ProblemContext:
    """Return the question with *its displacement is 2 m* as the moment *it has moved 2 m*; others are unchanged."""
    moment = setting.query.moment
    if not isinstance(moment, Reached):
        return setting
    named = next(_thresholds(setting, moment.target, moment.given.value), None)
    return setting if named is None else replace(setting, query=Query(named.kind, setting.query.target, named))


def _thresholds(setting: ProblemContext, target: Target, value: float) -> Iterator[Threshold]:
    """Yield the moments at which a quantity first has a value, if they coincide with the moment of the question."""
    if target.sense is not None or setting.unknown or value <= 0.0:
        return
    for cls in THRESHOLDS.get(target.quantity, ()):
        if target.subject in cls.candidates(setting.words):
            moment = cls(target.subject, value)
            time = setting.study.time(moment)
            if time is not None and isclose(time, setting.time, rel_tol=SAME_TIME):
                yield moment


def instants(setting: ProblemContext) -> Iterator[tuple[Moment, float]]:
    """Yield (moment, its distance, angle or time) for each moment at the same instant as the question's moment.

    Distances along a line and angles come first, at which energy gives speeds without the time, which comes last.
    """
    reached, query = setting.query.moment, setting.query
    assert isinstance(reached, Reached)
    asked = (query.target.subject,) if query.target is not None else ()
    for quantity, classes in THRESHOLDS.items():
        kept = (
            [] if setting.mechanism.burns else [cls for cls in classes if cls is not Away]
        )  # its mass hangs on the time
        subjects = {name: None for cls in kept for name in cls.candidates(setting.words)}
        for subject in sorted(subjects, key=lambda name: name not in (*asked, reached.target.subject)):
            target = Target(quantity, subject)
            value = target.value(setting.study.trace.at(setting.time))
            yield from ((moment, value) for moment in _thresholds(setting, target, value))
    yield AtTime(setting.time), setting.time


def is_number_of(moment: Moment, target: Target | None) -> bool:
    """Return whether a quantity is the one whose value defines a moment, such as the displacement for *moved 2 m*."""
    if target is None or target.sense is not None or not isinstance(moment, Threshold):
        return False
    return type(moment) in THRESHOLDS.get(target.quantity, ()) and moment.name == target.subject
