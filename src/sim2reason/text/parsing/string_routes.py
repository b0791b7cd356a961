"""Possible routes of a string through the parsed entities: the stops that its sentence may name."""

from collections.abc import Iterator
from dataclasses import dataclass

from sim2reason.scenes.dsl.connection import Connection, InternalConnection, Leg, Link
from sim2reason.scenes.dsl.entity import Part, outer_ports, ports_of
from sim2reason.scenes.dsl.ports import Chain, Pass, SitePort, Stop, StringEnd, StringPort, reversed_stops, travelled
from sim2reason.text.parsing.parse_state import ParseState


@dataclass(frozen=True, slots=True)
class InnerRoute:
    """The route of a string inside one entity: the entity declares the points it passes, only the direction is open."""

    entity: str
    inner: InternalConnection

    def legs(self, kind: type[Connection], state: ParseState, links: tuple[Link, ...]) -> Iterator[Leg[ParseState]]:
        """Yield the whole route of the string inside the entity, once from each end."""
        del kind
        if links:
            return
        stops = travelled([stop for port in self.inner.stops for stop in port_stops(state, port, self.entity)])
        for path in (stops, reversed_stops(stops)):
            yield Leg(Link(entity=self.entity, port="inside"), tuple(path), last=True, state=state)


def port_stops(state: ParseState, name: str, address: str) -> list[Stop]:
    """Return the points that a string passes at a port of a parsed entity, from the inside outwards."""
    head, _, rest = name.partition(".")
    if rest:
        inner = f"{address}.{head}"
        return port_stops(state, rest, inner) if inner in state.kinds else []
    port = ports_of(state.kind(address, Part))[name]
    if isinstance(port, Chain):
        return [stop for inner in port.stops for stop in port_stops(state, inner, address)]
    return [Stop(address, port)] if isinstance(port, SitePort) else []


def must_end_at(state: ParseState, address: str) -> bool:
    """Return whether a string must end at an entity: a port needs one, but none lets a string continue."""
    ports = outer_ports(state.kind(address, Part))
    if not any(port.required for port in ports.values()):
        return False
    return not any(_goes_on(port_stops(state, name, address)) for name in ports)


def _goes_on(stops: list[Stop]) -> bool:
    return bool(stops) and all(isinstance(stop.port, Pass) for stop in stops)


def free_legs(kind: type[Connection], state: ParseState, address: str, *, first: bool) -> Iterator[Leg[ParseState]]:
    """Yield the free ports of an entity at which a connection can start (`first`), or end or continue."""
    taken = {(link.entity, link.port) for joined in state.joined for link in joined.links}
    for name in outer_ports(state.kind(address, Part)):
        stops = port_stops(state, name, address)
        if (address, name) in taken or not stops:
            continue
        link = Link(entity=address, port=name)
        if not issubclass(StringPort, kind.joins) and not issubclass(kind.joins, StringPort):
            if any(kind.admits(stops[0].port, index, 1) for index in (0, 1)):  # either end may be told first
                yield Leg(link, tuple(stops), last=not first, state=state)
        elif isinstance(stops[0].port, StringEnd):
            path = stops if first else reversed_stops(stops)
            yield Leg(link, tuple(path), last=not first, state=state)
        elif not first and _goes_on(stops):
            yield Leg(link, tuple(stops), last=False, state=state)
