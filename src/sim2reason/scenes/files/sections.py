"""Sections of scene files with their own syntax: strings between pairs of ends, the wording, and the question.

A file names the two ends of each straight segment. A string that passes a movable pulley is several pairs, which meet
at the pulley's two sides; in a scene it is one connection, a path through ports. A wording is

    text:
      wording: 1234
      symbols: [ramp.plane.angle]
      without: [start]
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, cast, get_args

from sim2reason.base.registry import similar_names
from sim2reason.base.yaml_text import Plain, parse, quote_value
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.connection import CONNECTIONS, Connection, Link
from sim2reason.scenes.dsl.entity import Entity, outer_ports
from sim2reason.scenes.dsl.ports import Pass
from sim2reason.scenes.dsl.template import Topic

END_KEYS = ("entity", "direction", "connecting_point")
WAYS = ("inner_to_outer", "outer_to_inner")  # along the string: the end in that direction


@dataclass(frozen=True, slots=True)
class FileEnd:
    """One end of a pair: a port of an entity; `side` (0 or 1) is that of a passed port, None for an end."""

    entity: str
    port: str
    side: int | None
    place: str


@dataclass(frozen=True, slots=True)
class FilePair:
    """One entry of `connections`, with the parameters beside its two ends."""

    kind: type[Connection]
    ends: tuple[FileEnd, FileEnd]
    own: dict[str, Plain]
    place: str


@dataclass(frozen=True, slots=True)
class Path:
    """One connection, from several pairs: its links in the order of travel; `first` is the place of the first pair."""

    kind: type[Connection]
    links: tuple[Link, ...]
    own: dict[str, Plain]
    first: str


@cache
def directions(cls: type[Entity]) -> dict[tuple[str, str], tuple[str, int | None]]:
    """Return the spellings of an entity's ports: (direction, connecting_point or "") to (port, side).

    An end is entered by its name. A side of a passed port is entered by its own name, if no other port or side has
    it, or as connecting_point beside the port's name.
    """
    ports = outer_ports(cls)
    spellings: dict[tuple[str, str], tuple[str, int | None]] = {
        (name, ""): (name, None) for name, port in ports.items() if not isinstance(port, Pass)
    }
    passes = [(name, port) for name, port in ports.items() if isinstance(port, Pass)]
    names = [*ports, *(side for _, port in passes for side in port.sides)]
    for name, port in passes:
        for number, side in enumerate(port.sides):
            spellings[name, side] = (name, number)
            if names.count(side) == 1:
                spellings[side, ""] = (name, number)
    return spellings


def end_to_plain(entity: str, cls: type[Entity], port: str, side: int | None) -> dict[str, Plain]:
    """Return an end as in a scene file, by its shortest name."""
    names = [spelling for spelling, end in directions(cls).items() if end == (port, side)]
    direction, point = min(names, key=lambda spelling: bool(spelling[1]))
    mapping: dict[str, Plain] = {"entity": entity, "direction": direction}
    return mapping | {"connecting_point": point} if point else mapping


def pairs_to_plain(connection: Connection, classes: Mapping[str, type[Entity]]) -> list[list[Plain]]:
    """Return a connection as pairs of ends, in the order of travel."""
    first, *inner, last = connection.links
    ends = [end_to_plain(first.entity, classes[first.entity], first.port, None)]
    for link in inner:
        enters = 1 if link.flipped else 0
        ends.extend(end_to_plain(link.entity, classes[link.entity], link.port, side) for side in (enters, 1 - enters))
    ends.append(end_to_plain(last.entity, classes[last.entity], last.port, None))
    return [[ends[index], ends[index + 1]] for index in range(0, len(ends), 2)]


def read_pair(entry: Plain, location: str, classes: Mapping[str, type[Entity]]) -> FilePair:
    """Return an entry of `connections`, without validating the values of its parameters."""
    if not isinstance(entry, dict):
        raise SceneError(location, "it is no mapping", "write it as: - tendon: [{entity: …, direction: …}, …]")
    keys = [key for key in entry if key in CONNECTIONS]
    if len(keys) != 1:
        problem = (
            "it says more than one kind of connection" if keys else "it does not say which kind of connection it is"
        )
        raise SceneError(location, problem, f"give it one of: {', '.join(CONNECTIONS)}")
    ends = entry[keys[0]]
    where = f"{location}.{keys[0]}"
    if not isinstance(ends, list) or len(ends) != 2:
        raise SceneError(where, "a connection joins two ends", "list two: [{entity: …, direction: …}, …]")
    first, last = (_end(end, f"{where}[{index}]", classes) for index, end in enumerate(ends))
    own = {key: value for key, value in entry.items() if key != keys[0]}
    return FilePair(CONNECTIONS[keys[0]], (first, last), own, location)


def _end(end: Plain, location: str, classes: Mapping[str, type[Entity]]) -> FileEnd:
    if not isinstance(end, dict):
        raise SceneError(location, "it is no mapping", "write it as {entity: …, direction: …}")
    for key in end:
        if key not in END_KEYS:
            raise SceneError(f"{location}.{key}", "there is no such key", f"an end has: {', '.join(END_KEYS)}")
    entity = _text(end, "entity", location)
    direction = _text(end, "direction", location)
    point = _text(end, "connecting_point", location) if "connecting_point" in end else ""
    if entity not in classes:
        near = similar_names(entity, classes) or list(classes)
        raise SceneError(
            f"{location}.entity", f"no entity is called {quote_value(entity)}", f"there are: {', '.join(near)}"
        )
    known = directions(classes[entity])
    direction, point = _named(direction, point, known)
    if (direction, point) not in known:
        short = [name for name, side in known if not side]
        names = ", ".join(short or [f"{name} with connecting_point {side}" for name, side in known])
        spelling = quote_value(direction) + (f" with connecting_point {quote_value(point)}" if point else "")
        kind = classes[entity].__name__
        raise SceneError(f"{location}.direction", f"{kind} has no direction {spelling}", f"it has: {names}")
    return FileEnd(entity, *known[direction, point], location)


def _named(direction: str, point: str, known: Mapping[tuple[str, str], tuple[str, int | None]]) -> tuple[str, str]:
    """Replace a direction along the string, as ``inner_to_outer``, by the entity's only end or the named point."""
    ends = [name for (name, side), (_, passed) in known.items() if not side and passed is None]
    if direction not in WAYS or (not point and len(ends) != 1):
        return direction, point
    return point or ends[0], ""


