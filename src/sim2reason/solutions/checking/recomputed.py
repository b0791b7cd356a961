"""The outcome of recomputing a worked solution."""

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class Recomputed:
    """The answer to which the data of a solution leads, in the unit of the question, and what is wrong with it.

    `values` are those of all names that have one.
    """

    answer: float | None
    faults: tuple[str, ...]
    values: Mapping[str, float] = field(default_factory=dict[str, float])

    def agrees(self, answer: float, within: float) -> bool:
        """Return whether there is no fault, and the answer is another one but for a relative deviation."""
        return not self.faults and self.answer is not None and abs(self.answer - answer) <= within * abs(answer)
