"""Random mechanisms with bodies on bodies, and lines between any of their points."""

from math import pi

import numpy as np

from curved_mechanisms.pieces import Rng, about_y, chance, choice, mass, number, polar, slope, spring
from sim2reason.scenes.dsl.builder import Builder, Frame
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Y, Z
from sim2reason.scenes.dsl.vectors import Vector


def tangle(seed: int) -> Mechanism:
    """Build bodies on bodies that slide, turn, rest, roll and swing, and lines of all laws between their points."""
    rng = np.random.default_rng(seed)
    builder = Builder()
    room = builder.room()
    frames: list[Frame] = [room]
    sites, joined = list[str](), list[set[str]]()
    for i in range(int(rng.integers(1, 5))):
        parent = frames[int(rng.integers(0, len(frames)))]
        frames.append(_limb(parent, rng, f"b{i}", (2.0 * i, 0.0, 0.0) if parent is room else _near(rng)))
        frames[-1].site(f"b{i}.hook", _near(rng))
        sites.append(f"b{i}.hook")
    for i in range(int(rng.integers(1, 4))):
        room.site(f"nail{i}", (number(rng, -1.0, 6.0), 0.0, number(rng, 0.5, 2.0)))
        sites.append(f"nail{i}")
    for i in range(int(rng.integers(0, 4))):
        one, other = (str(site) for site in rng.choice(sites, 2, replace=False))
        if builder.carrier(one) == builder.carrier(other) or {one, other} in joined:
            continue
        joined.append({one, other})
        kind = rng.random()
        if kind < 0.45:
            spring(room, rng, one, other)
        elif kind < 0.75:
            room.string(f"string{i}", one, other, slack=choice(rng, 0.0, 0.1))
        elif kind < 0.9:
            room.rod(f"rod{i}", one, other)
        else:
            room.prop(f"prop{i}", one, other)
    return builder.finish()


def _near(rng: Rng) -> Vector:
    return (number(rng, -0.5, 0.5), 0.0, number(rng, -0.5, 0.5))


def _limb(parent: Frame, rng: Rng, name: str, at: Vector) -> Frame:
    inertia = about_y(number(rng, 0.01, 0.2))
    kind = int(rng.integers(0, 6))
    friction = choice(rng, 0.0, 0.0, number(rng, 0.05, 0.5))
    speed = choice(rng, 0.0, number(rng, -1.0, 1.0))
    if kind == 0:
        return parent.body(name, mass(rng), at=at, center=_near(rng), inertia=inertia).hinge(Y, 2.0 * speed)
    if kind == 1:
        return parent.body(name, mass(rng), at=at).slide(polar(1.0, number(rng, 0.0, pi)), speed)
    if kind == 2:
        uphill, out = slope(number(rng, -0.5, 0.5))
        return parent.body(name, mass(rng), at=at).rest(uphill, out, friction, speed)
    if kind == 3:
        radius = number(rng, 0.1, 0.4)
        uphill, out = slope(number(rng, -0.3, 0.3))
        center = (0.3 * radius * number(rng, -1.0, 1.0), 0.0, 0.3 * radius * number(rng, -1.0, 1.0))
        body = parent.body(name, mass(rng), at=at, center=center, inertia=inertia)
        return body.roll(uphill, out, radius, max(friction, 0.1), speed)
    if kind == 4:
        radius, angle = number(rng, 0.3, 0.8), number(rng, -1.0, 1.0)
        place = polar(radius, angle)
        body = parent.body(name, mass(rng), at=at, center=place)
        out = tuple(-part / radius for part in place)
        return body.swing(Y, out, radius, friction=friction, speed=speed, guided=chance(rng, 0.5))
    body = parent.body(name, mass(rng), at=at, inertia=inertia).slide(X, speed, name="x").slide(Z, name="z")
    return body.hinge(Y) if chance(rng, 0.5) else body
