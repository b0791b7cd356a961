"""Numerical integration of a mechanism with changing equations, with events located within the steps."""

from collections.abc import Sequence
from math import inf, isfinite, pi

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.exact import dop853
from sim2reason.simulation.engines.exact.balance import Balance
from sim2reason.simulation.engines.exact.crossings import (
    Crossing,
    FlowStep,
    MarginWatch,
    StepTable,
    bracketed_root,
    motion_scale,
)
from sim2reason.simulation.engines.exact.eigenmodes import (
    LinearInterval,
    find_modes,
    pieces,
    solve_interval,
    turning_times,
)
from sim2reason.simulation.engines.exact.formulas import VariableEquations
from sim2reason.simulation.engines.exact.lengths import SwitchState
from sim2reason.simulation.engines.exact.margins import StopReason
from sim2reason.simulation.engines.exact.system import Instant

ABSOLUTE_TOL_RATIO = 1e-2  # absolute error per relative tolerance of a step, in m or rad and their rates
MIN_STEP = 1e-13  # fraction of the duration: a smaller step indicates a singularity
CONSTRAINT_VIOLATION_TOL = 1e-6  # m; larger violation of an acting constraint is an error
SIMULTANEITY_RTOL = 1e-10  # fraction of the duration: events closer than this are simultaneous
MAX_POLISHES = 4  # corrections of an event time by an integrator step
STEPS_BEFORE_ESTIMATE = 200  # steps after which the number of remaining steps is first estimated
EIGENMODE_STEP_THRESHOLD = 20_000  # remaining steps above which linear equations are solved by eigenmodes instead
MIN_RESOLVED_DISPLACEMENT, SMALL_DISPLACEMENT = (
    1e-12,
    1e-4,
)  # m or rad; displacements too small for `ABSOLUTE_TOL_RATIO`; below the first none is resolved
MIN_LEAP = 10  # least length of an interval solved by eigenmodes, in fastest periods
PIECE_OPERATIONS = 20  # operations of a piece of an eigenmode interval, for each coordinate
REST_SPEED = 1e-11  # m/s or rad/s; residual round-off of a speed that is zero


