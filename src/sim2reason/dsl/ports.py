"""Where a string can be tied to an entity, or led through it, and in which words.

Every clause is a verb phrase whose subject is the string, but for `tied`, which names what it is tied to.
Sites are listed from the inside out; where a string must go from the last one is said by the site itself.
"""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class End:
    """One end of a string. Without `tied` it is always told last; without `leaves` it is told last if it can be."""

    sites: tuple[str, ...]
    arrives: str
    tied: str = ""
    leaves: str = ""
    required: bool = False  # left open, it would change what the text says

    @property
    def can_begin(self) -> bool:
        """Whether a sentence can start here."""
        return bool(self.tied)


@dataclass(frozen=True, slots=True)
class Pass:
    """A place where a string goes on. `sides` name its two directions in files, in the order of `sites`."""

    sites: tuple[str, str]
    passes: str
    sides: tuple[str, str] = ("left", "right")
    required: bool = False


@dataclass(frozen=True, slots=True)
class Chain:
    """A port that consists of others, from the inside out: an end and what the string passes on its way out."""

    stops: tuple[str, ...]
    required: bool = False


@dataclass(frozen=True, slots=True)
class Rope:
    """A string inside an entity, through its own ports from end to end."""

    stops: tuple[str, ...]


Port = End | Pass | Chain
PORT_TYPES = (End, Pass, Chain, Rope)


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
