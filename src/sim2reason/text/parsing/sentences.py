"""Sentences and tables of a text: division, and the proof that the parsed scene reproduces them.

In the comparison trailing zeros of decimals and SI prefixes are ignored: *1.20 km* equals *1.2 km* and *1200 m*.
"""

import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal

import numpy as np

from sim2reason.errors import TextError
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.entity import Part
from sim2reason.scenes.dsl.measures import Measure, join_unit, show_unit
from sim2reason.scenes.dsl.model import Parameter, field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import Each, PartLines, Saying, Topic, line_topic
from sim2reason.scenes.dsl.units import UnitError, to_coherent_unit
from sim2reason.text.parsing.matcher import NONE_GIVEN, Matcher
from sim2reason.text.parsing.parse_state import NUMBER, SYMBOL, ParseState
from sim2reason.text.prose.closings import Closing, closings
from sim2reason.text.prose.description import Description
from sim2reason.text.prose.phrases import (
    LEAD_INS,
    headings,
    letters,
    sentence_templates,
    shared_start,
    write_table_lead_in,
)
from sim2reason.text.prose.voices import Voice, numeric, symbolic, symbolic_at
from sim2reason.text.prose.writer import Writer

MAX_CHARACTERS = 20_000
MAX_PIECES = 60

_END = re.compile(r"(?<=\.) ")


def split_pieces(text: str) -> tuple[str, ...]:
    """Return the sentences, and tables with rows joined by line breaks; TextError if empty or too long."""
    if len(text) > MAX_CHARACTERS:
        raise TextError("text", f"it has {len(text)} characters", f"give at most {MAX_CHARACTERS}")
    parts: list[str] = []
    prose: list[str] = []
    rows: list[str] = []
    for line in [*text.splitlines(), ""]:
        if line.startswith("|"):
            parts.extend(_sentences(prose))
            prose = []
            rows.append(line.strip())
            continue
        if rows:
            parts.append("\n".join(rows))
            rows = []
        prose.append(line)
    parts.extend(_sentences(prose))
    if not 1 <= len(parts) <= MAX_PIECES:
        raise TextError("text", f"it has {len(parts)} sentences", f"give 1 to {MAX_PIECES}")
    return tuple(parts)


def _sentences(lines: list[str]) -> list[str]:
    prose = " ".join(" ".join(lines).split())
    return _END.split(prose) if prose else []


def quoted(piece: str) -> str:
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
    matcher: Matcher, leads: tuple[str, ...], field: str, kind: type[Body], position: int, state: ParseState
) -> Iterator[tuple[int, ParseState]]:
    """Yield the states after parsing a table of bodies: lead-in, sentences on columns with equal numbers, and rows."""
    at = next((i for i in range(position, len(matcher.pieces)) if matcher.pieces[i].startswith("|")), position)
    grid = _grid(matcher.pieces[at]) if at > position else None
    if grid is None or grid.noun not in kind.nouns or state.nouns.get(kind, grid.noun) != grid.noun:
        return
    members = [f"{field}.{index}" for index in range(len(grid.letters))]
    then = state.with_noun(kind, grid.noun).with_count(field, len(members), len(members))
    then = _listed(then, kind, members, grid) if then is not None else None
    then = _filled(matcher, then, kind, members, grid) if then is not None else None
    for piece in matcher.pieces[position + 1 : at]:
        then = _agreed(matcher, piece, kind, members, then) if then is not None else None
    if then is None:
        return
    shown = [name for name, heading in headings(kind).items() if heading in grid.headings]
    for number, lead in enumerate(leads or LEAD_INS):
        template = write_table_lead_in(lead, grid.noun, kind, shown)
        for next_state in matcher.sentence(position, template, field.rpartition(".")[0], then.with_choice(number)):
            matcher.reach = max(matcher.reach, at + 1)
            yield at + 1, next_state


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
    filled: ParseState | None = state
    for address, row in zip(members, grid.cells, strict=True):
        for heading, cell in zip(grid.headings, row, strict=True):
            name = columns.get(heading, "")
            value = _cell_value(matcher, cell, field_types(kind)[name].measure) if name else None
            filled = filled.with_value(f"{address}.{name}", value) if filled is not None and value is not None else None
    return filled


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


_ZEROS = re.compile(r"(?<=\d)\.0+(?![\d])|(?<=\.)(\d*[1-9])0+(?!\d)")
_MEASURED = re.compile(r"(\d+(?:\.\d+)?) ([A-Za-zµΩ²³·]+(?:/[A-Za-zµΩ²³·]+)?)")


class MissingClosingError(TextError):
    """An error for a text that omits a closing sentence that its scene needs."""

    def __init__(self, name: str) -> None:
        """Store the name of the missing closing sentence, such as *rest* for a start from rest."""
        self.name = name
        super().__init__("text", f"nothing is said of {name!r}, which matters here", "say it at the end")

    def __reduce__(self) -> tuple[type[TextError], tuple[str, str, str]]:
        """Pickle the error without the name of the closing sentence, which only the parser uses."""
        return TextError, (self.place, self.problem, self.remedy)


