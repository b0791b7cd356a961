"""Sentences about a vector, made sentences about its magnitude where its sign is dropped."""

import re

from sim2reason.quantities import QUANTITIES


def of_magnitude(said: str, quantity: str) -> str:
    """Return the words before a formula, such as *The momentum is*, with the magnitude of a vector as their subject.

    Words that do not name it are replaced; those about what is no vector stay as they are.
    """
    if quantity not in QUANTITIES or not QUANTITIES[quantity].vector:
        return said
    found, count = re.subn(rf"\b([Tt])he {quantity}\b", rf"\1he magnitude of the {quantity}", said, count=1)
    return found if count else f"The magnitude of the {quantity} is"
