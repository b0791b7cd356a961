"""Where a string can begin and go on, as far as a text has told: the stops that its sentence may name."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

from sim2reason.dsl.connection import Link
from sim2reason.dsl.entity import Part, outer_ports, ports_of
from sim2reason.dsl.ports import Chain, End, Pass, Rope, Stop
from sim2reason.dsl.reading.heard import Heard
from sim2reason.dsl.scene import reversed_stops, travelled


@dataclass(frozen=True, slots=True)
class Leg:
    """A port that a string takes, as its stops in the order of travel; `last` ends the string."""

    link: Link
    stops: tuple[Stop, ...]
    last: bool
    heard: Heard


class Trail(Protocol):
    """What a connection's sentence may name next."""

    def legs(self, heard: Heard, links: tuple[Link, ...]) -> Iterator[Leg]:
        """All ways to go on after `links`; without any, all ways to begin."""
        ...


@dataclass(frozen=True, slots=True)
class Rigged:
    """A string inside an entity: all its stops are declared, only its direction is open."""

    entity: str
    rope: Rope

    def legs(self, heard: Heard, links: tuple[Link, ...]) -> Iterator[Leg]:
        """The whole string, from either end."""
        if links:
            return
        stops = travelled([stop for port in self.rope.stops for stop in port_stops(heard, port, self.entity)])
        for path in (stops, reversed_stops(stops)):
            yield Leg(Link(entity=self.entity, port="rope"), tuple(path), last=True, heard=heard)


def port_stops(heard: Heard, name: str, address: str) -> list[Stop]:
    """A port of an entity that was read as the stops that a string makes there, from the inside out."""
    head, _, rest = name.partition(".")
    if rest:
        inner = f"{address}.{head}"
        return port_stops(heard, rest, inner) if inner in heard.kinds else []
    port = ports_of(heard.kind(address, Part))[name]
    if isinstance(port, Chain):
        return [stop for inner in port.stops for stop in port_stops(heard, inner, address)]
    return [Stop(address, port)] if isinstance(port, End | Pass) else []


def free_legs(heard: Heard, address: str, *, first: bool) -> Iterator[Leg]:
    """The ports of an entity that no string has taken, as a string's beginning or as its next leg."""
    taken = {(link.entity, link.port) for strung in heard.strung for link in strung.links}
    for name in outer_ports(heard.kind(address, Part)):
        stops = port_stops(heard, name, address)
        if (address, name) in taken or not stops:
            continue
        link = Link(entity=address, port=name)
        if isinstance(stops[0].port, End):
            path = stops if first else reversed_stops(stops)
            yield Leg(link, tuple(path), last=not first, heard=heard)
        elif not first and all(isinstance(stop.port, Pass) for stop in stops):
            yield Leg(link, tuple(stops), last=False, heard=heard)
