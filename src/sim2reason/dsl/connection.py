"""Connections: what joins the ports of entities."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from sim2reason.dsl.body import Body
from sim2reason.dsl.builder import Builder
from sim2reason.dsl.model import Model
from sim2reason.dsl.ports import Port, Stop
from sim2reason.registry import Registry

if TYPE_CHECKING:
    from sim2reason.dsl.reading.heard import Heard
    from sim2reason.dsl.reading.hearer import Hearer
    from sim2reason.dsl.reading.trails import Trail
    from sim2reason.dsl.telling.speaker import Speaker


class Link(Model):
    """A port of an entity of the scene, by name; a passed port may be passed from its far side."""

    entity: str
    port: str
    flipped: bool = False

    def __str__(self) -> str:
        """As messages name it."""
        return f"{self.entity}.{self.port}"


@dataclass(frozen=True, slots=True)
class Told:
    """A connection's sentence as it was read: its links and own bodies in the order in which they are told."""

    heard: "Heard"
    links: tuple[Link, ...]
    owned: tuple[str, ...]


class Connection(Model):
    """The base of all connections: a path through ports, built and told as one thing."""

    key: ClassVar[str] = ""  # its name in scene files
    joins: ClassVar[type[Port]] = Port  # the type of ports between which it can run
    links: tuple[Link, ...]

    @classmethod
    def owned(cls, name: str, stops: list[Stop], builder: Builder) -> dict[str, Body]:
        """The bodies that the connection itself brings, by address."""
        raise NotImplementedError

    @classmethod
    def stretch(cls, name: str, stops: list[Stop], builder: Builder, values: dict[str, Any]) -> None:
        """Build the connection, once all entities are built; `values` are its own parameters."""
        raise NotImplementedError

    @classmethod
    def tell(cls, name: str, stops: list[Stop], speaker: "Speaker") -> str:
        """Its sentence."""
        raise NotImplementedError

    @classmethod
    def hear(cls, name: str, place: int, heard: "Heard", hearer: "Hearer", trail: "Trail") -> Iterator[Told]:
        """Its sentence read back: all that the piece at `place` can mean as what `tell` says."""
        raise NotImplementedError


C = TypeVar("C", bound=Connection)
CONNECTIONS: Registry[type[Connection]] = Registry("connections")


def connection(cls: type[C]) -> type[C]:
    """Enter a connection class under its key in scene files."""
    return CONNECTIONS.add(cls.key, cls)