def _text(end: dict[str, Plain], key: str, location: str) -> str:
    value = end.get(key)
    if not isinstance(value, str):
        problem = f"it is {quote_value(value)}, not a word" if key in end else "it is missing"
        raise SceneError(f"{location}.{key}", problem, "write each end as {entity: …, direction: …}")
    return value


def paths(pairs: list[FilePair]) -> Iterator[Path]:
    """Yield the connections that pairs form, in the order of their first pairs in the file.

    A path is travelled in the direction of the first of its pairs.
    """
    by_end: dict[tuple[str, str, int | None], tuple[int, int]] = {}
    for number, pair in enumerate(pairs):
        for index, end in enumerate(pair.ends):
            other = by_end.setdefault((end.entity, end.port, end.side), (number, index))
            if other != (number, index):
                first = pairs[other[0]].ends[other[1]].place
                raise SceneError(end.place, f"{first} is the same end", "use each end of an entity once")
    done: set[int] = set()
    for number, pair in enumerate(pairs):
        if number not in done:
            forth = _onward(number, 1, pairs, by_end)
            back = _onward(number, 0, pairs, by_end)
            travelled = [*((other, 1 - index) for other, index in reversed(back)), (number, 0), *forth]
            done |= {other for other, _ in travelled}
            yield _path(pair, [(pairs[other], index) for other, index in travelled])


def _onward(
    number: int, leaves: int, pairs: list[FilePair], by_end: Mapping[tuple[str, str, int | None], tuple[int, int]]
) -> list[tuple[int, int]]:
    """Return the pairs, by index, by which a string goes on beyond one end of a pair, each with its entering end."""
    steps: list[tuple[int, int]] = []
    end = pairs[number].ends[leaves]
    while end.side is not None:
        other = by_end.get((end.entity, end.port, 1 - end.side))
        if other is None:
            raise SceneError(
                end.place, "the string comes to this pulley and does not go on", "add the pair with its other side"
            )
        if other[0] == number:
            raise SceneError(end.place, "the string closes on itself", "give it two ends")
        steps.append(other)
        end = pairs[other[0]].ends[1 - other[1]]
    return steps


def _path(first: FilePair, travelled: list[tuple[FilePair, int]]) -> Path:
    """Return one connection from pairs in the order of travel, each with the index of its first end."""
    own: dict[str, Plain] = {}
    for pair, _ in travelled:
        if pair.kind is not first.kind:
            raise SceneError(pair.place, f"a {first.kind.key} can't go on as a {pair.kind.key}", "use one kind")
        for key, value in pair.own.items():
            if key in own:
                raise SceneError(f"{pair.place}.{key}", "it is given twice for one connection", "keep one of them")
            own[key] = value
    start, enters = travelled[0]
    links = [_link(start.ends[enters])]
    links.extend(_link(pair.ends[enters]) for pair, enters in travelled[1:])
    last, enters = travelled[-1]
    links.append(_link(last.ends[1 - enters], passed=False))
    return Path(first.kind, tuple(links), own, first.place)


