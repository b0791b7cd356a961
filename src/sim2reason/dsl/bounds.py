"""What an annotation allows of a number."""

from collections.abc import Iterable
from math import inf, nextafter
from typing import cast

from annotated_types import Ge, Gt, Le, Lt


def bounds(metadata: Iterable[object]) -> tuple[float, float]:
    """The least and the greatest float that all of the bounds in an annotation's metadata allow."""
    least, most = -inf, inf
    for bound in metadata:
        if isinstance(bound, Ge):
            least = max(least, cast("float", bound.ge))
        elif isinstance(bound, Gt):
            least = max(least, nextafter(cast("float", bound.gt), inf))
        elif isinstance(bound, Le):
            most = min(most, cast("float", bound.le))
        elif isinstance(bound, Lt):
            most = min(most, nextafter(cast("float", bound.lt), -inf))
    return float(least), float(most)
