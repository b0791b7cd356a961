"""A tape records arithmetic once and compiles it to straight-line code.

Arithmetic on symbols creates new symbols. Constants are folded, and repeated expressions are stored once. Every symbol
also has its value at one point, by which a solver may choose pivots. Numbers become parameters of the code: mechanisms
of the same shape share one piece of code.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.vectors import Number
from sim2reason.simulation.engines.exact.code import compiled
from sim2reason.simulation.engines.exact.native import core

Node = tuple[str, int, int]
Code = Callable[[Any], Callable[..., tuple[Any, ...]]]
"""What compiles code for one kind of number."""
ConstantText = str | int
"""A constant: its text if it is part of the code, else its index among all parameters."""
CACHE_SIZE = 128  # number of cached codes, with their nodes
MAX_BRACKET_DEPTH = 12  # largest depth of brackets in a line of code
PLAIN = {0.0: "0.0", 1.0: "1.0", -1.0: "-1.0", 2.0: "2.0", 0.5: "0.5"}  # literals in the code


class PlainSymbol:
    """A number whose value is known only when the generated code runs."""

    __slots__ = ("id", "tape")

    def __init__(self, tape: "PlainTape", number: int) -> None:
        """Create the symbol of the node with the given index."""
        self.tape, self.id = tape, number

    @property
    def value(self) -> float:
        """Return the value at the inputs that `Tape.stand` received last."""
        return self.tape.values[self.id]

    def __add__(self, other: Number) -> Number:
        """Return the sum; adding zero creates no operation."""
        return self if type(other) is float and other == 0.0 else self.tape.commuting("+", self, other)

    __radd__ = __add__

    def __neg__(self) -> "PlainSymbol":
        """Return the negative."""
        return self.tape.node("neg", self.id, -1)

    def __sub__(self, other: Number) -> Number:
        """Return the difference; subtracting zero creates no operation."""
        if type(other) is float and other == 0.0:
            return self
        return self.tape.binary("-", self, other)

    def __rsub__(self, other: Number) -> Number:
        """Return the reversed difference; zero minus the symbol becomes its negative."""
        return -self if type(other) is float and other == 0.0 else self.tape.binary("-", other, self)

    def __mul__(self, other: Number) -> Number:
        """Return the product; factors of zero, one and minus one create no operation."""
        if type(other) is float:
            if other == 0.0:
                return 0.0
            if other == 1.0:
                return self
            if other == -1.0:
                return -self
        return self.tape.commuting("*", self, other)

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> Number:
        """Return the quotient; division by one creates no operation."""
        return self if type(other) is float and other == 1.0 else self.tape.binary("/", self, other)

    def __rtruediv__(self, other: Number) -> Number:
        """Return the reversed quotient; zero divided by the symbol creates no operation."""
        return 0.0 if type(other) is float and other == 0.0 else self.tape.binary("/", other, self)


class PlainTape:
    """A record of arithmetic operations, which also provides the elementary functions of its symbols."""

    def __init__(self, inputs: Sequence[str]) -> None:
        """Start a tape with the named inputs, the arguments of the generated code."""
        self.nodes: list[Node] = []
        self.values: list[float] = []
        self.constants: list[float] = []
        self._known: dict[Node, int] = {}
        self._constant: dict[float, int] = {}
        self.names = list(inputs)
        self._stands = False  # before that, values say nothing
        for number in range(len(inputs)):
            self.node("input", number, -1)
        self.written = 0  # operations, in the code that was written last

    @property
    def inputs(self) -> dict[str, PlainSymbol]:
        """Return the input symbols by name; they are created on each call to avoid a reference cycle."""
        return {name: PlainSymbol(self, number) for number, name in enumerate(self.names)}

    # ---- recording

    def node(self, operation: str, a: int, b: int) -> PlainSymbol:
        """Return the symbol of an operation on earlier nodes, reusing an equal node."""
        key = (operation, a, b)
        number = self._known.get(key)
        if number is None:
            number = len(self.nodes)
            self._known[key] = number
            self.nodes.append(key)
            self.values.append(self._value(key) if self._stands else 0.0)
        return PlainSymbol(self, number)

    def binary(self, operation: str, a: Number, b: Number) -> PlainSymbol:
        """Return the symbol of a binary operation on two numbers, at least one of them a symbol."""
        return self.node(operation, self._id(a), self._id(b))

    def commuting(self, operation: str, a: Number, b: Number) -> PlainSymbol:
        """Return the symbol of a commutative operation, with its operands in canonical order."""
        one, other = self._id(a), self._id(b)
        return self.node(operation, min(one, other), max(one, other))

    def _id(self, number: Number) -> int:
        if isinstance(number, PlainSymbol):
            return number.id
        value = float(number)
        if value not in self._constant:
            self._constant[value] = len(self.constants)
            self.constants.append(value)
        return self.node("constant", self._constant[value], -1).id

    def sqrt(self, x: Number) -> Number:
        """Return the square root of a number or symbol."""
        return self.node("sqrt", x.id, -1) if isinstance(x, PlainSymbol) else math.sqrt(x)

    def sin(self, x: Number) -> Number:
        """Return the sine of a number or symbol."""
        return self.node("sin", x.id, -1) if isinstance(x, PlainSymbol) else math.sin(x)

    def cos(self, x: Number) -> Number:
        """Return the cosine of a number or symbol."""
        return self.node("cos", x.id, -1) if isinstance(x, PlainSymbol) else math.cos(x)

    # ---- values at one point

    def stand(self, inputs: Sequence[float]) -> None:
        """Evaluate every recorded symbol for given input values; a symbol without a value becomes NaN."""
        values, nodes, self._stands = self.values, self.nodes, True
        for number, value in enumerate(inputs):
            values[number] = value
        for number in range(len(self.names), len(nodes)):
            values[number] = self._value(nodes[number])

    def _value(self, node: Node) -> float:  # noqa: PLR0911 - one line for each operation
        operation, a, b = node
        values = self.values
        match operation:
            case "*":
                return values[a] * values[b]
            case "+":
                return values[a] + values[b]
            case "-":
                return values[a] - values[b]
            case "constant":
                return self.constants[a]
            case "neg":
                return -values[a]
            case "/":
                return values[a] / values[b] if values[b] else math.nan
            case "sqrt":
                return math.sqrt(values[a]) if values[a] >= 0.0 else math.nan
            case "sin":
                return math.sin(values[a])
            case _:
                return math.cos(values[a])

    def code(self, outputs: Sequence[Number], guards: Sequence[tuple["PlainSymbol", float]] = ()) -> Code:
        """Return the function that compiles the code of `outputs` for one kind of number (`math` or `numpy`).

        The code is a function (t, y) of the first input and of a sequence with all others. A guard is a symbol whose
        absolute value must not fall below a bound; otherwise the code raises ArithmeticError.
        """
        made, self.written = _generated(self, outputs, guards)
        return made


class ArrayMaths:
    """The functions of arrays (m,): sine and cosine of the C library, since NumPy's vary with the processor."""

    sqrt = np.sqrt

    @staticmethod
    def sin(x: Array) -> Array:
        """Return the sine of angles; NaN for infinite ones."""
        return np.array([math.sin(angle) if math.isfinite(angle) else math.nan for angle in x.tolist()])

    @staticmethod
    def cos(x: Array) -> Array:
        """Return the cosine of angles; NaN for infinite ones."""
        return np.array([math.cos(angle) if math.isfinite(angle) else math.nan for angle in x.tolist()])


