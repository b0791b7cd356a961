"""What mathematics it takes to finish a problem, from arithmetic to numerical integration."""

from collections.abc import Iterable
from enum import IntEnum


class Need(IntEnum):
    """The most advanced operation that a calculation takes, in ascending order."""

    ARITHMETIC = 0
    """Sums, products, quotients, whole powers, and sines and cosines of known angles."""
    QUADRATIC = 1
    """A square root, or a quadratic equation."""
    INVERSE_FUNCTION = 2
    """An inverse trigonometric function, a logarithm or an exponential function."""
    ROOT = 3
    """An equation that is solved numerically, be it transcendental or of a higher degree."""
    SPECIAL_FUNCTION = 4
    """An elliptic integral."""
    INTEGRATION = 5
    """Equations of motion that are integrated numerically."""

    @property
    def label(self) -> str:
        """Its name in items, on the command line and in the docs."""
        return self.name.lower().replace("_", " ")


NEEDS = {need.label: need for need in Need}
"""All needs by their labels."""
EVERY = frozenset(Need)
ELEMENTARY = Need.INVERSE_FUNCTION
"""The greatest need that is met without a computer."""


def greatest(needs: Iterable[Need]) -> Need:
    """Return the most advanced of some needs; ARITHMETIC if there are none."""
    return max(needs, default=Need.ARITHMETIC)
