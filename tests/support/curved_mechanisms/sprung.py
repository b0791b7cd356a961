"""Random mechanisms with springs: nets of particles, and blocks in a row."""

from collections.abc import Callable

import numpy as np

from curved_mechanisms.pieces import Rng, chance, choice, mass, number, particle, slope, spring
from sim2reason.scenes.dsl.builder import Builder, Frame
from sim2reason.scenes.dsl.mechanism import Mechanism


def nets(seed: int) -> Mechanism:
    """Build particles joined to each other and to nails by damped springs at angles, and perhaps a string or rod."""
    rng = np.random.default_rng(seed)
    builder = Builder((0.0, 0.0, -choice(rng, 0.0, 9.8)))
    room = builder.room()
    count = int(rng.integers(1, 5))
    velocity = (0.0, 0.0)
    for i in range(count):
        rigid = i > 0 and chance(rng, 0.2)
        drawn = (number(rng, -1.0, 1.0), number(rng, -1.0, 1.0))
        velocity = velocity if rigid else drawn  # the ends of a rod begin as one
        particle(room, f"p{i}", rng, (0.7 * i, 0.0, number(rng, -0.3, 0.3)), velocity=velocity)
        for j in range(int(rng.integers(1, 3))):
            across, rise = number(rng, -0.8, 0.8), choice(rng, -1.0, 1.0) * number(rng, 0.6, 1.2)
            room.site(f"nail{i}{j}", (0.7 * i + across, 0.0, rise))
            spring(room, rng, f"nail{i}{j}", f"p{i}.hook")
        if i:
            (room.rod if rigid else room.string if chance(rng, 0.2) else _plain(room, rng))(
                f"link{i}", f"p{i - 1}.hook", f"p{i}.hook"
            )
    return builder.finish()


def _plain(room: Frame, rng: Rng) -> Callable[[str, str, str], None]:
    def join(_: str, one: str, other: str) -> None:
        spring(room, rng, one, other)

    return join


def chains(seed: int) -> Mechanism:
    """Build blocks in a row, level or inclined, rough or smooth, with springs, walls, strings and collisions."""
    rng = np.random.default_rng(seed)
    builder = Builder()
    room = builder.room()
    uphill, out = slope(choice(rng, 0.0, 0.0, number(rng, 0.1, 0.6)))
    last: Frame | None = None
    room.site("wall", tuple(-1.0 * part for part in uphill))
    hook = "wall"
    for i in range(int(rng.integers(1, 5))):
        friction = choice(rng, 0.0, 0.0, number(rng, 0.05, 0.5))
        block = room.body(f"block{i}", mass(rng), at=tuple(i * part for part in uphill))
        block.rest(uphill, out, friction, choice(rng, 0.0, number(rng, -2.0, 2.0))).site(f"hook{i}")
        if chance(rng, 0.7):
            stretched, damping = choice(rng, 0.0, number(rng, -0.2, 0.2)), choice(rng, 0.0, 0.0, number(rng, 0.1, 2.0))
            stiffness = number(rng, 20.0, 150.0)
            room.spring(f"spring{i}", hook, f"hook{i}", stiffness=stiffness, length=1.0 + stretched, damping=damping)
        elif chance(rng, 0.3):
            room.string(f"string{i}", hook, f"hook{i}", slack=choice(rng, 0.0, 0.1))
        if last is not None and chance(rng, 0.4):
            room.collide(last, block, number(rng, 0.2, 0.6), choice(rng, 1.0, number(rng, 0.3, 0.95)))
        last, hook = block, f"hook{i}"
    return builder.finish()
