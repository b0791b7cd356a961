"""Names in LaTeX with something below them."""

from collections.abc import Iterator
from itertools import count


def subscript(name: str) -> str:
    """What stands below a name, without its braces; empty for nothing."""
    inner = name.partition("_")[2]
    return inner[1:-1] if inner.startswith("{") else inner


def marked(base: str, mark: str) -> str:
    """A name with a subscript, added to the one that it may have."""
    if not mark:
        return base
    inner = subscript(base)
    joined = f"{inner},{mark}" if inner else mark
    stem = base.partition("_")[0]
    return f"{stem}_{joined}" if len(joined) == 1 else f"{stem}_{{{joined}}}"


def split(name: str) -> tuple[str, str]:
    """Return the base of a name and its subscript without braces."""
    base, _, mark = name.partition("_")
    return base, mark[1:-1] if mark.startswith("{") and mark.endswith("}") else mark


def numbered(name: str) -> Iterator[str]:
    """Yield the further names for what a name is taken for: t₁, t₂ for t; m₂, m₃ for m₁; s_{x,2} for s_{x,1}.

    A number alone below a name is followed by the next one, never by a second number.
    """
    base, mark = split(name)
    rest, _, last = mark.rpartition(",")
    counts = last.isdecimal() and not rest.rpartition(",")[2].isdecimal()
    first, mark = (int(last), rest) if counts else (0, mark)
    for number in count(first + 1):
        yield marked(base, f"{mark},{number}" if mark else str(number))


def primed(name: str, primes: int = 1) -> str:
    """Return a name with primes before its subscript."""
    base, mark = split(name)
    return marked(base + "'" * primes, mark)
