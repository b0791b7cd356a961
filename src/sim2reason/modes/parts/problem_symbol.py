"""A number of a problem for which a symbol stands."""

from dataclasses import dataclass

from sim2reason.prose.formula_numbers import factor


@dataclass(frozen=True, slots=True)
class ProblemSymbol:
    """A symbol of a problem: its unit and value as the text says them, and the address of its number.

    What the question itself says has no address. A `signed` one may stand for a negative number, too.
    """

    symbol: str
    unit: str
    value: float
    path: str = ""
    signed: bool = False

    @property
    def of_world(self) -> bool:
        """Whether it is a number of the world, as g is, and of nothing in it."""
        return self.path.startswith("world.")

    def counted(self, value: float) -> float:
        """A value of it as formulas count: in radians and metres, where it is said in degrees or kilometres."""
        return value * factor(self.unit)
