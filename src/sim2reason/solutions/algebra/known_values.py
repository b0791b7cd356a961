"""Formulas with numbers in place of known symbols, for evaluation at many values of one unknown."""

from collections.abc import Mapping

from sim2reason.solutions.algebra.evaluated import Chain, NumericFormula
from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Quotient, Sum, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Call, Power, Root


def with_known_values(chain: Chain, at: Mapping[str, float], unknown: str) -> Chain:
    """Return a chain of formulas with numbers in place of all parts that do not contain an unknown.

    At any value of the unknown it has exactly the value of the original chain, rounding errors included.

    Raises:
        ValueError, ArithmeticError: a part without the unknown is undefined.
    """
    known, opened, formulas = {**at}, {unknown}, list[tuple[str, Expression]]()
    for name, formula in chain.formulas:
        plain = _plain(formula, known, opened)
        if isinstance(plain, Number):
            known[name] = plain.x
            opened.discard(name)
        else:
            opened.add(name)
        if not isinstance(plain, Number) or name == chain.formulas[-1][0]:
            formulas.append((name, plain))
    return Chain(tuple(formulas))


def _plain(expression: Expression, at: Mapping[str, float], opened: set[str]) -> Expression:
    """Return a formula with numbers in place of its parts without the symbols in `opened`."""
    match expression:
        case Number():
            return expression
        case Symbol(name):
            return expression if name in opened else Number(at[name])
        case NumericFormula(inner):
            return _plain(inner, at, opened)
        case Sum() | Product() | Quotient() | Power() | Root() | Absolute() | Call():
            parts = tuple(_plain(part, at, opened) for part in expression.parts)
            plain = _rebuilt(expression, parts)
            known = all(isinstance(part, Number) for part in parts)
        case _:
            plain, known = expression, opened.isdisjoint(expression.symbols())
    if not known:
        return plain
    value = plain.value(at)
    return plain if isinstance(value, complex) else Number(value)


def _rebuilt(expression: Expression, parts: tuple[Expression, ...]) -> Expression:
    """Return the same operation on other parts, without the simplifications that would change rounding errors."""
    match expression:
        case Sum():
            return Sum(parts)
        case Product():
            return Product(parts)
        case Quotient():
            return Quotient(parts[0], parts[1])
        case Power(_, exponent):
            return Power(parts[0], exponent)
        case Call(function, _):
            return Call(function, parts[0])
        case _:
            return expression.built_of(parts)
