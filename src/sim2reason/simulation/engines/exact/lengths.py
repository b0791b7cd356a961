"""Lengths, gaps and rows: what constrains a motion, for any kind of number."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from sim2reason.scenes.dsl.mechanism import Mechanism, Rigid
from sim2reason.scenes.dsl.vectors import Gradient, Number, Point, Triple, product, relative


class Phase(NamedTuple):
    """What is switched on or off by events: forces in regions, engines, pairs that stick together, half springs."""

    inside: tuple[tuple[bool, ...], ...] = ()  # for each force, for each border of its region
    burning: tuple[bool, ...] = ()
    stuck: tuple[bool, ...] = ()  # of each meeting
    strained: tuple[bool, ...] = ()  # of each spring that acts only one way


@dataclass(slots=True)
class PathLength:
    """A length, its rate, its second derivative at q̈ = 0, and its gradient."""

    value: Number
    rate: Number
    bias: Number
    along: Mapping[int, Number]
    lift: Mapping[int, Number]


ORIGIN = Point((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), {}, {})


@dataclass(slots=True)
class RowTerms:
    """A constraint row: along·q̈ + Σ lift·rise ≤ target, or = where it acts both ways."""

    along: Mapping[int, Number]
    lift: Mapping[int, Number]
    value: Number  # what is left until it acts, m
    rate: Number  # of what it bounds: positive where that is used up
    target: Number


@dataclass(slots=True)
class Separation:
    """How the two of a meeting stand apart: the gap, and the gradient, rate and bias of its growth."""

    gap: Number
    rate: Number
    bias: Number  # of the second derivative, at q̈ = 0
    along: Mapping[int, Number]
    lift: Mapping[int, Number]


@dataclass(slots=True)
class RowKind:
    """What a row is: ``string``, ``rod``, ``prop``, ``foot``, ``hold`` (of a foot) or ``stuck``, and whose."""

    kind: str
    name: str
    both: bool  # it acts both ways
    follows: int  # the row with which it acts or not; −1 for none


def row_kinds(mechanism: Mechanism, phase: Phase) -> list[RowKind]:
    """Return what the rows of a mechanism are, in order: lines, two for each foot, pairs that stick together."""
    found = [RowKind(line.law.row, line.name, isinstance(line.law, Rigid), -1) for line in mechanism.constraints]
    for foot in mechanism.feet:
        found.append(RowKind("foot", foot.name, both=False, follows=-1))
        found.append(RowKind("hold", foot.name, both=True, follows=len(found) - 1))
    for meeting, stuck in zip(mechanism.meetings, phase.stuck, strict=True):
        if stuck:
            found.append(RowKind("stuck", " and ".join(meeting.names), both=True, follows=-1))
    return found


def projected(one: Gradient, other: Gradient, way: Triple) -> dict[int, Number]:
    """Return how the second point moves relative to the first along `way`, by coordinate."""
    return {i: product(way, axis) for i, axis in relative(one, other).items()}


def point_row(point: Point, way: Triple, gap: Number) -> RowTerms:
    """Return the row that holds a point along `way`."""
    along = {i: product(way, axis) for i, axis in point.gradient.items()}
    lift = {i: product(way, normal) for i, normal in point.lift.items()}
    return RowTerms(along, lift, gap, product(way, point.velocity), -product(way, point.bias))


def merge(total: dict[int, Number], more: Mapping[int, Number]) -> None:
    """Add the entries of one gradient to those of another."""
    for i, part in more.items():
        total[i] = total[i] + part if i in total else part
