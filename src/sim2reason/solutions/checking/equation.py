"""One relation of a solution, as two trees."""

from collections.abc import Mapping
from dataclasses import dataclass

from sim2reason.solutions.checking.trees import Tree, Values, derivatives, size, symbols, value, written

WELL = 1e-9  # relative to the largest term: how well a relation must hold
ROUNDING = 1e-13  # in SI units: what rounding leaves of numbers that cancel


@dataclass(frozen=True, eq=False)
class Equation:
    """A relation with its role, and the symbols in it."""

    left: Tree
    right: Tree
    role: str
    names: frozenset[str]

    @classmethod
    def of(cls, left: Tree, right: Tree, role: str = "law") -> "Equation":
        """Collect the symbols of both sides."""
        return cls(left, right, role, frozenset(symbols(left)) | frozenset(symbols(right)))

    def __str__(self) -> str:
        """Both trees on one line."""
        return f"{written(self.left)} = {written(self.right)}"

    @property
    def near(self) -> float | None:
        """The number close to which all earlier relations determine the left side, if that is what it says."""
        if isinstance(self.right, list) and self.right[0] == "solve":
            return float(self.right[1])  # type: ignore[arg-type]
        return None

    @property
    def asserts(self) -> bool:
        """Whether it only says which number follows for a name, so that it can be verified but gives no value."""
        return self.role != "law" and not isinstance(self.right, str | list) and isinstance(self.left, str)

    def definition(self, name: str) -> Tree | None:
        """The formula of a name that stands alone on one side; None if it does not, or if the other side has it."""
        if self.asserts:
            return None
        for side, other in ((self.left, self.right), (self.right, self.left)):
            if side == name:
                return None if name in symbols(other) else other
        return None

    def excess(self, at: Values) -> float:
        """Left less right."""
        return value(self.left, at) - value(self.right, at)

    def holds(self, at: Values) -> bool:
        """Whether both sides agree, compared with the largest of their terms."""
        return abs(self.excess(at)) <= WELL * max(size(self.left, at), size(self.right, at)) + ROUNDING

    def slopes(self, at: Values) -> tuple[float, Mapping[str, float]]:
        """Left less right, and its partial derivatives by the symbols."""
        (one, found), (other, right) = derivatives(self.left, at), derivatives(self.right, at)
        for name, slope in right.items():
            found[name] = found.get(name, 0.0) - slope
        return one - other, found
