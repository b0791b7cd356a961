"""Parsing of the sentences of entities and parts, and of the possible routes of a string through them."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache, partial
from itertools import chain
from typing import NamedTuple

from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.connection import Connection, InternalConnection, Leg, Link
from sim2reason.scenes.dsl.entity import Part, declared_ports, internal_connections, outer_ports
from sim2reason.scenes.dsl.model import FieldType, field_types
from sim2reason.scenes.dsl.ports import Chain, Pass, SitePort, Stop, StringEnd, StringPort, reversed_stops, travelled
from sim2reason.scenes.dsl.template import Each, PartLines, Saying, Wordings, line_topic, slots, variants, wordings
from sim2reason.text.parsing.matcher import Matcher
from sim2reason.text.parsing.parse_state import MAX_MEMBERS, ParseState, declared_type
from sim2reason.text.parsing.sentences import parse_table


@dataclass(frozen=True, slots=True)
class InnerRoute:
    """The route of a string inside one entity: the entity declares the points it passes, only the direction is open."""

    entity: str
    inner: InternalConnection

    def legs(self, kind: type[Connection], state: ParseState, links: tuple[Link, ...]) -> Iterator[Leg[ParseState]]:
        """Yield the whole route of the string inside the entity, once from each end."""
        del kind
        if links:
            return
        stops = travelled([stop for port in self.inner.stops for stop in port_stops(state, port, self.entity)])
        for path in (stops, reversed_stops(stops)):
            yield Leg(Link(entity=self.entity, port="inside"), tuple(path), last=True, state=state)


def port_stops(state: ParseState, name: str, address: str) -> list[Stop]:
    """Return the points that a string passes at a port of a parsed entity, from the inside outwards."""
    head, _, rest = name.partition(".")
    if rest:
        inner = f"{address}.{head}"
        return port_stops(state, rest, inner) if inner in state.kinds else []
    port = declared_ports(state.kind(address, Part))[name]
    if isinstance(port, Chain):
        return [stop for inner in port.stops for stop in port_stops(state, inner, address)]
    return [Stop(address, port)] if isinstance(port, SitePort) else []


def must_end_at(state: ParseState, address: str) -> bool:
    """Return whether a string must end at an entity: a port needs one, but none lets a string continue."""
    ports = outer_ports(state.kind(address, Part))
    if not any(port.required for port in ports.values()):
        return False
    return not any(_goes_on(port_stops(state, name, address)) for name in ports)


def _goes_on(stops: list[Stop]) -> bool:
    return bool(stops) and all(isinstance(stop.port, Pass) for stop in stops)


def free_legs(kind: type[Connection], state: ParseState, address: str, *, first: bool) -> Iterator[Leg[ParseState]]:
    """Yield the free ports of an entity at which a connection can start (`first`), or end or continue."""
    taken = {(link.entity, link.port) for joined in state.joined for link in joined.links}
    for name in outer_ports(state.kind(address, Part)):
        stops = port_stops(state, name, address)
        if (address, name) in taken or not stops:
            continue
        link = Link(entity=address, port=name)
        if not issubclass(StringPort, kind.joins) and not issubclass(kind.joins, StringPort):
            if any(kind.admits(stops[0].port, index, 1) for index in (0, 1)):  # either end may be told first
                yield Leg(link, tuple(stops), last=not first, state=state)
        elif isinstance(stops[0].port, StringEnd):
            path = stops if first else reversed_stops(stops)
            yield Leg(link, tuple(path), last=not first, state=state)
        elif not first and _goes_on(stops):
            yield Leg(link, tuple(stops), last=False, state=state)


Step = Callable[[int, ParseState], Iterator[tuple[int, ParseState]]]
"""From a piece of the text and what was read before it, to all that can be read from there on."""


class _SentenceStarts(NamedTuple):
    """The sentence beginnings of a part and of the parts inside it."""

    templates: frozenset[str]
    tables: bool
    strings: bool


def may_begin(matcher: Matcher, kind: type[Part], position: int) -> bool:
    """Return whether an entity's text may begin with sentence `position`, by the fixed words of the templates."""
    templates, tables, strings = _sentence_starts(kind)
    if strings or any(matcher.contains_fixed_words(position, template) for template in templates):
        return True
    return tables and any(piece.startswith("|") for piece in matcher.pieces[position + 1 :])