def _link(end: FileEnd, *, passed: bool = True) -> Link:
    """Return the link of an end; the side of a passed port is where the string leaves, so 0 means flipped."""
    return Link(entity=end.entity, port=end.port, flipped=passed and end.side == 0)


def own_fields(kind: type[Connection]) -> list[str]:
    """Return the names of the parameters of a kind of connection."""
    return [name for name in kind.model_fields if name != "links"]


def own_values(connection: Connection) -> dict[str, Any]:
    """Return the values of the parameters of a connection, by name."""
    return {name: getattr(connection, name) for name in own_fields(type(connection))}


KEYS = ("wording", "symbols", "without")
MAX_SEED = 2**63 - 1

TEXT: dict[str, Any] = {
    "type": "object",
    "additionalProperties": False,
    "description": "How a problem tells the scene, so that figures name things as it does and show no more.",
    "properties": {
        "wording": {"type": "integer", "minimum": 0, "description": "The seed of its wording."},
        "symbols": {
            "type": "array",
            "items": {"type": "string"},
            "description": "Addresses of numbers for which it says symbols, as of what it asks for.",
        },
        "without": {
            "type": "array",
            "items": {"enum": list(get_args(Topic))},
            "description": "Topics on which it says nothing.",
        },
    },
}
"""The JSON schema of the key ``text``."""


@dataclass(frozen=True, slots=True)
class Wording:
    """The choices that fix the text of a scene: its seed, symbols for numbers, and omitted sentences.

    `seed` selects the wording and the names; at the addresses in `symbols` the text has symbols instead of numbers, as
    for unknowns; sentences on the topics in `without` are omitted.
    """

    seed: int = 0
    symbols: tuple[str, ...] = ()
    without: tuple[Topic, ...] = ()

    @property
    def plain(self) -> dict[str, Plain]:
        """Return the mapping under the key ``text`` of a file."""
        mapping: dict[str, Plain] = {"wording": self.seed}
        if self.symbols:
            mapping["symbols"] = list[Plain](self.symbols)
        if self.without:
            mapping["without"] = list[Plain](self.without)
        return mapping


def read_wording(text: str) -> Wording | None:
    """Return the wording in a scene file; None if it has none.

    Raises:
        SceneError: the value is invalid; the message has path, problem and remedy.
    """
    data = parse(text)
    return parse_wording(data["text"]) if isinstance(data, dict) and "text" in data else None


def parse_wording(data: Plain) -> Wording:
    """Return the wording from the value of the key ``text``; errors as in `read_wording`."""
    if not isinstance(data, dict):
        raise SceneError("text", f"it is {quote_value(data)}, not a mapping", f"give it these keys: {', '.join(KEYS)}")
    for key in data:
        if key not in KEYS:
            raise SceneError(f"text.{key}", "there is no such key here", f"keys: {', '.join(KEYS)}")
    seed, topics = data.get("wording", 0), get_args(Topic)
    if not isinstance(seed, int) or isinstance(seed, bool) or not 0 <= seed <= MAX_SEED:
        raise SceneError("text.wording", f"it is {quote_value(seed)}", "give a whole number of at least 0")
    without = _words(data.get("without", []), "text.without")
    if unknown := next((word for word in without if word not in topics), ""):
        raise SceneError("text.without", f"there is no topic {unknown!r}", f"there are: {', '.join(topics)}")
    return Wording(seed, _words(data.get("symbols", []), "text.symbols"), cast("tuple[Topic, ...]", without))


def _words(data: Plain, location: str) -> tuple[str, ...]:
    if not isinstance(data, Sequence) or isinstance(data, str) or not all(isinstance(word, str) for word in data):
        raise SceneError(
            location, f"it is {quote_value(data)}, not a list of words", "give a list, perhaps an empty one"
        )
    return tuple(cast("Sequence[str]", data))


def read_question(text: str) -> dict[str, Plain] | str | None:
    """Return the question under a scene file's key ``question``, a sentence or its parts; None without this key.

    Raises:
        SceneError: the question is neither a sentence nor a mapping.
    """
    data = parse(text)
    return parse_question(data["question"]) if isinstance(data, dict) and "question" in data else None


def parse_question(data: Plain) -> dict[str, Plain] | str:
    """Return the value of the key ``question``; SceneError unless it is a sentence or a mapping, with any keys."""
    if not isinstance(data, dict | str) or data == "":
        remedy = "ask in a sentence, or give it parts, such as find, of and when"
        raise SceneError("question", f"it is {quote_value(data)}, neither a sentence nor a mapping", remedy)
    return data