if TYPE_CHECKING or core is None:
    Symbol = PlainSymbol
    Tape = PlainTape
else:
    Symbol = core.Symbol

    class Tape(core.Tape):
        """A record of arithmetic operations in the native core."""

        __slots__ = ()

        def code(self, outputs: Sequence[Number], guards: Sequence[tuple[Symbol, float]] = ()) -> Code:
            """Return what `PlainTape.code` does; for `math`, the code is a program of the native core."""
            program = self.program(outputs, guards)
            return lambda maths: program if maths is math else _generated(self, outputs, guards)[0](maths)


def _generated(
    tape: "PlainTape", outputs: Sequence[Number], guards: Sequence[tuple["PlainSymbol", float]]
) -> tuple[Code, int]:
    """Return the function that compiles the code of `outputs`, as `PlainTape.code` does, and its operation count."""
    values: dict[float, int] = {}

    def said(value: float) -> ConstantText:
        return PLAIN.get(value) or values.setdefault(value, len(values))

    constants = tuple(map(said, tape.constants))
    wanted = tuple((o.id, "") if isinstance(o, (Symbol, PlainSymbol)) else (-1, said(float(o))) for o in outputs)
    held = tuple((guard.id, said(bound)) for guard, bound in guards)
    code = _written(tuple(tape.names), tuple(tape.nodes), constants, wanted, held)
    every = list(values)
    parameters = [every[place] for place in code.parameters]
    return lambda maths: code.make(maths, *parameters), code.operations