@cache
def _sentence_starts(kind: type[Part]) -> _SentenceStarts:
    members = (
        model for field_type in field_types(kind).values() for model in field_type.models if issubclass(model, Part)
    )
    inner_starts = [_sentence_starts(model) for model in members]
    own = [saying for saying in kind.says if not isinstance(saying, PartLines)]
    lines = (line for saying in own for line in variants(saying))
    return _SentenceStarts(
        frozenset(chain(*lines, *(starts.templates for starts in inner_starts))),
        any(isinstance(saying, Each) for saying in own) or any(starts.tables for starts in inner_starts),
        bool(internal_connections(kind)) or any(starts.strings for starts in inner_starts),
    )


def entity_lines(matcher: Matcher, address: str, position: int, state: ParseState) -> Iterator[tuple[int, ParseState]]:
    """Yield the parses of all sentences of an entity: of its parts, its own, of its inner strings."""
    inner = [partial(_inside, matcher, address, name) for name in internal_connections(state.kind(address, Part))]
    steps: list[Step] = [partial(part_lines, matcher, address), *inner]
    yield from _in_turn(steps, position, state)


def part_lines(matcher: Matcher, address: str, position: int, state: ParseState) -> Iterator[tuple[int, ParseState]]:
    """Yield the parses of the sentences of a part: of the parts inside it first, then its own."""
    kind = state.kind(address, Part)
    placed = {saying.field for saying in kind.says if isinstance(saying, PartLines)}
    first = [PartLines(name) for name in field_types(kind) if name not in placed]
    steps: list[Step] = [partial(_saying, matcher, saying, address) for saying in (*first, *kind.says)]
    yield from _in_turn(steps, position, state)


def _in_turn(steps: list[Step], position: int, state: ParseState) -> Iterator[tuple[int, ParseState]]:
    if not steps:
        yield position, state
        return
    for after, then in steps[0](position, state):
        yield from _in_turn(steps[1:], after, then)


def _parts(
    matcher: Matcher, field: str, address: str, position: int, state: ParseState
) -> Iterator[tuple[int, ParseState]]:
    """Yield the parses of the parts in a field; parts without sentences are described by their entity."""
    field_type, where = field_types(state.kind(address, Part))[field], f"{address}.{field}"
    parts = [model for model in field_type.models if issubclass(model, Part)]
    if parts and field_type.count is None:
        yield from _inner(matcher, where, field_type, position, state)
    elif any(model.says for model in parts):
        yield from _several(matcher, where, field_type, position, state)
    else:
        yield position, state


def _inner(
    matcher: Matcher, address: str, field_type: FieldType, position: int, state: ParseState
) -> Iterator[tuple[int, ParseState]]:
    """Yield the parses of a single part, for each of its possible classes; an optional part may be absent."""
    for kind in field_type.models:
        yield from part_lines(matcher, address, position, state.with_kind(address, kind))
    absent = state.with_value(address, None) if field_type.optional else None
    if absent is not None:
        yield position, absent


def _several(
    matcher: Matcher, address: str, field_type: FieldType, position: int, state: ParseState, index: int = 0
) -> Iterator[tuple[int, ParseState]]:
    """Yield the parses of a variable number of parts, each with its own sentences and of any of its classes."""
    done = state.with_count(address, index, index)
    if done is not None:
        yield position, done
    here = f"{address}.{index}"
    for kind in field_type.models if index < MAX_MEMBERS else ():
        for after, then in part_lines(matcher, here, position, state.with_kind(here, kind)):
            if after > position:
                yield from _several(matcher, address, field_type, after, then, index + 1)


def _inside(
    matcher: Matcher, address: str, name: str, position: int, state: ParseState
) -> Iterator[tuple[int, ParseState]]:
    """Yield the parse of the sentence of an entity's inner connection, with the index of the next sentence."""
    inner = internal_connections(state.kind(address, Part))[name]
    routes = InnerRoute(address, inner)
    for parsed in inner.kind.parse(f"{address}.{name}", position, state, matcher, routes):
        yield position + 1, parsed.state


