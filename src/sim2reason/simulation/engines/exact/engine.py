"""The main loop of the exact engine: impacts, forces, and motion to the next event, repeated until the end."""

from threading import local
from typing import NamedTuple

from sim2reason.base.records import cached_property
from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.exact.balance import Balance
from sim2reason.simulation.engines.exact.contact_modes import NoForcesError
from sim2reason.simulation.engines.exact.flow import Flow
from sim2reason.simulation.engines.exact.formulas import VariableEquations
from sim2reason.simulation.engines.exact.glide import REST_RATE, ConstantEquations, stopping_time
from sim2reason.simulation.engines.exact.lengths import RowKind, SwitchState
from sim2reason.simulation.engines.exact.linear import ContactMode, Row
from sim2reason.simulation.engines.exact.margins import ENDS, Margin, StopReason
from sim2reason.simulation.engines.exact.motion import (
    BEGINS,
    SIMULTANEITY_TOL,
    STOPS,
    LogState,
    Motion,
    Sampler,
    Segment,
)
from sim2reason.simulation.engines.exact.native import core
from sim2reason.simulation.engines.exact.native_flow import NativeFlow
from sim2reason.simulation.engines.exact.settling import REST_SPEED, Settling
from sim2reason.simulation.engines.exact.system import Instant
from sim2reason.simulation.trace import DEFAULT_STEP_RTOL, ENGINES, Trace

FLOW = Flow if core is None else NativeFlow
SEGMENTS = 500  # largest number of motion segments
SETTLING_OPERATIONS = 5_000  # operations of an event for each coordinate


@ENGINES.register("exact")
def simulate(mechanism: Mechanism, times: Array, tolerance: float = DEFAULT_STEP_RTOL) -> Trace:
    """Simulate a mechanism in closed form, or by numerical integration if its equations change, at `times` (m,).

    Times are in seconds, increasing from 0; `tolerance` is of an integrator's step, relative.

    Raises:
        UnsupportedError: the mechanism has a part that this engine does not model.
        SimulationError: no consistent forces, a singular motion, more than 500 events or operations than `budget` has.
    """
    trajectory = motion(mechanism, float(times[-1]), tolerance)
    coarse = tolerance if tolerance > DEFAULT_STEP_RTOL else 0.0
    state = trajectory.state(times)
    return Trace(
        "exact",
        state,
        trajectory.events,
        trajectory.end,
        trajectory.cut,
        Sampler(trajectory),
        lambda: trajectory.knots,
        coarse,
        trajectory,
    )


def motion(mechanism: Mechanism, duration: float, tolerance: float = DEFAULT_STEP_RTOL) -> Motion:
    """Return the motion from 0 to `duration` seconds or to the event that ends it.

    Raises as `simulate` does.
    """
    run = _LATEST.take(mechanism, duration)
    try:
        if run is None:
            run = _Run(mechanism, duration, tolerance)
            run.motion = run.finished(run.step())
        elif not run.has_motion(duration, tolerance):
            run.motion = run.finished(run.resume(duration, tolerance))
        return _LATEST.keep(run)
    except NoForcesError as error:
        rough = ", ".join(name for name, contact in mechanism.contacts.items() if contact.friction > 0.0)
        remedy = f"; friction may be too strong on {rough}" if rough else ""
        now = run.now if run else 0.0
        raise SimulationError(f"{error} at {now:.6g} {mechanism.units.time}{remedy}", reached=now) from error
    except (ZeroDivisionError, OverflowError):
        if run is None:
            raise SimulationError("the motion is singular from the start; move apart what coincides") from None
        unit = mechanism.units.time
        problem = f"the motion becomes singular at {run.now:.6g} {unit}; simulate a shorter time"
        raise SimulationError(problem, reached=run.now) from None
    except SimulationError as error:
        error.reached = max(error.reached, run.now if run else 0.0)
        raise


class _Resumption(NamedTuple):
    """A state that does not depend on the duration of the motion: an instant with its forces, before it advances."""

    now: float
    q: Row
    v: Row
    phase: SwitchState
    kinds: list[RowKind]
    mode: ContactMode
    segments: list[Segment]
    before: int  # number of segments before
    log: LogState
    operations: int  # that remain
    instant: Instant
    found: Balance


