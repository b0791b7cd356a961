"""A text in pieces: sentences and tables."""

import re

from sim2reason.errors import TextError

MAX_CHARACTERS = 20_000
MAX_PIECES = 60

_END = re.compile(r"(?<=\.) ")


def pieces(text: str) -> tuple[str, ...]:
    """Sentences, and tables as their rows joined by line breaks; TextError for a text that is empty or too long."""
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
    """Return a piece as messages quote it."""
    return repr(piece if len(piece) <= 120 else f"{piece[:117]}...")
