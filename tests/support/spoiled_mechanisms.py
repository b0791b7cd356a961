"""Faulty mechanisms: extreme numbers, parts removed, doubled or exchanged, and singularities.

Each is a function of a seed; its names still refer to existing parts.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from curved_mechanisms import FAMILIES
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.fields import Central
from sim2reason.scenes.dsl.mechanism import ZERO, Elastic, Inextensible, Mechanism, X, Z

Rng = np.random.Generator
Spoil = Callable[[Mechanism, Rng], Mechanism]
MASSES = (1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9)
SPEEDS = (-1e6, -1e3, 1e-9, 30.0, 1e3, 1e6, 1e9)


def _one_of(items: tuple[Any, ...], rng: Rng) -> int:
    return int(rng.integers(len(items)))


def _with(items: tuple[Any, ...], number: int, **changes: object) -> tuple[Any, ...]:
    return tuple(replace(item, **changes) if i == number else item for i, item in enumerate(items))


def massive(mechanism: Mechanism, rng: Rng) -> Mechanism:
    """Return the mechanism with an extreme mass of one body."""
    number = _one_of(mechanism.bodies, rng)
    mass = float(rng.choice(MASSES))
    ratio = mass / (mechanism.bodies[number].mass or 1.0)
    inertia = tuple(ratio * part for part in mechanism.bodies[number].inertia)
    return replace(mechanism, bodies=_with(mechanism.bodies, number, mass=mass, inertia=inertia))


def fast(mechanism: Mechanism, rng: Rng) -> Mechanism:
    """Return the mechanism with an extreme initial speed of one coordinate."""
    number = _one_of(mechanism.bodies, rng)
    body = mechanism.bodies[number]
    if not body.coordinates:
        return mechanism
    coordinates = _with(body.coordinates, _one_of(body.coordinates, rng), speed=float(rng.choice(SPEEDS)))
    return replace(mechanism, bodies=_with(mechanism.bodies, number, coordinates=coordinates))


def stiff(mechanism: Mechanism, rng: Rng) -> Mechanism:
    """Return the mechanism with very stiff springs on very light bodies."""
    lines = tuple(
        replace(line, law=replace(line.law, stiffness=1e6, damping=float(rng.choice((0.0, 1.0, 1e4)))))
        if isinstance(line.law, Elastic)
        else line
        for line in mechanism.lines
    )
    return massive(replace(mechanism, lines=lines), rng)


def doubled(mechanism: Mechanism, rng: Rng) -> Mechanism:
    """Return the mechanism with one line doubled, perhaps with another law."""
    if not mechanism.lines:
        return massive(mechanism, rng)
    line = mechanism.lines[_one_of(mechanism.lines, rng)]
    law = mechanism.lines[_one_of(mechanism.lines, rng)].law
    twin = replace(line, name=f"{line.name} again", whole=f"{line.name} again", law=law)
    return replace(mechanism, lines=(*mechanism.lines, twin))


def lost(mechanism: Mechanism, rng: Rng) -> Mechanism:
    """Return the mechanism without one of its lines, faces, forces or collisions."""
    kinds = [kind for kind in ("lines", "faces", "forces", "meetings", "attractions") if getattr(mechanism, kind)]
    if not kinds:
        return fast(mechanism, rng)
    kind = str(rng.choice(kinds))
    items = getattr(mechanism, kind)
    gone = _one_of(items, rng)
    return replace(mechanism, **{kind: tuple(item for i, item in enumerate(items) if i != gone)})


def swapped(mechanism: Mechanism, rng: Rng) -> Mechanism:
    """Return the mechanism with the masses of two bodies and the laws of two lines exchanged."""
    one, other = _one_of(mechanism.bodies, rng), _one_of(mechanism.bodies, rng)
    masses = mechanism.bodies[one].mass, mechanism.bodies[other].mass
    bodies = _with(_with(mechanism.bodies, one, mass=masses[1]), other, mass=masses[0])
    if len(mechanism.lines) < 2:
        return replace(mechanism, bodies=bodies)
    one, other = _one_of(mechanism.lines, rng), _one_of(mechanism.lines, rng)
    laws = mechanism.lines[one].law, mechanism.lines[other].law
    lines = _with(_with(mechanism.lines, one, law=laws[1]), other, law=laws[0])
    return replace(mechanism, bodies=bodies, lines=lines)


def moved(mechanism: Mechanism, rng: Rng) -> Mechanism:
    """Return the mechanism with a site moved to another one or far away."""
    if not mechanism.sites:
        return fast(mechanism, rng)
    number = _one_of(mechanism.sites, rng)
    at = mechanism.sites[_one_of(mechanism.sites, rng)].at if rng.random() < 0.5 else (1e6, 0.0, -1e6)
    return replace(mechanism, sites=_with(mechanism.sites, number, at=at))


def heavy(mechanism: Mechanism, rng: Rng) -> Mechanism:
    """Return the mechanism with gravity upwards, sideways, or that of a white dwarf."""
    gravities = ((0.0, 0.0, 9.8), (9.8, 0.0, 0.0), (0.0, 0.0, -1e6), (0.0, 9.8, 0.0), ZERO)
    return replace(mechanism, gravity=gravities[int(rng.integers(len(gravities)))])


def slippery(mechanism: Mechanism, rng: Rng) -> Mechanism:
    """Return the mechanism with extreme coefficients of friction and restitution."""
    faces = tuple(replace(face, friction=float(rng.choice((0.0, 1e-9, 5.0, 1e6)))) for face in mechanism.faces)
    meetings = tuple(
        replace(meeting, restitution=float(rng.choice((0.0, 1e-9, 0.999999, 1.0)))) for meeting in mechanism.meetings
    )
    return massive(replace(mechanism, faces=faces, meetings=meetings), rng)


def reeled(mechanism: Mechanism, rng: Rng) -> Mechanism:
    """Return the mechanism with all strings wound in, at any speed up to that of sound, or slightly slack."""
    law = Inextensible(float(rng.choice((0.0, 1e-9, 1e3))), float(rng.choice((0.0, 1e-6, 0.5, 300.0))))
    lines = tuple(replace(line, law=law) if isinstance(line.law, Inextensible) else line for line in mechanism.lines)
    return replace(mechanism, lines=lines)


SPOILS: tuple[Spoil, ...] = (massive, fast, stiff, doubled, lost, swapped, moved, heavy, slippery, reeled)


def spoiled(seed: int) -> Mechanism:
    """Return a mechanism of any curved family with one to three faults."""
    rng = np.random.default_rng([seed, 99])
    mechanism = FAMILIES[str(rng.choice(list(FAMILIES)))](int(rng.integers(1000)))
    for _ in range(int(rng.integers(1, 4))):
        mechanism = SPOILS[_one_of(SPOILS, rng)](mechanism, rng)
    return mechanism


def collapse(seed: int) -> Mechanism:
    """Return a mechanism that leads to a singularity or to endless events."""
    rng = np.random.default_rng([seed, 98])
    return COLLAPSES[seed % len(COLLAPSES)](rng)


def _fall(rng: Rng) -> Mechanism:
    """Build a body that falls into a centre of attraction, or passes very close to it."""
    builder = Builder(ZERO)
    room = builder.room()
    stone = room.body("stone", float(rng.choice((1e-6, 1.0))), at=(1.0, 0.0, 0.0))
    stone.slide(X, name="x").slide(Z, float(rng.choice((0.0, 1e-12, 1e-6, 1e-3))), name="z")
    if rng.random() < 0.5:
        stone.force("C", Central(ZERO, -float(rng.choice((1.0, 1e6))), int(rng.integers(1, 4))))
    else:
        stone.attract(room.body("star", 1.0), float(rng.choice((1.0, 1e6))))
    return builder.finish()


def _chatter(rng: Rng) -> Mechanism:
    """Build a ball between two approaching bodies, or between a floor and an approaching body."""
    builder = Builder((0.0, 0.0, -float(rng.choice((0.0, 9.8)))))
    room = builder.room()
    low, high = (
        room.body(name, float(rng.choice((1e-3, 1.0, 1e3))), at=(0.0, 0.0, z)) for name, z in (("b", 0.5), ("c", 1.0))
    )
    low.slide(Z, float(rng.choice((0.0, 10.0, 1e3))))
    high.slide(Z, float(rng.choice((0.0, -1.0))))
    restitution = float(rng.choice((0.0, 0.5, 0.999999, 1.0)))
    room.bump(room, low, Z, 0.1, restitution)
    room.collide(low, high, 0.1, restitution)
    return builder.finish()


def _grazing(rng: Rng) -> Mechanism:
    """Build discs that just touch in passing, or miss by less than rounding errors."""
    builder = Builder(ZERO)
    room = builder.room()
    miss = float(rng.choice((-1e-9, 0.0, 1e-15, 1e-9)))
    one = room.body("one", 1.0).slide(X, name="x").slide(Z, name="z")
    for number in range(3):
        other = room.body(f"d{number}", 1.0, at=(-1.0 - number, 0.0, 0.2 + miss))
        other.slide(X, float(rng.choice((1e-3, 1.0, 1e3))), name="x").slide(Z, name="z")
        room.collide(one, other, 0.2, 1.0)
    return builder.finish()


def _singing(rng: Rng) -> Mechanism:
    """Build light bodies on the stiffest springs, one after the other, from 1e6 N/m on 1e-6 kg."""
    builder = Builder()
    room = builder.room()
    room.site("wall", (-1.0, 0.0, 0.0))
    last = "wall"
    for number in range(int(rng.integers(1, 5))):
        block = room.body(f"b{number}", float(rng.choice((1e-6, 1.0, 1e9))), at=(float(number), 0.0, 0.0))
        block.rest(X, Z, float(rng.choice((0.0, 0.3))), float(rng.choice((0.0, 1.0)))).site(f"hook{number}")
        damping = float(rng.choice((0.0, 0.0, 1.0, 1e3)))
        room.spring(f"s{number}", last, f"hook{number}", stiffness=1e6, length=1.001, damping=damping)
        last = f"hook{number}"
    return builder.finish()


def _crowded(rng: Rng) -> Mechanism:
    """Build long chains of pendulums and of springs, with very many moving bodies."""
    builder = Builder()
    room = builder.room()
    room.site("top")
    last, count = "top", int(rng.integers(6, 13))
    for number in range(count):
        body = room.body(f"p{number}", 0.1, at=(0.3 * (number + 1), 0.0, 0.0)).slide(X, name="x").slide(Z, name="z")
        body.site(f"h{number}")
        kind = rng.random()
        if kind < 0.4:
            room.rod(f"l{number}", last, f"h{number}")
        elif kind < 0.7:
            room.string(f"l{number}", last, f"h{number}")
        else:
            room.spring(f"l{number}", last, f"h{number}", stiffness=float(rng.choice((10.0, 1e4))))
        last = f"h{number}"
    return builder.finish()


COLLAPSES: tuple[Callable[[Rng], Mechanism], ...] = (_fall, _chatter, _grazing, _singing, _crowded)
