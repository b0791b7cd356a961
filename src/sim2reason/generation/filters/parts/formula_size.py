"""Size of a formula, independent of its arrangement."""

from collections.abc import Iterator

from sim2reason.solutions.algebra.expressions import Expression, Product, Sum, Symbol
from sim2reason.solutions.algebra.functions import Call, Root
from sim2reason.solutions.closed_forms.gathering import factor_terms, parted, symbols_in
from sim2reason.solutions.difficulty import is_vector

SQUARE = 2
LENGTH = Symbol("length")


def size(whole: Expression) -> int:
    """Return the number of symbols in a formula, with repetitions; a given initial vector counts as one symbol.

    The magnitude of a given vector counts as one symbol, and so does a repeated root, such as √(k/m) in A ω sin ωt.
    """
    shortest = parted(factor_terms(_with_lengths(whole), symbols_in))
    return symbols_in(shortest) - sum(symbols_in(root) - 1 for root in _again(shortest, set()))


def has_logarithm(held: Expression) -> bool:
    """Return whether a formula contains a logarithm, as from an integral."""
    return (isinstance(held, Call) and held.function == "ln") or any(map(has_logarithm, held.parts))


def _again(held: Expression, seen: set[Expression]) -> Iterator[Expression]:
    """Yield each root, such as √(k/m), that occurs in the formula a second time; roots inside these are omitted."""
    if isinstance(held, Root) and held in seen:
        yield held
        return
    for part in held.parts:
        yield from _again(part, seen)
    if isinstance(held, Root):
        seen.add(held)


def _with_lengths(held: Expression) -> Expression:
    if is_vector(held) and all(_is_given(part) for term in held.parts[0].parts for part in term.parts):
        return LENGTH
    return held.built_of([_with_lengths(part) for part in held.parts]) if held.parts else held


def _is_given(component: Expression) -> bool:
    """Return whether a vector component is a stated number, or the difference of two."""
    match component:
        case Sum(terms):
            return all(map(_is_given, terms))
        case Product(factors):
            return symbols_in(component) == 1 and len(factors) <= SQUARE
        case _:
            return isinstance(component, Symbol)
