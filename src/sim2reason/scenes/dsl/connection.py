"""Connections: what joins the ports of entities. Each knows how it is built, described, parsed and drawn.

How a sentence is written or matched is the business of `prose` and `parsing`; what a connection needs of them is
said here as protocols, so that the language does not depend on its readers.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import ClassVar, Generic, Literal, Protocol, Self, TypeVar

from sim2reason.base.registry import Registry
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.model import Model
from sim2reason.scenes.dsl.ports import Port, Stop
from sim2reason.scenes.dsl.template import Word

FREE = 2.5  # m of free string between neighbours, so that motions of a second or two have room
Told = float | str | None
"""What a text tells of an address: a number, a word of a choice, or that it is absent."""

Look = Literal["string", "spring", "rod", "pivot", "weld"]
"""How a connection is drawn: a thin line, a coil, a bar; a ring or a square where two bodies meet."""


class Link(Model):
    """A port of an entity of the scene, by name; a passed port may be passed from its far side."""

    entity: str
    port: str
    flipped: bool = False

    def __str__(self) -> str:
        """As messages name it."""
        return f"{self.entity}.{self.port}"


class SentenceWriter(Protocol):
    """What a connection needs of whoever writes a scene's text."""

    @property
    def builder(self) -> Builder:
        """Return where sites are, and which way strings must leave them."""
        ...

    def choose(self, options: tuple[str, ...]) -> str:
        """Return one of several wordings."""
        ...

    def render(self, template: str, address: str) -> str:
        """Return a template of the entity or part at an address."""
        ...

    def at(self, address: str) -> str:
        """Return what the text has for an address: a number, a body, a list of bodies."""
        ...

    @property
    def finished(self) -> tuple[str, ...]:
        """All earlier sentences."""
        ...


class SentenceState(Protocol):
    """What a text has told so far; frozen, so that many readings can be followed at once."""

    @property
    def values(self) -> Mapping[str, Told]:
        """Numbers by address."""
        ...

    def with_choice(self, number: int) -> Self:
        """With one more wording that was met."""
        ...

    def with_kind(self, address: str, kind: type[Model]) -> Self:
        """With the class of what stands at an address."""
        ...

    def with_value(self, address: str, value: Told) -> Self | None:
        """With a number; None if another one was told before."""
        ...


S = TypeVar("S", bound=SentenceState)


@dataclass(frozen=True, slots=True)
class Leg(Generic[S]):
    """A port that a connection takes, as its stops in the order of travel; `last` ends the connection."""

    link: Link
    stops: tuple[Stop, ...]
    last: bool
    state: S


class Routes(Protocol[S]):
    """What a connection's sentence may name next."""

    def legs(self, kind: "type[Connection]", state: S, links: tuple[Link, ...]) -> Iterator[Leg[S]]:
        """Return all ways in which a kind of connection can go on after `links`; without any, all ways to begin."""
        ...


class SentenceMatcher(Protocol[S]):
    """What a connection needs of whoever matches the sentences of a text."""

    pieces: tuple[str, ...]
    reach: int

    def may_be(self, place: int, template: str) -> bool:
        """Return whether all fixed words of a template stand somewhere in a sentence."""
        ...

    def literal(self, text: str, at: int, wanted: str) -> int | None:
        """Return where `wanted` ends if it stands at `at`."""
        ...

    def template(self, text: str, at: int, template: str, owner: str, state: S) -> Iterator[tuple[int, S]]:
        """Return all ways in which a template of the part at `owner` can stand at `at`."""
        ...


@dataclass(frozen=True, slots=True)
class ParsedSentence(Generic[S]):
    """A connection's sentence as it was read: its links and own bodies in the order in which they are told."""

    state: S
    links: tuple[Link, ...]
    owned: tuple[str, ...]


class Connection(Model):
    """The base of all connections: a path through ports, built and told as one thing."""

    key: ClassVar[str] = ""  # its name in scene files
    joins: ClassVar[type[Port]] = Port  # the type of ports between which it can run
    look: ClassVar[Look] = "string"
    carries: ClassVar[bool] = False  # whether its first end carries the entity at its last one
    stiff: ClassVar[bool] = False  # and if so, without letting it turn
    words: ClassVar[dict[str, Word]] = {}
    links: tuple[Link, ...]

    @classmethod
    def admits(cls, port: Port, index: int, last: int) -> bool:
        """Return whether its link at `index` may lead to a port."""
        del index, last
        return isinstance(port, cls.joins)

    @property
    def spacing(self) -> float:
        """Return how far apart neighbours on it stand, m."""
        return FREE

    def brings(self, joint: "Joint", builder: Builder) -> dict[str, Body]:
        """Return the bodies that the connection itself brings, by address."""
        raise NotImplementedError

    def build(self, joint: "Joint", builder: Builder) -> None:
        """Build the connection, once all entities are built."""
        raise NotImplementedError

    def describe(self, joint: "Joint", writer: SentenceWriter) -> str:
        """Return its sentence."""
        raise NotImplementedError

    @classmethod
    def parse(
        cls, name: str, place: int, state: S, matcher: SentenceMatcher[S], routes: Routes[S]
    ) -> Iterator[ParsedSentence[S]]:
        """Return its sentence read back: all that the piece at `place` can mean as what `describe` says."""
        raise NotImplementedError


@dataclass(frozen=True, slots=True)
class Joint:
    """A connection at its place in a scene: its address, and its stops in the order of travel."""

    name: str
    connection: Connection
    stops: tuple[Stop, ...]

    def brings(self, builder: Builder) -> dict[str, Body]:
        """Return the bodies that the connection itself brings, by address."""
        return self.connection.brings(self, builder)

    def build(self, builder: Builder) -> None:
        """Build the connection, once all entities are built."""
        self.connection.build(self, builder)

    def describe(self, writer: SentenceWriter) -> str:
        """Return its sentence."""
        return self.connection.describe(self, writer)


@dataclass(frozen=True, slots=True)
class Inside:
    """A connection inside an entity, through its own ports from end to end."""

    kind: type[Connection]
    stops: tuple[str, ...]

    def made(self) -> Connection:
        """Return the connection, with the default of each of its numbers."""
        return self.kind(links=())


C = TypeVar("C", bound=Connection)
CONNECTIONS: Registry[type[Connection]] = Registry("connections", package="sim2reason.scenes.connections")


def connection(cls: type[C]) -> type[C]:
    """Enter a connection class under its key in scene files."""
    return CONNECTIONS.add(cls.key, cls)
