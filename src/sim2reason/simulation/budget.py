"""Limit on the operations spent on one motion, so that the result does not depend on the speed of the machine."""

from sim2reason.errors import SimulationError

OPERATIONS = 40_000_000  # arithmetic operations for one motion, each about 30 ns of Python on a machine of 2024


class Budget:
    """The arithmetic operations that remain for one engine and one motion."""

    __slots__ = ("all", "left")

    def __init__(self, operations: int = OPERATIONS) -> None:
        """Start with the full number of operations."""
        self.all = self.left = operations

    def spend(self, operations: int) -> None:
        """Subtract operations from the budget; raise SimulationError if none remain."""
        self.left -= operations
        if self.left < 0:
            raise SimulationError(
                f"it takes more than {self.all // 1_000_000} million operations; simulate a shorter time"
            )
