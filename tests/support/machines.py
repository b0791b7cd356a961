"""Mechanisms shared by tests of the simulation, made with the builder alone."""

from collections.abc import Callable
from math import cos, radians, sin

import numpy as np

from sim2reason.scenes.dsl.builder import Builder, Frame, Rim
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Y, Z
from sim2reason.scenes.dsl.vectors import Vector, scale


def face(angle: float, side: float = 1.0) -> tuple[Vector, Vector]:
    """Return the unit vectors up the slope and normal to it; `side` −1 mirrors them."""
    slope = radians(angle)
    return (side * cos(slope), 0.0, sin(slope)), (-side * sin(slope), 0.0, cos(slope))


def atwood(
    left: float = 2.0, right: float = 3.0, pulley: float = 0.0, slack: float = 0.0, speed: float = 0.0
) -> Mechanism:
    builder = Builder()
    room = builder.room()
    wheel = room.pulley("wheel", (0.0, 0.0, 2.0), mass=pulley, radius=0.1)
    room.body("left", left, at=(-0.1, 0.0, 0.0)).slide(Z, speed=speed).site("left.hook")
    room.body("right", right, at=(0.1, 0.0, 0.0)).slide(Z).site("right.hook")
    room.string("rope", "left.hook", wheel, "right.hook", slack=slack)
    return builder.finish()


def movable(load: float = 3.0, weight: float = 1.0, pulley: float = 0.0) -> Mechanism:
    builder = Builder()
    room = builder.room()
    block = room.body("pulley", pulley, at=(0.1, 0.0, -2.0)).slide(Z).site("axle")
    rim = block.pulley("rim", radius=0.1)
    room.site("nail")
    top = room.pulley("top", (0.3, 0.0, 0.0), radius=0.1)
    room.body("load", load, at=(0.1, 0.0, -3.0)).slide(Z).site("load.hook")
    room.body("weight", weight, at=(0.4, 0.0, -2.0)).slide(Z).site("weight.hook")
    room.string("rope", "nail", rim, top, "weight.hook")
    room.string("hanger", "axle", "load.hook")
    return builder.finish()


def nested(lone: float = 4.0, left: float = 1.0, right: float = 2.0, pulley: float = 0.0) -> Mechanism:
    builder = Builder()
    room = builder.room()
    top = room.pulley("top", radius=0.5)
    inner = room.body("inner", pulley, at=(-0.5, 0.0, -2.0)).slide(Z).site("axle")
    rim = inner.pulley("rim", radius=0.1)
    for name, mass, x, z in (("lone", lone, 0.5, -2.0), ("left", left, -0.6, -4.0), ("right", right, -0.4, -4.0)):
        room.body(name, mass, at=(x, 0.0, z)).slide(Z).site(f"{name}.hook")
    room.string("upper", "axle", top, "lone.hook")
    room.string("lower", "left.hook", rim, "right.hook")
    return builder.finish()


def incline(mass: float = 2.0, angle: float = 30.0, friction: float = 0.3, speed: float = 0.0) -> Mechanism:
    builder = Builder()
    builder.room().body("block", mass).rest(*face(angle), friction, speed=speed)
    return builder.finish()


def tied_incline(mass: float = 2.0, weight: float = 1.2, angle: float = 30.0, friction: float = 0.3) -> Mechanism:
    builder = Builder()
    room = builder.room()
    uphill, out = face(angle)
    room.body("block", mass, at=scale(-3.0, uphill)).rest(uphill, out, friction).site("hook")
    room.site("edge")
    room.body("weight", weight, at=(0.0, 0.0, -1.5)).slide(Z).site("weight.hook")
    room.string("rope", "hook", "edge", "weight.hook")
    return builder.finish()


def wedge(
    mass: float = 5.0,
    block: float = 2.0,
    angle: float = 35.0,
    friction: float = 0.0,
    floor: float = 0.0,
    weight: float = 0.0,
) -> Mechanism:
    """Build a wedge on the floor with a block on its face and, with `weight`, another one hanging at its side."""
    builder = Builder()
    carrier = builder.room().body("wedge", mass).rest(X, Z, floor)
    uphill, out = face(angle)
    carrier.body("block", block, at=scale(-2.0, uphill)).rest(uphill, out, friction).site("hook")
    if weight:
        carrier.site("top")
        carrier.body("weight", weight, at=(0.0, 0.0, -1.0)).slide(Z).site("weight.hook")
        carrier.string("rope", "hook", "top", "weight.hook")
    return builder.finish()


