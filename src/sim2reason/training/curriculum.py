"""A curriculum: what a model solves sometimes comes more often than what it always or never solves."""

from typing import Annotated

from annotated_types import Gt, Le, Lt
from pydantic import BaseModel, ConfigDict

__all__ = ["Curriculum"]

UNKNOWN = 0.5  # the pass rate of what has not been tried


class Curriculum(BaseModel):
    """How cells are weighed by their measured pass rates.

    A cell of pass rate p has the weight `floor` + 4 p (1 − p): the variance of its rewards, on which the gradient of a
    group-relative advantage rests, and a floor so that no cell is given up.
    """

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    floor: Annotated[float, Gt(0.0), Le(10.0)] = 0.2
    memory: Annotated[float, Gt(0.0), Lt(1.0)] = 0.98
    """How much of an average over groups stays when another group of the cell is seen."""

    def weight(self, rate: float | None) -> float:
        """Of a cell with a pass rate, None for one that has not been tried."""
        p = UNKNOWN if rate is None else rate
        return self.floor + 4.0 * p * (1.0 - p)

    def after(self, rate: float | None, seen: float) -> float:
        """Return the pass rate of a cell after a group in which the share `seen` was right."""
        before = UNKNOWN if rate is None else rate
        return self.memory * before + (1.0 - self.memory) * seen
