"""Periodicity of a motion, permanent rest, and reasons why an event never occurs."""

from dataclasses import dataclass
from itertools import islice
from math import pi

import numpy as np

from sim2reason.questions.choices import REST_SPEED_RTOL, is_clear_of_events
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.crossings import Threshold, crossings
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.reached import Reached
from sim2reason.scenes.dsl.fields import Magnetic, Push
from sim2reason.scenes.dsl.mechanism import Inextensible, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.structure import changing
from sim2reason.scenes.dsl.vectors import inner
from sim2reason.simulation.quantities.subjects.bodies import ancestor_chain, center_path
from sim2reason.simulation.quantities.subjects.interactions import members
from sim2reason.simulation.trace import Trace, ending

RECURRENCE_RTOL, ERRS = (
    1e-6,
    100.0,
)  # of the greatest displacement and speed; times the error of a step: tolerances of recurrence
MAX_CANDIDATES = 12  # greatest number of candidate times


@dataclass(frozen=True, slots=True)
class Repetition:
    """The first time that a body and its carriers are back in their initial state."""

    name: str

    def time(self, trace: Trace) -> float | None:
        """Return the time, s, of the first recurrence of the state; None if there is none, or only one at an event."""
        mechanism = trace.mechanism
        names = [c.name for body in ancestor_chain(mechanism, self.name) for c in body.coordinates]
        time = _first_return(trace, tuple(mechanism.number[name] for name in names))
        return time if time is not None and is_clear_of_events(time, trace) else None


def is_autonomous(mechanism: Mechanism) -> bool:
    """Return whether time does not occur in the equations: no engine, winch or time-dependent field."""
    return _is_steady(mechanism) and not mechanism.burns


def _is_steady(mechanism: Mechanism) -> bool:
    """Return whether the equations do not depend explicitly on time, apart from burning fuel."""
    reeled = any(isinstance(line.law, Inextensible) and line.law.reel for line in mechanism.lines)
    steady = all(f.law.profile.steady for f in mechanism.forces if isinstance(f.law, Push | Magnetic))
    return steady and not reeled


def first_return(trace: Trace) -> float | None:
    """Return the period, s: the first time at which all coordinates and velocities recur; None if there is none.

    None if they do not return while the motion is described, or if time has a part in the equations.
    """
    mechanism = trace.mechanism
    return _first_return(trace, tuple(range(len(mechanism.coordinates)))) if is_autonomous(mechanism) else None


def drift_return(trace: Trace) -> float | None:
    """Return the first time, s, at which everything but the position recurs; None if there is none.

    Then everything repeats itself elsewhere: all velocities, accelerations, angles and lengths. None if they do not
    return while the motion is described, or if bodies may meet, attract one another, or feel a field that differs.
    """
    mechanism, start = trace.mechanism, trace.at(0.0)
    local = any(force.region is not None or not isinstance(force.law, Push | Magnetic) for force in mechanism.forces)
    if not is_autonomous(mechanism) or mechanism.meetings or mechanism.attractions or mechanism.feet or local:
        return None
    hinges = [n for n, coordinate in enumerate(mechanism.coordinates) if coordinate.kind == "hinge"]
    felt = _felt(mechanism)
    far = float(np.abs((trace.scan.q - start.q)[:, felt]).max(initial=0.0))
    fast, rapid = (float(np.abs(values).max(initial=0.0)) for values in (trace.scan.v, trace.scan.a))
    lengths = [(line, start.length(line)[0]) for line in mechanism.lines]
    same, sizes = max(RECURRENCE_RTOL, ERRS * trace.tolerance), np.linalg.norm(trace.scan.a, axis=1)
    idle = bool(sizes[0] <= RECURRENCE_RTOL * sizes.max())  # nothing is accelerated at first
    direction = trace.scan.a[int(np.argmax(sizes >= 0.5 * sizes.max()))] if idle else start.a[0]

    def excess(state: State) -> Array:
        """Return the velocity change, or the acceleration, projected on its initial direction, (n,)."""
        return (state.a if idle else state.v - start.v[0]) @ direction

    def alike(here: State) -> bool:
        changes = [np.abs(here.v - start.v) / fast, np.abs(here.a - start.a) / rapid]
        changes += [np.abs(here.q - start.q)[:, hinges]]
        changes += [np.abs(here.q - start.q)[:, felt] / far] if far else []
        changes += [np.abs(here.length(line)[0] / length - 1.0) for line, length in lengths]
        return all(float(change.max(initial=0.0)) <= same for change in changes)

    if not direction.any():
        return None
    return next((time for time in islice(crossings(trace, excess), MAX_CANDIDATES) if alike(trace.at(time))), None)