def prism(
    left: float = 2.0,
    right: float = 1.5,
    mass: float = 4.0,
    angles: tuple[float, float] = (30.0, 50.0),
    friction: tuple[float, float, float] = (0.0, 0.0, 0.0),
    slack: float = 0.0,
) -> Mechanism:
    """Build two blocks on the faces of a prism that may slide, with friction of left block, right block and floor."""
    builder = Builder()
    carrier = builder.room().body("prism", mass).rest(X, Z, friction[2])
    carrier.site("top")
    for name, load, angle, side, mu in (
        ("left", left, angles[0], 1.0, friction[0]),
        ("right", right, angles[1], -1.0, friction[1]),
    ):
        uphill, out = face(angle, side)
        carrier.body(name, load, at=scale(-2.0, uphill)).rest(uphill, out, mu).site(f"{name}.hook")
    carrier.string("rope", "left.hook", "top", "right.hook", slack=slack)
    return builder.finish()


def stack(
    upper: float = 1.0,
    lower: float = 3.0,
    friction: float = 0.4,
    floor: float = 0.1,
    force: float = 20.0,
    speed: float = 0.0,
) -> Mechanism:
    builder = Builder()
    room = builder.room()
    carrier = room.body("lower", lower).rest(X, Z, floor).site("ring")
    carrier.body("upper", upper, at=(0.0, 0.0, 0.5)).rest(X, Z, friction, speed=speed)
    room.site("hand", (30.0, 0.0, 0.0))
    room.pull("pull", "ring", "hand", force=force)
    return builder.finish()


def discs(
    restitution: float = 0.5, speed: float = 2.0, offset: float = 0.05, first: float = 1.0, second: float = 2.0
) -> Mechanism:
    """Build two discs on a smooth table, the first thrown at the second."""
    builder = Builder()
    room = builder.room()
    a = room.body("first", first).rest(X, Z, speed=speed).slide(Y, name="across")
    b = room.body("second", second, at=(1.0, offset, 0.0)).rest(X, Z).slide(Y, name="across")
    room.collide(a, b, 0.2, restitution)
    return builder.finish()


def carts(
    restitution: float = 0.5, friction: float = 0.1, weight: float = 0.3, masses: tuple[float, float] = (2.0, 1.0)
) -> Mechanism:
    """Build two carts that collide; with `weight`, a string over the table's edge ties the second to a weight."""
    builder = Builder()
    room = builder.room()
    runner = room.body("runner", masses[0], at=(-1.0, 0.0, 0.0)).rest(X, Z, friction, speed=4.0)
    target = room.body("target", masses[1]).rest(X, Z, friction).site("hook")
    room.collide(runner, target, 0.2, restitution)
    if weight:
        room.site("edge", (3.0, 0.0, 0.0))
        room.body("weight", weight, at=(3.0, 0.0, -1.0)).slide(Z).site("weight.hook")
        room.string("rope", "hook", "edge", "weight.hook")
    return builder.finish()


def train(rng: np.random.Generator) -> Mechanism:
    """Build a row of random carts, some tied or bouncing, some with a block or a slope on them, drawn by pulleys."""
    builder = Builder()
    room = builder.room()
    previous: Frame | None = None
    count = int(rng.integers(1, 4))
    for number in range(count):
        speed = float(rng.choice([0.0, round(rng.uniform(-2.0, 2.0), 2)]))
        cart = room.body(f"cart{number}", _mass(rng), at=(2.0 * number, 0.0, 0.0))
        cart.rest(X, Z, _friction(rng), speed=speed).site(f"back{number}")
        cart.site(f"front{number}")
        _cargo(cart, number, rng)
        if previous is not None:
            if rng.random() < 0.6:
                room.string(
                    f"link{number}", f"front{number - 1}", f"back{number}", slack=round(rng.uniform(0.05, 0.5), 2)
                )
            if rng.random() < 0.7:
                room.collide(previous, cart, round(rng.uniform(0.5, 1.9), 2), _restitution(rng))
        previous = cart
    _drawn(room, count, rng)
    return builder.finish()


