"""Splitting of letter runs, such as ``mgh``, into names."""

from functools import lru_cache
from typing import Final

from sim2reason.grading.alphabet import FUNCTIONS, GREEK_NAMES

Pieces = tuple[tuple[str, str], ...]
_SHORT: Final = 24  # letters of the longest runs whose splits are cached


def split(run: str, symbols: frozenset[str] | None) -> Pieces | None:
    """Split letters such as ``mgh`` into known names, the longest first; None if some letter fits no name."""
    return (_split if len(run) <= _SHORT else _split.__wrapped__)(run, symbols)


@lru_cache(maxsize=4096)
def _split(run: str, symbols: frozenset[str] | None) -> Pieces | None:
    pieces: list[tuple[str, str]] = []
    at = 0
    while at < len(run):
        lengths = range(min(12, len(run) - at), 0, -1)
        piece = next((found for n in lengths if (found := _meaning(run[at : at + n], symbols))), None)
        if piece is None:
            return None
        pieces.append(piece)
        at += len(piece[1])
    return tuple(pieces)


def _meaning(name: str, symbols: frozenset[str] | None) -> tuple[str, str] | None:
    if symbols is not None and name in symbols:
        return "symbol", name
    if name in FUNCTIONS:
        return "function", name
    if name in {"pi", "e"}:
        return "constant", name
    if name == "sqrt":
        return "root", name
    is_symbol = symbols is None and (len(name) == 1 or name in GREEK_NAMES)
    return ("symbol", name) if is_symbol else None