def _felt(mechanism: Mechanism) -> list[int]:
    """Return the indices of the coordinates along which a field varies."""
    laws = [force.law for force in mechanism.forces]
    ways = [law.profile.axis for law in laws if isinstance(law, Push | Magnetic) and law.profile.slope]
    coordinates = enumerate(mechanism.coordinates)
    return [
        number
        for number, coordinate in coordinates
        if any(inner(coordinate.axis, field_axis) != 0.0 for field_axis in ways)
    ]


def ends_at_rest(trace: Trace) -> bool:
    """Return whether all velocities and accelerations are zero at the end, and the equations are autonomous."""
    end = trace.at(float(trace.state.times[-1]))
    fastest = float(np.abs(trace.scan.v).max(initial=0.0))
    at_rest = float(np.abs(end.v).max(initial=0.0)) <= REST_SPEED_RTOL * fastest and not np.any(
        np.abs(end.a) > REST_SPEED_RTOL
    )
    return not trace.cut and at_rest and is_autonomous(trace.mechanism)


def rest_for_good(trace: Trace) -> float | None:
    """Return the time, s, from which everything stays at rest; None if there is none in the simulated motion.

    For a motion that decays without an event, it is the end of the simulated motion.
    """
    if not ends_at_rest(trace):
        return None
    last = max((event.time for event in trace.events), default=0.0)
    speeds = np.abs(trace.scan.v).max(axis=1, initial=0.0)
    still = float(speeds[trace.scan.times >= last].max(initial=0.0)) <= REST_SPEED_RTOL * float(speeds.max(initial=0.0))
    return last if still else trace.stable_until


def uniform_from(trace: Trace) -> float | None:
    """Return the time of the last event, s, if all motion is uniform from then on; else None.

    Then no rocket has fuel left, and there is nothing that could be met, become taut, be entered, or attract.
    """
    mechanism = trace.mechanism
    out = sum(event.kind == "burn-out" for event in trace.events) == len(mechanism.burns)
    local = any(force.region is not None for force in mechanism.forces)
    alone = not (mechanism.meetings or mechanism.lines or mechanism.attractions or mechanism.feet or local)
    last = max((event.time for event in trace.events), default=0.0)
    if trace.cut or not (out and alone and _is_steady(mechanism) and 0.0 < last < trace.stable_until):
        return None
    return None if trace.scan.a[trace.scan.times > last].any() else last


def has_known_continuation(trace: Trace) -> bool:
    """Return whether the motion after the end of the simulation is known: permanent rest, or a repetition."""
    return ends_at_rest(trace) or first_return(trace) is not None


def escapes(trace: Trace, name: str) -> bool:
    """Return whether a body under gravitation of the others alone escapes from all of them.

    It recedes from each, and is faster than it must be to escape: v² > 2 Σ GM/r. Where others move, too, that one of
    them overtakes it is left out of account.
    """
    mechanism, end = trace.mechanism, trace.at(trace.stable_until)
    pulls = [pull for pull in mechanism.attractions if name in (pull.a, pull.b)]
    others = [pull.a if pull.b == name else pull.b for pull in pulls]
    weight = np.array(center_path(mechanism, name).ways).reshape(-1, 3) @ np.array(mechanism.gravity)
    alone = not (mechanism.forces or mechanism.lines or mechanism.meetings or weight.any())
    if not pulls or not alone or any(pull.power != 2.0 for pull in pulls):
        return False
    point, depth = end.frames.center(name), 0.0
    velocity = end.vector(point.velocity)[0]
    for pull, other in zip(pulls, map(end.frames.center, others), strict=True):
        away = end.vector(point.place)[0] - end.vector(other.place)[0]
        if away @ (velocity - end.vector(other.velocity)[0]) <= 0.0:
            return False
        depth += pull.constant * mechanism.body[pull.a if pull.b == name else pull.b].mass / np.linalg.norm(away)
    return bool(velocity @ velocity > 2.0 * depth)


def _first_return(trace: Trace, numbers: tuple[int, ...]) -> float | None:
    """Return the first time, s, at which given coordinates and their velocities recur, up to full turns of hinges.

    Candidates are zero crossings of the coordinates, or of the velocities of a motion that starts from rest, projected
    on their initial direction.
    """
    return trace.memoize(("first return", numbers), lambda: _search_return(trace, list(numbers)))


def _search_return(trace: Trace, number: list[int]) -> float | None:
    mechanism, start = trace.mechanism, trace.at(0.0)
    hinges = np.array([mechanism.coordinates[n].kind == "hinge" for n in number], dtype=np.bool_)
    far, fast = (float(np.abs(values[:, number]).max(initial=0.0)) for values in (trace.scan.q, trace.scan.v))
    speeds = start.v[0, number]
    moves = bool((np.abs(speeds) > RECURRENCE_RTOL * fast).any())
    direction = speeds if moves else start.a[0, number]
    if not direction.any():
        return None
    turned = hinges & (not any(line.wheels for line in mechanism.lines))  # unless a line is wound up

    def gone(state: State) -> Array:
        """Return the change of the coordinates since the start, (n, c)."""
        return state.q[:, number] - start.q[0, number]

    def excess(state: State) -> Array:
        """Return the displacement, or the velocity, projected on its initial direction, (n,)."""
        return (np.where(turned, np.sin(gone(state)), gone(state)) if moves else state.v[:, number]) @ direction

    def alike(here: State) -> bool:
        off = np.where(turned, np.remainder(gone(here) + pi, 2.0 * pi) - pi, gone(here))
        changed = here.v[:, number] - speeds
        same = max(RECURRENCE_RTOL, ERRS * trace.tolerance)
        return float(np.abs(off).max()) <= same * far and float(np.abs(changed).max()) <= same * fast

    return next((time for time in islice(crossings(trace, excess), MAX_CANDIDATES) if alike(trace.at(time))), None)


