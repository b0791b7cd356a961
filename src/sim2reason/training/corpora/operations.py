"""Arithmetic solutions: one operation after another, short enough for a small model to learn.

    a=2/3*sin44*9.8=4.54; v=*0.5=2.27; p=6.1*2.27=13.8

Each line of a worked solution that gives a name its value is followed back from the answer; sums, products and
functions are worked out one at a time, with three digits. As on a pocket calculator, an operation without its first
number goes on from the result before it. The answer follows in a box, on a line of its own.
"""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from math import degrees
from typing import Final

from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Quotient, Sum, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Call, Pi, Power, Root
from sim2reason.solutions.algebra.rounded_numbers import rounded_latex, simple_fraction
from sim2reason.solutions.solution import CHECKS, Solution

__all__ = ["ARITHMETIC_DIGITS", "Definitions", "arithmetic", "definitions", "format_number", "given_values"]

ARITHMETIC_DIGITS: Final = 3
ANGULAR: Final = frozenset({"sin", "cos", "tan"})
MAX_POWER: Final = 4
MAX_PLAIN_NUMBER: Final = 1e4
UNWRITTEN: Final = re.compile(r"text|[\\_{},]")  # of LaTeX in a name
OPERATORS: Final = frozenset("+*/")  # a minus sign could also be that of a number

Definitions = Mapping[str, Expression]
"""What each name that the answer needs is defined by, in the order in which they are worked out."""


class UnwrittenError(Exception):
    """An error for a formula that cannot be written as arithmetic operations, such as a numerical root."""


def definitions(solution: Solution) -> Definitions:
    """Return the formulas that lead from the given numbers to the answer, in order; empty if there are none."""
    known = given_values(solution)
    formulas: dict[str, Expression] = {}
    for relation in solution.relations:
        name = relation.left.latex()
        if (
            isinstance(relation.left, Symbol)
            and relation.role not in ("given", *CHECKS)
            and name not in known
            and name in solution.values
            and all(symbol in known or symbol in formulas for symbol in relation.right.symbols())
        ):
            formulas.setdefault(name, relation.right)
    needed = set[str]()
    for name in reversed([*formulas]):
        if name == solution.goal or name in needed:
            needed.update((name, *formulas[name].symbols()))
    return {name: formula for name, formula in formulas.items() if name in needed} if solution.goal in formulas else {}


def arithmetic(solution: Solution, slip: Callable[[Definitions], Definitions] = lambda mapping: mapping) -> str:
    """Return a solution as arithmetic operations with the boxed answer; empty if a formula has no such form.

    `slip` may replace formulas by wrong ones, whose consequences are computed consistently.
    """
    if not solution.derived or not solution.values.get(solution.goal):
        return ""
    formulas = slip(definitions(solution))
    if solution.goal not in formulas:
        return ""
    stated = given_values(solution)
    written = _Written({name: _Operand(f"{value:.6g}", value) for name, value in stated.items()})
    try:
        for name, formula in formulas.items():
            written.define(name, formula)
    except (UnwrittenError, ArithmeticError, ValueError):
        return ""
    assert solution.answer is not None
    answer = written.values[solution.goal].value * (solution.answer / solution.values[solution.goal])
    return f"{'; '.join(written.steps)}\n\\boxed{{{format_number(answer)}}}"


def given_values(solution: Solution) -> dict[str, float]:
    """Return the numbers that a problem states, by symbol."""
    return {
        relation.left.latex(): solution.values[relation.left.latex()]
        for relation in solution.relations
        if relation.role == "given" and relation.left.latex() in solution.values
    }


def format_number(value: float) -> str:
    """Return a number with three digits, without LaTeX; from ten thousand on with a power of ten."""
    if abs(value) >= MAX_PLAIN_NUMBER:
        return f"{value:.{ARITHMETIC_DIGITS - 1}e}".replace("e+0", "e").replace("e+", "e")
    return rounded_latex(value, ARITHMETIC_DIGITS).replace(r" \times 10^{", "e").rstrip("}")


@dataclass(frozen=True, slots=True)
class _Operand:
    """A number in an arithmetic operation, with the text in which it is written."""

    text: str
    value: float


def _constant(value: float) -> _Operand:
    """Return a pure number, as a fraction if it is a simple one."""
    fraction = simple_fraction(value)
    return _rounded(value) if fraction is None else _Operand(str(fraction), value)


def _rounded(value: float) -> _Operand:
    text = format_number(value)
    return _Operand(text, float(text))


