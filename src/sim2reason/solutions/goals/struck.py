"""Interface of a collision as goals use it."""

from typing import Protocol

from sim2reason.solutions.algebra.expressions import Expression


class CollisionTerm(Protocol):
    """A collision of a motion."""

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the names of the colliding bodies."""
        ...

    @property
    def told(self) -> str:
        """Return the name of the collision, such as *the first collision of A and B*."""
        ...

    @property
    def loses(self) -> str:
        """Return the beginning of a sentence with the reason for the loss of kinetic energy."""
        ...

    @property
    def pushes(self) -> str:
        """Return the beginning of a sentence with the laws that give the impulse."""
        ...

    @property
    def lost(self) -> Expression:
        """Return the kinetic energy lost, J."""
        ...

    @property
    def push(self) -> Expression:
        """Return the magnitude of the impulse, N s."""
        ...