def _saying(
    matcher: Matcher, saying: Saying, address: str, position: int, state: ParseState
) -> Iterator[tuple[int, ParseState]]:
    if isinstance(saying, PartLines):
        yield from _parts(matcher, saying.field, address, position, state)
        return
    if isinstance(saying, Each):
        yield from _each(matcher, saying, address, position, state)
        return
    several = f"{address}.{saying.several}" if isinstance(saying, Wordings) and saying.several else ""
    many, one = (state.with_count(several, 2), state.with_count(several, 1, 1)) if several else (state, None)
    for line in variants(saying):
        here = _without(saying, line, address, many) if many is not None else None
        for number, template in enumerate(line):
            if here is not None and matcher.contains_fixed_words(position, template):
                for then in matcher.sentence(position, template, address, here.with_choice(number)):
                    yield position + 1, then
    if one is not None:
        yield position, one
    if topic := line_topic(saying):
        yield position, _with_minimums(wordings(saying)[0], address, state)._replace(without=state.without | {topic})
    for then in _unsaid(wordings(saying)[0], address, state):
        yield position, then


def _without(saying: Saying, line: tuple[str, ...], address: str, state: ParseState) -> ParseState | None:
    """Return the state after a sentence; its optional number is marked as absent if the wording used omits it."""
    if not isinstance(saying, Wordings) or not saying.given or line is not saying.wordings:
        return state
    return state.with_value(f"{address}.{saying.given}", None)


def _with_minimums(template: str, address: str, state: ParseState) -> ParseState:
    """Return the state after omission of a sentence, whose numbers get the smallest values that are ever drawn."""
    kind = state.kind(address, Part)
    for path in (slot.path for slot in slots(template) if slot.kind == "path"):
        full_address = f"{address}.{kind.words[path].parameter if path in kind.words else path}"
        owner, _, name = full_address.rpartition(".")
        owners = (kind,) if owner == address else declared_type(state, owner).models
        field_type = next((field_types(each)[name] for each in owners if name in field_types(each)), None)
        if field_type is not None and field_type.drawn is not None and not field_type.optional:
            state = state.with_value(full_address, field_type.drawn.low) or state
    return state


def _each(
    matcher: Matcher, saying: Each, address: str, position: int, state: ParseState
) -> Iterator[tuple[int, ParseState]]:
    """Yield the parses of one sentence per member, or of a table of three or more similar bodies."""
    field = f"{address}.{saying.field}"
    none = state.with_count(field, 0, 0)
    if none is not None:
        yield position, none
    for number, template in enumerate(saying.wordings):
        if matcher.contains_fixed_words(position, template):
            yield from _members(matcher, template, field, position, state.with_choice(number), 0)
    for kind in declared_type(state, field).models:
        if issubclass(kind, Body):
            here = state.with_choice(0)  # the wording of the sentences does not show
            yield from parse_table(matcher, saying.table, field, kind, position, here)


def _members(
    matcher: Matcher, template: str, field: str, position: int, state: ParseState, index: int
) -> Iterator[tuple[int, ParseState]]:
    """Yield the parses of the sentences of the members from `index` on, all in one wording."""
    address = field.rpartition(".")[0]
    if index == MAX_MEMBERS:
        return
    for then in matcher.sentence(position, template.replace(".*", f".{index}"), address, state):
        complete = then.with_count(field, index + 1, index + 1)
        if complete is not None:
            yield position + 1, complete
        yield from _members(matcher, template, field, position + 1, then, index + 1)


def _unsaid(template: str, address: str, state: ParseState) -> Iterator[ParseState]:
    """Yield the states that justify a missing sentence: a part named in it is absent, or a word states its number."""
    kind = state.kind(address, Part)
    for path in dict.fromkeys(slot.path for slot in slots(template) if slot.kind == "path" and "*" not in slot.path):
        path = kind.words[path].parameter if path in kind.words else path  # noqa: PLW2901 - what the word depends on
        where, (head, _, inner) = f"{address}.{path}", path.partition(".")
        field_type, holder = field_types(kind).get(head), f"{address}.{head}"
        may_be_absent = field_type is not None and field_type.optional and holder not in state.letters
        absent = state.with_value(holder, None) if may_be_absent else None
        if absent is not None:
            yield absent
        is_stated = kind.is_stated_by_word(path, state.values.get(where)) or _by_word(state, where)
        if is_stated and (inner or field_type is None or not field_type.optional):
            yield state


def _by_word(state: ParseState, address: str) -> bool:
    """Return whether the introduction of a body has stated a number by a word, or still may."""
    owner, _, name = address.rpartition(".")
    for model in declared_type(state, owner).models:
        if issubclass(model, Body):
            words = [word for word in model.introduced_words() if word.parameter == name]
            return any(address not in state.values or state.values[address] in word.special for word in words)
    return False
