"""Optional fields that a port needs, and nothing else: they are given where a connection uses it, and only there."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain

from sim2reason.scenes.dsl.connection import Link
from sim2reason.scenes.dsl.entity import Named, outer_ports
from sim2reason.scenes.dsl.model import rebuilt


def used_ports(paths: Iterable[Sequence[Link]]) -> set[tuple[str, str]]:
    """Entity and port of all links of some connections."""
    return {(link.entity, link.port) for link in chain.from_iterable(paths)}


def idle_fields(named: Named, used: set[tuple[str, str]]) -> Iterator[tuple[str, str]]:
    """Yield the fields that are given though every port that needs them is open, each with one of these ports."""
    needed: dict[str, list[str]] = {}
    for name, port in outer_ports(type(named.entity)).items():
        if port.needs:
            needed.setdefault(port.needs, []).append(name)
    for field, ports in needed.items():
        if getattr(named.entity, field) is not None and not any((named.name, port) in used for port in ports):
            yield field, ports[0]


def vacated(entities: Iterable[Named], paths: Iterable[Sequence[Link]]) -> tuple[Named, ...]:
    """The entities without what only open ports need: what to make a scene of once it is known what is connected."""
    used = used_ports(paths)
    return tuple(_vacated(named, used) for named in entities)


def _vacated(named: Named, used: set[tuple[str, str]]) -> Named:
    idle = {field: None for field, _ in idle_fields(named, used)}
    return Named(name=named.name, entity=rebuilt(named.entity, **idle)) if idle else named
