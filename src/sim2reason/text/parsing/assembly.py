"""Construction of a scene from the facts that were parsed; hidden numbers are drawn at random."""

from collections.abc import Iterable
from typing import Any

import numpy as np
from pydantic import ValidationError

from sim2reason.errors import TextError
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.connection import Connection, StatedValue
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.model import FieldType, M, Model, field_types
from sim2reason.scenes.dsl.scene import Scene, World
from sim2reason.scenes.files.mistakes import explain_error
from sim2reason.text.parsing.parse_state import ParsedConnection, ParseState, declared_type

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
    told = {path.removeprefix("world."): value for path, value in state.values.items() if path.startswith("world.")}
    return Scene(entities=tuple(entities), connections=connections, world=World.model_validate(told))


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
        held = next(field_types(kind)[name] for kind in declared_type(state, owner).models if name in field_types(kind))
        if held.drawn is None:
            raise TextError("text", f"it does not tell {symbol}", "say it")
        values[path] = held.drawn.low + share * (held.drawn.high - held.drawn.low)
    return state._replace(values=values)


def _connection(state: ParseState, joined: ParsedConnection, rng: np.random.Generator) -> Connection:
    own = {name: held for name, held in field_types(joined.kind).items() if held.measure is not None or held.words}
    told = {name: _field(state, f"{joined.name}.{name}", joined.kind, held, rng) for name, held in own.items()}
    return joined.kind(links=joined.links, **told)


def _model(state: ParseState, address: str, kind: type[M], rng: np.random.Generator) -> M:
    fields: dict[str, Any] = {}
    for name, held in field_types(kind).items():
        fields[name] = _field(state, f"{address}.{name}", kind, held, rng)
    try:
        return kind(**fields)
    except ValidationError as error:
        raise explain_error(kind, error, address) from None


def _field(state: ParseState, address: str, kind: type[Model], held: FieldType, rng: np.random.Generator) -> Any:
    if held.hidden:
        return _drawn(held, rng)
    if address in state.values:
        told = state.values[address]
        return told if held.measure is not None or held.words else _index(told)
    if held.count is not None:
        return _several(state, address, held, rng)
    if held.models and not (held.optional and _is_silent(state, address)):
        return _model(state, address, state.kinds.get(address, held.models[0]), rng)
    if held.optional:
        return None
    usual: Any = kind.model_fields[address.rpartition(".")[2]].default
    if (held.words or held.member) and isinstance(usual, str | int):
        return usual
    what = held.measure.name if held.measure is not None else address.rpartition(".")[2]
    raise TextError("text", f"the {what} of a {kind.__name__} is not told", "say it")


def _drawn(held: FieldType, rng: np.random.Generator) -> float:
    if held.measure is None or held.drawn is None:
        raise TypeError("a hidden number needs a range to be drawn from")
    return held.measure.draw(rng, held.drawn.low, held.drawn.high)


def _index(value: StatedValue) -> int | None:
    return None if value is None else int(value)


def _several(state: ParseState, address: str, held: FieldType, rng: np.random.Generator) -> tuple[Model, ...]:
    low, high = state.size_range(address)
    if low != high:
        raise TextError("text", f"it is not told how many {address.rpartition('.')[2]} there are", "name them all")
    members = [f"{address}.{index}" for index in range(high)]
    return tuple(_model(state, member, state.kinds.get(member, held.models[0]), rng) for member in members)


def _is_silent(state: ParseState, address: str) -> bool:
    """Return whether the text states nothing about an optional body or part."""
    kind = state.kinds.get(address)
    if kind is None:
        return not any(path.startswith(f"{address}.") for path in state.values)
    return issubclass(kind, Body) and address not in state.letters
