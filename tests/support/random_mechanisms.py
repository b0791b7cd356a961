"""Random mechanisms of four families for tests of both engines, each a function of a seed."""

import numpy as np

from sim2reason.scenes.dsl.builder import Builder, Frame, Rim
from sim2reason.scenes.dsl.mechanism import ZERO, X, Y, Z


def hang(builder: Builder, rng: np.random.Generator, x: float, z: float, depth: int) -> str:
    """Hang a load, or a pulley with two more of these, from a string, and return the site for its end."""
    name = f"b{len(builder.finish().bodies)}"
    z -= rng.uniform(15.0, 25.0)
    split = depth > 0 and rng.random() < 0.6
    mass = 0.0 if split and rng.random() < 0.5 else rng.uniform(0.2, 5.0)
    frame = builder.room().body(name, mass, at=(x, 0.0, z)).slide(Z).site(f"{name}.hook")
    if split:
        wheel = rng.choice([0.0, rng.uniform(0.1, 2.0)])
        over(builder, rng, frame.pulley(f"{name}.wheel", mass=wheel, radius=0.1 * depth), (x, z), depth - 1)
    builder.add_site(f"{name}.top", name, (x, 0.0, z))
    return f"{name}.top"


def over(builder: Builder, rng: np.random.Generator, pulley: Rim, at: tuple[float, float], depth: int) -> None:
    """Lay a string over a pulley, with a body or pulley at both ends."""
    left, right = (hang(builder, rng, at[0] + side * pulley.radius, at[1], depth) for side in (-1.0, 1.0))
    builder.room().string(f"s.{pulley.left}", left, pulley, right)


def pulleys(seed: int) -> Builder:
    """Build a tree of pulleys, light and heavy, three levels deep."""
    rng = np.random.default_rng(seed)
    builder = Builder()
    top = builder.room().pulley("top", mass=rng.choice([0.0, 1.0]), radius=0.3)
    over(builder, rng, top, (0.0, 0.0), 2)
    return builder


def wedges(seed: int) -> Builder:
    """Build a movable wedge with a block on its face, perhaps tied over the top to a load in a guide, and a ball."""
    rng = np.random.default_rng(seed)
    builder = Builder()
    room = builder.room()
    theta = rng.uniform(0.2, 1.2)
    uphill, outward = (np.cos(theta), 0.0, np.sin(theta)), (-np.sin(theta), 0.0, np.cos(theta))
    wedge = room.body("W", rng.uniform(0.5, 9.0)).rest(X, Z, speed=rng.uniform(-1.0, 1.0))
    block = wedge.body("A", rng.uniform(0.5, 4.0)).rest(uphill, outward)
    top = tuple(30.0 * part for part in uphill)
    beyond = (top[0] + 0.1, 0.0, top[2])
    wedge.site("left", at=top).site("right", at=beyond)
    block.site("eye")
    load = wedge.body("B", rng.uniform(0.5, 4.0), at=(beyond[0], 0.0, beyond[2] - 30.0)).slide(Z).site("hook")
    builder.add_site("load.hook", "B", (beyond[0], 0.0, beyond[2] - 30.0))
    if rng.random() < 0.7:
        room.string("s", "eye", "left", "right", "load.hook")
    ball = room.body("S", rng.uniform(0.2, 3.0), at=(rng.uniform(0.6, 2.0), 0.0, 0.0)).rest(X, Z, speed=-1.0)
    room.collide(wedge, ball, 0.5, 1.0)
    assert load.name == "B"
    return builder


def table(seed: int, restitution: float | None = None) -> Builder:
    """Build discs on an open table."""
    rng = np.random.default_rng(seed)
    builder = Builder(gravity=ZERO)
    room = builder.room()
    discs: list[Frame] = []
    for number in range(rng.integers(2, 6)):
        u = rng.uniform(-2.0, 2.0, 2)
        at = (0.8 * number, rng.uniform(-0.2, 0.2), 0.0)
        disc = room.body(f"d{number}", rng.uniform(0.2, 5.0), at=at).slide(X, u[0], name="x").slide(Y, u[1], name="y")
        for other in discs:
            room.collide(other, disc, 0.3, rng.uniform(0.3, 1.0) if restitution is None else restitution)
        discs.append(disc)
    return builder


def rough(seed: int) -> Builder:
    """Build a rough wedge with rough blocks on both faces, one carrying another, a string over the top, a striker."""
    rng = np.random.default_rng(seed)
    builder = Builder()
    room = builder.room()
    wedge = room.body("W", rng.uniform(0.5, 9.0)).rest(X, Z, rng.choice([0.0, 0.1, 0.5]), rng.choice([0.0, 1.0, -1.0]))
    for name, side in (("A", -1), ("B", 1)):
        angle = rng.uniform(0.1, 1.3)
        uphill, outward = (-side * np.cos(angle), 0.0, np.sin(angle)), (side * np.sin(angle), 0.0, np.cos(angle))
        at = (side * 0.1 - 30.0 * uphill[0], 0.0, -30.0 * uphill[2])
        mu, speed = rng.choice([0.0, 0.2, 0.7]), rng.choice([0.0, 0.0, 1.0, -1.0])
        block = wedge.body(name, rng.uniform(0.2, 4.0), at=at).rest(uphill, outward, mu, speed)
        builder.add_site(f"{name}.eye", name, at)
        if rng.random() < 0.4:
            block.body(f"{name}.upper", rng.uniform(0.2, 2.0)).rest(uphill, outward, rng.choice([0.0, 0.1, 0.6]))
    wedge.site("left", at=(-0.1, 0.0, 0.0)).site("right", at=(0.1, 0.0, 0.0))
    if rng.random() < 0.8:
        room.string("s", "A.eye", "left", "right", "B.eye", slack=rng.choice([0.0, 0.0, 0.1]))
    if rng.random() < 0.5:
        ball = room.body("S", rng.uniform(0.2, 3.0), at=(1.0, 0.0, 0.0)).rest(X, Z, speed=-1.5)
        room.collide(wedge, ball, 0.5, rng.uniform(0.2, 1.0))
    return builder
