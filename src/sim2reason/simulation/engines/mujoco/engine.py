"""The main loop of the MuJoCo engine: impacts, forces, and steps to the next event."""

from math import isfinite

import numpy as np

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.event_search import ARMING_MARGIN, STEP_RTOL, EventSearch
from sim2reason.simulation.engines.mujoco.forces import ForceSolution
from sim2reason.simulation.engines.mujoco.instant import BEGINS, REST_SPEED, STOPS, InstantSolver
from sim2reason.simulation.engines.mujoco.integration import Knot, extrapolate_step
from sim2reason.simulation.engines.mujoco.margins import ActingModel, EventFunction
from sim2reason.simulation.trace import EVENT_KINDS, Event, Trace

MAX_STEP_DIVISOR = (
    24  # fraction of the duration: the longest step of changing forces, so that its ends determine the motion,
)
STRIDE, MIN_SAMPLE_STEPS = 5 / 3, 10  # or this many intervals between samples, if there are at least so many steps
FIRST_STEP_FRACTION = (
    0.05  # fraction of the longest step: the first step after a separation, so that the gap opens before it closes
)
MAX_STEPS = 4000  # largest number of steps
MIN_STEP = 1e-11  # fraction of the duration: the shortest step
SEGMENTS = 500  # largest number of motion segments
ORDER = {kind: place for place, kind in enumerate(EVENT_KINDS)}  # rank of simultaneous events


def run(mechanism: Mechanism, times: Array) -> Trace:
    """Return the motion at `times` (m,), in seconds, increasing from 0; raises as `simulate` of the package does."""
    motion: EventDrivenLoop | None = None
    try:
        with np.errstate(over="raise"):
            motion = EventDrivenLoop(mechanism, times)
            while motion.advance():
                if len(motion.record.intervals) > SEGMENTS:
                    many = f"more than {SEGMENTS} events before {times[-1]:g} s"
                    raise SimulationError(f"{many}; simulate a shorter time")
    except (ZeroDivisionError, FloatingPointError, np.linalg.LinAlgError) as error:
        now = motion.now if motion else 0.0
        raise SimulationError(f"MuJoCo: the motion becomes singular at {now:.6g} s ({error})") from None
    events = tuple(sorted(motion.events, key=lambda event: (event.time, ORDER[event.kind])))
    return Trace("mujoco", motion.record.state(times), events, motion.now, motion.cut, motion.record.state)


class EventDrivenLoop(InstantSolver):
    """A motion under construction, extended from event to event."""

    def __init__(self, mechanism: Mechanism, times: Array) -> None:
        """Initialize at the start of the motion; raises as `run` does."""
        super().__init__(mechanism, times)
        stride = min(STRIDE * float(times[1] - times[0]), self.duration / MIN_SAMPLE_STEPS) if len(times) > 2 else 0.0
        self.longest = self.duration if self.model.constant else max(self.duration / MAX_STEP_DIVISOR, stride)

    def advance(self) -> bool:
        """Settle the present instant and advance to the next event; return False at the end."""
        self.model.set_state(self.now, self.q, self.v, self.switches)
        goes_on = self.impact()
        self.model.set_state(self.now, self.q, self.v, self.switches)
        while goes_on and self.meets():  # what was driven against others that touch strikes those at once
            self._count(self.longest)
            goes_on = self.impact()
            self.model.set_state(self.now, self.q, self.v, self.switches)
        if not goes_on:
            return False
        solution = self.settle()
        if self.cut:
            return False
        self.mode = solution.mode._replace(rubbing=self._rubbing(solution))
        return self._travel(solution)

    def _travel(self, found: ForceSolution) -> bool:
        """Step to the next event; return False at the end."""
        acting = ActingModel(self.model, self.record, self.switches, found)
        self.record.start(found.mode, found, self.switches)
        begun, before = acting.knot(self.now, np.concatenate([self.q, self.v]))
        self.record.add(begun)
        armed = [value > ARMING_MARGIN for value in before]
        leaves = any(due.kind == "spare" and not up for due, up in zip(acting.events, armed, strict=True))
        length = self.longest * (FIRST_STEP_FRACTION if leaves and not acting.constant else 1.0)
        tolerance = STEP_RTOL * acting.closeness(begun)
        while self.duration - self.now > MIN_STEP * self.duration:
            length = min(length, self.longest, self.duration - self.now)
            last = self.record.last
            trial = extrapolate_step(acting.rate, last.time, last.values, last.rates, length, tolerance)
            self._count(length)
            if not trial.error <= 1.0:
                length *= min(0.7, trial.factor) if isfinite(trial.error) else 0.1
                continue
            here, after = acting.knot(self.now + length, trial.values)
            event = EventSearch(acting, (last, here), (before, after), armed).due(self.duration)
            if event is not None:
                self._accept(event[0])
                acting.check(event[0])
                self.due = event[1]
                return self._apply(self.due)
            self._accept(here)
            before = after
            armed = [was or value > ARMING_MARGIN for was, value in zip(armed, after, strict=True)]
            length, tolerance = length * trial.factor, STEP_RTOL * acting.closeness(here)
        acting.check(self.record.last)
        self.now = self.duration
        return False

    def _count(self, length: float) -> None:
        self.steps += 1
        if self.steps > MAX_STEPS:
            raise SimulationError("MuJoCo: the budget of steps is used up")
        if length < MIN_STEP * self.duration:
            raise SimulationError(f"MuJoCo: the motion becomes singular at {self.now:.6g} s")

    def _accept(self, knot: Knot) -> None:
        if knot is not self.record.last:
            self._note_turns(self.record.last, knot)
            self.record.add(knot)
        self.now = knot.time
        n = self.model.size
        self.q, self.v = knot.values[:n], knot.values[n:]

    def _note_turns(self, before: Knot, after: Knot) -> None:
        n = self.model.size
        starts, ends = before.values[n:].tolist(), after.values[n:].tolist()
        for name, number in self.model.index.items():
            old, new = starts[number], ends[number]
            if old * new < 0.0 and min(abs(old), abs(new)) > REST_SPEED:
                when = before.time + old / (old - new) * (after.time - before.time)
                self.events.append(Event(when, "turn", (name,)))

    def _apply(self, due: list[EventFunction]) -> bool:
        """Apply the events that have been reached; return False if one ends the motion."""
        together = any(each.kind == "reach" for each in due)  # what two points at one place seem to do is nothing
        for each in due:
            number = each.number
            if together and each.kind in ("limit", "normal"):
                continue
            match each.kind:
                case "reach":
                    self.end("reach", *self.record.runs[number])
                case "limit":
                    self.end("limit", self.mechanism.coordinates[number].name)
                case "normal":
                    self.end("lift", self.mechanism.faces[number].subject)
                case "burn":
                    self.note("burn-out", self.mechanism.burns[number].body)
                    self.switches.burning[number] = False
                case "border":
                    self._cross(number, each.side)
                case "strain":
                    self._strain(number)
                case _:
                    pass
        return not self.cut

    def _strain(self, number: int) -> None:
        self.switches.strained[number] = not self.switches.strained[number]
        line, law = self.mechanism.half_springs[number]
        kind = "prop" if law.acts == "pushes" else "string"
        self.note((BEGINS if self.switches.strained[number] else STOPS)[kind], line.name)

    def _cross(self, number: int, side: int) -> None:
        inside = self.switches.inside[number]
        was = all(inside)
        inside[side] = not inside[side]
        if was != all(inside):
            self.note("enter" if all(inside) else "exit", self.mechanism.forces[number].body)
