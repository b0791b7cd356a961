"""What can be recorded and asked of a motion, each a function of the state alone."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.units import parse_unit
from sim2reason.registry import Registry

Subject = Literal["body", "string", "contact"]
Evaluate = Callable[[State, str], Array]


@dataclass(frozen=True, slots=True)
class Quantity:
    """A quantity of every body, of every string part (pulls among them) or of every resting body."""

    name: str
    unit: str
    symbol: str
    of: Subject
    vector: bool
    evaluate: Evaluate  # (state, name of the subject) → (n,), or (n, 3) of a vector, in room coordinates

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """The names that `evaluate` takes, in the order of the mechanism."""
        match self.of:
            case "body":
                return tuple(mechanism.body)
            case "string":
                return tuple(line.name for line in mechanism.lines)
            case "contact":
                return tuple(mechanism.contacts)


QUANTITIES: Registry[Quantity] = Registry("quantities")


def quantity(name: str, *, unit: str, symbol: str, of: Subject, vector: bool = False) -> Callable[[Evaluate], Evaluate]:
    """Decorate a function of state and subject to make it a quantity."""
    parse_unit(unit)  # UnitError for a unit outside the table

    def declare(evaluate: Evaluate) -> Evaluate:
        QUANTITIES.add(name, Quantity(name, unit, symbol, of, vector, evaluate))
        return evaluate

    return declare
