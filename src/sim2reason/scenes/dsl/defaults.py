"""Defaults of scenes: positions of entities, chosen so that strings are straight, and the duration of a motion."""

from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from math import hypot, inf, pi, sqrt
from typing import NamedTuple

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import Connection
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.mechanism import GRAVITY, ZERO, Elastic, Mechanism
from sim2reason.scenes.dsl.ports import Stop, StringEnd
from sim2reason.scenes.dsl.vectors import Vector, add, scale

ENTITY_GAP = 1.0  # m between entities that no straight string aligns, for drawings only


def opposite_direction(one: Vector | None, other: Vector | None) -> bool:
    """Return whether a straight string can leave two sites in these directions; None means any direction."""
    return one is None or other is None or hypot(*add(one, other)) < 1e-9


class Neighbours(NamedTuple):
    """Two sites of different entities that a connection joins, and their distance."""

    one: str
    other: str
    spacing: float


class Mounted(NamedTuple):
    """An entity mounted on another: the carrying site, and whether it is welded."""

    name: str
    site: str
    stiff: bool


def place_entities(
    entities: Sequence[Named],
    paths: Sequence[tuple[Connection, Sequence[Stop]]],
    builder: Builder,
) -> Builder:
    """Return the builder with all entities built at the positions that their connections require, carriers first.

    `paths` are the connections, each with its stops in the order of travel.
    """
    pairs: list[Neighbours] = []
    mounted: dict[str, Mounted] = {}
    for connection, path in paths:
        if connection.carries:
            mounted[path[1].owner] = Mounted(path[1].owner, path[0].sites[0], connection.stiff)
        else:
            pairs += _pairs(path, connection.spacing)
    free = [named for named in entities if named.name not in mounted]
    offsets, alone, right = dict[str, Vector](), {named.name: named.alone for named in free}, 0.0
    for named in free:
        low, high = named.alone.extent
        offsets[named.name] = (right - low, 0.0, 0.0)
        right += high - low + ENTITY_GAP
    for _, path in paths:
        _check_sites(path, alone)
    _align([pair for pair in pairs if {_owner(pair.one), _owner(pair.other)} <= offsets.keys()], offsets, alone)
    for named in free:
        named.entity.build(builder.room(named.name, offsets[named.name]))
    _mount({named.name: named for named in entities}, mounted, builder)
    return builder


def _check_sites(path: Sequence[Stop], alone: Mapping[str, Builder]) -> None:
    """Raise SceneError for a stop at an optional part that its entity does not have."""
    for stop in path:
        known = alone.get(_owner(stop.owner))
        if known is not None and any(site not in known.faces for site in stop.sites):
            remedy = "leave the connection out, or give the part that it leads to"
            raise SceneError(stop.owner, f"there is nothing at its port {stop.port.name!r}", remedy)


def _mount(entities: Mapping[str, Named], mounted: Mapping[str, Mounted], builder: Builder) -> None:
    """Build the mounted entities after their carriers."""
    waiting = list(mounted.values())
    while waiting:
        ready = [each for each in waiting if _owner(each.site) not in {other.name for other in waiting}]
        if not ready:
            raise SceneError("connections", "entities carry each other in a ring", "let one of them stand alone")
        for each in ready:
            entities[each.name].entity.build(builder.mount(each.name, each.site, stiff=each.stiff))
        waiting = [each for each in waiting if each not in ready]


def _owner(site: str) -> str:
    return site.split(".", maxsplit=1)[0]


def _pairs(stops: Sequence[Stop], spacing: float) -> list[Neighbours]:
    """Return the neighbouring sites of different entities along a path."""
    neighbours: list[Neighbours] = []
    for one, other in pairwise(stops):
        leaves, reaches = one.sites[-1], _first(other)
        if _owner(leaves) != _owner(reaches):
            neighbours.append(Neighbours(leaves, reaches, spacing))
    return neighbours


def _first(stop: Stop) -> str:
    """Return the site of a stop that a connection reaches first: of a string end the outermost, else the first."""
    return stop.sites[-1] if isinstance(stop.port, StringEnd) else stop.sites[0]


def _align(pairs: list[Neighbours], offsets: dict[str, Vector], alone: Mapping[str, Builder]) -> None:
    """Shift entities, outwards from the first, so that facing sites lie on one line."""
    done: set[str] = set()
    both = [*pairs, *(Neighbours(pair.other, pair.one, pair.spacing) for pair in pairs)]
    for first in alone:  # each tree of the forest from its first entity on
        queue = [first]
        while queue:
            here = queue.pop()
            if here in done:
                continue
            done.add(here)
            for pair in both:
                if _owner(pair.one) == here and _owner(pair.other) not in done:
                    _shift(pair, alone, offsets)
                    queue.append(_owner(pair.other))


def _shift(pair: Neighbours, alone: Mapping[str, Builder], offsets: dict[str, Vector]) -> None:
    near, far = _owner(pair.one), _owner(pair.other)
    here, there = alone[near].faces[pair.one], alone[far].faces[pair.other]
    if (here is None and there is None) or not opposite_direction(here, there):
        return
    towards = here if here is not None else scale(-1.0, there or ZERO)
    wanted = add(alone[near].position(pair.one), offsets[near], scale(pair.spacing, towards))
    offsets[far] = add(wanted, scale(-1.0, alone[far].position(pair.other)))


DEFAULT_HORIZON = 2.0  # s, on Earth
MAX_OSCILLATIONS, SIMULATED_OSCILLATIONS = (
    100,
    40,
)  # oscillations of the stiffest spring: the limit for long motions, and the number simulated instead


def horizon(entities: Iterable[Entity], gravity: float) -> float:
    """Return the longest duration that any entity asks for under `gravity`, m/s², in the text's unit of time.

    If no entity asks for any, it is the time of a fall from the height from which a body falls for 2 s on Earth.
    """
    wanted = (entity.horizon(gravity) for entity in entities)
    usual = DEFAULT_HORIZON * sqrt(GRAVITY / gravity) if gravity else DEFAULT_HORIZON
    return max((duration for duration in wanted if duration is not None), default=usual)


def within_oscillations(duration: float, mechanism: Mechanism) -> float:
    """Return `duration`, s, or some periods of the stiffest spring if `duration` has too many for the engines."""
    period = stiffest_period(mechanism)
    return duration if duration <= MAX_OSCILLATIONS * period else SIMULATED_OSCILLATIONS * period


def stiffest_period(mechanism: Mechanism) -> float:
    """Return the shortest period of a body on a spring with its other end fixed, s; infinite without springs."""
    shortest = inf
    for line in mechanism.lines:
        if isinstance(line.law, Elastic) and line.law.acts == "both":
            ends = line.circle or tuple(mechanism.site[site].body for site in (line.through[0], line.through[-1]))
            masses = [mechanism.body[body].mass for body in ends if body is not None]
            shortest = min([shortest, *(2.0 * pi * sqrt(mass / line.law.stiffness) for mass in masses if mass > 0.0)])
    return shortest
