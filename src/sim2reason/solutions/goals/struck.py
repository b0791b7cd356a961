"""A collision as goals see it."""

from typing import Protocol

from sim2reason.solutions.algebra.expressions import Expression


class Struck(Protocol):
    """A collision of a motion."""

    @property
    def bodies(self) -> tuple[str, ...]:
        """Whose it is."""
        ...

    @property
    def told(self) -> str:
        """It in words: the collision of two bodies."""
        ...

    @property
    def loses(self) -> str:
        """Why kinetic energy is lost in it, as the beginning of a sentence."""
        ...

    @property
    def pushes(self) -> str:
        """The laws that give its impulse, as the beginning of a sentence."""
        ...

    @property
    def lost(self) -> Expression:
        """The kinetic energy that is lost in it."""
        ...

    @property
    def push(self) -> Expression:
        """The size of its impulse."""
        ...
