"""Ports of an entity, at which connections join it or pass through it, with their clauses.

A string's clauses are verb phrases with the string as subject, except `tied`, which names the body it is tied to.
Sites are listed from the inside out; a site declares the direction in which a string must leave it.
"""

from dataclasses import dataclass, field
from functools import lru_cache


@dataclass(frozen=True, kw_only=True)
class Port:
    """The base class of ports. Each kind of connection joins one type of port.

    Attributes:
        name: Name of the class attribute that is the port.
        required: Whether the port must be connected.
        unless: Name of a field of the entity; the port does not exist if it is given.
        needs: Name of an optional field of the entity that is given if and only if the port is connected.
    """

    name: str = field(default="", init=False, compare=False)
    required: bool = False  # whether an open port would change the meaning of the text
    unless: str = ""  # the field of its entity that replaces the port if it is present
    needs: str = ""  # the optional field of its entity that is given if and only if the port is connected

    def __set_name__(self, owner: type, name: str) -> None:
        """Store the name of the attribute."""
        del owner
        object.__setattr__(self, "name", name)


@dataclass(frozen=True, kw_only=True)
class SitePort(Port):
    """A port at sites of its entity; the sites are listed from the inside out."""

    sites: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class Attachment(SitePort):
    """A point to which a spring, a rod or a string can be attached; `tied` names the body there."""

    tied: str


@dataclass(frozen=True, kw_only=True)
class StringPort(Port):
    """A port for strings."""


@dataclass(frozen=True, kw_only=True)
class StringEnd(SitePort, StringPort):
    """A port for one end of a string.

    The clauses are verb phrases whose subject is the string, except `tied`.

    Attributes:
        sites: Sites through which the string runs, from the inside out.
        arrives: Clause for a string that ends here, as in ``reaches {block}``.
        tied: The body to which the string is tied, as in ``{block}``; empty if no sentence can start here.
        leaves: Clause for a string that starts here, as in ``runs horizontally``; empty if the end is described last.
        hangs: Whether the body may be said to hang from the string, without a clause for how the string leaves.
        can_begin: Whether a sentence can start here.
        required: Whether the port must be connected.
        unless: Name of a field of the entity; the port does not exist if it is given.
        needs: Name of an optional field of the entity that is given if and only if the port is connected.

    Examples:
        >>> from sim2reason.authoring import StringEnd
        >>> winch = StringEnd(sites=("drum",), arrives="is wound on a winch")
        >>> winch.can_begin
        False
    """

    arrives: str
    tied: str = ""
    leaves: str = ""
    hangs: bool = False

    @property
    def can_begin(self) -> bool:
        """Return whether the sentence about a string can begin at this end."""
        return bool(self.tied)


@dataclass(frozen=True, kw_only=True)
class End(StringEnd, Attachment):
    """A port for one end of a string, or for a spring or a rod.

    Attributes:
        sites: The single site of the port.
        arrives: Clause for a string that ends here, as in ``reaches {block}``.
        tied: The body to which the connection is attached, as in ``{block}``.
        leaves: Clause for a string that starts here; empty if the end is described last.
        hangs: Whether the body may be said to hang from the string, without a clause for how the string leaves.
        required: Whether the port must be connected.
        unless: Name of a field of the entity; the port does not exist if it is given.
        needs: Name of an optional field of the entity that is given if and only if the port is connected.

    Raises:
        ValueError: `tied` is empty, or there is more than one site.

    Examples:
        >>> from sim2reason.authoring import End
        >>> left = End(sites=("tail",), tied="{block}", leaves="runs horizontally", arrives="reaches {block}")
        >>> left.can_begin
        True
    """

    def __post_init__(self) -> None:
        """Check that the end is named and is a single point; ValueError otherwise."""
        if not self.tied:
            raise ValueError("an end must say what a string is tied to there; else it is a StringEnd")
        if len(self.sites) > 1:
            raise ValueError("an end is one point; where a string leads on round a corner, it is a StringEnd")


