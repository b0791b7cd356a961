"""State of a parse: the facts that the text has stated so far, and the scene that they make."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from pydantic import ValidationError

from sim2reason.errors import TextError
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.connection import Connection, Link, StatedValue
from sim2reason.scenes.dsl.entity import Entity, Named, Part
from sim2reason.scenes.dsl.measures import Measure
from sim2reason.scenes.dsl.model import FieldType, M, Model, field_types
from sim2reason.scenes.dsl.scene import Scene, World
from sim2reason.scenes.dsl.template import Topic, Word
from sim2reason.scenes.dsl.units import to_coherent_unit
from sim2reason.scenes.files.validation import explain_error
from sim2reason.text.prose.phrases import Names, body_name, letter_at

MAX_MEMBERS = 8  # largest number of members of a variable-length part


@dataclass(frozen=True, slots=True)
class ParsedConnection:
    """A parsed connection and the ports that it joins."""

    name: str
    kind: type[Connection]
    links: tuple[Link, ...]


NONE: Mapping[Any, Any] = MappingProxyType({})


class ParseState(NamedTuple):
    """Facts parsed so far, by address in the scene; `script` lists the index of the wording of each parsed sentence."""

    kinds: Mapping[str, type[Model]]
    values: Mapping[str, StatedValue] = NONE  # None: absent
    counts: Mapping[str, tuple[int, int]] = NONE  # least and most
    letters: Mapping[str, str] = NONE  # in the order of introduction
    nouns: Mapping[type[Body], str] = NONE
    script: tuple[int, ...] = ()
    entities: tuple[str, ...] = ()
    waiting: tuple[str, ...] = ()  # entities whose lines were read and that no string has reached
    joined: tuple[ParsedConnection, ...] = ()
    closings: tuple[str, ...] = ()
    without: frozenset[Topic] = frozenset()  # topics on which lines were left out

    @property
    def unknowns(self) -> dict[str, str]:
        """Return the symbols (with dollars) that stand for unknown numbers, by address."""
        return {path: value for path, value in self.values.items() if isinstance(value, str) and value.startswith("$")}

    def with_choice(self, number: int) -> "ParseState":
        """Return the state with the index of a sentence's wording appended to the script of wordings."""
        return self._replace(script=(*self.script, number))

    def with_kind(self, address: str, kind: type[Model]) -> "ParseState":
        """Return the state with the class of the object at an address."""
        return self._replace(kinds={**self.kinds, address: kind})

    def with_value(self, address: str, value: StatedValue) -> "ParseState | None":
        """Return the state with a number at an address; None if it contradicts an earlier value."""
        if address in self.values:
            return self if self.values[address] == value else None
        return self._replace(values={**self.values, address: value})

    def shared(self, members: Sequence[str], names: Iterable[str]) -> "ParseState | None":
        """Return the state in which all bodies of a list have the first one's known numbers; None on contradiction."""
        merged: ParseState | None = self
        for name in sorted(names):
            value = self.values.get(f"{members[0]}.{name}")
            for member in members[1:] if value is not None else ():
                merged = merged.with_value(f"{member}.{name}", value) if merged is not None else None
        return merged

    def with_count(self, address: str, low: int, high: int = MAX_MEMBERS) -> "ParseState | None":
        """Return the state with a narrower range for the number of members of a list; None if no number remains."""
        fewest, most = self.size_range(address)
        low, high = max(fewest, low), min(most, high)
        if low > high:
            return None
        return self if (low, high) == (fewest, most) else self._replace(counts={**self.counts, address: (low, high)})

    def size_range(self, address: str) -> tuple[int, int]:
        """Return the minimum and maximum number of members of a list of bodies or parts."""
        return self.counts.get(address, (0, MAX_MEMBERS))

    def with_noun(self, kind: type[Body], noun: str) -> "ParseState":
        """Return the state with the noun of a class of bodies."""
        return self if kind in self.nouns else self._replace(nouns={**self.nouns, kind: noun})

    def introduced(self, address: str, kind: type[Body], letter: str) -> "ParseState":
        """Return the state after the first mention of a body."""
        return self._replace(kinds={**self.kinds, address: kind}, letters={**self.letters, address: letter})

    def kind(self, address: str, base: type[M]) -> type[M]:
        """Return the class of the object at an address; TypeError if it is not a subclass of `base`."""
        cls = self.kinds[address]
        if not issubclass(cls, base):
            raise TypeError(f"{address} is a {cls.__name__}")
        return cls

    def body(self, address: str) -> type[Body]:
        """Return the class of an introduced body."""
        return self.kind(address, Body)

    def series(self, kind: type[Body]) -> list[str]:
        """Return the letters of all introduced bodies that draw their letters from the same series, such as A, B, C."""
        if not kind.letters:
            return []
        return [letter for address, letter in self.letters.items() if self.body(address).letters == kind.letters]

    def next_letters(self, kind: type[Body], count: int = 1) -> list[str] | None:
        """Return the next letters of a series of bodies; None if its first body has no letter."""
        given = self.series(kind)
        if not kind.letters or "" in given:
            return None
        return [letter_at(kind.letters, len(given) + index) for index in range(count)]

    def knows_noun(self, noun: str) -> bool:
        """Return whether a body with that noun was introduced."""
        return any(self.nouns[self.body(address)] == noun for address in self.letters)

    def mention(self, address: str, *, full: bool) -> str:
        """Return the name of an introduced body in running text, with its noun if `full`."""
        return body_name(self.nouns[self.body(address)], self.letters[address], full=full)

    @property
    def names(self) -> Names:
        """Return the letters and nouns of all bodies in the text."""
        return Names({address: letter for address, letter in self.letters.items() if letter}, self.nouns)

    def renamed(self, old: tuple[str, ...], new: tuple[str, ...]) -> "ParseState":
        """Return the state in which everything stored at the addresses `old` is moved to the addresses `new`."""
        moved = dict(zip(old, new, strict=True))

        def move(held: Mapping[str, Any]) -> dict[str, Any]:
            return {_moved(address, moved): value for address, value in held.items()}

        return self._replace(kinds=move(self.kinds), values=move(self.values), letters=move(self.letters))


