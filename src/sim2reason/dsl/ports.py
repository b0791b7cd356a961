"""Where a string can be tied to an entity, or led through it, and in which words.

Every clause is a verb phrase whose subject is the string, but for `tied`, which names what it is tied to.
Sites are listed from the inside out; where a string must go from the last one is said by the site itself.
"""

from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class Port:
    """What a connection can join to something. Each kind of connection joins one type of port.

    `name` is that of the class attribute that holds it.
    """

    name: str = field(default="", init=False, compare=False)
    required: bool = field(default=False, kw_only=True)  # left open, it would change what the text says

    def __set_name__(self, owner: type, name: str) -> None:
        """Python tells the attribute's name once, as the class is made."""
        del owner
        object.__setattr__(self, "name", name)


@dataclass(frozen=True, slots=True)
class StringPort(Port):
    """A port for strings."""


@dataclass(frozen=True, slots=True)
class End(StringPort):
    """One end of a string. Without `tied` it is always told last; without `leaves` it is told last if it can be."""

    sites: tuple[str, ...]
    arrives: str
    tied: str = ""
    leaves: str = ""

    @property
    def can_begin(self) -> bool:
        """Whether a sentence can start here."""
        return bool(self.tied)


@dataclass(frozen=True, slots=True)
class Pass(StringPort):
    """A place where a string goes on. `sides` name its two directions in files, in the order of `sites`."""

    sites: tuple[str, str]
    passes: str
    sides: tuple[str, str] = ("left", "right")


@dataclass(frozen=True, slots=True)
class Chain(StringPort):
    """A port that consists of others, from the inside out: an end and what the string passes on its way out."""

    stops: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Stop:
    """A port at its place in a scene: `owner` is the address of the entity or part that declares it."""

    owner: str
    port: End | Pass
    flipped: bool = False  # passed from its second side to its first

    @property
    def sites(self) -> tuple[str, ...]:
        """Full site addresses in the order of travel; an end is listed from the inside out."""
        sites = tuple(f"{self.owner}.{site}" for site in self.port.sites)
        return sites[::-1] if self.flipped else sites
