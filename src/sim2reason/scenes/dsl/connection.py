"""Connections between the ports of entities, with methods to build, describe, parse and draw them.

Writing and matching of sentences belong to `prose` and `parsing`; connections use them through the protocols in this
module, so that the scene language does not depend on its readers.
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

FREE_LENGTH = 2.5  # m of free string between neighbours, enough for motions of a second or two
StatedValue = float | str | None
"""The value that a text states for an address: a number, a word of a choice, or None if it is absent."""

Look = Literal["string", "spring", "rod", "pivot", "weld"]
"""The drawn kind of a connection: a thin line, a coil, a bar; a ring or a square where two bodies meet."""


class Link(Model):
    """A port of a named entity; `flipped` if a passed port is passed from its far side."""

    entity: str
    port: str
    flipped: bool = False

    def __str__(self) -> str:
        """Return the link as messages show it: the entity and the port, joined by a dot."""
        return f"{self.entity}.{self.port}"


class SentenceWriter(Protocol):
    """The protocol of the writer of a scene's text, whose methods connections call."""

    @property
    def builder(self) -> Builder:
        """Return the builder with the positions of sites and the directions of strings."""
        ...

    def choose(self, options: tuple[str, ...]) -> str:
        """Return one of several wordings."""
        ...

    def render(self, template: str, address: str) -> str:
        """Return the text of a template of the entity or part at an address."""
        ...

    def at(self, address: str) -> str:
        """Return the text for an address: a number, a body, a list of bodies."""
        ...

    @property
    def finished(self) -> tuple[str, ...]:
        """Return all earlier sentences of the text."""
        ...


class SentenceState(Protocol):
    """The protocol of the values read from a text so far; immutable, to follow several readings at once."""

    @property
    def values(self) -> Mapping[str, StatedValue]:
        """Return the stated values by address."""
        ...

    def with_choice(self, number: int) -> Self:
        """Return the state with the index of one more chosen wording."""
        ...

    def with_kind(self, address: str, kind: type[Model]) -> Self:
        """Return the state with the class of the body or connection at an address."""
        ...

    def with_value(self, address: str, value: StatedValue) -> Self | None:
        """Return the state with a value; None if it contradicts an earlier one."""
        ...


S = TypeVar("S", bound=SentenceState)


@dataclass(frozen=True, slots=True)
class Leg(Generic[S]):
    """A port on the path of a connection, as its stops in the order of travel; `last` marks the end."""

    link: Link
    stops: tuple[Stop, ...]
    last: bool
    state: S


class Routes(Protocol[S]):
    """The protocol of the ports that a connection's sentence may name next."""

    def legs(self, kind: "type[Connection]", state: S, links: tuple[Link, ...]) -> Iterator[Leg[S]]:
        """Return the ports to which a kind of connection can continue after `links`, or where it can begin if none."""
        ...


class SentenceMatcher(Protocol[S]):
    """The protocol of the matcher of a text's sentences with templates, whose methods connections call."""

    pieces: tuple[str, ...]
    reach: int

    def contains_fixed_words(self, place: int, template: str) -> bool:
        """Return whether all fixed words of a template occur in a sentence."""
        ...

    def literal(self, text: str, at: int, wanted: str) -> int | None:
        """Return the index after `wanted` if the text contains it at index `at`, else None."""
        ...

    def template(self, text: str, at: int, template: str, owner: str, state: S) -> Iterator[tuple[int, S]]:
        """Yield all readings of the text from index `at` as a template of the part at `owner`: end index and state."""
        ...


@dataclass(frozen=True, slots=True)
class ParsedSentence(Generic[S]):
    """A parsed sentence of a connection: its links and own bodies in the order of the text."""

    state: S
    links: tuple[Link, ...]
    owned: tuple[str, ...]


class Connection(Model):
    """The base class of connections: a path through ports, built and described as one unit."""

    key: ClassVar[str] = ""  # name in scene files
    joins: ClassVar[type[Port]] = Port  # type of ports that it can join
    look: ClassVar[Look] = "string"
    carries: ClassVar[bool] = False  # whether its first end carries the entity at its last one
    stiff: ClassVar[bool] = False  # whether the carried entity is welded, without rotation
    words: ClassVar[dict[str, Word]] = {}
    links: tuple[Link, ...]

    @classmethod
    def admits(cls, port: Port, index: int, last: int) -> bool:
        """Return whether the connection's link at `index` may lead to this port; `last` is the largest index."""
        del index, last
        return isinstance(port, cls.joins)

    @property
    def spacing(self) -> float:
        """Return the distance of neighbouring stops, m."""
        return FREE_LENGTH

    def brings(self, joint: "Joint", builder: Builder) -> dict[str, Body]:
        """Return the bodies that belong to the connection, by address."""
        raise NotImplementedError

    def build(self, joint: "Joint", builder: Builder) -> None:
        """Build the connection, once all entities are built."""
        raise NotImplementedError

    def describe(self, joint: "Joint", writer: SentenceWriter) -> str:
        """Return the sentence of the connection."""
        raise NotImplementedError

    @classmethod
    def parse(
        cls, name: str, place: int, state: S, matcher: SentenceMatcher[S], routes: Routes[S]
    ) -> Iterator[ParsedSentence[S]]:
        """Yield all parses of the connection's sentence at index `place`."""
        raise NotImplementedError


@dataclass(frozen=True, slots=True)
class Joint:
    """A connection in a scene, with its address and its stops in the order of travel."""

    name: str
    connection: Connection
    stops: tuple[Stop, ...]

    def brings(self, builder: Builder) -> dict[str, Body]:
        """Return the bodies that belong to the connection, by address."""
        return self.connection.brings(self, builder)

    def build(self, builder: Builder) -> None:
        """Build the connection, once all entities are built."""
        self.connection.build(self, builder)

    def describe(self, writer: SentenceWriter) -> str:
        """Return the sentence of the connection."""
        return self.connection.describe(self, writer)


@dataclass(frozen=True, slots=True)
class InternalConnection:
    """A connection within an entity, through its own ports from end to end."""

    kind: type[Connection]
    stops: tuple[str, ...]

    def made(self) -> Connection:
        """Return the connection with default numbers."""
        return self.kind(links=())


C = TypeVar("C", bound=Connection)
CONNECTIONS: Registry[type[Connection]] = Registry("connections", package="sim2reason.scenes.connections")


def connection(cls: type[C]) -> type[C]:
    """Register a connection class under its key in scene files."""
    return CONNECTIONS.add(cls.key, cls)