def _moved(address: str, moved: Mapping[str, str]) -> str:
    if address in moved:
        return moved[address]
    owner, dot, name = address.rpartition(".")
    return moved[owner] + dot + name if owner in moved else address


@dataclass(frozen=True, slots=True)
class DeclaredType:
    """The declared type of the value at an address: a number, a word, a list, or an object of some class."""

    measure: Measure | None = None
    word: Word | None = None
    choices: tuple[str, ...] = ()
    several: bool = False
    models: tuple[type[Model], ...] = ()


def declared_type(state: ParseState, address: str) -> DeclaredType:
    """Return the declared type of the value at an address; KeyError if the address does not exist."""
    if address in state.kinds:
        return DeclaredType(models=(state.kinds[address],))
    owner, _, step = address.rpartition(".")
    owner_type = declared_type(state, owner) if owner else DeclaredType()
    if step.isdigit():
        return replace(owner_type, several=False)
    for model in owner_type.models:
        if issubclass(model, Body) and step in model.words:
            return DeclaredType(word=model.words[step])
        if step in field_types(model):
            kind = field_types(model)[step]
            return DeclaredType(kind.measure, None, kind.words, kind.count is not None, kind.models)
    raise KeyError(address)


def join_address(owner: str, path: str) -> str:
    """Return the address of a relative path below an owner."""
    return f"{owner}.{path}" if owner else path


def part_word(state: ParseState, owner: str, path: str) -> Word | None:
    """Return a word of the part or the connection at an address."""
    kind = state.kinds.get(owner)
    return kind.words.get(path) if kind is not None and issubclass(kind, Part | Connection) else None


def canonical_addresses(address: str, state: ParseState) -> Iterator[tuple[str, ParseState]]:
    """Yield the address with an index for `first` or `last`; each possible index if the list's length is open."""
    address = address.replace(".first.", ".0.")
    owner, _, step = address.rpartition(".")
    if step == "first":
        yield f"{owner}.0", state
    elif step == "last":
        low, high = state.size_range(owner)
        for count in range(max(low, 1), high + 1):
            then = state.with_count(owner, count, count)
            if then is not None:
                yield f"{owner}.{count - 1}", then
    else:
        yield address, state


POWER = " \N{MULTIPLICATION SIGN} 10^"
NUMBER = re.compile(
    "\N{MINUS SIGN}?[0-9]{1,40}(?:\\.[0-9]{1,40})?"
    f"(?:e[+\N{MINUS SIGN}]?[0-9]{{1,3}}|{re.escape(POWER)}\N{MINUS SIGN}?[0-9]{{1,3}})?"
)
SYMBOL = re.compile(r"\$([^$\n]{1,40})\$")


def possible_units(digits: str, unit: str) -> list[tuple[str, float]]:
    """Return the units in which a number may be given, each with the number's value in the declared `unit`.

    For example, a speed declared in km/s may be stated in m/s.
    """
    number = digits.replace("\N{MINUS SIGN}", "-").replace(POWER, "e")
    bare, size = to_coherent_unit(unit)
    stated = [(unit, float(number))]
    return stated if size == 1 else [*stated, (bare, float(Decimal(number) / size))]


