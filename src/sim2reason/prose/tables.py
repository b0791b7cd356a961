"""A table of like bodies: one row each, a column for each number in which they differ."""

from typing import Protocol

from sim2reason.dsl.body import Body
from sim2reason.dsl.measures import show_unit
from sim2reason.dsl.model import field_types
from sim2reason.prose.naming import Names

LEAD_INS = (
    "listed below are the {plural} as they are at t = 0.",
    "at t = 0 the {plural} are as listed here.",
    "the state of the {plural} at t = 0 is this.",
    "the {plural} begin, at t = 0, as follows.",
    "for t = 0 the mass, the position and the velocity of all {plural} are these.",
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


def headings(kind: type[Body]) -> dict[str, str]:
    """The heading of every spoken column, by field: its symbol and unit."""
    found: dict[str, str] = {}
    for name, held in field_types(kind).items():
        if held.measure is not None and not held.hidden:
            symbol = kind.symbols.get(name, held.measure.symbol)
            unit = show_unit(held.measure.unit)
            found[name] = f"${symbol}$" + (f" ({unit})" if unit else "")
    return found


def table(writer: RowWriter, field: str, where: list[str], members: tuple[Body, ...]) -> list[str]:
    """A lead-in, the columns that agree in a sentence, the others as Markdown rows."""
    del field
    noun = writer.names.noun(members[0])
    lead = writer.finish(writer.choose(LEAD_INS).replace("{plural}", f"{noun}s"))
    columns = headings(type(members[0]))
    shared = [name for name in columns if len({getattr(member, name) for member in members}) == 1]
    said = [f"{shared_start(columns[name])}{writer.at(f'{where[0]}.{name}')}." for name in shared]
    rows: list[tuple[str, ...]] = [(noun, *(columns[name] for name in columns if name not in shared))]
    rows.append(tuple("---" for _ in rows[0]))
    for address in where:
        cells = [_cell(writer.at(f"{address}.{name}")) for name in columns if name not in shared]
        rows.append((writer.names.letters.get(address, ""), *cells))
    drawn = "\n".join("| " + " | ".join(row) + " |" for row in rows)
    return [*said, lead, f"\n\n{drawn}\n\n"]


def shared_start(heading: str) -> str:
    """How the sentence on a column that agrees begins, up to the number."""
    return f"All have {heading.split(' (', maxsplit=1)[0]} = "


def _cell(value: str) -> str:
    """A number without its unit, which the heading has."""
    return value.split(" ", maxsplit=1)[0]
