"""Random mechanisms with bodies in free motion: balls, charges in fields, planets."""

from math import cos, pi, sin

import numpy as np

from curved_mechanisms.pieces import Rng, chance, choice, mass, number, particle, spring
from sim2reason.scenes.dsl.builder import Builder, Frame
from sim2reason.scenes.dsl.fields import Central, Magnetic, Profile, Push, Resistance
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism, X, Y, Z
from sim2reason.scenes.dsl.vectors import BoxRegion, DiscRegion, HalfSpace, Region


def balls(seed: int) -> Mechanism:
    """Build balls with drag that bounce on the ground and on each other, and blocks on springs that they strike."""
    rng = np.random.default_rng(seed)
    builder = Builder()
    room = builder.room()
    made: list[Frame] = []
    for i in range(int(rng.integers(1, 4))):
        ball = particle(room, f"ball{i}", rng, (1.0 * i, 0.0, number(rng, 0.5, 2.0)), 2.0)
        if chance(rng, 0.6):
            ball.force("drag", Resistance(number(rng, 0.0, 0.3), choice(rng, 0.0, number(rng, 0.0, 0.1))))
        room.bump(room, ball, Z, 0.1, choice(rng, 1.0, number(rng, 0.5, 0.95)))
        for other in made:
            room.collide(other, ball, 0.2, choice(rng, 1.0, number(rng, 0.4, 0.95)))
        made.append(ball)
    if chance(rng, 0.4):
        room.site("nail", (0.0, 0.0, 2.5))
        spring(room, rng, "nail", "ball0.hook")
    return builder.finish()


def fields(seed: int) -> Mechanism:
    """Build one or two charges in fields that depend on place and time, in regions or everywhere."""
    rng = np.random.default_rng(seed)
    builder = Builder(ZERO)
    room = builder.room()
    for i in range(int(rng.integers(1, 3))):
        body = room.body(f"charge{i}", mass(rng), at=(number(rng, -1.5, -0.5), 2.0 * i, 0.0))
        body.slide(X, number(rng, 0.5, 3.0), name="x").slide(Y, number(rng, -1.0, 1.0), name="y")
        body.force("B", Magnetic(Z, _profile(rng)), _region(rng))
        if chance(rng, 0.6):
            body.force("E", Push(X if chance(rng, 0.5) else Y, _profile(rng)), _region(rng))
        if chance(rng, 0.3):
            body.force("C", Central((1.5, number(rng, 0.5, 1.0), 0.0), number(rng, -2.0, 2.0)))
        if chance(rng, 0.2):
            body.force("D", Resistance(number(rng, 0.0, 0.5)))
    return builder.finish()


def _profile(rng: Rng) -> Profile:
    slope_, rate = choice(rng, 0.0, 0.0, number(rng, -1.0, 1.0)), choice(rng, 0.0, 0.0, number(rng, -1.0, 1.0))
    return Profile(number(rng, -5.0, 5.0), slope_, X, rate, choice(rng, 0.0, 0.0, number(rng, 1.0, 8.0)))


def _region(rng: Rng) -> Region | None:
    kind = rng.random()
    if kind < 0.4:
        return None
    if kind < 0.6:
        return HalfSpace(X, number(rng, -0.4, 0.5))
    if kind < 0.8:
        return BoxRegion(((X, number(rng, -0.4, 0.2), number(rng, 0.4, 1.5)),))
    return DiscRegion((number(rng, -0.1, 0.5), number(rng, -0.5, 0.5), 0.0), number(rng, 0.2, 1.0))


def planets(seed: int) -> Mechanism:
    """Build bodies that attract each other, around a fixed star or free, with or without a burning rocket."""
    rng = np.random.default_rng(seed)
    builder = Builder(ZERO)
    room = builder.room()
    strength = 4.0 * pi**2
    star = room.body("star", 1.0)
    others: list[Frame] = []
    for i in range(int(rng.integers(1, 4))):
        radius, angle = 1.0 + 0.8 * i + number(rng, -0.1, 0.1), number(rng, 0.0, 2.0 * pi)
        speed = number(rng, 0.7, 1.15) * 2.0 * pi / radius**0.5
        place = (radius * cos(angle), radius * sin(angle), 0.0)
        planet = room.body(f"planet{i}", number(rng, 0.0, 0.02) + 0.001, at=place)
        planet.slide(X, -speed * sin(angle), name="x").slide(Y, speed * cos(angle), name="y")
        planet.attract(star, strength)
        for other in others:
            planet.attract(other, strength)
        others.append(planet)
    if chance(rng, 0.3):
        rocket = room.body("rocket", 1e-3, at=(0.0, 0.6, 0.0)).slide(X, 8.0, name="x").slide(Y, name="y")
        rocket.attract(star, strength)
        rocket.burn(1e-3 * number(rng, 0.3, 0.9), number(rng, 1.0, 10.0), number(rng, 0.3, 0.9), X)
    return builder.finish()