def _mass(rng: np.random.Generator) -> float:
    return round(float(rng.uniform(0.3, 8.0)), 2)


def _friction(rng: np.random.Generator) -> float:
    return float(rng.choice([0.0, round(rng.uniform(0.02, 0.6), 2)]))


def _restitution(rng: np.random.Generator) -> float:
    return float(rng.choice([0.0, 1.0, round(rng.uniform(0.2, 0.95), 2)]))


def _cargo(cart: Frame, number: int, rng: np.random.Generator) -> None:
    kind = rng.random()
    if kind < 0.25:
        cart.body(f"cargo{number}", _mass(rng), at=(0.0, 0.0, 0.4)).rest(
            X, Z, _friction(rng), speed=round(rng.uniform(-1, 1), 2)
        )
    elif kind < 0.5:
        uphill, out = face(float(rng.integers(10, 60)))
        at = (-uphill[0], 0.0, 1.0 - uphill[2])
        cart.body(f"cargo{number}", _mass(rng), at=at).rest(uphill, out, _friction(rng)).site(f"cargo{number}.hook")
        if rng.random() < 0.6:
            cart.site(f"peak{number}", (0.0, 0.0, 1.0))
            below = (0.0, 0.0, 0.2)
            cart.body(f"hanging{number}", _mass(rng), at=below).slide(Z).site(f"hanging{number}.hook")
            hooks = (f"cargo{number}.hook", f"peak{number}", f"hanging{number}.hook")
            cart.string(f"line{number}", *hooks, slack=float(rng.choice([0.0, 0.1])))


def _drawn(room: Frame, count: int, rng: np.random.Generator) -> None:
    """Add the random drive of the last cart: nothing, a hand, a weight over a pulley, or two over a movable one."""
    kind, last = rng.random(), f"front{count - 1}"
    edge = 2.0 * count + 1.0
    if kind < 0.2:
        return
    if kind < 0.4:
        room.site("hand", (edge + 20.0, 0.0, 0.0))
        room.pull("hand pulls", last, "hand", force=round(float(rng.uniform(1.0, 40.0)), 1))
        return
    wheel = _corner(room, edge, rng)
    depth = float(rng.uniform(1.0, 4.0))
    slack = float(rng.choice([0.0, 0.2]))
    at = (edge + 0.1, 0.0, -depth)
    if kind < 0.7:
        room.body("weight", _mass(rng), at=at).slide(Z).site("weight.hook")
        room.string("rope", last, wheel, "weight.hook", slack=slack)
        return
    light = 0.0 if slack == 0.0 else 0.2
    inner = room.body("inner", float(rng.choice([light, 0.5])), at=at).slide(Z).site("axle")
    rim = inner.pulley("rim", radius=0.05)
    for name, side in (("one", -0.05), ("two", 0.05)):
        here = (at[0] + side, 0.0, -depth - 2.0)
        room.body(name, _mass(rng), at=here).slide(Z).site(f"{name}.hook")
    room.string("rope", last, wheel, "axle", slack=slack)
    room.string("inner rope", "one.hook", rim, "two.hook")


def _corner(room: Frame, edge: float, rng: np.random.Generator) -> Rim:
    """Return the pulley at the edge of the table, whose left rim point is level with the table."""
    mass = float(rng.choice([0.0, round(rng.uniform(0.2, 3.0), 2)]))
    return room.pulley("corner", (edge, 0.0, 0.0), mass=mass, radius=0.1)


SAMPLES: dict[str, Callable[[], Mechanism]] = {
    "atwood": atwood,
    "atwood with a massive pulley": lambda: atwood(pulley=1.0),
    "atwood that starts slack": lambda: atwood(slack=0.3),
    "atwood thrown up": lambda: atwood(3.0, 2.0, speed=2.0),
    "movable pulley": movable,
    "nested atwood": nested,
    "rough incline": lambda: incline(speed=3.0),
    "tied incline": tied_incline,
    "wedge with string": lambda: wedge(friction=0.3, floor=0.1, weight=1.5),
    "prism": lambda: prism(friction=(0.1, 0.1, 0.0)),
    "stack": stack,
    "stack that comes to rest": lambda: stack(force=1.0, speed=2.0),
    "oblique discs": discs,
    "carts": carts,
    "carts that stick": lambda: carts(restitution=0.0),
}
