"""Open ports of the entities of a growing scene, and the connections they allow."""

from dataclasses import dataclass

from sim2reason.scenes.dsl.connection import Connection, Link
from sim2reason.scenes.dsl.defaults import opposite_direction
from sim2reason.scenes.dsl.entity import ENTITIES, Named, outer_ports, port_stops
from sim2reason.scenes.dsl.ports import Attachment, Pass, Port, StringPort
from sim2reason.scenes.dsl.vectors import Vector


@dataclass(frozen=True)
class OpenPort:
    """A port of an entity in the scene, and the required direction of a connection; None for any."""

    owner: Named
    port: Port

    @property
    def link(self) -> Link:
        """Return the link to the port, as in scene files."""
        return Link(entity=self.owner.name, port=self.port.name)

    @property
    def direction(self) -> Vector | None:
        """Return the direction in which a connection must leave; None for any."""
        stop = port_stops(self.owner.entity, self.port.name, self.owner.name)[-1]
        return self.owner.alone.faces.get(stop.sites[-1]) if stop.sites else None

    def meets(self, other: "OpenPort", kind: type[Connection]) -> bool:
        """Return whether a connection can run to another port; a vertical one needs a hanging end.

        Only a string can change its direction, at a pulley on its way.
        """
        here, there = self.direction, other.direction
        turns = issubclass(kind.joins, StringPort) and not (is_down(here) or is_down(there))
        return turns or opposite_direction(here, there)


def takes(kind: type[Connection], port: Port) -> bool:
    """Return whether a connection of a kind can begin, continue or end at a port."""
    return isinstance(port, kind.joins) and any(kind.admits(port, index, 2) for index in range(3))


def _joins(kind: type[Connection], here: Port, end: Port) -> bool:
    """Return whether a connection of a kind can run between two ports and end at the second."""
    if isinstance(end, Pass):
        return False
    forward = isinstance(here, Pass) or kind.admits(here, 0, 1)
    return (forward and kind.admits(end, 1, 1)) or (kind.admits(here, 1, 1) and kind.admits(end, 0, 1))


def open_ports(named: Named) -> list[OpenPort]:
    """Return the free ports of an entity to which a string may be tied."""
    builder = named.alone
    moves = any(coordinate.speed for coordinate in builder.finish().coordinates)
    ports = outer_ports(type(named.entity)).values()
    free = [port for port in ports if not port.unless or getattr(named.entity, port.unless) is None]
    free = [port for port in free if not (moves and isinstance(port, Attachment | StringPort))]
    sites = {p: [site for stop in port_stops(named.entity, p.name, named.name) for site in stop.sites] for p in free}
    return [OpenPort(named, port) for port in free if builder.faces.keys() >= set(sites[port])]


def ends_for(named: Named, kind: type[Connection], here: OpenPort) -> list[OpenPort]:
    """Return the open ports of an entity to which a connection can run from the port `here` of another entity."""
    return [end for end in open_ports(named) if _joins(kind, here.port, end.port) and end.meets(here, kind)]


def is_passed(name: str, kind: type[Connection]) -> bool:
    """Return whether connections of a kind only pass through an entity of a type, and never end there."""
    ports = outer_ports(ENTITIES[name]).values()
    return any(isinstance(port, Pass) and port.required and isinstance(port, kind.joins) for port in ports)


def is_motionless(named: Named) -> bool:
    """Return whether nothing of an entity moves or pulls."""
    return not named.alone.drawing and not named.alone.finish().bodies


def is_downhill(port: OpenPort) -> bool:
    """Return whether a string leaves a body down its slope, so that it pulls along the weight's component."""
    direction = port.direction
    return direction is not None and not is_down(direction) and direction[2] < -1e-9


def is_down(direction: Vector | None) -> bool:
    """Return whether a connection can only leave vertically downwards."""
    return direction is not None and direction[2] < -1.0 + 1e-9
