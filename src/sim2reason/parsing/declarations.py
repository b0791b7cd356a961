"""What the declarations say about an address of a scene that is still being read."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from sim2reason.dsl.body import Body
from sim2reason.dsl.connection import Connection
from sim2reason.dsl.entity import Part
from sim2reason.dsl.measures import Measure
from sim2reason.dsl.model import Model, field_types
from sim2reason.dsl.template import Word
from sim2reason.parsing.parse_state import ParseState


@dataclass(frozen=True, slots=True)
class Thing:
    """What stands at an address, as far as declarations tell: a number, a word, a list, or one of some models."""

    measure: Measure | None = None
    word: Word | None = None
    choices: tuple[str, ...] = ()
    several: bool = False
    models: tuple[type[Model], ...] = ()


def thing_at(state: ParseState, address: str) -> Thing:
    """What the declarations say about an address; KeyError for one that leads nowhere."""
    if address in state.kinds:
        return Thing(models=(state.kinds[address],))
    owner, _, step = address.rpartition(".")
    held = thing_at(state, owner) if owner else Thing()
    if step.isdigit():
        return replace(held, several=False)
    for model in held.models:
        if issubclass(model, Body) and step in model.words:
            return Thing(word=model.words[step])
        if step in field_types(model):
            kind = field_types(model)[step]
            return Thing(kind.measure, None, kind.words, kind.count is not None, kind.models)
    raise KeyError(address)


def joined(owner: str, path: str) -> str:
    """The address of a path below an owner."""
    return f"{owner}.{path}" if owner else path


def part_word(state: ParseState, owner: str, path: str) -> Word | None:
    """A word of the part or the connection at an address."""
    kind = state.kinds.get(owner)
    return kind.words.get(path) if kind is not None and issubclass(kind, Part | Connection) else None


def canonical(address: str, state: ParseState) -> Iterator[tuple[str, ParseState]]:
    """`first` and `last` as indices; where the last one is not known yet, every possible one."""
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
