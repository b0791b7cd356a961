"""Interface of a collision as goals use it."""

from typing import Protocol

from sim2reason.solutions.algebra.expressions import Expression


class CollisionTerm(Protocol):
    """One collision of a motion, with the reasons and formulas for its energy loss and impulse."""

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
        """Return the first words of a sentence that gives the energy loss: the reason why kinetic energy is lost."""
        ...

    @property
    def pushes(self) -> str:
        """Return the first words of a sentence that gives the impulse: the laws from which the impulse follows."""
        ...

    @property
    def lost(self) -> Expression:
        """Return the kinetic energy lost, J."""
        ...

    @property
    def push(self) -> Expression:
        """Return the magnitude of the impulse, N s."""
        ...
