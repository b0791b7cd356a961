"""The interface of a collision for goals."""

from typing import Protocol

from sim2reason.solutions.algebra.expressions import Expression


class Struck(Protocol):
    """A collision of a motion."""

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the bodies that collide."""
        ...

    @property
    def told(self) -> str:
        """Return a name of it, such as *the first collision of A and B*."""
        ...

    @property
    def loses(self) -> str:
        """Return the beginning of a sentence that says why kinetic energy is lost."""
        ...

    @property
    def pushes(self) -> str:
        """Return the beginning of a sentence that names the laws for the impulse."""
        ...

    @property
    def lost(self) -> Expression:
        """Return the kinetic energy lost."""
        ...

    @property
    def push(self) -> Expression:
        """Return the magnitude of the impulse."""
        ...
