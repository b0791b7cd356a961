"""Random numbers with few decimals, and parts that several families share."""

from math import cos, sin

import numpy as np

from sim2reason.scenes.dsl.builder import Frame
from sim2reason.scenes.dsl.mechanism import X, Z
from sim2reason.scenes.dsl.vectors import Tensor, Vector

Rng = np.random.Generator
SIDE: tuple[float, float] = (-1.0, 1.0)


def number(rng: Rng, low: float, high: float) -> float:
    """Return a random number with two decimals."""
    return round(float(rng.uniform(low, high)), 2)


def choice(rng: Rng, *values: float) -> float:
    return float(rng.choice(values))


def chance(rng: Rng, share: float) -> bool:
    return bool(rng.random() < share)


def mass(rng: Rng) -> float:
    return number(rng, 0.2, 3.0)


def polar(length: float, angle: float) -> Vector:
    """Return a vector in the xz plane, its angle measured from straight down towards x."""
    return (length * sin(angle), 0.0, -length * cos(angle))


def slope(angle: float) -> tuple[Vector, Vector]:
    """Return the unit vectors up an incline and normal to it."""
    return (cos(angle), 0.0, sin(angle)), (-sin(angle), 0.0, cos(angle))


def about_y(moment: float) -> Tensor:
    return (moment, moment, moment, 0.0, 0.0, 0.0)


def particle(
    frame: Frame, name: str, rng: Rng, at: Vector, speed: float = 0.0, velocity: tuple[float, float] | None = None
) -> Frame:
    """Build a body that moves freely in the xz plane, with a hook.

    The components of its velocity are given, or random up to `speed`.
    """
    drawn = (number(rng, -speed, speed), number(rng, -speed, speed)) if speed else (0.0, 0.0)
    vx, vz = drawn if velocity is None else velocity
    made = frame.body(name, mass(rng), at=at).slide(X, vx, name="x").slide(Z, vz, name="z")
    return made.site(f"{name}.hook")


def cart(room: Frame, rng: Rng) -> tuple[Frame, float]:
    """Build the support of a chain, and return it with its speed.

    The support is the room, or a cart on a rail, rough, smooth or on a spring.
    """
    if chance(rng, 0.5):
        return room, 0.0
    friction, speed = choice(rng, 0.0, 0.0, number(rng, 0.05, 0.3)), choice(rng, 0.0, number(rng, -1.0, 1.0))
    made = room.body("cart", mass(rng)).rest(X, Z, friction, speed).site("cart.hook")
    if chance(rng, 0.5):
        room.site("cart.wall", (-2.0, 0.0, 0.0))
        room.spring("cart.spring", "cart.wall", "cart.hook", stiffness=number(rng, 10.0, 80.0))
    return made, speed


def spring(room: Frame, rng: Rng, one: str, other: str) -> None:
    damping = choice(rng, 0.0, 0.0, number(rng, 0.05, 2.0))
    length = None if chance(rng, 0.3) else number(rng, 0.3, 0.9)
    room.spring(f"{one}-{other}", one, other, stiffness=number(rng, 5.0, 200.0), length=length, damping=damping)
