"""Equivalent questions: extreme values at an end of an interval, and values reached at the same instant.

The interval is that of the question, or the part of it before an event: an impact, burn-out or a turning point.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from math import isclose

import numpy as np

from sim2reason.questions import KINDS, Query
from sim2reason.questions.choices import only_falls
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.aggregates import Extreme
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.angles import Deflected, TurnedThrough
from sim2reason.questions.moments.bounces import GROUND, Bounced, Landed, obstacle_phrase
from sim2reason.questions.moments.crossings import Threshold
from sim2reason.questions.moments.distances import Away, Moved
from sim2reason.questions.moments.occurrence import VelocityJump
from sim2reason.questions.moments.reached import Reached
from sim2reason.questions.moments.times import AtStart, AtTime, BurnedOut, WholeMotion
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.questions.query import Target
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.structure import changing
from sim2reason.simulation.trace import IMPACTS
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.writing.notation import DEGREES, METRES, SECONDS
from sim2reason.solutions.writing.steps import SolutionBuilder

VALUE_RTOL = 1e-9  # relative: how well an extreme value is that at an end
SAMPLES = 2000  # instants of a stretch at which a function is looked at
MIN_CHANGE_RTOL = 1e-9  # of the greatest value: a function that changes by less is constant
SPEEDS = frozenset({"velocity", "kinetic energy"})
CHANGES: Mapping[str, tuple[str, str]] = {
    "displacement": ("{who} moves away from its starting point", "{who} approaches its starting point"),
    "height": ("{who} rises", "{who} sinks"),
    "distance": ("the two move apart", "the two approach each other"),
    "angular velocity": (
        "the angular acceleration of {who} has the sense of its rotation",
        "the angular acceleration of {who} is opposite to its rotation",
    ),
}
"""By quantity, why it increases and why it decreases."""


def at_end(setting: ProblemContext) -> ProblemContext | None:
    """Rewrite a question for an extreme value in an interval as one for the value at an end of it, or at an event.

    Return None if the extreme value is elsewhere, or if no reason is known why no other value exceeds it.
    """
    query = setting.query
    functional = FUNCTIONALS[query.functional] if isinstance(query, StretchQuery) else None
    if not isinstance(query, StretchQuery) or not isinstance(functional, Extreme):
        return None
    kind = KINDS[query.kind]
    if kind.answer(query, setting.study) is not None or kind.loose_answer(query, setting.study) is None:
        return None
    for moment in _ends(setting, query):
        rewritten = replace(setting, query=_value_at(moment, query, functional), extreme=query)
        if rewritten.answer is not None and _same(rewritten.answer, kind.loose_answer(query, setting.study)):
            return rewritten if reason(rewritten) else None
    return None


def _same(one: float, other: float | None) -> bool:
    return other is not None and abs(one - other) <= VALUE_RTOL * abs(other)


def _ends(setting: ProblemContext, query: StretchQuery) -> Iterator[Moment]:
    """Yield the moments at which the interval of a question ends (also just before an impact there) and begins.

    Last come events of the body that may be within the interval: its first impact, burn-out and turning point.
    """
    moment, study = query.moment, setting.study
    if isinstance(moment, WholeMotion):
        until = study.time(moment)
        happenings = (cls(name) for cls in (Landed, BurnedOut) for name in cls.candidates(setting.words))
        yield from (event for event in happenings if until is not None and study.time(event) == until)
    elif isinstance(moment, VelocityJump):
        yield from (moment, replace(moment, after=False))
    elif moment is not None:
        yield moment
    yield AtStart()
    if query.name in Bounced.candidates(setting.words):
        yield Bounced(query.name, after=False)
    yield from (cls(query.name) for cls in (BurnedOut, Stopped) if query.name in cls.candidates(setting.words))


def _value_at(moment: Moment, query: StretchQuery, functional: Extreme) -> Query:
    """Return the question for a quantity at a moment, instead of its extreme value over an interval."""
    return Query(moment.kind, Target(functional.quantity.name, query.name, functional.sense), moment)


def reason(setting: ProblemContext) -> str:
    """Return why the value at an end of the interval is the extreme one, in sentences; empty if no reason is known."""
    query = setting.extreme
    functional = FUNCTIONALS[query.functional] if query is not None else None
    if query is None or not isinstance(functional, Extreme):
        return ""
    event = _event_within(setting)
    trace, last = setting.study.trace, not isinstance(setting.query.moment, AtStart)
    times = np.linspace(0.0, _until(setting), SAMPLES + 1)
    state = trace.sample(times)
    values = functional.height(state, query.name)
    little = MIN_CHANGE_RTOL * float(np.abs(values).max())
    quantity = functional.quantity.name if functional.sense is None else query.functional.removeprefix("greatest ")
    if float(np.ptp(values)) <= little:
        who = setting.display_name(query.name)
        constant = f"No force has a component along the velocity of {who}, so its speed does not change."
        return constant if quantity in SPEEDS and little > 0.0 and not setting.mechanism.forces else ""
    if event is not None:
        grows = bool(np.diff(values[times <= event]).min(initial=0.0) >= -little)
        falls = bool(np.diff(values[times >= event]).max(initial=0.0) <= little)
        return _of_event(setting, quantity, turns=grows and falls)
    towards = values if last else values[::-1]  # the extreme value
    monotonic = bool(np.diff(towards).min() >= -little)
    if quantity in SPEEDS and any(e.kind in IMPACTS and 0.0 < e.time < times[-1] for e in trace.events):
        return ""  # what an impact does is no acceleration along the velocity, or opposite to it
    if quantity not in SPEEDS or functional.sign < 0.0:
        return _of_rate(setting, quantity, grows=(functional.sign > 0.0) is last, last=last) if monotonic else ""
    heights = state.frames.center(query.name).place[2] + 0.0 * times
    lowest = float(heights[-1 if last else 0]) <= float(heights.min()) + MIN_CHANGE_RTOL * float(np.abs(heights).max())
    return _of_speed(setting, _Course(last, monotonic, lowest, from_rest=float(towards[0]) <= little))


@dataclass(frozen=True, slots=True)
class _Course:
    """The change of a speed over an interval: whether the greatest is the `last`, and whether it is `monotonic`.

    `lowest` says that the body is nowhere lower than at the extreme.
    """

    last: bool
    monotonic: bool
    lowest: bool
    from_rest: bool

    @property
    def end(self) -> str:
        """Return the words *at the start* or *at the end*, by the end of the interval that has the extreme value."""
        return "at the end" if self.last else "at the start"


def _until(setting: ProblemContext) -> float:
    """Return the last instant, s, of the interval of the question."""
    moment = setting.extreme.moment if setting.extreme is not None else None
    assert moment is not None
    time = setting.study.time(moment)
    assert time is not None
    return float(np.nextafter(time, 0.0)) if isinstance(moment, VelocityJump) else moment.evaluation_time(time)


def _of_speed(setting: ProblemContext, course: _Course) -> str:
    """Return why the speed of a body is greatest at an end of the interval; empty if no reason is known."""
    query, mechanism, until = setting.extreme, setting.mechanism, _until(setting)
    assert query is not None
    who, noun = setting.display_name(query.name), FUNCTIONALS[query.functional].name
    jumps = any(event.changes_motion and 0.0 < event.time < until for event in setting.study.trace.events)
    steady = not changing(mechanism) and not jumps
    if steady and _flies(mechanism, query.name) and course.lowest:
        where = "at the end of this part of its path" if course.last else "where it starts"
        where = "where it lands" if isinstance(setting.query.moment, Landed) else where
        return (
            f"In flight only gravity does work on {who}, so that its kinetic energy increases as its height decreases."
            f" It is nowhere lower than {where}, so this is its {noun}."
        )
    if course.monotonic and steady and course.last and course.from_rest:
        return (
            f"The forces do not change, so {who} has a constant acceleration. From rest its speed can only increase,"
            f" so its {noun} is that at the end."
        )
    if course.monotonic:
        direction, changes = ("along", "increases") if course.last else ("opposite to", "decreases")
        return (
            f"All this time the acceleration of {who} has a component {direction} its velocity, so its speed {changes},"
            f" and its {noun} is that {course.end}."
        )
    if not changing(mechanism) and not steady:
        return (
            f"The acceleration of {who} is constant in each part of its motion, so the square of its speed is there a"
            " quadratic function of the time that opens upward, greatest at one end of the part. A comparison of these"
            f" ends shows that the {noun} is that {course.end}."
        )
    if steady:
        return (
            f"The acceleration of {who} is constant, so the square of its speed is a quadratic function of the time"
            f" that opens upward. It is therefore greatest at the start or at the end; here, {course.end}."
        )
    return ""


def _event_within(setting: ProblemContext) -> float | None:
    """Return the time, s, of the moment of the extreme value if it is inside the interval; None if at an end."""
    moment = setting.query.moment
    time = setting.study.time(moment) if moment is not None else None
    if time is None or isinstance(moment, AtStart) or not time < _until(setting) * (1.0 - VALUE_RTOL):
        return None
    return time


def _of_event(setting: ProblemContext, quantity: str, *, turns: bool) -> str:
    """Return why an extreme value is at an event within the interval; empty if no reason is known.

    `turns` says that the quantity increases until then, and never does afterwards.
    """
    moment, query = setting.query.moment, setting.extreme
    assert query is not None
    who, name = setting.display_name(query.name), query.functional
    if isinstance(moment, Bounced) and quantity in SPEEDS and _falls_to_ground(setting, query.name):
        return (
            f"In flight only gravity does work on {who}, so that its kinetic energy increases as its height decreases."
            f" It is lowest at the ground, and no impact there increases its energy, so the {name} is that just before"
            " the first impact."
        )
    if isinstance(moment, BurnedOut) and quantity in SPEEDS and turns:
        return (
            f"While fuel burns, the acceleration of {who} has a component along its velocity. After burn-out no force"
            f" increases its speed in this time, so the {name} is that at burn-out."
        )
    if isinstance(moment, Stopped) and quantity in ("displacement", "height") and turns:
        why = CHANGES[quantity][0].format(who=who)
        return f"Until then {why}, and afterwards it does not get beyond, so the {name} is that where it comes to rest."
    return ""


def _falls_to_ground(setting: ProblemContext, name: str) -> bool:
    return _flies(setting.mechanism, name) and obstacle_phrase(setting.words, name) == GROUND


def _flies(mechanism: Mechanism, name: str) -> bool:
    """Return whether gravity alone acts on a body."""
    return only_falls(mechanism) and mechanism.gravity[2] < 0.0 and mechanism.body[name].parent is None


def _of_rate(setting: ProblemContext, quantity: str, *, grows: bool, last: bool) -> str:
    """Return why a monotonic quantity is extreme at an end of the interval; empty if no reason is known."""
    query = setting.extreme
    assert query is not None
    end = "at the end" if last else "at the start"
    if quantity in SPEEDS:
        direction, changes = ("along", "increases") if grows else ("opposite to", "decreases")
        why = f"the acceleration of {setting.display_name(query.name)} has a component {direction} its velocity"
        return f"All this time {why}, so its speed {changes}, and its {query.functional} is that {end}."
    if quantity not in CHANGES:
        return ""
    who = setting.display_name(query.name) if quantity != "distance" else ""
    why = CHANGES[quantity][0 if grows else 1].format(who=who)
    return f"All this time {why}, so the {query.functional} is that {end}."


def write_reason(setting: ProblemContext, book: SolutionBuilder, goal: str) -> None:
    """Write why the value found for an end of the interval is the extreme one.

    If the text gives that value, nothing else is needed.
    """
    if setting.is_given(goal):
        book.rewrite(0, ())
    step = book.begin_step("extreme")
    step.rest_on(goal)
    step.add_text(reason(setting))
    step.close()


COINCIDENT_TIME_RTOL = 1e-9  # relative: two moments that are closer are one
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
            if time is not None and isclose(time, setting.time, rel_tol=COINCIDENT_TIME_RTOL):
                yield moment


def instants(setting: ProblemContext) -> Iterator[tuple[Moment, float]]:
    """Yield (moment, its distance, angle or time) for each moment at the same instant as the question's moment.

    Distances along a line and angles come first, at which energy gives speeds without the time, which comes last.
    """
    reached, query = setting.query.moment, setting.query
    assert isinstance(reached, Reached)
    query_subjects = (query.target.subject,) if query.target is not None else ()
    for quantity, classes in THRESHOLDS.items():
        kept = (
            [] if setting.mechanism.burns else [cls for cls in classes if cls is not Away]
        )  # its mass hangs on the time
        subjects = {name: None for cls in kept for name in cls.candidates(setting.words)}
        for subject in sorted(subjects, key=lambda name: name not in (*query_subjects, reached.target.subject)):
            target = Target(quantity, subject)
            value = target.value(setting.study.trace.at(setting.time))
            yield from ((moment, value) for moment in _thresholds(setting, target, value))
    yield AtTime(setting.time), setting.time


def is_number_of(moment: Moment, target: Target | None) -> bool:
    """Return whether a quantity is the one whose value defines a moment, such as the displacement for *moved 2 m*."""
    if target is None or target.sense is not None or not isinstance(moment, Threshold):
        return False
    return type(moment) in THRESHOLDS.get(target.quantity, ()) and moment.name == target.subject
