"""Division of a text into sentences and tables."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from sim2reason.errors import TextError
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.measures import Measure, join_unit, show_unit
from sim2reason.scenes.dsl.model import field_types
from sim2reason.text.parsing.matcher import Matcher
from sim2reason.text.parsing.parse_state import NUMBER, SYMBOL, ParseState
from sim2reason.text.prose.phrases import LEAD_INS, headings, introduced, shared_start

MAX_CHARACTERS = 20_000
MAX_PIECES = 60

_END = re.compile(r"(?<=\.) ")


def pieces(text: str) -> tuple[str, ...]:
    """Return the sentences, and tables with rows joined by line breaks; TextError if empty or too long."""
    if len(text) > MAX_CHARACTERS:
        raise TextError("text", f"it has {len(text)} characters", f"give at most {MAX_CHARACTERS}")
    found: list[str] = []
    prose: list[str] = []
    rows: list[str] = []
    for line in [*text.splitlines(), ""]:
        if line.startswith("|"):
            found.extend(_sentences(prose))
            prose = []
            rows.append(line.strip())
            continue
        if rows:
            found.append("\n".join(rows))
            rows = []
        prose.append(line)
    found.extend(_sentences(prose))
    if not 1 <= len(found) <= MAX_PIECES:
        raise TextError("text", f"it has {len(found)} sentences", f"give 1 to {MAX_PIECES}")
    return tuple(found)


def _sentences(lines: list[str]) -> list[str]:
    prose = " ".join(" ".join(lines).split())
    return _END.split(prose) if prose else []


def shown(piece: str) -> str:
    """Return a sentence or table, shortened for error messages."""
    return repr(piece if len(piece) <= 120 else f"{piece[:117]}...")


@dataclass(frozen=True, slots=True)
class _Grid:
    """The cells of a table: noun and headings in the first row, letters and numbers below."""

    noun: str
    headings: tuple[str, ...]
    letters: tuple[str, ...]
    cells: tuple[tuple[str, ...], ...]


def parse_table(
    matcher: Matcher, leads: tuple[str, ...], field: str, kind: type[Body], place: int, state: ParseState
) -> Iterator[tuple[int, ParseState]]:
    """Yield the states after parsing a table of bodies: lead-in, sentences on columns with equal numbers, and rows."""
    at = next((i for i in range(place, len(matcher.pieces)) if matcher.pieces[i].startswith("|")), place)
    grid = _grid(matcher.pieces[at]) if at > place else None
    if grid is None or grid.noun not in kind.nouns or state.nouns.get(kind, grid.noun) != grid.noun:
        return
    members = [f"{field}.{index}" for index in range(len(grid.letters))]
    then = state.with_noun(kind, grid.noun).with_count(field, len(members), len(members))
    then = _listed(then, kind, members, grid) if then is not None else None
    then = _filled(matcher, then, kind, members, grid) if then is not None else None
    for piece in matcher.pieces[place + 1 : at]:
        then = _agreed(matcher, piece, kind, members, then) if then is not None else None
    if then is None:
        return
    shown = [name for name, heading in headings(kind).items() if heading in grid.headings]
    for number, lead in enumerate(leads or LEAD_INS):
        template = introduced(lead, grid.noun, kind, shown)
        for told in matcher.sentence(place, template, field.rpartition(".")[0], then.with_choice(number)):
            matcher.reach = max(matcher.reach, at + 1)
            yield at + 1, told


def _grid(piece: str) -> _Grid | None:
    """Return the noun, headings, letters and numbers of a table; None if its rows have different lengths."""
    rows = [[cell.strip() for cell in row.strip("|").split("|")] for row in piece.split("\n")]
    head = rows[0]
    if len(rows) < 3 or rows[1] != ["---"] * len(head) or any(len(row) != len(head) for row in rows):
        return None
    body = rows[2:]
    cells = tuple(tuple(row[1:]) for row in body)
    return _Grid(head[0], tuple(head[1:]), tuple(row[0] for row in body), cells)


def _listed(state: ParseState, kind: type[Body], members: list[str], grid: _Grid) -> ParseState | None:
    """Return the state with the bodies of a table's rows introduced; None if their letters are not the next ones."""
    if list(grid.letters) != state.next_letters(kind, len(members)):
        return None
    for address, letter in zip(members, grid.letters, strict=True):
        state = state.introduced(address, kind, letter)
    return state


def _filled(
    matcher: Matcher, state: ParseState, kind: type[Body], members: list[str], grid: _Grid
) -> ParseState | None:
    """Return the state with the numbers of all table cells; None if a cell is invalid or contradicts the state."""
    columns = {heading: name for name, heading in headings(kind).items()}
    found: ParseState | None = state
    for address, row in zip(members, grid.cells, strict=True):
        for heading, cell in zip(grid.headings, row, strict=True):
            name = columns.get(heading, "")
            value = _cell_value(matcher, cell, field_types(kind)[name].measure) if name else None
            found = found.with_value(f"{address}.{name}", value) if found is not None and value is not None else None
    return found


def _cell_value(matcher: Matcher, cell: str, measure: Measure | None) -> float | str | None:
    """Return the value of a cell: a symbol, the number it stands for, or a number in the heading's unit."""
    unit = measure.unit if measure is not None else ""
    if symbol := SYMBOL.fullmatch(cell):
        if symbol[1] not in matcher.given:
            return cell
        digits = matcher.given[symbol[1]].removesuffix(join_unit("", unit))
    else:
        digits = cell.removesuffix(show_unit("deg")) if unit == "deg" else cell
    return float(digits.replace("\N{MINUS SIGN}", "-")) if NUMBER.fullmatch(digits) else None


def _agreed(matcher: Matcher, piece: str, kind: type[Body], members: list[str], state: ParseState) -> ParseState | None:
    """Return the state after a sentence beside a table that states a number common to all rows."""
    for name in headings(kind):
        start, measure = matcher.literal(piece, 0, shared_start(kind, name)), field_types(kind)[name].measure
        if start is None or measure is None:
            continue
        for end, then in matcher.number(piece, start, f"{members[0]}.{name}", measure, state):
            if piece[end:] == ".":
                return then.shared(members, [name])
    return None
