"""A row of the tables of what main clauses ask for."""

from collections.abc import Sequence
from typing import NamedTuple


class WantedRow(NamedTuple):
    """Patterns that must all occur, in any order, and the plain main clause with the same meaning."""

    parts: Sequence[str]
    plain: str
    subjects: int = 1
