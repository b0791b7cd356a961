"""Square roots of polynomials that are perfect squares."""

import math
from collections.abc import Mapping
from itertools import product

from sim2reason.solutions.algebra.polynomials import Polynomial, total

SUMMANDS = 5  # terms of the root, at most


def square_root(inside: Polynomial, at: Mapping[str, float]) -> Polynomial | None:
    """Return the square root of a polynomial, positive for the known values `at`; None if it is no perfect square."""
    plain = [(m, part) for m, part in inside.terms.items() if part > 0.0 and all(power % 2 == 0 for _, power in m)]
    if not 1 <= len(plain) <= SUMMANDS:
        return None
    roots = [Polynomial({tuple((atom, power // 2) for atom, power in m): math.sqrt(part)}) for m, part in plain]
    for signs in product((1.0, -1.0), repeat=len(roots) - 1):
        found = total(root.scaled(sign) for root, sign in zip(roots, (1.0, *signs), strict=True))
        if not (found * found - inside):
            return found if found.value(at) > 0.0 else found.scaled(-1.0)
    return None
