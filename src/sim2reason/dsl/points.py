"""Points of bodies: how they move, how far apart two are, and how that changes; for any kind of number.

These values, and the small ones of the exact engine, are not to be changed, but are not frozen either: a frozen one
takes five times as long to make, and they are made by the thousand.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from sim2reason.dsl.triples import Maths, Number, Triple, minus, product, times

Gradient = Mapping[int, Triple]  # by number of a coordinate, or of a face
NONE: Triple = (0.0, 0.0, 0.0)


@dataclass(slots=True)
class Point:
    """A point of a body; `gradient` by coordinate and `lift` by face hold what is not zero."""

    place: Triple  # m
    velocity: Triple  # m/s
    bias: Triple  # its acceleration at q̈ = 0, m/s²
    gradient: Gradient
    lift: Gradient


@dataclass(slots=True)
class Distance:
    """How far apart two points are; what does not move one relative to the other has no entry."""

    value: Number  # m
    rate: Number  # m/s
    bias: Number  # its second derivative at q̈ = 0, m/s²
    way: Triple  # unit vector from the first to the second
    moved: Gradient  # how the second moves relative to the first, by coordinate
    along: Mapping[int, Number]  # the part of that along `way`
    lift: Mapping[int, Number]  # the same for rises from faces


def distance(one: Point, other: Point, maths: Maths, steady: Triple | None = None) -> Distance:
    """From one point to another; ZeroDivisionError where they coincide and can part.

    `steady` is the unit vector from one to the other if that never turns: then it holds where they meet, too, and
    beyond, where their distance counts as negative.
    """
    apart = x, y, z = minus(other.place, one.place)
    value = maths.sqrt(x * x + y * y + z * z) if steady is None else product(steady, apart)
    moved, risen = relative(one.gradient, other.gradient), relative(one.lift, other.lift)
    if not moved and not risen:
        return Distance(value, 0.0, 0.0, NONE, {}, {}, {})
    way = x, y, z = times(1.0 / value, apart) if steady is None else steady
    along = {i: x * dx + y * dy + z * dz for i, (dx, dy, dz) in moved.items()}
    lift = {i: product(way, normal) for i, normal in risen.items()} if risen else {}
    if one.velocity is other.velocity and one.bias is other.bias:  # above all where nothing moves yet
        return Distance(value, 0.0, 0.0, way, moved, along, lift)
    parting = minus(other.velocity, one.velocity)
    rate = product(way, parting)
    bend = product(way, minus(other.bias, one.bias))
    bias = bend if steady is not None else bend + (product(parting, parting) - rate * rate) / value
    return Distance(value, rate, bias, way, moved, along, lift)


def relative(one: Gradient, other: Gradient) -> dict[int, Triple]:
    """How the second point moves relative to the first, where it does, in the order of coordinates."""
    if not one:
        return dict(other)
    if not other:
        return {i: (-way[0], -way[1], -way[2]) for i, way in one.items()}
    found: dict[int, Triple] = {}
    for i in sorted(one.keys() | other.keys()):
        mine, its = one.get(i), other.get(i)
        if mine is None:
            found[i] = other[i]
        elif its is None:
            found[i] = (-mine[0], -mine[1], -mine[2])
        elif mine != its:
            found[i] = minus(its, mine)
    return found
