"""The lines of entities and parts, read in the order in which the Speaker says them."""

from collections.abc import Callable, Iterator
from functools import partial

from sim2reason.dsl.body import Body
from sim2reason.dsl.connection import CONNECTIONS
from sim2reason.dsl.entity import Part, ropes_of
from sim2reason.dsl.model import FieldType, field_types
from sim2reason.dsl.reading.heard import MANY, Heard
from sim2reason.dsl.reading.hearer import Hearer, thing_at
from sim2reason.dsl.reading.tables import hear_table
from sim2reason.dsl.reading.trails import Rigged
from sim2reason.dsl.template import Each, Saying, slots, wordings

Step = Callable[[int, Heard], Iterator[tuple[int, Heard]]]
"""From a piece of the text and what was heard before it, to all that can be heard from there on."""


def entity_lines(hearer: Hearer, address: str, place: int, heard: Heard) -> Iterator[tuple[int, Heard]]:
    """All lines of an entity whose class is known: its parts', its own, its inner strings'."""
    ropes = [partial(_rope, hearer, address, name) for name in ropes_of(heard.kind(address, Part))]
    steps: list[Step] = [partial(part_lines, hearer, address), *ropes]
    yield from _in_turn(steps, place, heard)


def part_lines(hearer: Hearer, address: str, place: int, heard: Heard) -> Iterator[tuple[int, Heard]]:
    """The lines of the parts inside a part, then its own."""
    kind = heard.kind(address, Part)
    steps: list[Step] = []
    for name, held in field_types(kind).items():
        if held.count is None and any(issubclass(model, Part) for model in held.models):
            steps.append(partial(_inner, hearer, f"{address}.{name}", held))
    steps.extend(partial(_saying, hearer, saying, address) for saying in kind.says)
    yield from _in_turn(steps, place, heard)


def _in_turn(steps: list[Step], place: int, heard: Heard) -> Iterator[tuple[int, Heard]]:
    if not steps:
        yield place, heard
        return
    for after, then in steps[0](place, heard):
        yield from _in_turn(steps[1:], after, then)


def _inner(hearer: Hearer, address: str, held: FieldType, place: int, heard: Heard) -> Iterator[tuple[int, Heard]]:
    """A part of any of its classes; an optional one may be absent."""
    for kind in held.models:
        yield from part_lines(hearer, address, place, heard.knowing(address, kind))
    absent = heard.valued(address, None) if held.optional else None
    if absent is not None:
        yield place, absent


def _rope(hearer: Hearer, address: str, name: str, place: int, heard: Heard) -> Iterator[tuple[int, Heard]]:
    """The sentence of a string inside an entity."""
    kind = CONNECTIONS["tendon"]
    trail = Rigged(address, ropes_of(heard.kind(address, Part))[name])
    for told in kind.hear(f"{address}.{name}", place, heard, hearer, trail):
        yield place + 1, told.heard


def _saying(hearer: Hearer, saying: Saying, address: str, place: int, heard: Heard) -> Iterator[tuple[int, Heard]]:
    if isinstance(saying, Each):
        yield from _each(hearer, saying, address, place, heard)
        return
    for number, template in enumerate(wordings(saying)):
        for then in hearer.sentence(place, template, address, heard.chose(number)):
            yield place + 1, then
    for then in _unsaid(wordings(saying)[0], address, heard):
        yield place, then


def _each(hearer: Hearer, saying: Each, address: str, place: int, heard: Heard) -> Iterator[tuple[int, Heard]]:
    """A sentence for each member; like bodies from three on are a table; nothing where there is none."""
    field = f"{address}.{saying.field}"
    none = heard.counted(field, 0, 0)
    if none is not None:
        yield place, none
    for number, template in enumerate(saying.wordings):
        yield from _members(hearer, template, field, place, heard.chose(number), 0)
    for kind in thing_at(heard, field).models:
        if issubclass(kind, Body):
            yield from hear_table(hearer, field, kind, place, heard.chose(0))  # its wording does not show


def _members(
    hearer: Hearer, template: str, field: str, place: int, heard: Heard, index: int
) -> Iterator[tuple[int, Heard]]:
    """The sentences of the members from `index` on, all in one wording."""
    address = field.rpartition(".")[0]
    if index == MANY:
        return
    for then in hearer.sentence(place, template.replace(".*", f".{index}"), address, heard):
        whole = then.counted(field, index + 1, index + 1)
        if whole is not None:
            yield place + 1, whole
        yield from _members(hearer, template, field, place + 1, then, index + 1)


def _unsaid(template: str, address: str, heard: Heard) -> Iterator[Heard]:
    """What may be so if a line stays unsaid: something absent that it needs, or a number that a word tells."""
    kind = heard.kind(address, Part)
    for path in dict.fromkeys(slot.path for slot in slots(template) if slot.kind == "path" and "*" not in slot.path):
        if path in kind.words:
            continue
        where = f"{address}.{path}"
        held = field_types(kind).get(path)
        if held is not None and held.optional:
            absent = heard.valued(where, None) if where not in heard.letters else None
            if absent is not None:
                yield absent
        elif _by_word(heard, where):
            yield heard


def _by_word(heard: Heard, address: str) -> bool:
    """Whether the introduction of a body has told a number by a word, or still may."""
    owner, _, name = address.rpartition(".")
    for model in thing_at(heard, owner).models:
        if issubclass(model, Body):
            words = [word for word in model.introduced_words() if word.parameter == name]
            return any(address not in heard.values or heard.values[address] in word.special for word in words)
    return False