class ScriptedWriter(Writer):
    """A writer that repeats the wordings of a parsed text, and then takes the first wording of each sentence."""

    def __init__(
        self,
        scene: Scene,
        state: ParseState,
        given: Mapping[str, str] = NONE_GIVEN,
        order: tuple[str, ...] = (),
        without: Collection[Topic] = (),
    ) -> None:
        """Store the wordings of all sentences in the parsed text, by their indices.

        Symbols in `given` are written as symbols. Sentences on an initial state that the text omits are skipped.
        """
        super().__init__(scene, state.names, np.random.default_rng(0), _voice(given, state.unknowns), order, without)
        self._script, self._state = iter(state.script), state

    def choose(self, options: tuple[str, ...]) -> str:
        """Return the wording that the parsed text uses for the next sentence."""
        return options[min(next(self._script, 0), len(options) - 1)]

    def pass_over(self, options: tuple[str, ...]) -> None:
        """Do nothing: an omitted sentence has no wording in the parsed text."""

    def leaves_out(self, closing: Closing) -> bool:
        """Return whether to omit a closing sentence; one on the start, only if the text omits the initial motion."""
        if closing.role == "start":
            return closing.name not in self._state.closings and _unstated_start(closing, self._state)
        return super().leaves_out(closing)

    def _say(self, saying: Saying, part: Part, address: str) -> list[str]:
        if isinstance(saying, PartLines):
            return super()._say(saying, part, address)
        if isinstance(saying, Each):
            is_stated = bool(getattr(part, saying.field))
        else:
            included = line_topic(saying) not in self._without
            is_stated = included and self.says_line(saying, sentence_templates(saying, part)[0], part)
        return super()._say(saying, part, address) if is_stated else []


def _voice(given: Mapping[str, str], unknown: Collection[str]) -> Voice:
    """Return a voice with numbers, except for symbols that are defined elsewhere or unknown."""

    def said(parameter: Parameter, symbol: str) -> str:
        return (symbolic if symbol in given or parameter.path in unknown else numeric)(parameter, symbol)

    return said if given else symbolic_at(*unknown)


def missing_closings(scene: Scene, state: ParseState) -> list[str]:
    """Return the names of the closing sentences that the text omits although every answer depends on them."""
    lacking = [closing for closing in closings(scene) if closing.name not in state.closings]
    return [closing.name for closing in lacking if not closing.topic and not _unstated_start(closing, state)]


def _plain(sentence: str) -> str:
    """Return a sentence without trailing zeros of decimals and without SI prefixes of units."""
    return _ZEROS.sub(r"\1", _MEASURED.sub(_without_prefix, sentence))


def _without_prefix(measured: re.Match[str]) -> str:
    try:
        unit, size = to_coherent_unit(measured[2])
    except UnitError:
        return measured[0]
    return f"{(Decimal(measured[1]) * size):f} {unit}"


def _unstated_start(closing: Closing, state: ParseState) -> bool:
    """Return whether a closing sentence states the start from rest, in a text that omits the initial motion."""
    return closing.role == "start" and "start" in state.without


def prove(scene: Scene, state: ParseState, text: tuple[str, ...], given: Mapping[str, str] = NONE_GIVEN) -> None:
    """Raise TextError, with the expected sentence, unless the scene renders as this text."""
    needed: dict[str, Topic | None] = {closing.name: closing.topic for closing in closings(scene)}
    if lacking := missing_closings(scene, state):
        raise MissingClosingError(lacking[0])
    for name in state.closings:
        if name not in needed:
            raise TextError("text", f"it speaks of {name!r}, which does not matter here", "leave it out")
    left_out: set[Topic] = {topic for name, topic in needed.items() if topic and name not in state.closings}
    without = state.without | left_out
    order: tuple[str, ...] = ()
    if given:
        first = ScriptedWriter(scene, state, without=without)
        first.sentences()
        order = tuple(first.told)
    echo = ScriptedWriter(scene, state, given, order, without)
    description = Description(scene, tuple(echo.sentences()), state.names, {})
    if spare := given.keys() - {echo.symbols.get(path) for path in echo.told}:
        raise TextError("text", f"it gives ${min(spare)}$, of which it does not speak", "leave it out")
    again = split_pieces(description.text)
    for number, (mine, theirs) in enumerate(zip(again, text, strict=False), start=1):
        if mine != theirs and _plain(mine) != _plain(theirs):
            raise TextError(f"sentence {number}", f"{quoted(theirs)} does not fit", f"say {quoted(mine)}")
    if len(again) != len(text):
        count = f"it has {len(text)} sentences where the scene needs {len(again)}"
        raise TextError("text", count, "say each fact once")
    if letters(echo.introduced, scene.bodies) != dict(state.names.letters):
        raise TextError("text", "its letters are not in the order of first mention", "begin each series with its first")
