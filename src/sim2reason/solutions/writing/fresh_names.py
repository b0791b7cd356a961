"""Unused names for the quantities that a solution introduces."""

from collections.abc import Mapping
from itertools import chain

from sim2reason.grading.tokens import canonical
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.writing.subscripts import marked, numbered, primed

MOST_PRIMES = 3


class FreshNames:
    """The allocation of names: each is given to one value only."""

    def __init__(self, called: Mapping[str, str] | None = None) -> None:
        """Start with no name taken; `called` maps names that would be chosen to those of the text."""
        self._called = called
        self._taken: set[str] = set()

    def reserve(self, *names: str) -> None:
        """Keep names from being given to something else."""
        self._taken.update(map(canonical, names))

    def fresh(self, base: str, mark: str = "") -> Symbol:
        """Return an unused name: the base with a subscript, and with a number if that is taken."""
        name = marked(base, mark)
        return self._take(next(each for each in chain([name], numbered(name)) if self._is_free(each)))

    def after(self, base: str, mark: str = "") -> Symbol:
        """Return an unused name for a value just after an impact: v', then v'' and v''', then numbered ones."""
        name = marked(base, mark)
        names = [primed(name, primes) for primes in range(1, MOST_PRIMES + 1)]
        return self._take(next(each for each in chain(names, numbered(names[0])) if self._is_free(each)))

    def _is_free(self, name: str) -> bool:
        return canonical(name) not in self._taken

    def _take(self, name: str) -> Symbol:
        self._taken.add(canonical(name))
        return Symbol((self._called or {}).get(name, name))
