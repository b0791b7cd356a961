"""Lengths, gaps and constraint rows of a mechanism, for floats or symbols."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from sim2reason.scenes.dsl.mechanism import Mechanism, Rigid
from sim2reason.scenes.dsl.vectors import Gradient, Number, Point, Triple, dot, relative


class SwitchState(NamedTuple):
    """The on/off state that events change: forces in regions, engines, pairs stuck together and one-sided springs."""

    inside: tuple[tuple[bool, ...], ...] = ()  # for each force, for each border of its region
    burning: tuple[bool, ...] = ()
    stuck: tuple[bool, ...] = ()  # for each collision pair
    strained: tuple[bool, ...] = ()  # for each one-sided spring


@dataclass(slots=True)
class PathLength:
    """The length of a line with its rate, its second derivative at q̈ = 0, and its gradient."""

    value: Number
    rate: Number
    bias: Number
    along: Mapping[int, Number]
    lift: Mapping[int, Number]


ORIGIN = Point((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), {}, {})


@dataclass(slots=True)
class RowTerms:
    """A constraint along·q̈ + Σ lift·(acceleration off a face) ≤ target, or = if it is two-sided."""

    along: Mapping[int, Number]
    lift: Mapping[int, Number]
    value: Number  # distance until the constraint acts, m
    rate: Number  # of the constrained length; positive when the distance shrinks
    target: Number


@dataclass(slots=True)
class Separation:
    """The gap of a collision pair, with its gradient, rate, and second derivative at q̈ = 0 (bias)."""

    gap: Number
    rate: Number
    bias: Number  # second derivative of the gap at q̈ = 0
    along: Mapping[int, Number]
    lift: Mapping[int, Number]


@dataclass(slots=True)
class RowKind:
    """The kind (``string``, ``rod``, ``prop``, ``foot``, ``hold``, ``stuck``) and name of a constraint row."""

    kind: str
    name: str
    both: bool  # whether the constraint is two-sided
    follows: int  # the index of the row with which this one acts; −1 for none


def row_kinds(mechanism: Mechanism, phase: SwitchState) -> list[RowKind]:
    """Return the kinds of all constraint rows in order: lines, two rows for each foot, pairs that stick together."""
    kinds = [RowKind(line.law.row, line.name, isinstance(line.law, Rigid), -1) for line in mechanism.constraints]
    for foot in mechanism.feet:
        kinds.append(RowKind("foot", foot.name, both=False, follows=-1))
        kinds.append(RowKind("hold", foot.name, both=True, follows=len(kinds) - 1))
    for meeting, stuck in zip(mechanism.meetings, phase.stuck, strict=True):
        if stuck:
            kinds.append(RowKind("stuck", " and ".join(meeting.names), both=True, follows=-1))
    return kinds


def project_gradient(one: Gradient, other: Gradient, direction: Triple) -> dict[int, Number]:
    """Return the gradient of the relative motion of the second point to the first along `direction`, by coordinate."""
    return {i: dot(direction, axis) for i, axis in relative(one, other).items()}


def point_row(point: Point, direction: Triple, gap: Number) -> RowTerms:
    """Return the constraint row that holds a point along the direction `direction`."""
    along = {i: dot(direction, axis) for i, axis in point.gradient.items()}
    lift = {i: dot(direction, normal) for i, normal in point.lift.items()}
    return RowTerms(along, lift, gap, dot(direction, point.velocity), -dot(direction, point.bias))


def add_gradient(total: dict[int, Number], more: Mapping[int, Number]) -> None:
    """Add the entries of one gradient to those of another."""
    for i, part in more.items():
        total[i] = total[i] + part if i in total else part
