"""Where entities stand: each is placed so that the strings from its neighbours run straight."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from math import hypot

from sim2reason.dsl.builder import Builder
from sim2reason.dsl.connection import Connection
from sim2reason.dsl.entity import Named
from sim2reason.dsl.mechanism import ZERO
from sim2reason.dsl.ports import End, Stop
from sim2reason.dsl.vectors import Vector, add, scale

GAP = 1.0  # m between entities that no straight string aligns; only for looks
FREE = 2.5  # m of free string between neighbours, so that motions of a second or two have room


def opposite(one: Vector | None, other: Vector | None) -> bool:
    """Whether a straight string can leave two sites in these directions; None means any direction."""
    return one is None or other is None or hypot(*add(one, other)) < 1e-9


def placed(
    entities: Sequence[Named],
    connections: Sequence[Connection],
    gravity: float,
    glued: Iterable[str],
    stops: Callable[[Connection], list[Stop]],
) -> Builder:
    """A builder in which all entities are built, each where its strings want it."""
    neighbours = [pair for connection in connections for pair in _pairs(stops(connection))]
    offsets: dict[str, Vector] = {}
    alone: dict[str, Builder] = {}
    right = 0.0
    for named in entities:
        scratch = alone[named.name] = Builder()
        named.entity.build(scratch.room(named.name))
        low, high = scratch.extent()
        offsets[named.name] = (right - low, 0.0, 0.0)
        right += high - low + GAP
    _align(neighbours, offsets, alone)
    builder = Builder((0.0, 0.0, -gravity), glued)
    for named in entities:
        named.entity.build(builder.room(named.name, offsets[named.name]))
    return builder


def _pairs(stops: list[Stop]) -> list[tuple[str, str]]:
    """Neighbouring sites of different entities along a path: where it leaves one and reaches the next."""
    found: list[tuple[str, str]] = []
    for one, other in pairwise(stops):
        leaves, reaches = one.sites[-1], _first(other)
        if leaves.split(".")[0] != reaches.split(".")[0]:
            found.append((leaves, reaches))
    return found


def _first(stop: Stop) -> str:
    """The site that a string reaches first: an end is listed from the inside out, so its last."""
    return stop.sites[-1] if isinstance(stop.port, End) else stop.sites[0]


def _align(pairs: list[tuple[str, str]], offsets: dict[str, Vector], alone: Mapping[str, Builder]) -> None:
    """Shift entities, outwards from the first, so that what faces each other does so on one line."""
    done: set[str] = set()
    for first in alone:  # each tree of the forest from its first entity on
        queue = [first]
        while queue:
            here = queue.pop()
            if here in done:
                continue
            done.add(here)
            for one, other in [*pairs, *((b, a) for a, b in pairs)]:
                name, neighbour = one.split(".")[0], other.split(".")[0]
                if name == here and neighbour not in done:
                    _shift(one, other, alone, offsets)
                    queue.append(neighbour)


def _shift(fixed: str, moved: str, alone: Mapping[str, Builder], offsets: dict[str, Vector]) -> None:
    near, far = fixed.split(".", maxsplit=1)[0], moved.split(".", maxsplit=1)[0]
    here, there = alone[near].faces[fixed], alone[far].faces[moved]
    if (here is None and there is None) or not opposite(here, there):
        return
    towards = here if here is not None else scale(-1.0, there or ZERO)
    wanted = add(alone[near].position(fixed), offsets[near], scale(FREE, towards))
    offsets[far] = add(wanted, scale(-1.0, alone[far].position(moved)))
