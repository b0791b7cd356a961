"""Selection of questions worth asking: quantities that vary with time, constant quantities, and moments."""

from collections import Counter
from collections.abc import Callable, Iterable
from math import hypot, inf

import numpy as np

from sim2reason.base.draws import draw_index
from sim2reason.questions.moments import Moment
from sim2reason.questions.query import Target
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.structure import changing, rotating_line
from sim2reason.simulation.quantities import QUANTITIES, Quantity
from sim2reason.simulation.trace import EVENT_TIME_RTOL, Event, Trace

MIN_VARIATION = 0.05  # relative: a value that varies by less is graded correct at any moment
CONSTANT_RTOL = 1e-6  # relative: a value that varies by less is constant
ENDINGS = frozenset({"reach", "limit"})  # events that a text excludes
SAMPLED_FRACTIONS = np.array([0.07, 0.3, 0.6, 0.93])  # of an interval between two events: sampled fractions
MIN_DISTINCT_SAMPLES = 2  # sampled instants, of eight, at which a varying value must differ
Values = Callable[[Array], Array]
"""A value at some instants, s: (n,) to (n,); NaN where there is none."""


def depends_on_moment(moment: Moment, trace: Trace, time: float, values: Values) -> bool:
    """Return whether a value varies clearly between the events before and after a moment, or jumps at the moment.

    Otherwise a question at another moment has the same answer, so that the moment is irrelevant.
    """
    here = float(values(np.array([moment.evaluation_time(time)]))[0])
    before, after = _between(trace, time)
    others = np.concatenate([before + SAMPLED_FRACTIONS * (time - before), time + SAMPLED_FRACTIONS * (after - time)])
    sides = np.array([np.nextafter(time, 0.0), time] if moment.event else [])

    def differing(instants: Array) -> int:
        return int(np.sum(np.abs(values(instants) - here) > MIN_VARIATION * abs(here)))

    ends = [0, len(others) - 1]  # which most often differ: the rest need not be looked at then
    count = differing(others[ends])
    if count < MIN_DISTINCT_SAMPLES:
        count += differing(np.delete(others, ends))
    return count >= MIN_DISTINCT_SAMPLES or (len(sides) > 0 and differing(sides) > 0)


def is_constant(target: Target, trace: Trace) -> bool:
    """Return whether a quantity is constant throughout the motion, including any later part that is not simulated.

    What rubs against something and does not begin at rest may stop later on.
    """
    if QUANTITIES[target.quantity].timeless:
        return True
    mechanism = trace.mechanism
    still = not any(coordinate.speed for coordinate in mechanism.coordinates)
    rubs = any(0.0 < face.friction < inf for face in mechanism.faces)
    if any(map(_changes_something, trace.events)) or (rubs and not still):
        return False
    values = target.values(trace.sample(np.append(0.0, SAMPLED_FRACTIONS * trace.stable_until)))
    return bool(np.all(np.abs(values - values[0]) <= CONSTANT_RTOL * abs(values[0])))


def _between(trace: Trace, time: float) -> tuple[float, float]:
    """Return the times, s, of the events just before and after a time, or the ends of the simulated motion."""
    times = [event.time for event in trace.events if _changes_something(event)]
    before = max((instant for instant in times if instant < time * (1.0 - EVENT_TIME_RTOL)), default=0.0)
    after = min((instant for instant in times if instant > time * (1.0 + EVENT_TIME_RTOL)), default=trace.stable_until)
    return before, max(time, min(after, trace.stable_until))


def _changes_something(event: Event) -> bool:
    return event.changes_motion and event.kind not in ENDINGS


CROSSINGS = "enter", "exit"
EVENT_CLEARANCE = 1e-3  # of the duration: least distance of a question's time from events
MAX_SPRING_BODIES = 2  # maximum number of bodies on springs whose oscillation has a short formula of time
MIN_HORIZONTAL_COMPONENT = 1e-9  # least horizontal component of an axle's direction that is not vertical
REST_SPEED_RTOL, SPEED_NOISE_RTOL = (
    1e-7,
    1e-9,
)  # of the subject's own and of the overall greatest speed: a lower speed is rest


def draw_target(
    targets: Iterable[Target], rng: np.random.Generator, worth: Callable[[Target], bool] = lambda _: True
) -> Target | None:
    """Return a random target worth asking for, weighted by the weights of quantities; None if there is none."""
    left = [target for target in targets if QUANTITIES[target.quantity].drawn_by_recipes]
    sizes = [target.share * QUANTITIES[target.quantity].weight for target in left]
    counts = Counter(target.quantity for target in left)
    while left:
        number = draw_index(rng, [size / counts[t.quantity] for size, t in zip(sizes, left, strict=True)])
        chosen = left.pop(number)
        del sizes[number]
        counts[chosen.quantity] -= 1
        if worth(chosen):
            return chosen
    return None


def is_clear_of_events(time: float, trace: Trace) -> bool:
    """Return whether a time, s, is not close to any event that changes the motion."""
    clear = EVENT_CLEARANCE * float(trace.state.times[-1])
    return all(abs(time - event.time) > clear for event in trace.events if event.changes_motion)


