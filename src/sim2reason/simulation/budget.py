"""How much one motion may cost: work is counted, never the clock looked at, so that every machine gives up alike."""

from sim2reason.errors import SimulationError

OPERATIONS = 40_000_000  # of arithmetic, each about 30 ns of Python on a machine of 2024


class Budget:
    """The operations that are left to one engine for one motion."""

    __slots__ = ("all", "left")

    def __init__(self, operations: int = OPERATIONS) -> None:
        """Nothing is spent."""
        self.all = self.left = operations

    def spend(self, operations: int) -> None:
        """Take so many; SimulationError once there are none left."""
        self.left -= operations
        if self.left < 0:
            raise SimulationError(
                f"it takes more than {self.all // 1_000_000} million operations; simulate a shorter time"
            )