@dataclass(frozen=True, kw_only=True)
class Pass(SitePort, StringPort):
    """A port through which a string runs, such as a pulley.

    Attributes:
        sites: The two sites of the port.
        passes: Clause for the string, as in ``passes over {pulley}``.
        sides: Names of the two directions in scene files, in the order of `sites`.
        required: Whether the port must be connected.
        unless: Name of a field of the entity; the port does not exist if it is given.
        needs: Name of an optional field of the entity that is given if and only if the port is connected.

    Examples:
        >>> from sim2reason.authoring import Pass
        >>> over = Pass(sites=("pulley.left", "pulley.right"), passes="passes over {pulley}")
        >>> over.sides
        ('left', 'right')
    """

    sites: tuple[str, str]
    passes: str
    sides: tuple[str, str] = ("left", "right")


@dataclass(frozen=True, kw_only=True)
class Chain(StringPort):
    """A port for a string that consists of other ports: an end, and the pulleys that the string passes.

    Attributes:
        stops: Names of the other ports, from the inside out.
        required: Whether the port must be connected.
        unless: Name of a field of the entity; the port does not exist if it is given.
        needs: Name of an optional field of the entity that is given if and only if the port is connected.

    Examples:
        >>> from sim2reason.authoring import Chain
        >>> Chain(stops=("system.tail", "over"), required=True).stops
        ('system.tail', 'over')
    """

    stops: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class Mount(SitePort):
    """A point of a body on which another entity can stand or hang.

    Attributes:
        sites: The site of the port.
        place: The place in words, as in ``the far end of {arm}``.
        required: Whether the port must be connected.
        unless: Name of a field of the entity; the port does not exist if it is given.
        needs: Name of an optional field of the entity that is given if and only if the port is connected.

    Examples:
        >>> from sim2reason.authoring import Mount
        >>> Mount(sites=("tip",), place="the far end of {arm}").place
        'the far end of {arm}'
    """

    place: str


@dataclass(frozen=True, kw_only=True)
class Base(SitePort):
    """The point at which an entity is mounted on another: its origin.

    Attributes:
        sites: Not used; the point is the origin of the entity.
        held: The part that is mounted, in words, as in ``{arm}``.
        required: Whether the port must be connected.
        unless: Name of a field of the entity; the port does not exist if it is given.
        needs: Name of an optional field of the entity that is given if and only if the port is connected.

    Examples:
        >>> from sim2reason.authoring import Base
        >>> Base(held="{arm}", required=True).held
        '{arm}'
    """

    sites: tuple[str, ...] = ()
    held: str


@dataclass(frozen=True, slots=True)
class Stop:
    """A port of a part or an entity in a scene; `owner` is the address of the part or entity."""

    owner: str
    port: SitePort
    flipped: bool = False  # passed from its second side to its first

    @property
    def sites(self) -> tuple[str, ...]:
        """Return the full site addresses in the order of travel; those of an end from the inside out."""
        return _addressed(self.owner, self.port.sites, self.flipped)


def reversed_stops(stops: list[Stop]) -> list[Stop]:
    """Return the stops in the opposite order of travel; passes within a chain are flipped."""
    return [Stop(s.owner, s.port, not s.flipped if isinstance(s.port, Pass) else s.flipped) for s in reversed(stops)]


def travelled(stops: list[Stop]) -> list[Stop]:
    """Return the stops of a string inside an entity in order of travel, with those of its last port reversed."""
    if not isinstance(stops[-1].port, StringEnd):
        inner = next(i for i, stop in enumerate(stops) if i > 0 and isinstance(stop.port, StringEnd | Chain))
        return [*stops[:inner], *reversed_stops(stops[inner:])]
    return stops


@lru_cache(maxsize=1024)
def _addressed(owner: str, names: tuple[str, ...], flipped: bool) -> tuple[str, ...]:  # noqa: FBT001 - a key
    sites = tuple(f"{owner}.{site}" for site in names)
    return sites[::-1] if flipped else sites