EVENTLESS_FACTOR = 1e3  # times the time of the last event: uniform motion up to then remains eventless
POSITION_QUANTITIES = (
    "displacement",
    "extension",
    "spring length",
    "deflection",
    "angle turned",
)  # quantities of position
MIN_REVERSALS = 2  # reversals of a motion, one on each side
FULL_TURN_RTOL = 1e-3  # of the greatest displacement: a returned coordinate has made no full turn


def why_never(moment: Moment | None, trace: Trace) -> str:
    """Return a clause explaining why a moment or a repetition never occurs; empty if either still may occur.

    A motion whose description ends before the moment never reaches the moment.
    """
    unit = trace.mechanism.units.time
    until, last = f"{trace.stable_until:.6g} {unit}", f"{_last_change(trace):.6g} {unit}"
    if trace.cut:
        return f"it does not happen before {until}, where the description of the motion ends: {ending(trace)}"
    if moment is not None and moment.stated_time is not None:
        return ""
    period = _period(trace)
    reasons = {
        "what moves turns back before it has moved so far": isinstance(moment, Moved) and moment.comes_later(trace),
        f"everything is at rest for good from {last} on": ends_at_rest(trace),
        f"the motion repeats itself every {period or 0.0:.6g} {unit}": period is not None
        and trace.stable_until > (getattr(moment, "number", 1) + 1) * period,
        "it has turned back on both sides, and has no energy to come any farther": reverses_before(moment, trace),
        "what it is about flies off for ever": subjects_escape(moment, trace),
        f"it has not by {until}, and from {last} on no acceleration changes any more": not changing(trace.mechanism)
        and trace.stable_until > EVENTLESS_FACTOR * max(_last_change(trace), _own(trace)),
    }
    return next((f"it never happens: {reason}" for reason, holds in reasons.items() if holds), "")


def reverses_before(moment: Moment | None, trace: Trace) -> bool:
    """Return whether a motion along one coordinate has reversed on both sides and so never reaches a position.

    A force that depends on that coordinate alone has a potential, and all other forces take energy away. At a turning
    point the energy equals the potential there, so that the motion never passes a turning point again.
    """
    mechanism = trace.mechanism
    placed = isinstance(moment, Threshold) or (
        isinstance(moment, Reached) and moment.target.quantity in POSITION_QUANTITIES
    )
    if not placed or len(mechanism.coordinates) != 1 or not is_autonomous(mechanism) or mechanism.meetings:
        return False
    turns = [event for event in trace.events if event.kind == "turn" and event.time <= trace.stable_until]
    return len(turns) >= MIN_REVERSALS and all(event.kind == "turn" for event in trace.events)


def subjects_escape(moment: Moment | None, trace: Trace) -> bool:
    """Return whether a moment never occurs because its bodies escape to infinity.

    If only one of two moving bodies flies off, the other may still go round and overtake it again and again.
    """
    if moment is None or not moment.requires_return:
        return False
    named = {name for subject in moment.subjects for name in members(subject)}
    bodies = (body for body in trace.mechanism.bodies if body.coordinates and (not named or body.name in named))
    flying = [escapes(trace, body.name) for body in bodies]
    return all(flying) if moment.subjects else any(flying)


def _last_change(trace: Trace) -> float:
    """Return the time of the last event, s; 0 if there is none."""
    return max((event.time for event in trace.events), default=0.0)


def _own(trace: Trace) -> float:
    """Return the time, s, in which the initial accelerations double the initial velocities; at least 1 s."""
    start = trace.at(0.0)
    speeds, rates = np.abs(start.v[0]).max(initial=0.0), np.abs(start.a[0]).max(initial=0.0)
    return float(max(1.0, speeds / rates if rates else 0.0))


def _period(trace: Trace) -> float | None:
    """Return the period of a motion, s; None if there is none, or a hinge makes full turns in it."""
    period = first_return(trace)
    if period is None:
        return None
    gone = np.abs(trace.at(period).q[0] - trace.at(0.0).q[0])
    far = np.abs(trace.scan.q - trace.at(0.0).q).max(axis=0)
    return period if bool((gone <= FULL_TURN_RTOL * far).all()) else None
