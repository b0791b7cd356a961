"""Extreme values at an end of a stretch of motion: the question about the value there, and why it is the extreme."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from sim2reason.dsl.constancy import changing
from sim2reason.questions import KINDS, Query
from sim2reason.questions.choices import only_falls
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.bounces import Landed
from sim2reason.questions.moments.parts.occurrence import VelocityJump
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.questions.targets import Target
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.writing.steps import Book

SAME = 1e-9  # relative: how well an extreme value is that at an end
SAMPLES = 2000  # instants of a stretch at which a function is looked at
LEAST_RISE = 1e-9  # of the greatest value: a function that changes by less is constant
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


def at_end(setting: Setting) -> Setting | None:
    """Return the question about the value at the end of a stretch; None if that is not the extreme value asked for.

    Also None if it is not clear why there is no other value beyond it.
    """
    query = setting.query
    functional = FUNCTIONALS[query.functional] if isinstance(query, StretchQuery) else None
    if not isinstance(query, StretchQuery) or not isinstance(functional, Extreme):
        return None
    kind = KINDS[query.kind]
    if kind.answer(query, setting.study) is not None or kind.loose_answer(query, setting.study) is None:
        return None
    for moment in _ends(setting, query):
        found = replace(setting, query=_value_at(moment, query, functional), extreme=query)
        if found.answer is not None and _same(found.answer, kind.loose_answer(query, setting.study)):
            return found if reason(found) else None
    return None


def _same(one: float, other: float | None) -> bool:
    return other is not None and abs(one - other) <= SAME * abs(other)


def _ends(setting: Setting, query: StretchQuery) -> Iterator[Moment]:
    """Yield the moments with which a stretch may end: its own, of a jump of velocities just before it."""
    moment, study = query.moment, setting.study
    if isinstance(moment, WholeMotion):
        until = study.time(moment)
        landings = (Landed(name) for name in Landed.candidates(setting.words))
        yield from (landing for landing in landings if until is not None and study.time(landing) == until)
    elif isinstance(moment, VelocityJump):
        yield from (moment, replace(moment, after=False))
    elif moment is not None:
        yield moment


def _value_at(moment: Moment, query: StretchQuery, functional: Extreme) -> Query:
    """Return the question about the quantity itself at a moment."""
    return Query(moment.kind, Target(functional.quantity.name, query.name, functional.sense), moment)


def reason(setting: Setting) -> str:
    """Return why the value at the end of a stretch is the extreme one, in sentences; empty if no reason is known."""
    query = setting.extreme
    functional = FUNCTIONALS[query.functional] if query is not None else None
    if query is None or not isinstance(functional, Extreme):
        return ""
    times = np.linspace(0.0, _end(setting), SAMPLES + 1)
    state = setting.study.trace.sample(times)
    values = functional.height(state, query.name)
    little = LEAST_RISE * float(np.abs(values).max())
    if float(np.ptp(values)) <= little:
        return ""
    grows_always = bool(np.diff(values).min() >= -little)
    quantity = functional.quantity.name if functional.sense is None else query.functional.removeprefix("greatest ")
    if quantity not in SPEEDS or functional.sign < 0.0:
        return _of_rate(setting, quantity, grows=functional.sign > 0.0) if grows_always else ""
    heights = state.frames.center(query.name).place[2] + 0.0 * times
    lowest = float(heights[-1]) <= float(heights.min()) + LEAST_RISE * float(np.abs(heights).max())
    from_rest = float(values[0]) <= little
    return _of_speed(setting, grows_always=grows_always, lowest=lowest, from_rest=from_rest)


def _end(setting: Setting) -> float:
    """Return the last instant of the stretch, s."""
    moment = setting.query.moment
    assert moment is not None
    return moment.side(setting.time)


def _of_speed(setting: Setting, *, grows_always: bool, lowest: bool, from_rest: bool) -> str:
    """Return why the speed of a body is greatest at the end of a stretch; empty if it is not clear."""
    query, mechanism = setting.extreme, setting.mechanism
    assert query is not None
    who, noun = setting.called(query.name), FUNCTIONALS[query.functional].name.removeprefix("greatest ")
    events = any(event.changes_motion and 0.0 < event.time < _end(setting) for event in setting.motion.events)
    steady = not changing(mechanism) and not events
    if steady and only_falls(mechanism) and lowest and mechanism.gravity[2] < 0.0:
        where = "where it lands" if isinstance(setting.query.moment, Landed) else "at the end of this part of its path"
        return (
            f"In flight only gravity does work on {who}, so that its kinetic energy increases as its height decreases."
            f" It is nowhere lower than {where}, so this is its greatest {noun}."
        )
    if grows_always and steady and from_rest:
        return (
            f"The forces do not change, so {who} has a constant acceleration. From rest its speed can only increase,"
            f" so its greatest {noun} is that at the end."
        )
    if grows_always:
        return (
            f"All this time the acceleration of {who} has a component along its velocity, so its speed increases,"
            f" and its greatest {noun} is that at the end."
        )
    if steady:
        return (
            f"The acceleration of {who} is constant, so the square of its speed is a quadratic function of the time"
            f" that opens upward. It is therefore greatest at the start or at the end; here, at the end."
        )
    return ""


def _of_rate(setting: Setting, quantity: str, *, grows: bool) -> str:
    """Return why a quantity that changes in one sense is extreme at the end of a stretch; empty if it is not clear."""
    query = setting.extreme
    assert query is not None
    name = query.functional
    if quantity in SPEEDS:
        who = setting.called(query.name)
        why = f"the acceleration of {who} has a component opposite to its velocity"
        return f"All this time {why}, so its speed decreases, and its {name} is that at the end."
    if quantity not in CHANGES:
        return ""
    who = setting.called(query.name) if quantity != "distance" else ""
    why = CHANGES[quantity][0 if grows else 1].format(who=who)
    return f"All this time {why}, so the {name} is that at the end."


def tell_reason(setting: Setting, book: Book, goal: str) -> None:
    """Write why the value at the end of a stretch, which is written already, is the extreme one."""
    step = book.open("extreme")
    step.rest_on(goal)
    step.say(reason(setting))
    step.close()
