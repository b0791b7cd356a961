"""Names for what a text finds: each is given to one value only."""

from collections.abc import Mapping
from itertools import chain

from sim2reason.grading.tokens import canonical
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.writing.subscripts import marked, numbered, primed

MOST_PRIMES = 3


class FreshNames:
    """The names that are taken, and those that are still free."""

    def __init__(self, called: Mapping[str, str] | None = None) -> None:
        """Nothing is taken; `called` are the names of the text by those that they would have."""
        self._called = called
        self._taken: set[str] = set()

    def reserve(self, *names: str) -> None:
        """Keep names from being given to something else."""
        self._taken.update(map(canonical, names))

    def fresh(self, base: str, mark: str = "") -> Symbol:
        """A name that nothing has yet: the base with a subscript, and a number where that is taken."""
        name = marked(base, mark)
        return self._take(next(each for each in chain([name], numbered(name)) if self._is_free(each)))

    def after(self, base: str, mark: str = "") -> Symbol:
        """A name for a value just after an impact: v' after the first one, v'' after the second, then by numbers."""
        name = marked(base, mark)
        names = [primed(name, primes) for primes in range(1, MOST_PRIMES + 1)]
        return self._take(next(each for each in chain(names, numbered(names[0])) if self._is_free(each)))

    def _is_free(self, name: str) -> bool:
        return canonical(name) not in self._taken

    def _take(self, name: str) -> Symbol:
        self._taken.add(canonical(name))
        return Symbol((self._called or {}).get(name, name))
