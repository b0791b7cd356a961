"""How many scenes a CPU-second the exact engine simulates.

    python benchmarks/engine.py [scenes per family] [--rounds N] [--against COMMIT]

Each scene is built, then simulated from its mechanism: motion over 2 s, events, and its state at two times,
as the sensitivity filter asks for. Times are of one process's CPU; building is not counted.
"""

import json
from collections.abc import Callable
from math import cos, pi, sin
from time import process_time

import numpy as np
from against import PHASE, fixed_loop, medians, parser, script_against

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Y, Z
from sim2reason.simulation.engines.exact import motion

Rng = np.random.Generator


def nested(rng: Rng, levels: int = 3, wheel: float = 0.0) -> Builder:
    """A nested Atwood machine: every pulley carries a load on one side and the next pulley on the other."""
    builder = Builder()
    room = builder.room()
    pulley, x, radius = room.pulley("top", radius=0.4, mass=wheel), 0.0, 0.4
    for level in range(levels):
        name, below = f"A{level}", f"P{level}"
        room.body(name, rng.uniform(0.5, 5.0), at=(x - radius, 0.0, -50.0)).slide(Z)
        builder.add_site(f"{name}.eye", name, (x - radius, 0.0, -50.0))
        x += radius
        last = level == levels - 1
        mass = rng.uniform(0.5, 5.0) if last else 0.0
        frame = room.body(below, mass, at=(x, 0.0, -10.0 * (level + 1))).slide(Z)
        builder.add_site(f"{below}.eye", below, (x, 0.0, -10.0 * (level + 1)))
        room.string(f"s{level}", f"{name}.eye", pulley, f"{below}.eye")
        radius /= 2.0
        pulley = frame.pulley("wheel" + below, radius=radius, mass=wheel)
    return builder


def ramp(rng: Rng) -> Builder:
    """Rough blocks on both faces of a movable wedge, joined over its top; one is thrown uphill."""
    builder = Builder()
    wedge = builder.room().body("W", rng.uniform(4.0, 9.0)).rest(X, Z)
    for name, side, speed in (("A", -1.0, rng.uniform(0.0, 2.0)), ("B", 1.0, 0.0)):
        angle = rng.uniform(0.3, 1.0)
        uphill, outward = (-side * cos(angle), 0.0, sin(angle)), (side * sin(angle), 0.0, cos(angle))
        at = (side * 0.1 - 30.0 * uphill[0], 0.0, -30.0 * uphill[2])
        wedge.body(name, rng.uniform(0.5, 3.0), at=at).rest(uphill, outward, rng.uniform(0.05, 0.6), speed)
        builder.add_site(f"{name}.eye", name, at)
    wedge.site("left", at=(-0.1, 0.0, 0.0)).site("right", at=(0.1, 0.0, 0.0))
    builder.room().string("s", "A.eye", "left", "right", "B.eye")
    return builder


def table(rng: Rng) -> Builder:
    """Five discs on an open table, one of them thrown at the rest."""
    builder = Builder(gravity=(0.0, 0.0, 0.0))
    room = builder.room()
    discs = [room.body("d0", 1.0).slide(X, 2.0, name="x").slide(Y, name="y")]
    for number in range(1, 5):
        angle, far = rng.uniform(-0.2, 0.2) * pi, 0.4 * number
        at = (far * cos(angle), far * sin(angle), 0.0)
        disc = room.body(f"d{number}", rng.uniform(0.5, 2.0), at=at).slide(X, name="x").slide(Y, name="y")
        for other in discs:
            room.collide(other, disc, 0.1, rng.uniform(0.3, 1.0))
        discs.append(disc)
    return builder


def measure(draw: Callable[[Rng], Builder], count: int) -> tuple[float, float, float]:
    """Milliseconds a scene, its mean number of bodies and of events."""
    rng = np.random.default_rng(7)
    mechanisms: list[Mechanism] = [draw(rng).finish() for _ in range(count)]
    times, events = np.array([0.3, 0.7]), 0
    start = process_time()
    for mechanism in mechanisms:
        found = motion(mechanism, 2.0)
        found.state(times)
        events += len(found.events)
    spent = process_time() - start
    return 1e3 * spent / count, np.mean([len(m.bodies) for m in mechanisms]).item(), events / count


FAMILIES: dict[str, Callable[[Rng], Builder]] = {
    "Atwood": lambda rng: nested(rng, 1),
    "nested, light pulleys": nested,
    "nested, heavy pulleys": lambda rng: nested(rng, 3, 0.5),
    "rough movable wedge": ramp,
    "discs on a table": table,
}


def main() -> None:
    options = parser(__doc__)
    options.add_argument("count", type=int, nargs="?", default=200, help="scenes of each family (default: 200)")
    given = options.parse_args()
    if given.against:
        script_against(__file__, given.against, given.rounds, str(given.count))
        return
    rounds = [{name: measure(draw, given.count) for name, draw in FAMILIES.items()} for _ in range(given.rounds)]
    if given.figures:
        print(json.dumps({name: 1e3 / found[0] for name, found in rounds[0].items()} | {PHASE: fixed_loop()}))
        return
    fastest = medians([{name: found[0] for name, found in each.items()} for each in rounds])
    for name, (_, bodies, events) in rounds[0].items():
        milliseconds = fastest[name]
        rate = 1e3 / milliseconds
        print(f"{name:24} {bodies:4.1f} bodies {events:4.1f} events {milliseconds:6.3f} ms {rate:7.0f} scenes/CPU-s")
    print(f"{PHASE} {fixed_loop():.1f}")


if __name__ == "__main__":
    main()
