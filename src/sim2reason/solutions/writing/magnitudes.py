"""Rewording of sentences about a vector whose sign is dropped, so that they are about its magnitude."""

import re

from sim2reason.quantities import QUANTITIES


def of_magnitude(said: str, quantity: str) -> str:
    """Reword the text before a formula, such as *The momentum is*, so that its subject is the magnitude of a vector.

    Text that does not name `quantity` is replaced; text about a scalar is unchanged.
    """
    if quantity not in QUANTITIES or not QUANTITIES[quantity].vector:
        return said
    found, count = re.subn(rf"\b([Tt])he {quantity}\b", rf"\1he magnitude of the {quantity}", said, count=1)
    return found if count else f"The magnitude of the {quantity} is"
