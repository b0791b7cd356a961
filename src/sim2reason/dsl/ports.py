"""Where connections can be joined to an entity, or led through it, and in which words.

A string's clauses are verb phrases whose subject is the string, but for `tied`, which names what it is tied to. Sites
are listed from the inside out; where a string must go from the last one is said by the site itself.
"""

from dataclasses import dataclass, field
from functools import lru_cache


@dataclass(frozen=True, kw_only=True)
class Port:
    """What a connection can join to something. Each kind of connection joins one type of port.

    `name` is that of the class attribute that holds it.
    """

    name: str = field(default="", init=False, compare=False)
    required: bool = False  # left open, it would change what the text says
    unless: str = ""  # the field of its entity that, where it is there, takes the port's place
    needs: str = ""  # the optional field of its entity that is given where the port is used, and only there

    def __set_name__(self, owner: type, name: str) -> None:
        """Python tells the attribute's name once, as the class is made."""
        del owner
        object.__setattr__(self, "name", name)


@dataclass(frozen=True, kw_only=True)
class SitePort(Port):
    """A port at sites of its entity."""

    sites: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class Attachment(SitePort):
    """A point that a spring, a rod or a string can hold; `tied` names what it is on."""

    tied: str


@dataclass(frozen=True, kw_only=True)
class StringPort(Port):
    """A port for strings."""


@dataclass(frozen=True, kw_only=True)
class StringEnd(SitePort, StringPort):
    """One end of a string. Without `tied` it is always told last; without `leaves` it is told last if it can be.

    With `hangs`, what it is tied to can be said to hang on the string, and how the string leaves need not be said.
    """

    arrives: str
    tied: str = ""
    leaves: str = ""
    hangs: bool = False

    @property
    def can_begin(self) -> bool:
        """Whether a sentence can start here."""
        return bool(self.tied)


@dataclass(frozen=True, kw_only=True)
class End(StringEnd, Attachment):
    """One end of a string, at something that a spring or a rod can hold as well."""

    def __post_init__(self) -> None:
        """Refuse an end that nothing names, and one whose string turns a corner, which no spring does; ValueError."""
        if not self.tied:
            raise ValueError("an end must say what a string is tied to there; else it is a StringEnd")
        if len(self.sites) > 1:
            raise ValueError("an end is one point; where a string leads on round a corner, it is a StringEnd")


@dataclass(frozen=True, kw_only=True)
class Pass(SitePort, StringPort):
    """A place where a string goes on. `sides` name its two directions in files, in the order of `sites`."""

    sites: tuple[str, str]
    passes: str
    sides: tuple[str, str] = ("left", "right")


@dataclass(frozen=True, kw_only=True)
class Chain(StringPort):
    """A port that consists of others, from the inside out: an end and what the string passes on its way out."""

    stops: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class Mount(SitePort):
    """A point of a body that can carry another entity; `place` names what it is on."""

    place: str


@dataclass(frozen=True, kw_only=True)
class Base(SitePort):
    """The point by which an entity is carried, its origin; `held` names it."""

    sites: tuple[str, ...] = ()
    held: str


@dataclass(frozen=True, slots=True)
class Stop:
    """A port at its place in a scene: `owner` is the address of the entity or part that declares it."""

    owner: str
    port: SitePort
    flipped: bool = False  # passed from its second side to its first

    @property
    def sites(self) -> tuple[str, ...]:
        """Full site addresses in the order of travel; an end is listed from the inside out."""
        return _addressed(self.owner, self.port.sites, self.flipped)


def reversed_stops(stops: list[Stop]) -> list[Stop]:
    """Return the stops in the opposite order of travel; a pass within a chain is then passed from its far side."""
    return [Stop(s.owner, s.port, not s.flipped if isinstance(s.port, Pass) else s.flipped) for s in reversed(stops)]


def travelled(stops: list[Stop]) -> list[Stop]:
    """Return the stops of an inner rope in the order of travel; the last port was listed from the inside out."""
    if not isinstance(stops[-1].port, StringEnd):
        inner = next(i for i, stop in enumerate(stops) if i > 0 and isinstance(stop.port, StringEnd | Chain))
        return [*stops[:inner], *reversed_stops(stops[inner:])]
    return stops


@lru_cache(maxsize=1024)
def _addressed(owner: str, names: tuple[str, ...], flipped: bool) -> tuple[str, ...]:  # noqa: FBT001 - a key
    sites = tuple(f"{owner}.{site}" for site in names)
    return sites[::-1] if flipped else sites