@dataclass(frozen=True, slots=True)
class _Code:
    """Generated code of equations that may differ in constants, with the indices of these and the operation count."""

    make: Callable[..., Any]
    parameters: tuple[int, ...]
    operations: int


@lru_cache(maxsize=CACHE_SIZE)
def _written(
    names: Sequence[str],
    nodes: Sequence[Node],
    constants: Sequence[ConstantText],
    outputs: tuple[tuple[int, ConstantText], ...],
    guards: tuple[tuple[int, ConstantText], ...],
) -> _Code:
    """Generate the code of a tape with constants as parameters, so that equations that differ only in these share it.

    Outputs and guards are nodes with a number; an output that is no node has the index −1.
    """
    writer = _Writer(names, nodes, constants, [node for node, _ in (*outputs, *guards) if node >= 0])
    lines = [f"{', '.join(names[1:])}, = y"] if len(names) > 1 else []
    lines += writer.lines
    for guard, bound in guards:
        name, threshold = writer.name(guard), writer.constant(bound)
        lines.append(f"if -{threshold} < {name} < {threshold}: raise ArithmeticError('a pivot is lost')")
    rendered = [writer.name(node) if node >= 0 else writer.constant(number) for node, number in outputs]
    lines.append(f"return ({', '.join(rendered)}{',' if len(rendered) == 1 else ''})")
    make = compiled(f"{names[0]}, y", lines, ", ".join(["maths", *writer.parameters.values()]))
    return _Code(make, tuple(writer.parameters), writer.operations)


class _Writer:
    """Writer of code for the recorded operations that some outputs need; results used only once are written inline."""

    def __init__(
        self, names: Sequence[str], nodes: Sequence[Node], constants: Sequence[ConstantText], outputs: Sequence[int]
    ) -> None:
        self._inputs, self._nodes, self._constants = names, nodes, constants
        self.parameters: dict[int, str] = {}  # by their places, and how they are written
        self._text: dict[int, tuple[str, int]] = {}  # how a node is written, and how deep its brackets are
        self.lines: list[str] = []
        uses = self._uses(outputs)
        self.operations = len(uses)
        kept = set(outputs)
        for number in sorted(uses):
            self._write(number, single=uses[number] == 1 and number not in kept)

    def _uses(self, outputs: Sequence[int]) -> dict[int, int]:
        uses: dict[int, int] = {}
        waiting = [*outputs]
        while waiting:
            number = waiting.pop()
            uses[number] = uses.get(number, 0) + 1
            if uses[number] == 1:
                operation, a, b = self._nodes[number]
                if operation not in ("input", "constant"):
                    waiting += [a] if b < 0 else [a, b]
        return uses

    def _write(self, number: int, *, single: bool) -> None:
        operation, a, b = self._nodes[number]
        if operation == "input":
            self._text[number] = (self._inputs[a], 0)
            return
        if operation == "constant":
            self._text[number] = (self.constant(self._constants[a]), 0)
            return
        depth = 1 + max(self._text[a][1], self._text[b][1] if b >= 0 else 0)
        if operation in ("sqrt", "sin", "cos"):
            text = f"maths.{operation}({self._text[a][0]})"
        elif operation == "neg":
            text = f"(-{self._text[a][0]})"
        else:
            text = f"({self._text[a][0]} {operation} {self._text[b][0]})"
        if single and depth < MAX_BRACKET_DEPTH:
            self._text[number] = (text, depth)
            return
        name = f"s{len(self.lines)}"
        self.lines.append(f"{name} = {text}")
        self._text[number] = (name, 0)

    def name(self, number: int) -> str:
        """Return the code for the result of a recorded operation."""
        return self._text[number][0]

    def constant(self, number: ConstantText) -> str:
        """Return the code for a constant: the constant itself if it is a text, else the name of a parameter."""
        return number if isinstance(number, str) else self.parameters.setdefault(number, f"c{len(self.parameters)}")


def float_value(number: Number) -> float:
    """Return the value of a number or symbol as a float."""
    return number.value if isinstance(number, (Symbol, PlainSymbol)) else float(cast("float", number))
