"""LaTeX names with subscripts, unused names, and labels of equations."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import chain, count

from sim2reason.grading.tokens import canonical
from sim2reason.solutions.algebra.expressions import Symbol


def subscript(name: str) -> str:
    """Return the subscript of a name, without its braces; empty for none."""
    inner = name.partition("_")[2]
    return inner[1:-1] if inner.startswith("{") else inner


def with_subscript(base: str, mark: str) -> str:
    """Return a name with a subscript, appended to the one that it may have."""
    if not mark:
        return base
    inner = subscript(base)
    joined = f"{inner},{mark}" if inner else mark
    stem = base.partition("_")[0]
    return f"{stem}_{joined}" if len(joined) == 1 else f"{stem}_{{{joined}}}"


def split_name(name: str) -> tuple[str, str]:
    """Return the base of a name and its subscript without braces."""
    base, _, mark = name.partition("_")
    return base, mark[1:-1] if mark.startswith("{") and mark.endswith("}") else mark


def numbered(name: str) -> Iterator[str]:
    """Yield names with the next numbers as subscripts: t₁, t₂ for t; m₂, m₃ for m₁; s_{x,2} for s_{x,1}.

    A subscript that is a number is incremented; no second number is appended.
    """
    base, mark = split_name(name)
    rest, _, last = mark.rpartition(",")
    counts = last.isdecimal() and not rest.rpartition(",")[2].isdecimal()
    first, mark = (int(last), rest) if counts else (0, mark)
    for number in count(first + 1):
        yield with_subscript(base, f"{mark},{number}" if mark else str(number))


def primed(name: str, primes: int = 1) -> str:
    """Return a name with primes before its subscript."""
    base, mark = split_name(name)
    return with_subscript(base + "'" * primes, mark)


MAX_PRIMES = 3


class NameAllocator:
    """An allocator of names that gives each name to one value only."""

    def __init__(self, called: Mapping[str, str] | None = None) -> None:
        """Start with no name taken; `called` maps chosen names to those of the text."""
        self._called = called
        self._taken: set[str] = set()

    def reserve(self, *names: str) -> None:
        """Exclude names from later allocation."""
        self._taken.update(map(canonical, names))

    def fresh(self, base: str, mark: str = "") -> Symbol:
        """Return an unused name: the base with a subscript, and with a number if that is taken."""
        name = with_subscript(base, mark)
        return self._take(next(each for each in chain([name], numbered(name)) if self._is_free(each)))

    def name_after_impact(self, base: str, mark: str = "") -> Symbol:
        """Return an unused name for a value just after an impact: v', then v'' and v''', then numbered ones."""
        name = with_subscript(base, mark)
        names = [primed(name, primes) for primes in range(1, MAX_PRIMES + 1)]
        return self._take(next(each for each in chain(names, numbered(names[0])) if self._is_free(each)))

    def _is_free(self, name: str) -> bool:
        return canonical(name) not in self._taken

    def _take(self, name: str) -> Symbol:
        self._taken.add(canonical(name))
        return Symbol((self._called or {}).get(name, name))


@dataclass
class Labels:
    """A counter of equation labels."""

    used: int = 0

    def next(self) -> str:
        """Return the next equation label, a number in parentheses such as *(3)*."""
        self.used += 1
        return f"({self.used})"