class _Run(Settling):
    """A motion under construction: the present state and the segments so far, extended from event to event."""

    curved: VariableEquations | None
    motion: Motion  # the complete one
    _resumption: _Resumption | None = None

    def finished(self, goes_on: bool) -> Motion:  # noqa: FBT001 - what a step returns
        """Return the complete motion; raise SimulationError if it takes too many events or operations."""
        while goes_on:
            self.system.budget.spend(SETTLING_OPERATIONS * (1 + self.system.size))
            if len(self.segments) > SEGMENTS:
                before = f"{self.duration:g} {self.mechanism.units.time}"
                raise SimulationError(f"more than {SEGMENTS} events before {before}; simulate a shorter time")
            goes_on = self.step()
        if not self.segments:  # an impact at the start ended it
            force_balance = self.balance(self.instant(), set(), None)
            self.append(force_balance, None)
        return Motion(self.mechanism, tuple(self.segments), self.event_log.sorted(), self.now, self.event_log.cut)

    def step(self) -> bool:
        """Settle the present instant and advance to the next event; return False at the end."""
        self.v = [0.0 if abs(speed) < REST_SPEED else speed for speed in self.v]
        before = self.instant()
        snapped = self.impact(before)
        if snapped is None:
            return False
        instant = before if self.v is before.v else self.instant()
        force_balance = self.settle(instant, snapped, before.rates)
        if force_balance is None:
            return False
        if self.steady is not None or not self.segments:  # steps of an integrator depend on the duration
            self._resumption = self._resumable(instant, force_balance)
        return self._advance(instant, force_balance)

    # -- a longer duration -----------------------------------------------------------------------

    def can_resume(self, duration: float) -> bool:
        """Return whether the motion can be continued to `duration`, s."""
        return self._resumption is not None and duration >= self.duration

    def has_motion(self, duration: float, tolerance: float) -> bool:
        """Return whether the complete motion is that of a duration, s, and a tolerance of the integrator's steps."""
        return duration == self.duration and (self.curved is None or tolerance == self.tolerance)

    def _resumable(self, instant: Instant, found: Balance) -> _Resumption:
        segments, left = self.segments, self.system.budget.left
        state = (self.now, self.q, self.v, self.phase, self.kinds, self.mode, segments, len(segments))
        return _Resumption(*state, self.event_log.state, left, instant, found)

    def resume(self, duration: float, tolerance: float) -> bool:
        """Take the last step that depended on the duration again, for a longer one; return False at the end.

        The result is that of a new motion of this duration.
        """
        past = self._resumption
        assert past is not None
        self.duration, self.tolerance = duration, tolerance
        self.now, self.q, self.v, self.phase, self.kinds, self.mode = past[:6]
        self.segments = past.segments[: past.before]
        self.event_log.restore(past.log)
        self.system.budget.left = past.operations
        if self.curved is not None:
            self.curved = self.curved.restarted()
        self._resumption = past._replace(segments=self.segments)
        return self._advance(past.instant, past.found)

    # -- the next event --------------------------------------------------------------------------

    def _advance(self, instant: Instant, found: Balance) -> bool:
        """Advance to the next event; return False at the end."""
        left = self.duration - self.now
        if self.steady is not None:
            stop = self._glide(self.steady, instant, found, left)
        else:
            stop = self._flow(instant, found, left)
        self.due = stop.due
        ended = False
        for margin in stop.due:
            ended = self._happen(margin) or ended
        if not ended and stop.elapsed >= left:
            self.now = self.duration
            return False
        return not ended

    def _glide(self, steady: ConstantEquations, instant: Instant, found: Balance, left: float) -> StopReason:
        stop = steady.glide(instant, found, left)
        span = stop.elapsed
        self._note_turns(found, span)
        self.append(found, None)
        self.q = [q + span * (v + 0.5 * span * a) for q, v, a in zip(self.q, self.v, found.a, strict=True)]
        self.v = [v + span * a for v, a in zip(self.v, found.a, strict=True)]
        self.now += span
        return stop

    def _flow(self, instant: Instant, found: Balance, left: float) -> StopReason:
        assert self.curved is not None
        flow = FLOW(self.curved, instant, self.phase, found, self.tolerance)
        stop = flow.advance(left, self.duration)
        self.append(found, flow)
        n = self.system.size
        self.now, self.q, self.v = flow.time, list(flow.values[:n]), list(flow.values[n:])
        rough = self._rough
        for time, number in flow.turns:
            if number not in rough:
                self.event_log.record(time, "turn", self.mechanism.coordinates[number].name)
        return stop

    def _happen(self, margin: Margin) -> bool:
        """Apply the event whose event function has reached zero; return whether it ends the motion."""
        number = margin.number
        match margin.kind:
            case "reach":
                self.event_log.end(self.now, "reach", *list(self.system.runs)[number])
            case "limit":
                self.event_log.end(self.now, "limit", self.system.limits[number].name)
            case "normal":
                self.event_log.lift(self.now, (number,))
            case "burn":
                self.event_log.record(self.now, "burn-out", self.mechanism.burns[number].body)
                burning = tuple(on and i != number for i, on in enumerate(self.phase.burning))
                self.phase = self.phase._replace(burning=burning)
            case "border":
                self._cross(number, margin.side)
            case "slip":
                self._halt(number)
            case "strain":
                self._strain(number)
            case _:
                pass
        return margin.kind in ENDS

    def _halt(self, number: int) -> None:
        """Apply the end of sliding at a contact; if the slip is one coordinate's rate, set that rate to exact zero."""
        grip = self.system.grips[number]
        if grip.coordinate >= 0 and abs(self.v[grip.coordinate]) < REST_RATE:
            self.v = [0.0 if k == grip.coordinate else speed for k, speed in enumerate(self.v)]

    def _cross(self, number: int, side: int) -> None:
        """Apply the crossing of a border of a region in which a force acts."""
        inside = self.phase.inside[number]
        crossed = tuple(not within if i == side else within for i, within in enumerate(inside))
        if all(inside) != all(crossed):
            self.event_log.record(self.now, "enter" if all(crossed) else "exit", self.mechanism.forces[number].body)
        everywhere = tuple(crossed if i == number else flags for i, flags in enumerate(self.phase.inside))
        self.phase = self.phase._replace(inside=everywhere)

    def _strain(self, number: int) -> None:
        """Switch a one-sided spring on or off."""
        strained = tuple(was != (i == number) for i, was in enumerate(self.phase.strained))
        self.phase = self.phase._replace(strained=strained)
        line, law = self.mechanism.half_springs[number]
        kind = "prop" if law.acts == "pushes" else "string"
        self.event_log.record(self.now, (BEGINS if strained[number] else STOPS)[kind], line.name)

    @cached_property
    def _rough(self) -> set[int]:
        """Return the indices of the coordinates with friction, whose reversal changes the contact mode."""
        return {grip.coordinate for grip in self.system.grips}

    def _note_turns(self, found: Balance, span: float) -> None:
        """Record the instants within `span` at which the rate of a frictionless coordinate passes through zero."""
        for number, (speed, a) in enumerate(zip(self.v, found.a, strict=True)):
            if (
                speed * a < 0.0
                and SIMULTANEITY_TOL < stopping_time(speed, a) < span - SIMULTANEITY_TOL
                and number not in self._rough
            ):
                self.event_log.record(
                    self.now + stopping_time(speed, a), "turn", self.mechanism.coordinates[number].name
                )


class _Latest(local):
    """The latest run of a thread, which a search for an event continues to longer and longer durations.

    More of them would take more time by their memory than they save.
    """

    run: _Run | None = None

    def take(self, mechanism: Mechanism, duration: float) -> _Run | None:
        """Remove and return the run if it is of this very mechanism and can be continued to `duration`, s."""
        run, self.run = self.run, None
        return run if run is not None and run.mechanism is mechanism and run.can_resume(duration) else None

    def keep(self, run: _Run) -> Motion:
        """Keep a run, and return its motion."""
        self.run = run
        return run.motion


_LATEST = _Latest()
