"""Numerical integration of one contact mode by the native core, equal to that of `flow` bit for bit."""

from typing import TYPE_CHECKING, cast

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.exact.crossings import FlowStep
from sim2reason.simulation.engines.exact.flow import ABSOLUTE_TOL_RATIO, Flow
from sim2reason.simulation.engines.exact.margins import StopReason
from sim2reason.simulation.engines.exact.native import core

if TYPE_CHECKING:
    from sim2reason.simulation.engines.exact.core import _core

ENDED, DUE, ESTIMATE, SHORT, SPENT, PARTED = range(6)
"""Why the native loop returns: the end, an event, an estimate of the steps that remain, too short a step, an exhausted
budget, or a violated constraint."""


class NativeFlow(Flow):
    """The numerical integration of one contact mode by the native core, which also stores the steps."""

    _run: "_core.Integration | None" = None

    def _advance(self, duration: float, longest: float) -> StopReason:
        assert core is not None
        formulas, end = self.formulas, self.start + duration
        if formulas.braced:  # the condition on undetermined forces is evaluated in Python
            return super()._advance(duration, longest)
        rate, margins, closing, held = (
            cast("_core.Program", code) for code in (formulas.rate, formulas.code, formulas.closing, formulas.held)
        )
        run = core.Integration(rate, margins, closing, held, formulas.passing, self.time, self.values)
        self._store(run)
        run.begin(ABSOLUTE_TOL_RATIO * self._relative, self._relative)
        while True:
            why, due = self._continued(run, end, longest)
            if why == DUE:
                return StopReason(self.time - self.start, tuple(formulas.watched[number] for number in due))
            if why == SHORT:
                return self._singular()
            if why == ENDED:
                break
            self._interrupted(run, why, end)
        if self.steps and not self.stretches and self._is_small():
            self._take(self.steps[0], end, 0.0)
        return StopReason(duration, ())

    def _continued(self, run: "_core.Integration", end: float, longest: float) -> tuple[int, tuple[int, ...]]:
        """Run the native loop as far as the budget allows; return why it stops, and which event functions are due."""
        budget, cost = self._equations.system.budget, self.formulas.cost
        try:
            return run.advance(end, longest, budget.left // cost)
        finally:
            self.time, self.values = run.time, run.values
            self.turns += run.take_turns()
            budget.spend(cost * run.attempts)

    def _interrupted(self, run: "_core.Integration", why: int, end: float) -> None:
        """Decide how to continue; raise SimulationError if the budget is exhausted or constraints are violated."""
        if why == SPENT:
            self._equations.system.budget.spend(self.formulas.cost)
        elif why == PARTED:
            self._check_held()
        elif self._leap(end, (end - self.time) / run.length):
            run.resume(self.time, self.values, self._stored is not None)
            self._store(run)

    def _store(self, run: "_core.Integration") -> None:
        """Let the steps be those of the integration, of which Python reads the times, lengths and values."""
        self._run, self.steps = run, cast("list[FlowStep]", run)

    @property
    def _stored(self) -> "_core.Integration | None":
        """Return the native integration if it has the steps; None if Python has them or none is left."""
        return self._run if cast("object", self.steps) is self._run else None

    @property
    def integration(self) -> "_core.Integration | None":
        """Return the native integration if it has all of the motion, else None."""
        return None if self.stretches else self._stored

    @property
    def step_times(self) -> list[float]:
        """Return the times at which the integrator steps start, s."""
        return super().step_times if self._stored is None else self._stored.times()

    def on_steps(self, times: Array) -> Array:
        """Return coordinates and rates at times within integrator steps, (m, 2n)."""
        if self._stored is None:
            return super().on_steps(times)
        found = np.empty((len(times), len(self.values)))
        self._stored.sample(np.ascontiguousarray(times), found)
        return found
