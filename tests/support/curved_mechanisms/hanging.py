"""Random mechanisms with hanging bodies: rigid bodies on hinges, bobs on rods and strings, deflected strings."""

import numpy as np

from curved_mechanisms.pieces import about_y, cart, chance, choice, mass, number, particle, polar
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism, X, Y, Z
from sim2reason.scenes.dsl.vectors import add


def hinged(seed: int) -> Mechanism:
    """Build a chain of rigid bodies on hinges, from a support or a cart, with or without a bob on a string below."""
    rng = np.random.default_rng(seed)
    builder = Builder()
    (frame, _), at = cart(builder.room(), rng), ZERO
    for i in range(int(rng.integers(1, 4))):
        angle, long = number(rng, -2.0, 2.0), number(rng, 0.3, 1.0)
        center = polar(long * number(rng, 0.3, 1.0), angle)
        inertia = about_y(choice(rng, 0.0, number(rng, 0.01, 0.1)))
        frame = frame.body(f"link{i}", mass(rng), at=at, center=center, inertia=inertia)
        frame.hinge(Y, choice(rng, 0.0, number(rng, -3.0, 3.0)))
        at = polar(long, angle)
    frame.site("end", at)
    if chance(rng, 0.3):
        long, angle = number(rng, 0.3, 0.8), number(rng, -0.6, 0.6)
        place = add(builder.position("end"), polar(long, angle))
        builder.room().body("bob", mass(rng), at=place).slide(X, name="x").slide(Z, name="z").site("bob.hook")
        builder.room().string("string", "end", "bob.hook", slack=choice(rng, 0.0, 0.0, 0.1))
    return builder.finish()


def bobs(seed: int) -> Mechanism:
    """Build a chain of particles on rods and strings, some released with slack strings."""
    rng = np.random.default_rng(seed)
    builder = Builder()
    support, speed = cart(builder.room(), rng)
    support.site("top")
    last, at = "top", ZERO
    for i in range(int(rng.integers(1, 4))):
        long, wide = number(rng, 0.3, 1.0), choice(rng, 1.0, 1.0, 2.5)
        at = add(at, polar(long, number(rng, -wide, wide)))
        particle(builder.room(), f"bob{i}", rng, at, velocity=(speed, 0.0))
        if chance(rng, 0.5):
            builder.room().rod(f"rod{i}", last, f"bob{i}.hook")
        else:
            builder.room().string(f"string{i}", last, f"bob{i}.hook", slack=choice(rng, 0.0, 0.0, 0.05))
        last = f"bob{i}.hook"
    return builder.finish()


def bent(seed: int) -> Mechanism:
    """Build deflected strings: bobs that swing over pulleys, blocks on inclined guides, winches, hands."""
    rng = np.random.default_rng(seed)
    builder = Builder()
    room = builder.room()
    rim = room.pulley("pulley", at=(-0.05, 0.0, 0.0), mass=choice(rng, 0.0, number(rng, 0.1, 1.0)))
    if chance(rng, 0.5):
        particle(room, "one", rng, polar(number(rng, 0.5, 1.5), number(rng, -0.2, 1.2)))
    else:
        block = room.body("one", mass(rng), at=(number(rng, 0.5, 1.2), 0.0, -number(rng, 0.4, 1.0)))
        block.rest(X, Z, choice(rng, 0.0, number(rng, 0.05, 0.4))).site("one.hook")
    kind = rng.random()
    if kind < 0.5:
        room.body("weight", mass(rng), at=(-0.1, 0.0, -1.5)).slide(Z).site("weight.hook")
        room.string("string", "weight.hook", rim, "one.hook", slack=choice(rng, 0.0, 0.0, 0.05))
    elif kind < 0.75:
        room.site("hand", (-0.1, 0.0, -3.0))
        room.pull("string", "one.hook", rim, "hand", force=number(rng, 1.0, 20.0))
    else:
        particle(room, "two", rng, add((-0.1, 0.0, 0.0), polar(number(rng, 0.5, 1.5), number(rng, -1.2, 0.2))))
        room.string("string", "two.hook", rim, "one.hook")
    return builder.finish()
