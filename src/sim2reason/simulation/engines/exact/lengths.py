"""Lengths, gaps and rows: what constrains a motion, for any kind of number."""

from collections.abc import Mapping
from typing import NamedTuple

from sim2reason.dsl.frames import Gradient, Point
from sim2reason.dsl.mechanism import Inextensible, Line, Mechanism, Prop, Rigid
from sim2reason.dsl.triples import Maths, Number, Triple, minus, product, times


class Phase(NamedTuple):
    """What is switched on or off by events: forces in regions, burning engines, pairs that stick together."""

    inside: tuple[tuple[bool, ...], ...] = ()  # for each force, for each border of its region
    burning: tuple[bool, ...] = ()
    stuck: tuple[bool, ...] = ()  # of each meeting


class PathLength(NamedTuple):
    """A length, its rate, its second derivative at q̈ = 0, and its gradient."""

    value: Number
    rate: Number
    bias: Number
    along: dict[int, Number]
    lift: dict[int, Number]


ORIGIN = Point((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), {}, {})


class RowTerms(NamedTuple):
    """A constraint row: along·q̈ + Σ lift·rise ≤ target, or = where it acts both ways."""

    along: Mapping[int, Number]
    lift: Mapping[int, Number]
    value: Number  # what is left until it acts, m
    rate: Number  # of what it bounds: positive where that is used up
    target: Number


class Separation(NamedTuple):
    """How the two of a meeting stand apart: the gap, and the gradient, rate and bias of its growth."""

    gap: Number
    rate: Number
    bias: Number  # of the second derivative, at q̈ = 0
    along: Mapping[int, Number]
    lift: Mapping[int, Number]


def constraints(mechanism: Mechanism) -> list[Line]:
    """The lines that are rows of their own."""
    return [line for line in mechanism.lines if isinstance(line.law, Inextensible | Rigid | Prop)]


class RowKind(NamedTuple):
    """What a row is: ``string``, ``rod``, ``prop``, ``foot``, ``hold`` (of a foot) or ``stuck``, and whose."""

    kind: str
    name: str
    both: bool  # it acts both ways
    follows: int  # the row with which it acts or not; −1 for none


def row_kinds(mechanism: Mechanism, phase: Phase) -> list[RowKind]:
    """What the rows of a mechanism are, in order: lines, two for each foot, pairs that stick together."""
    found: list[RowKind] = []
    for line in constraints(mechanism):
        kind = "string" if isinstance(line.law, Inextensible) else "prop" if isinstance(line.law, Prop) else "rod"
        found.append(RowKind(kind, line.name, kind == "rod", -1))
    for foot in mechanism.feet:
        found.append(RowKind("foot", foot.name, both=False, follows=-1))
        found.append(RowKind("hold", foot.name, both=True, follows=len(found) - 1))
    for meeting, stuck in zip(mechanism.meetings, phase.stuck, strict=True):
        if stuck:
            found.append(RowKind("stuck", " and ".join(meeting.names), both=True, follows=-1))
    return found


def run_between(one: Point, other: Point, maths: Maths) -> PathLength:
    """The distance of two points; only what moves one relative to the other has a gradient."""
    apart = minus(other.place, one.place)
    distance = maths.sqrt(product(apart, apart))
    moving = relative(one.gradient, other.gradient)
    rising = relative(one.lift, other.lift)
    if not moving and not rising:
        return PathLength(distance, 0.0, 0.0, {}, {})
    way = times(1.0 / distance, apart)
    along = {i: product(way, axis) for i, axis in moving.items()}
    lift = {i: product(way, normal) for i, normal in rising.items()}
    parting = minus(other.velocity, one.velocity)
    rate = product(way, parting)
    bend = product(way, minus(other.bias, one.bias))
    bias = bend + (product(parting, parting) - rate * rate) / distance
    return PathLength(distance, rate, bias, along, lift)


def relative(one: Gradient, other: Gradient) -> dict[int, Triple]:
    """How the second point moves relative to the first, where it does."""
    found: dict[int, Triple] = {}
    for i in one.keys() | other.keys():
        if i in one and i in other and one[i] == other[i]:
            continue
        found[i] = minus(other.get(i, _NONE), one.get(i, _NONE))
    return dict(sorted(found.items()))


_NONE = (0.0, 0.0, 0.0)


def projected(one: Gradient, other: Gradient, way: Triple) -> dict[int, Number]:
    """How the second point moves relative to the first along `way`, by coordinate."""
    return {i: product(way, axis) for i, axis in relative(one, other).items()}


def point_row(point: Point, way: Triple, gap: Number) -> RowTerms:
    """The row that holds a point along `way`."""
    along = {i: product(way, axis) for i, axis in point.gradient.items()}
    lift = {i: product(way, normal) for i, normal in point.lift.items()}
    return RowTerms(along, lift, gap, product(way, point.velocity), -product(way, point.bias))


def merge(total: dict[int, Number], more: Mapping[int, Number]) -> None:
    """Add the entries of one gradient to those of another."""
    for i, part in more.items():
        total[i] = total[i] + part if i in total else part
