"""How much there is to a formula, however it was put together."""

from sim2reason.solutions.closed_forms.gathering import gathered, parted, symbols_in
from sim2reason.solutions.expressions import Expression, Product, Sum, Symbol
from sim2reason.solutions.functions import Call, Power, Root

SQUARE = 2
LENGTH = Symbol("length")


def size(whole: Expression) -> int:
    """How many symbols it has at least, each as often as it stands there; the size of a vector that is given is one."""
    return symbols_in(parted(gathered(_with_lengths(whole), symbols_in)))


def has_logarithm(held: Expression) -> bool:
    """Whether there is one, as an integral leaves it."""
    return (isinstance(held, Call) and held.function == "ln") or any(map(has_logarithm, held.parts))


def is_vector(held: Expression) -> bool:
    """Whether it is the size of a vector by its components."""
    squares = isinstance(held, Root) and isinstance(held.inside, Sum) and held.inside.terms
    return bool(squares) and all(isinstance(term, Power) and term.exponent == SQUARE for term in squares)


def _with_lengths(held: Expression) -> Expression:
    if is_vector(held) and all(_is_given(part) for term in held.parts[0].parts for part in term.parts):
        return LENGTH
    return held.built_of([_with_lengths(part) for part in held.parts]) if held.parts else held


def _is_given(component: Expression) -> bool:
    """Whether a component is a number of the text, or the difference of two."""
    match component:
        case Sum(terms):
            return all(map(_is_given, terms))
        case Product(factors):
            return symbols_in(component) == 1 and len(factors) <= SQUARE
        case _:
            return isinstance(component, Symbol)