MAX_UNKNOWNS = 2  # unknown numbers in a text: the one it asks for, and one whose limiting value it gives


def build_scene(state: ParseState, rng: np.random.Generator, share: float = 0.5) -> Scene:
    """Build the parsed scene; each number stated only as a symbol gets the value at fraction `share` of its range.

    Raises:
        TextError: something is not told.
        SceneError, ValueError: what is told can't be.
    """
    state = _guessed(state, share)
    entities = [Named(name=name, entity=_model(state, name, state.kind(name, Entity), rng)) for name in state.entities]
    connections = tuple(_connection(state, joined, rng) for joined in state.joined)
    world_values = {
        path.removeprefix("world."): value for path, value in state.values.items() if path.startswith("world.")
    }
    return Scene(entities=tuple(entities), connections=connections, world=World.model_validate(world_values))


def unstated_error(symbols: Iterable[str]) -> TextError:
    """Return the error for a text that leaves more numbers unknown than its question asks for."""
    return TextError("text", f"it does not tell {' and '.join(symbols)}", "leave one number unknown")


def _guessed(state: ParseState, share: float) -> ParseState:
    """Return the parse state with numbers in place of symbols; TextError for several possible values or no range."""
    unknowns = state.unknowns
    if len(unknowns) > MAX_UNKNOWNS:
        raise unstated_error(unknowns.values())
    values = dict(state.values)
    for path, symbol in unknowns.items():
        owner, _, name = path.rpartition(".")
        field_type = next(
            field_types(kind)[name] for kind in declared_type(state, owner).models if name in field_types(kind)
        )
        if field_type.drawn is None:
            raise TextError("text", f"it does not tell {symbol}", "say it")
        values[path] = field_type.drawn.low + share * (field_type.drawn.high - field_type.drawn.low)
    return state._replace(values=values)


def _connection(state: ParseState, joined: ParsedConnection, rng: np.random.Generator) -> Connection:
    own = {
        name: field_type
        for name, field_type in field_types(joined.kind).items()
        if field_type.measure is not None or field_type.words
    }
    values = {
        name: _field(state, f"{joined.name}.{name}", joined.kind, field_type, rng) for name, field_type in own.items()
    }
    return joined.kind(links=joined.links, **values)


def _model(state: ParseState, address: str, kind: type[M], rng: np.random.Generator) -> M:
    fields: dict[str, Any] = {}
    for name, field_type in field_types(kind).items():
        fields[name] = _field(state, f"{address}.{name}", kind, field_type, rng)
    try:
        return kind(**fields)
    except ValidationError as error:
        raise explain_error(kind, error, address) from None


def _field(state: ParseState, address: str, kind: type[Model], field_type: FieldType, rng: np.random.Generator) -> Any:
    if field_type.hidden:
        return _drawn(field_type, rng)
    if address in state.values:
        value = state.values[address]
        return value if field_type.measure is not None or field_type.words else _index(value)
    if field_type.count is not None:
        return _several(state, address, field_type, rng)
    if field_type.models and not (field_type.optional and _is_silent(state, address)):
        return _model(state, address, state.kinds.get(address, field_type.models[0]), rng)
    if field_type.optional:
        return None
    usual: Any = kind.model_fields[address.rpartition(".")[2]].default
    if (field_type.words or field_type.member) and isinstance(usual, str | int):
        return usual
    what = field_type.measure.name if field_type.measure is not None else address.rpartition(".")[2]
    raise TextError("text", f"the {what} of a {kind.__name__} is not told", "say it")


def _drawn(field_type: FieldType, rng: np.random.Generator) -> float:
    if field_type.measure is None or field_type.drawn is None:
        raise TypeError("a hidden number needs a range to be drawn from")
    return field_type.measure.draw(rng, field_type.drawn.low, field_type.drawn.high)


def _index(value: StatedValue) -> int | None:
    return None if value is None else int(value)


def _several(state: ParseState, address: str, field_type: FieldType, rng: np.random.Generator) -> tuple[Model, ...]:
    low, high = state.size_range(address)
    if low != high:
        raise TextError("text", f"it is not told how many {address.rpartition('.')[2]} there are", "name them all")
    members = [f"{address}.{index}" for index in range(high)]
    return tuple(_model(state, member, state.kinds.get(member, field_type.models[0]), rng) for member in members)


def _is_silent(state: ParseState, address: str) -> bool:
    """Return whether the text states nothing about an optional body or part."""
    kind = state.kinds.get(address)
    if kind is None:
        return not any(path.startswith(f"{address}.") for path in state.values)
    return issubclass(kind, Body) and address not in state.letters
