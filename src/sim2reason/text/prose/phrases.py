"""Names, phrases and tables in the text of a scene."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol, cast

from sim2reason.scenes.dsl.addresses import lookup
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.measures import show_unit
from sim2reason.scenes.dsl.model import Model, Parameter, field_types
from sim2reason.scenes.dsl.template import Saying, Wordings, wordings

_ENDS = {"first": 0, "last": -1}


BODIES = "bodies"
"""The plural of several that are not all of one kind."""


def same_class(members: tuple[object, ...]) -> bool:
    """Return whether all objects have the same class."""
    return len({type(member) for member in members}) == 1


def paragraphs(sentences: Iterable[str]) -> str:
    """Join sentences into one paragraph; tables keep lines of their own."""
    return " ".join(sentences).replace(" \n\n", "\n\n").replace("\n\n ", "\n\n").strip()


def join(items: list[str], last: str = " and ") -> str:
    """Join items with commas and a conjunction: *A, B and C*."""
    return items[0] if len(items) == 1 else ", ".join(items[:-1]) + last + items[-1]


def introduce_another(text: str) -> str:
    """Return the phrase that introduces a second body of a class: *another block*."""
    for article in ("a ", "an "):
        if text.startswith(article):
            return "another " + text[len(article) :]
    return text


def introductions(kind: type[Body], *, again: bool) -> tuple[str, ...]:
    """Return the templates that introduce a body without a letter; `again` if its noun occurred before."""
    return (kind.again or tuple(map(introduce_another, kind.lone))) if again else kind.lone


def canonical_path(part: Model, path: str) -> str:
    """Return the path of a list member with an index in place of `first` or `last`, as in `blocks.0.mass`."""
    steps = path.replace(".first.", ".0.").split(".")
    if steps[-1] in ("first", "last"):
        members = lookup(part, ".".join(steps[:-1]))
        steps[-1] = "0" if steps[-1] == "first" else str(len(members) - 1)
    return ".".join(steps)


def sentence_templates(saying: Saying, part: Any) -> tuple[str, ...]:
    """Return the templates of a sentence about a part; these may depend on whether an optional number has a value."""
    given = isinstance(saying, Wordings) and saying.given
    return wordings(saying, given=bool(given) and referenced_object(part, str(given)) is not None)


def referenced_object(part: Any, path: str) -> Any:
    """Return the value at a slot's path from a part, or the body whose word the slot names; None if absent."""
    value: Any = part
    for step in path.split("."):
        if value is None:
            return None
        if isinstance(value, tuple):
            value = cast("tuple[Any, ...]", value)[_ENDS[step] if step in _ENDS else int(step)]
        elif isinstance(value, Body) and step in value.words:
            return value
        else:
            value = getattr(value, step)
    return value


@dataclass(frozen=True)
class Names:
    """The letters of bodies (empty for a single one), and the noun of each class in the text."""

    letters: Mapping[str, str] = field(default_factory=dict[str, str])
    nouns: Mapping[type[Body], str] = field(default_factory=dict[type[Body], str])

    def noun(self, body: Body) -> str:
        """Return the noun for a body in this text."""
        return self.nouns.get(type(body), body.nouns[0])

    def mention(self, address: str, body: Body, *, full: bool = True) -> str:
        """Return the name of an introduced body: *the block*, *block A*, or *A* if not `full`."""
        return body_name(self.noun(body), self.letters.get(address, ""), full=full)


def body_name(noun: str, letter: str, *, full: bool) -> str:
    """Return the name of a body from its noun and letter; a digit alone would be mistaken for a number."""
    if not letter:
        return f"the {noun}"
    return f"{noun} {letter}" if full or letter[0].isdigit() else letter


def join_body_names(noun: str, letters: list[str], *, full: bool) -> str:
    """Return the names of several bodies with one noun: *blocks A and B*, or *A and B* if not `full`."""
    plural = f"{noun}s " if full or letters[0][:1].isdigit() else ""
    return plural + join(letters)


def letters(order: Iterable[str], bodies: Mapping[str, Body]) -> dict[str, str]:
    """Return letters by address in the order of first mention; a single body of its series has none.

    Classes with the same series of letters share it.
    """
    series: dict[str, list[str]] = {}
    for address in order:
        if bodies[address].letters:
            series.setdefault(bodies[address].letters, []).append(address)
    letters_by_address: dict[str, str] = {}
    for alphabet, members in series.items():
        if len(members) > 1:
            letters_by_address.update({address: letter_at(alphabet, index) for index, address in enumerate(members)})
    return letters_by_address


def letter_at(alphabet: str, index: int) -> str:
    """Return the letter at an index of a series; after the last letter a digit is added."""
    turn, position = divmod(index, len(alphabet))
    return alphabet[position] + (str(turn + 1) if turn else "")


