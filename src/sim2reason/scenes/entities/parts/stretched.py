"""What entities with a spring share: how long it is at the start."""

from collections.abc import Mapping
from typing import Annotated, Any

import numpy as np

from sim2reason.scenes.authoring import GRAVITY, Length, Range, placing
from sim2reason.scenes.bodies.spring import Spring
from sim2reason.scenes.dsl.model import as_said, rebuilt

LONG = Range(0.85, 1.15)  # times its natural length that a drawn spring is long at the start
FIRM = Range(6.0, 15.0)  # times the weight of the block that would stretch it to twice its length
SHORTEST = 0.3  # m, by itself
StartLength = Annotated[Length, Range(0.2, 1.0)]
AT_FIRST = placing(
    "initially {spring} has a length of {start}.",
    "the length of {spring} at the start is {start}.",
    "the initial length of {spring} is {start}.",
)


def fitted_spring(drawn: Mapping[str, Any], rng: np.random.Generator) -> dict[str, object]:
    """Return a `spring` that the weight of the drawn `block` changes little, and a `start` near its natural length."""
    spring, weight = drawn["spring"], GRAVITY * drawn["block"].mass
    length = max(spring.length, SHORTEST)
    stiffness = max(spring.stiffness, rng.uniform(FIRM.low, FIRM.high) * weight / length)
    firm = rebuilt(spring, stiffness=as_said(Spring, "stiffness", stiffness), length=length)
    return {"spring": firm, "start": as_said(Spring, "length", rng.uniform(LONG.low, LONG.high) * length)}
