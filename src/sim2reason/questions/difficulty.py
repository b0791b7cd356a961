"""Difficulty labels, and the mathematics that a solution needs, in ascending order."""

from collections.abc import Iterable
from enum import IntEnum
from typing import Literal

Difficulty = Literal["easy", "medium", "hard"]
DIFFICULTIES: tuple[Difficulty, ...] = ("easy", "medium", "hard")


class Need(IntEnum):
    """The most advanced operation of a calculation, in ascending order."""

    ARITHMETIC = 0
    QUADRATIC = 1
    INVERSE_FUNCTION = 2
    ROOT = 3
    SPECIAL_FUNCTION = 4
    INTEGRATION = 5

    @property
    def label(self) -> str:
        """Return the name of the need in items, on the command line and in the docs."""
        return self.name.lower().replace("_", " ")


NEED_DESCRIPTIONS = {
    Need.ARITHMETIC: "sums, products, quotients, whole powers, and sines and cosines of known angles",
    Need.QUADRATIC: "a square root or a quadratic equation",
    Need.INVERSE_FUNCTION: "an inverse trigonometric function, a logarithm or an exponential function",
    Need.ROOT: "a transcendental equation or one of a higher degree, solved numerically",
    Need.SPECIAL_FUNCTION: "an elliptic integral",
    Need.INTEGRATION: "equations of motion that are integrated numerically",
}
"""What each of them is, for people."""
NEEDS = {need.label: need for need in Need}
"""All needs by their labels."""
EVERY = frozenset(Need)
ELEMENTARY = Need.INVERSE_FUNCTION
"""The greatest need that is met without a computer."""


def most_advanced(needs: Iterable[Need]) -> Need:
    """Return the most advanced of some needs; ARITHMETIC if there are none."""
    return max(needs, default=Need.ARITHMETIC)