def symbols(parameters: Iterable[Parameter], bodies: Mapping[str, Body], names: Names) -> dict[str, str]:
    """Return a LaTeX symbol for every parameter: m_A if the body has a letter, else m, or m with the noun."""
    wanted: dict[str, list[str]] = {}
    for parameter in parameters:
        owner, _, name = parameter.path.rpartition(".")
        body = bodies.get(owner)
        base = (body.symbols.get(name) if body else None) or parameter.measure.symbol
        letter = names.letters.get(owner, "")
        wanted.setdefault(_subscript(base, letter), []).append(parameter.path)
    symbols_by_path: dict[str, str] = {}
    for symbol, paths in wanted.items():
        for number, path in enumerate(paths, start=1):
            symbols_by_path[path] = symbol if len(paths) == 1 else _subscript(symbol, str(number))
    return symbols_by_path


def _subscript(base: str, mark: str) -> str:
    if not mark:
        return base
    stem, _, inner = base.partition("_")
    inner = inner.strip("{}")
    joined = inner + ("," if inner else "") + mark
    return f"{stem}_{joined}" if len(joined) == 1 else f"{stem}_{{{joined}}}"


LEAD_INS = (
    "the table gives each {noun}'s {columns}.",
    "the table shows the {columns} of each {noun}.",
    "each {noun} has the {columns} that the table gives.",
    "for each {noun} the table lists the {columns}.",
)


class RowWriter(Protocol):
    """The methods of a writer that tables need."""

    names: Names

    def choose(self, options: tuple[str, ...]) -> str:
        """Return one of several wordings."""
        ...

    def finish(self, sentence: str) -> str:
        """Return a rendered sentence with an initial capital."""
        ...

    def at(self, address: str) -> str:
        """Return the text of the value at an address."""
        ...

    def render(self, template: str, address: str) -> str:
        """Render a template of the part at an address."""
        ...


def headings(kind: type[Body]) -> dict[str, str]:
    """Return the headings of all columns, by field: symbol and unit."""
    headings_by_field: dict[str, str] = {}
    for name, field_type in field_types(kind).items():
        if field_type.measure is not None and not field_type.hidden:
            symbol = kind.symbols.get(name, field_type.measure.symbol)
            unit = show_unit(field_type.measure.unit)
            headings_by_field[name] = f"${symbol}$" + (f" ({unit})" if unit else "")
    return headings_by_field


def table(writer: RowWriter, leads: tuple[str, ...], where: list[str], members: tuple[Body, ...]) -> list[str]:
    """Return a table of similar bodies as a lead-in, sentences on columns with equal numbers, and Markdown."""
    noun, kind = writer.names.noun(members[0]), type(members[0])
    columns = headings(kind)
    shared = [name for name in columns if _agrees(writer, name, where, members)]
    shown = [name for name in columns if name not in shared]
    owner = where[0].rpartition(".")[0].rpartition(".")[0]
    lead = writer.finish(writer.render(write_table_lead_in(writer.choose(leads or LEAD_INS), noun, kind, shown), owner))
    sentences = [f"{shared_start(kind, name)}{writer.at(f'{where[0]}.{name}')}." for name in shared]
    rows: list[tuple[str, ...]] = [(noun, *(columns[name] for name in shown))]
    rows.append(tuple("---" for _ in rows[0]))
    for address in where:
        cells = [_cell(writer.at(f"{address}.{name}")) for name in shown]
        rows.append((writer.names.letters.get(address, ""), *cells))
    drawn = "\n".join("| " + " | ".join(row) + " |" for row in rows)
    return [lead, *sentences, f"\n\n{drawn}\n\n"]


def _agrees(writer: RowWriter, name: str, where: list[str], members: tuple[Body, ...]) -> bool:
    """Return whether all rows have the same number in a column (an unknown in all of them counts as the same)."""
    texts = {writer.at(f"{address}.{name}") for address in where}
    return len({getattr(member, name) for member in members}) == 1 and len(texts) in (1, len(where))


def write_table_lead_in(lead: str, noun: str, kind: type[Body], shown: list[str]) -> str:
    """Return a table's lead-in with the noun of the bodies and the names of the columns filled in."""
    columns = join(list(dict.fromkeys(_name(kind, name) for name in shown)))
    return lead.replace("{noun}", noun).replace("{columns}", columns)


def shared_start(kind: type[Body], name: str) -> str:
    """Return the beginning of the sentence that states the common number of a table column, by name or symbol."""
    names = [_name(kind, other) for other in headings(kind)]
    mine = _name(kind, name)
    return f"Each has the {mine} " if names.count(mine) == 1 else f"Each has {headings(kind)[name].split(' (')[0]} = "


def _name(kind: type[Body], name: str) -> str:
    measure = field_types(kind)[name].measure
    return measure.name if measure is not None else name


def _cell(value: str) -> str:
    """Return a number without its unit, which the heading states."""
    return value.split(" ", maxsplit=1)[0]