def rest_speed(trace: Trace, speeds: Array) -> float:
    """Return the speed, m/s, below which a subject with these sampled speeds (n,) counts as at rest.

    What never moves has speeds, too, as rounding leaves them.
    """
    fastest = float(np.abs(trace.scan.v).max(initial=0.0))
    return max(REST_SPEED_RTOL * float(np.abs(speeds).max(initial=0.0)), SPEED_NOISE_RTOL * fastest)


def data_relevant_from(trace: Trace) -> float:
    """Return the time, s, from which all given data can affect the motion; infinite if they never do.

    If bodies can collide, all bodies that ever do must have collided; fuel must be used up; the first boundary of a
    field must have been crossed; and a string that goes slack must have done so.
    """
    mechanism, waits = trace.mechanism, [burn.until for burn in trace.mechanism.burns]
    if mechanism.meetings:
        first: dict[str, float] = {}
        for event in trace.events:
            if event.kind == "collision":
                first = dict.fromkeys(event.subjects, event.time) | first
        waits += first.values()
    if any(force.region is not None for force in mechanism.forces):
        waits.append(next((event.time for event in trace.events if event.kind in CROSSINGS), inf))
    slack = next((event for event in trace.events if event.kind == "slack"), None)
    if slack is not None and rotating_line(mechanism.line[slack.subjects[0]], initial_frames(mechanism)):
        waits.append(slack.time)
    return max(waits, default=0.0)


def smallest_answer(mechanism: Mechanism, quantity: Quantity) -> float:
    """Return the least admissible answer of a quantity; if all masses are < 1 kg, less for one that grows with mass."""
    return quantity.least * min(1.0, max(body.mass for body in mechanism.bodies)) if quantity.heavy else quantity.least


def has_collided(trace: Trace, time: float, *, just_after: bool = False) -> bool:
    """Return whether a collision occurs before a time, or `just_after` it; True if bodies cannot collide."""
    if not trace.mechanism.meetings:
        return True
    end = time * (1.0 + (EVENT_TIME_RTOL if just_after else -EVENT_TIME_RTOL))
    return any(event.kind == "collision" and event.time <= end for event in trace.events)


def has_formula_of_time(mechanism: Mechanism) -> bool:
    """Return whether a short formula gives all positions as functions of time.

    That is so where accelerations are constant or depend on time or velocity alone, and where springs move one or two
    bodies along lines or level circles. Where forces depend on positions otherwise, turning points are worth asking
    about.
    """
    coordinates = mechanism.coordinates
    if mechanism.burns or mechanism.forces or not changing(mechanism):
        return True
    swings = any(one.kind == "hinge" and hypot(*one.axis[:2]) > MIN_HORIZONTAL_COMPONENT for one in coordinates)
    if len(coordinates) > MAX_SPRING_BODIES or mechanism.attractions or swings:
        return False
    frames = initial_frames(mechanism)
    return not any(rotating_line(line, frames) for line in mechanism.lines)


def only_falls(mechanism: Mechanism) -> bool:
    """Return whether gravity is the only force, so that all accelerations are given."""
    forces = (mechanism.lines, mechanism.contacts, mechanism.forces, mechanism.attractions, mechanism.burns)
    return not any(forces) and all(c.kind == "slide" for c in mechanism.coordinates)


DISTINCT_RTOL = 2e-3  # relative: values that differ by less agree in three digits
JUMP_RTOL = 1e-5  # relative: least change of a value across an event that is a jump


def is_worth_asking_at(study: SimulatedScene, moment: Moment) -> Callable[[Target], bool]:
    """Return a predicate that tests whether the value of a target at a moment is worth asking for.

    It must be neither zero nor stated, and differ from the initial value and from that at other moments. At an event
    whose words name no side of it, it must not jump either.
    """
    time, trace = study.time(moment), study.trace
    if time is None:
        return lambda _: False
    start, here = trace.at(0.0), trace.at(moment.evaluation_time(time))
    sides = [trace.at(float(np.nextafter(time, 0.0)))] if moment.event and moment.sided is None else []

    def differs(target: Target) -> bool:
        value = target.value(here)
        if not is_large_enough(value, target, study):
            return False
        known = [target.value(start), *(number for number, unit in moment.stated if unit == target.unit)]
        if any(
            abs(value - known_value) <= DISTINCT_RTOL * abs(value)
            for known_value in (*known, *(-number for number in known[1:]))
        ):
            return False
        if any(abs(value - target.value(side)) > JUMP_RTOL * abs(value) for side in sides):
            return False
        return depends_on_moment(moment, trace, time, lambda times: target.values(trace.sample(times)))

    return differs


def is_large_enough(value: float, target: Target, study: SimulatedScene) -> bool:
    """Return whether a value exceeds the smallest admissible answer of its quantity; False for negative values."""
    return value > smallest_answer(study.mechanism, QUANTITIES[target.quantity])  # NaN is no more
