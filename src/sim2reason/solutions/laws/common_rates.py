"""Coordinates with equal rates, and the quantities that laws relate."""

from dataclasses import dataclass
from math import isclose, pi

from sim2reason.solutions.algebra.expressions import Number, Product, Symbol
from sim2reason.solutions.algebra.functions import PI, Power
from sim2reason.solutions.laws.newton import Row
from sim2reason.solutions.writing.steps import SolutionBuilder
from sim2reason.solutions.writing.unit_latex import ACCELERATION, latex

RATE_RTOL = 1e-9  # relative: largest difference of coefficients that count as equal


@dataclass(slots=True)
class SharedRate:
    """The common rate of several coordinates: its symbol, and by coordinate the sign relative to the symbol."""

    symbol: Symbol
    sense: dict[int, int]


@dataclass(frozen=True, slots=True)
class LawQuantity:
    """The kind of quantity that laws relate: accelerations, or displacements in motions where no force matters.

    `values` has the engine's values by coordinate; `known` is a coordinate whose value has a symbol already.
    """

    base: str
    unit: str
    noun: str
    values: tuple[float, ...] = ()
    known: tuple[int, Symbol] | None = None


ACCELERATIONS = LawQuantity("a", ACCELERATION, "acceleration")


def equal_rates(row: Row) -> tuple[tuple[int, int], int] | None:
    """Return two coordinates that a string binds to equal rates, with their relative sign; None for other laws."""
    if row.kind not in ("string", "grip") or len(row.inertia.terms) != 2:
        return None
    parts = [(int(m[0][0].latex()[1:]), part) for m, part in row.inertia.terms.items() if len(m) == 1 and m[0][1] == 1]
    if len(parts) != 2 or abs(abs(parts[0][1]) - abs(parts[1][1])) > RATE_RTOL:
        return None
    return (parts[0][0], parts[1][0]), -1 if parts[0][1] * parts[1][1] > 0.0 else 1


def gravitational_constant(book: SolutionBuilder, value: float) -> Symbol:
    """Return the symbol of the gravitational constant and state its value on first use."""
    if "G" not in book.values:
        book.reserve("G")
        book.set_value("G", value)
        mantissa, _, power = f"{value:.8g}".partition("e")
        said = rf"{mantissa} \times 10^{{{int(power)}}}" if power else mantissa
        plain = isclose(value, 4.0 * pi**2)
        unit = latex("au^3/(Msun yr^2)" if plain else "N m^2/kg^2")
        book.stated["G"] = (r"4 \pi^{2}" if plain else said) + unit
        book.constants["G"] = Product((Number(4.0), Power(PI, 2))) if plain else Number(value)
    return Symbol("G")
