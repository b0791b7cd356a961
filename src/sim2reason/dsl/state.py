"""What a motion looks like to whoever reads it: arrays over time, the same from every engine."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sim2reason.dsl.mechanism import Mechanism

Array = NDArray[np.float64]


@dataclass(frozen=True)
class State:
    """The motion of a mechanism at n instants.

    `q`, `v`, `a` have the shape (n, number of coordinates), in the order of `mechanism.coordinates`.
    At an instant of an event the values are those just after it. A force that the mechanism does not
    determine (three supports, two unknown frictions) is NaN; everything else is finite.
    """

    mechanism: Mechanism
    times: Array  # s, (n,)
    q: Array  # m or rad
    v: Array
    a: Array
    tension: Mapping[str, Array]  # by string part, N, ≥ 0; also the pulls, constant
    normal: Mapping[str, Array]  # by the body that rests, N, ≥ 0
    friction: Mapping[str, Array]  # by the body that rests, N, on that body, positive along its coordinate
