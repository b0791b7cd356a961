"""Random mechanisms with bodies that roll on faces or slide along curved ones."""

from math import cos, inf, pi, sin

import numpy as np

from curved_mechanisms.pieces import about_y, chance, choice, mass, number, polar, slope, spring
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Y, Z
from sim2reason.scenes.dsl.vectors import add


def rollers(seed: int) -> Mechanism:
    """Build round bodies, eccentric or not, that slip and roll on inclines or movable wedges, with lines."""
    rng = np.random.default_rng(seed)
    builder = Builder()
    room = builder.room()
    uphill, out = slope(number(rng, 0.0, 0.6))
    carrier = room.body("wedge", number(rng, 1.0, 6.0)).rest(X, Z) if chance(rng, 0.3) else room
    body_mass, radius = mass(rng), number(rng, 0.1, 0.5)
    offset = radius * choice(rng, 0.0, number(rng, 0.05, 0.5))
    angle = number(rng, 0.0, 2.0 * pi)
    inertia = about_y(body_mass * radius**2 * number(rng, 0.3, 0.9))
    disc = carrier.body("disc", body_mass, center=(offset * cos(angle), 0.0, offset * sin(angle)), inertia=inertia)
    speed = choice(rng, 0.0, number(rng, -2.0, 2.0))
    spin = None if chance(rng, 0.4) else number(rng, -8.0, 8.0)
    friction = inf if chance(rng, 0.2) and spin is None else number(rng, 0.05, 0.9)
    disc.roll(uphill, out, radius, friction, speed, spin).site("axle")
    if chance(rng, 0.5):
        top = tuple(3.0 * part for part in uphill)
        carrier.site("top", top)
        if chance(rng, 0.5):
            carrier.spring("spring", "top", "axle", stiffness=number(rng, 5.0, 80.0))
        else:
            room.body("weight", mass(rng), at=add((top[0] + 0.05, 0.0, top[2]), polar(1.0, 0.0))).slide(Z).site("eye")
            if carrier is room:
                room.string("string", "axle", "top", "eye")
    return builder.finish()


def curves(seed: int) -> Mechanism:
    """Build small bodies on curved faces: bowls, domes, and fixed or rotating hoops, rough or smooth."""
    rng = np.random.default_rng(seed)
    builder = Builder()
    room = builder.room()
    carrier = room
    turning = chance(rng, 0.25)
    if turning:
        about = (0.2, 0.2, number(rng, 0.1, 0.4), 0.0, 0.0, 0.0)
        carrier = room.body("hoop", 1.0, inertia=about).hinge(Z, number(rng, -5.0, 5.0))
    elif chance(rng, 0.3):
        carrier = room.body("bowl", number(rng, 1.0, 5.0)).rest(X, Z)
    radius, inside = number(rng, 0.4, 1.2), chance(rng, 0.6) or turning
    angle = number(rng, -1.5, 1.5) if inside else pi + number(rng, -0.3, 0.3)
    at = polar(radius, angle)
    out = tuple((-1.0 if inside else 1.0) * part / radius for part in at)
    friction = 0.0 if turning else choice(rng, 0.0, number(rng, 0.05, 0.6))
    body = carrier.body("bead", mass(rng), center=at)
    speed = choice(rng, 0.0, number(rng, -6.0, 6.0)) if inside else number(rng, -0.5, 0.5)
    body.swing(Y, out, radius, friction=friction, speed=speed, guided=turning or chance(rng, 0.4))
    body.site("eye", at)
    if chance(rng, 0.3):
        room.site("nail", (0.0, 0.0, 0.2 + 1.5 * radius))
        spring(room, rng, "nail", "eye")
    return builder.finish()
