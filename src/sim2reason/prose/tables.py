"""A table of like bodies: one row each, a column for each number in which they differ."""

from typing import Protocol

from sim2reason.dsl.body import Body
from sim2reason.dsl.measures import show_unit
from sim2reason.dsl.model import field_types
from sim2reason.prose.naming import Names
from sim2reason.prose.phrases import join

LEAD_INS = (
    "the table gives each {noun}'s {columns}.",
    "the table shows the {columns} of each {noun}.",
    "each {noun} has the {columns} that the table gives.",
    "for each {noun} the table lists the {columns}.",
)


class RowWriter(Protocol):
    """What a table needs of whoever writes the text around it."""

    names: Names

    def choose(self, options: tuple[str, ...]) -> str:
        """One of several wordings."""
        ...

    def finish(self, sentence: str) -> str:
        """A rendered sentence with its capital."""
        ...

    def at(self, address: str) -> str:
        """What the text has for an address."""
        ...

    def render(self, template: str, address: str) -> str:
        """A template of the part at an address."""
        ...


def headings(kind: type[Body]) -> dict[str, str]:
    """The heading of every spoken column, by field: its symbol and unit."""
    found: dict[str, str] = {}
    for name, held in field_types(kind).items():
        if held.measure is not None and not held.hidden:
            symbol = kind.symbols.get(name, held.measure.symbol)
            unit = show_unit(held.measure.unit)
            found[name] = f"${symbol}$" + (f" ({unit})" if unit else "")
    return found


def table(writer: RowWriter, leads: tuple[str, ...], where: list[str], members: tuple[Body, ...]) -> list[str]:
    """A lead-in, one of `leads`, the columns that agree in sentences, the others as Markdown rows."""
    noun, kind = writer.names.noun(members[0]), type(members[0])
    columns = headings(kind)
    shared = [name for name in columns if _agrees(writer, name, where, members)]
    shown = [name for name in columns if name not in shared]
    owner = where[0].rpartition(".")[0].rpartition(".")[0]
    lead = writer.finish(writer.render(introduced(writer.choose(leads or LEAD_INS), noun, kind, shown), owner))
    said = [f"{shared_start(kind, name)}{writer.at(f'{where[0]}.{name}')}." for name in shared]
    rows: list[tuple[str, ...]] = [(noun, *(columns[name] for name in shown))]
    rows.append(tuple("---" for _ in rows[0]))
    for address in where:
        cells = [_cell(writer.at(f"{address}.{name}")) for name in shown]
        rows.append((writer.names.letters.get(address, ""), *cells))
    drawn = "\n".join("| " + " | ".join(row) + " |" for row in rows)
    return [lead, *said, f"\n\n{drawn}\n\n"]


def _agrees(writer: RowWriter, name: str, where: list[str], members: tuple[Body, ...]) -> bool:
    """Whether a column has the same number in all rows, and none of them alone is an unknown."""
    said = {writer.at(f"{address}.{name}") for address in where}
    return len({getattr(member, name) for member in members}) == 1 and len(said) in (1, len(where))


def introduced(lead: str, noun: str, kind: type[Body], shown: list[str]) -> str:
    """A lead-in with the noun of the rows and the names of the columns."""
    columns = join(list(dict.fromkeys(_name(kind, name) for name in shown)))
    return lead.replace("{noun}", noun).replace("{columns}", columns)


def shared_start(kind: type[Body], name: str) -> str:
    """How the sentence on a column that agrees begins, up to the number: by name, or by symbol if two share it."""
    names = [_name(kind, other) for other in headings(kind)]
    mine = _name(kind, name)
    return f"Each has the {mine} " if names.count(mine) == 1 else f"Each has {headings(kind)[name].split(' (')[0]} = "


def _name(kind: type[Body], name: str) -> str:
    measure = field_types(kind)[name].measure
    return measure.name if measure is not None else name


def _cell(value: str) -> str:
    """A number without its unit, which the heading has."""
    return value.split(" ", maxsplit=1)[0]
