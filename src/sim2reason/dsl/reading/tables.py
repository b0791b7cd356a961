"""Tables of like bodies, read back."""

from collections.abc import Iterator
from dataclasses import dataclass

from sim2reason.dsl.body import Body
from sim2reason.dsl.measures import Measure, show_unit
from sim2reason.dsl.model import field_types
from sim2reason.dsl.reading.heard import Heard
from sim2reason.dsl.reading.hearer import NUMBER, Hearer
from sim2reason.dsl.telling.table import LEAD_INS, headings, shared_start


@dataclass(frozen=True, slots=True)
class _Grid:
    """The cells of a table: the noun and the headings above, letters and numbers below."""

    noun: str
    headings: tuple[str, ...]
    letters: tuple[str, ...]
    cells: tuple[tuple[str, ...], ...]


def hear_table(hearer: Hearer, field: str, kind: type[Body], place: int, heard: Heard) -> Iterator[tuple[int, Heard]]:
    """The members of `field` from sentences on what agrees, a lead-in, and a table of the rest."""
    at = next((i for i in range(place, len(hearer.pieces)) if hearer.pieces[i].startswith("|")), place)
    grid = _grid(hearer.pieces[at]) if at > place else None
    if grid is None or grid.noun not in kind.nouns or heard.nouns.get(kind, grid.noun) != grid.noun:
        return
    members = [f"{field}.{index}" for index in range(len(grid.letters))]
    then = heard.calling(kind, grid.noun).counted(field, len(members), len(members))
    then = _listed(then, kind, members, grid) if then is not None else None
    then = _filled(then, kind, members, grid) if then is not None else None
    for piece in hearer.pieces[place : at - 1]:
        then = _agreed(hearer, piece, kind, members, then) if then is not None else None
    if then is None:
        return
    text = hearer.pieces[at - 1]
    for number, lead in enumerate(LEAD_INS):
        if hearer.literal(text, 0, lead.replace("{plural}", f"{grid.noun}s")) == len(text):
            hearer.reach = max(hearer.reach, at + 1)
            yield at + 1, then.chose(number)


def _grid(piece: str) -> _Grid | None:
    """A table taken apart; None if its rows do not fit together."""
    rows = [[cell.strip() for cell in row.strip("|").split("|")] for row in piece.split("\n")]
    head = rows[0]
    if len(rows) < 3 or rows[1] != ["---"] * len(head) or any(len(row) != len(head) for row in rows):
        return None
    body = rows[2:]
    cells = tuple(tuple(row[1:]) for row in body)
    return _Grid(head[0], tuple(head[1:]), tuple(row[0] for row in body), cells)


def _listed(heard: Heard, kind: type[Body], members: list[str], grid: _Grid) -> Heard | None:
    """The bodies of the rows, if they have the letters that come next."""
    if list(grid.letters) != heard.next_letters(kind, len(members)):
        return None
    for address, letter in zip(members, grid.letters, strict=True):
        heard = heard.introduced(address, kind, letter)
    return heard


def _filled(heard: Heard, kind: type[Body], members: list[str], grid: _Grid) -> Heard | None:
    """The numbers of all cells."""
    columns = {heading: name for name, heading in headings(kind).items()}
    found: Heard | None = heard
    for address, row in zip(members, grid.cells, strict=True):
        for heading, cell in zip(grid.headings, row, strict=True):
            name = columns.get(heading, "")
            value = _number(cell, field_types(kind)[name].measure) if name else None
            found = found.valued(f"{address}.{name}", value) if found is not None and value is not None else None
    return found


def _number(cell: str, measure: Measure | None) -> float | None:
    """A number whose unit stands in the heading, but for the sign of a degree."""
    digits = cell.removesuffix(show_unit("deg")) if measure is not None and measure.unit == "deg" else cell
    return float(digits.replace("\N{MINUS SIGN}", "-")) if NUMBER.fullmatch(digits) else None


def _agreed(hearer: Hearer, piece: str, kind: type[Body], members: list[str], heard: Heard) -> Heard | None:
    """What a sentence on a number that all rows share tells."""
    for name, heading in headings(kind).items():
        start, measure = hearer.literal(piece, 0, shared_start(heading)), field_types(kind)[name].measure
        if start is None or measure is None:
            continue
        for end, then in hearer.number(piece, start, f"{members[0]}.{name}", measure, heard):
            if piece[end:] == ".":
                return _spread(then, members, name)
    return None


def _spread(heard: Heard, members: list[str], name: str) -> Heard | None:
    """The first member's number as that of all."""
    found: Heard | None = heard
    for address in members[1:]:
        found = found.valued(f"{address}.{name}", heard.values[f"{members[0]}.{name}"]) if found is not None else None
    return found