class Flow:
    """The numerical integration of one contact mode, from its start to the event that ends it."""

    def __init__(
        self, equations: VariableEquations, instant: Instant, phase: SwitchState, found: Balance, tolerance: float
    ) -> None:
        """Generate the code of the mode unless it exists; `tolerance` is the relative error of a step."""
        self._relative = tolerance
        self._tolerance = ABSOLUTE_TOL_RATIO * tolerance, tolerance
        self._equations, self._phase, self._mode = equations, phase, found.mode
        self.formulas = equations.formulas(instant, phase, found.mode)
        self.start = self.time = instant.time
        self.values: dop853.Values = (*instant.q, *instant.v)
        self.steps: list[FlowStep] = []
        self.stretches: list[
            LinearInterval
        ] = []  # between steps, where the motion is linear and steps would be too many
        self._watch = MarginWatch(())
        self.turns: list[tuple[float, int]] = []  # when a coordinate's speed passes through zero, and which

    @property
    def moves(self) -> bool:
        """Return whether the integration has made any progress in time."""
        return bool(self.steps or self.stretches)

    @property
    def step_times(self) -> list[float]:
        """Return the times at which the integrator steps start, s."""
        return [step.time for step in self.steps]

    @cached_property
    def table(self) -> StepTable:
        """Return all steps as arrays, once the integration is complete."""
        return StepTable(self.steps)

    def on_steps(self, times: Array) -> Array:
        """Return coordinates and rates at times within integrator steps, (m, 2n)."""
        table = self.table
        at = np.maximum(table.starts.searchsorted(times, side="right") - 1, 0)
        numbers = set[int](at.tolist())
        table.fill(self.steps, numbers)
        if len(numbers) == 1:  # as where an instant is closed in on: NumPy repeats the one step by itself
            at = at[:1]
        x = ((times - table.starts[at]) / table.lengths[at])[:, None]
        y = 1.0 - x
        a, b, c, d, e, f, g = table.polynomials[:, at]
        rise = x * (a + y * (b + x * (c + y * (d + x * (e + y * (f + x * g))))))
        found: Array = table.values[at] + rise
        return found

    def advance(self, duration: float, longest: float) -> StopReason:
        """Integrate for `duration`, s, or to the first event, or to where the linear equations need new pivots.

        `longest` is the duration of the whole motion. Raises SimulationError if the steps become too costly or too
        short, or if the equations have no value.
        """
        try:
            return self._advance(duration, longest)
        except (ZeroDivisionError, OverflowError, ValueError):
            return self._singular()
        except ArithmeticError:
            self._equations.forget(self._phase, self._mode)
            return StopReason(self.time - self.start, ())

    def _advance(self, duration: float, longest: float) -> StopReason:
        end, rate = self.start + duration, self.formulas.rate
        first = rate(self.time, self.values)
        self._tolerance = (
            ABSOLUTE_TOL_RATIO * self._relative * motion_scale(rate, self.time, self.values, first),
            self._relative,
        )
        before = self.formulas.margins(self.time, self.values)
        self._watch = MarginWatch(before)
        length = dop853.first_step(rate, self.time, self.values, first, self._tolerance)
        while self.time < end:
            length = min(length, end - self.time)
            if not length >= MIN_STEP * longest and end - self.time > MIN_STEP * longest:  # or it is no number
                return self._singular()
            self._equations.system.budget.spend(self.formulas.cost)
            try:
                trial = dop853.advance(rate, self.time, self.values, first, length, self._tolerance)
            except (ZeroDivisionError, OverflowError, ValueError):  # somewhere ahead; nearer, a pivot is lost before
                length *= 0.1
                continue
            if not trial.error <= 1.0:
                length *= min(0.5, dop853.step_ratio(trial.error)) if isfinite(trial.error) else 0.1
                continue
            step = FlowStep(self.formulas, self.time, length, self.values, trial)
            after = self.formulas.margins(step.time + length, trial.values)
            due = self._due(step, before, after, SIMULTANEITY_RTOL * longest)
            if due is not None:
                return due
            self._keep(step)
            self._check_held()
            first, before = trial.stages[-1], after
            self._watch.passed(after)
            length *= dop853.step_ratio(trial.error)
            if len(self.steps) % STEPS_BEFORE_ESTIMATE == 0 and self._leap(end, (end - self.time) / length):
                first, before = rate(self.time, self.values), self.formulas.margins(self.time, self.values)
                self._watch.passed(before)
        if self.steps and not self.stretches and self._is_small():
            self._take(self.steps[0], end, 0.0)
        return StopReason(duration, ())

    def _leap(self, end: float, steps: float) -> bool:
        """Solve the motion to `end` by eigenmodes if `steps` steps are too many or coarse; return whether this is done.

        The interval starts at the first step if possible, because errors of early steps persist; otherwise at the
        present.
        """
        budget = self._equations.system.budget
        if (
            steps < EIGENMODE_STEP_THRESHOLD
            and steps * self.formulas.cost < budget.left
            and (self.stretches or not self._is_small())
        ):
            return False
        took = not self.stretches and self._take(self.steps[0], end)
        while self.time < end and self._take(None, end):
            took = True
        return took

    def _is_small(self) -> bool:
        """Return whether the motion so far is so small that the absolute error of the integrator matters."""
        here, n = self.values[: self._equations.system.size], self._equations.system.size
        far = 0.0
        for step in reversed(self.steps):  # an ordinary motion is known by the first of them
            far = max(far, *(abs(a - b) for a, b in zip(here, step.values[:n], strict=False)), 0.0)
            if far > SMALL_DISPLACEMENT:
                return False
        return far > MIN_RESOLVED_DISPLACEMENT

    def _take(self, begin: FlowStep | None, end: float, periods: float = MIN_LEAP) -> bool:
        """Solve an interval by eigenmodes, from now or from step `begin`, replacing all steps; return the success."""
        linear = self.formulas.linear
        if linear is None:
            return False
        time, values = (begin.time, begin.values) if begin else (self.time, self.values)
        modes = find_modes(linear, time, values)
        if modes is None:
            return False
        left = np.array(self.formulas.margins(time, values))
        linear_stretch = solve_interval(modes, end - time, left, linear.margins, periods * 2.0 * pi / modes.fastest)
        if linear_stretch is None or linear_stretch.time + linear_stretch.length < self.time:
            return False
        self._equations.system.budget.spend(
            PIECE_OPERATIONS * self._equations.system.size * pieces(modes, linear_stretch.length)
        )
        if begin:
            self.steps, self.turns = [], []
        self.stretches.append(linear_stretch)
        self.turns += turning_times(modes, linear_stretch.length)
        self.time, self.values = linear_stretch.time + linear_stretch.length, linear_stretch.new
        return True

    def _check_held(self) -> None:
        """Raise SimulationError if redundant constraints block the motion, as equations of one instant cannot show."""
        constraint_values = self.formulas.held
        if (
            constraint_values is not None
            and max(map(abs, constraint_values(self.time, self.values))) > CONSTRAINT_VIOLATION_TOL
        ):
            problem = "strings and rods hold something so often that they contradict each other"
            raise SimulationError(f"{problem} once it moves, at {self.start:.6g} s", reached=self.start)

    def _singular(self) -> StopReason:
        """Handle a singular step: return the event if two points of a line coincide, else raise SimulationError."""
        watched = zip(self.formulas.watched, self._margins(), strict=True)
        due = tuple(margin for margin, left in watched if margin.kind == "reach" and left <= 0.0)
        if not due:
            unit = self._equations.system.mechanism.units.time
            problem = f"the motion becomes singular at {self.time:.6g} {unit}; simulate a shorter time"
            raise SimulationError(problem, reached=self.time)
        return StopReason(self.time - self.start, due)

    def _margins(self) -> Sequence[float]:
        """Return all event functions at the present; infinite if they have no value."""
        try:
            return self.formulas.margins(self.time, self.values)
        except (ZeroDivisionError, OverflowError, ValueError):
            return (inf,) * len(self.formulas.watched)

    def _keep(self, step: FlowStep) -> None:
        self._note_turns(step)
        self.steps.append(step)
        self.time, self.values = step.time + step.length, step.new

    # ---- events

    def _due(self, step: FlowStep, before: Sequence[float], after: Sequence[float], tie: float) -> StopReason | None:
        """Truncate the step at its first event and return that event; None if there is none."""
        if not before:
            return None
        crossings = self._watch.crossings((before, step.margins(0.5), after), step.margins)
        crossings += self._passes(step, {number for number, _ in crossings})
        if not crossings:
            return None
        roots = [
            (bracketed_root(lambda x, i=number, r=room: step.margins(x)[i] + r, low, high), number, room)
            for number, (low, high, room) in crossings
        ]
        soonest, leader, room = min(roots)
        length = self._polished(step, soonest, leader, room)
        near = [self.formulas.watched[i] for x, i, _ in roots if (x - soonest) * step.length <= tie]
        due = [each for margin in near for each in self.formulas.due(margin, self.time, self.values)]
        return StopReason(self.time - self.start, tuple(due)) if length >= 0.0 else None

    def _passes(self, step: FlowStep, known: set[int]) -> list[tuple[int, Crossing]]:
        """Return event functions, by index, of line points that coincide within a step, each with the instant."""
        passing = self.formulas.passing
        if not passing:
            return []
        passes: list[tuple[int, Crossing]] = []
        count, ends = len(passing), (step.closing(0.0), step.closing(1.0))
        for index, (number, first, last) in enumerate(zip(passing, *(end[:count] for end in ends), strict=True)):
            if first < 0.0 < last and number not in known:
                nearest = bracketed_root(lambda x, i=index: -step.closing(x)[i], 0.0, 1.0)
                if step.closing(nearest)[count + index] <= 0.0:
                    passes.append((number, Crossing(0.0, nearest)))
        return passes

    def _polished(self, step: FlowStep, x: float, number: int, room: float) -> float:
        """Append a step that ends at an event, predicted at fraction `x` of `step`; return the length of that step."""
        rate, first = self.formulas.rate, step.stages[0]
        width = 1e-4 * min(x, 1.0 - x) if 0.0 < x < 1.0 else 1e-6
        slope = (step.margins(x + width)[number] - step.margins(x - width)[number]) / (2.0 * width * step.length)
        length = x * step.length
        for _ in range(MAX_POLISHES):
            if length <= 0.0:
                return 0.0
            trial = dop853.advance(rate, step.time, step.values, first, length, self._tolerance)
            missed = self.formulas.margins(step.time + length, trial.values)[number] + room
            change = -missed / slope if slope else 0.0
            if abs(change) <= 1e-15 * (step.time + length) or not 0.0 < length + change <= 1.5 * step.length:
                break
            length += change
        trial = dop853.advance(rate, step.time, step.values, first, length, self._tolerance)
        self._keep(FlowStep(self.formulas, step.time, length, step.values, trial))
        return length

    def _note_turns(self, step: FlowStep) -> None:
        """Record the instants within a step at which speeds pass through zero."""
        n = self._equations.system.size
        for number in range(n, 2 * n):
            old, new = step.values[number], step.new[number]
            if old * new < 0.0 and abs(old) > REST_SPEED and abs(new) > REST_SPEED:
                sign = 1.0 if old > 0.0 else -1.0
                path = step.polynomial[number]
                x = bracketed_root(lambda x, o=old, p=path, s=sign: s * dop853.interpolated_one(o, p, x), 0.0, 1.0)
                self.turns.append((step.time + x * step.length, number - n))


def sampled(flow: Flow, times: Array) -> Array:
    """Return coordinates and rates at times within an integrated motion, (m, 2n)."""
    values = flow.on_steps(times) if flow.steps else np.empty((len(times), len(flow.values)))
    for linear in flow.stretches:
        inside = (times >= linear.time) & (times <= linear.time + linear.length)
        if inside.any():
            values = np.broadcast_to(values, (len(times), values.shape[1])).copy()
            values[inside] = linear.modes.at(times[inside])
    return values