@dataclass
class _Written:
    """An arithmetic solution in progress: the operations written so far, and their results by name."""

    values: dict[str, _Operand]
    steps: list[str] = field(default_factory=list[str])
    _done: dict[str, _Operand] = field(default_factory=dict[str, _Operand])
    _last: str = "nothing yet"  # the result of the last operation

    def define(self, name: str, formula: Expression) -> None:
        """Write the operations that evaluate a formula; the last operation gives the result its name."""
        before = len(self.steps)
        operand = self._operand(formula)
        plain = UNWRITTEN.sub("", name)
        if len(self.steps) == before:
            self.steps.append(f"{plain}={operand.text}")
        else:
            self.steps[-1] = f"{plain}={self.steps[-1]}"
        self.values[name] = operand

    def _operand(self, held: Expression) -> _Operand:
        match held:
            case Number() | Pi():
                return _constant(held.value({}).real)
            case Symbol(name):
                return self.values[name]
            case Sum(terms):
                return self._sum([self._operand(term) for term in terms])
            case Product(factors):
                return self._product(factors)
            case Quotient(above, below):
                return self._quotient(above, below)
            case _:
                return self._function(held)

    def _step(self, text: str, value: float) -> _Operand:
        """Return the result of an operation; write the operation unless the same one was written before."""
        if text not in self._done:
            self._done[text] = _rounded(value)
            operation = text.removeprefix(self._last)
            self.steps.append(f"{operation if operation[0] in OPERATORS else text}={self._done[text].text}")
            self._last = self._done[text].text
        return self._done[text]

    def _sum(self, terms: list[_Operand]) -> _Operand:
        terms = sorted(terms, key=lambda term: term.text.startswith("-"))
        total = terms[0]
        for term in terms[1:]:
            sign = "" if term.text.startswith("-") else "+"
            total = self._step(f"{total.text}{sign}{term.text}", total.value + term.value)
        return total

    def _product(self, factors: tuple[Expression, ...]) -> _Operand:
        """Return a product; its numbers and functions, such as sin44, are multiplied in one operation with a factor."""
        single = [part for factor in factors for part in _repeated(factor)]
        constants = [factor for factor in single if isinstance(factor, Number | Pi | Call)]
        others = [factor for factor in single if factor not in constants]
        if [*constants] == [Number(-1.0)] and others:
            first, *rest = (self._operand(factor) for factor in others)
            negative = first.text[1:] if first.text.startswith("-") else f"-{first.text}"
            return self._multiplied([_Operand(negative, -first.value)], rest)
        texts = [self._inline(factor) for factor in constants]
        first, *rest = [*(self._operand(factor) for factor in others)] or [None]
        return self._multiplied([*texts, *([first] if first else [])], [each for each in rest if each])

    def _multiplied(self, together: list[_Operand], rest: list[_Operand]) -> _Operand:
        product = together[0]
        if len(together) > 1:
            value = 1.0
            for each in together:
                value *= each.value
            product = self._step("*".join(each.text for each in together), value)
        for each in rest:
            product = self._step(f"{product.text}*{each.text}", product.value * each.value)
        return product

    def _inline(self, held: Expression) -> _Operand:
        """Return a function written inside a product, as in 9.8*sin44."""
        if isinstance(held, Call):
            return self._called(held)
        return self._operand(held)

    def _called(self, held: Call) -> _Operand:
        inside = self._operand(held.argument)
        text = f"{degrees(inside.value):.4g}" if held.function in ANGULAR else inside.text
        return _Operand(f"{held.function}{text}", float(held.value(_values(self.values)).real))

    def _quotient(self, above: Expression, below: Expression) -> _Operand:
        over, under = self._operand(above), self._operand(below)
        return self._step(f"{over.text}/{under.text}", over.value / under.value)

    def _function(self, held: Expression) -> _Operand:
        match held:
            case Power(base, exponent) if 0 < exponent <= MAX_POWER:
                return self._product((base,) * exponent)
            case Root(inside):
                under = self._operand(inside)
                return self._step(f"sqrt{under.text}", under.value**0.5)
            case Absolute(inside):
                operand = self._operand(inside)
                return _Operand(operand.text.removeprefix("-"), abs(operand.value))
            case Call():
                operand = self._called(held)
                return self._step(operand.text, operand.value)
            case _:
                raise UnwrittenError


def _repeated(expression: Expression) -> Iterator[Expression]:
    """Yield the factors of a power, one by one."""
    if isinstance(expression, Power) and 0 < expression.exponent <= MAX_POWER and not isinstance(expression.base, Call):
        yield from (expression.base for _ in range(expression.exponent))
    else:
        yield expression


def _values(operands: Mapping[str, _Operand]) -> dict[str, float]:
    return {name: each.value for name, each in operands.items()}
