"""Integrator steps with dense output."""

from collections.abc import Sequence

import numpy as np

from sim2reason.simulation.engines.exact import dop853
from sim2reason.simulation.engines.exact.mode_code import Formulas


class FlowStep:
    """One integrator step with dense output."""

    __slots__ = ("_polynomial", "formulas", "length", "new", "stages", "time", "values")

    def __init__(
        self, formulas: Formulas, time: float, length: float, values: dop853.Values, to: dop853.Advance
    ) -> None:
        """`values` are coordinates, then rates, at its beginning."""
        self.formulas, self.time, self.length, self.values = formulas, time, length, values
        self.new, self.stages = to.values, to.stages
        self._polynomial: tuple[dop853.Values, ...] | None = None

    @property
    def polynomial(self) -> tuple[dop853.Values, ...]:
        """The coefficients of its unknowns."""
        if self._polynomial is None:
            rate = self.formulas.rate
            self._polynomial = dop853.dense(rate, self.time, self.values, self.length, self.new, self.stages)
        return self._polynomial

    def at(self, x: float) -> dop853.Values:
        """Coordinates and rates at a fraction of the step."""
        return dop853.interpolated(self.values, self.polynomial, x)

    def margins(self, x: float) -> tuple[float, ...]:
        """All margins at a fraction of the step."""
        return self.formulas.margins(self.time + x * self.length, self.at(x))

    def closing(self, x: float) -> tuple[float, ...]:
        """Return the closing speeds and distances of points that may pass each other, at a fraction of the step."""
        return self.formulas.closing(self.time + x * self.length, self.at(x))


class StepTable:
    """All steps of a flow in arrays; the polynomials of those that were looked at."""

    def __init__(self, steps: Sequence[FlowStep]) -> None:
        """The flow is at its end."""
        self.starts = np.array([step.time for step in steps])
        self.lengths = np.array([step.length for step in steps])
        self.values = np.array([step.values for step in steps])
        self.polynomials = np.empty((dop853.COEFFICIENTS, *self.values.shape))
        self._filled = set[int]()

    def fill(self, steps: Sequence[FlowStep], numbers: set[int]) -> None:
        """Look at some steps."""
        new = sorted(numbers - self._filled)
        if new:
            self._filled.update(new)
            self.polynomials[:, new] = np.array([steps[number].polynomial for number in new]).transpose(2, 0, 1)
