"""Notation in LaTeX: names with subscripts, labels of equations, letters for quantities, and units."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import chain, count

from sim2reason.grading.tokens import canonical
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.solutions.algebra.expressions import Symbol

DEGREES = r"^\circ"

MICRO = "\N{MICRO SIGN}"


def latex(unit: str) -> str:
    """Return a unit in LaTeX, upright and with the space before it; empty for a dimensionless number."""
    if unit == "deg":
        return DEGREES
    if unit.startswith("1/"):
        base, _, power = unit[2:].partition("^")
        return f"{latex(base)}^{{-{power or 1}}}"
    text = re.sub(r"\bu(?=[A-Za-z])", MICRO, unit.replace("*", " "))
    text = re.sub(r"\^(\d)", r"}^\1\\text{", text)
    return rf"\ \text{{{text}}}".replace(r"\text{}", "") if unit else ""


def unit_of(text: str) -> str:
    """Return the unit at the end of a LaTeX text; empty if there is none."""
    if text.endswith(DEGREES):
        return "deg"
    match = re.search(r"(?:\\ )?((?:\\text\{[^{}]*\}(?:\^\d)?)+)(?:\^\{-(\d)\})?$", text)
    if match is None:
        return ""
    unit = re.sub(r"\\text\{([^{}]*)\}", r"\1", match[1]).strip().replace(MICRO, "u")
    return f"1/{unit}{f'^{match[2]}' if match[2] != '1' else ''}" if match[2] else unit


METRES, SECONDS, KILOGRAMS, RADIANS = latex("m"), latex("s"), latex("kg"), latex("rad")
SPEED, ACCELERATION, STIFFNESS = latex("m/s"), latex("m/s^2"), latex("N/m")
PER_SECOND, ANGULAR_SPEED, ANGULAR_ACCELERATION = latex("1/s"), latex("rad/s"), latex("rad/s^2")
NEWTONS, JOULES, IMPULSE = latex("N"), latex("J"), latex("N s")
INERTIA, TORQUE = latex("kg m^2"), latex("N m")
PER_SECOND_SQUARED = latex("1/s^2")

LENGTHS = "m", "m^2", "m/s", "m/s^2", "m^2/s", "m^3/s^2"
MECHANICAL = (*LENGTHS, "s", "kg", "N", "J", "N s", "J s", "kg m/s", "1/s", "rad/s")
CANONICAL = {latex(name): name for name in MECHANICAL}  # unit by its LaTeX


QUANTITY_SYMBOLS = {
    "acceleration": "a",
    "angle rolled": r"\phi",
    "angle turned": r"\phi",
    "angular acceleration": r"\alpha",
    "angular momentum": "L",
    "angular velocity": r"\omega",
    "axle force": "F",
    "deflection": r"\phi",
    "displacement": "s",
    "distance": "r",
    "distance travelled": "d",
    "electric potential energy": "U",
    "energy dissipated by friction": "Q",
    "energy lost in a collision": "Q",
    "energy lost in a jerk": "Q",
    "extension": "e",
    "extension rate": "u",
    "height": "h",
    "impulse of the net force": "J",
    "kinetic energy": "K",
    "moment of inertia": "I",
    "momentum": "p",
    "net force": "F",
    "potential energy": "U",
    "relative speed": "v",
    "rod force": "T",
    "rotational kinetic energy": "K",
    "spring energy": "U",
    "spring force": "F",
    "spring length": r"\ell",
    "tension": "T",
    "torque": "M",
    "total angle": r"\Phi",
    "translational kinetic energy": "K",
    "velocity": "v",
    "work of a tension": "W",
}
"""Letters by quantity, or by functional if that is not the extreme value of a quantity."""


def unit_of_quantity(name: str) -> str:
    """Return the unit of a quantity or a functional, in LaTeX."""
    declared = QUANTITIES[name] if name in QUANTITIES else FUNCTIONALS[name]
    return latex(declared.unit)


def magnitude_words(text: str, quantity: str) -> str:
    """Reword an introduction such as *The momentum is* as *The magnitude of the momentum is*, for vector quantities.

    Text that does not name `quantity` is replaced; text about a scalar is unchanged.
    """
    if quantity not in QUANTITIES or not QUANTITIES[quantity].vector:
        return text
    reworded, count = re.subn(rf"\b([Tt])he {quantity}\b", rf"\1he magnitude of the {quantity}", text, count=1)
    return reworded if count else f"The magnitude of the {quantity} is"


def subscript(name: str) -> str:
    """Return the subscript of a name, without its braces; empty for none."""
    inner = name.partition("_")[2]
    return inner[1:-1] if inner.startswith("{") else inner


def with_subscript(base: str, mark: str) -> str:
    """Return a name with a subscript, appended to the one that it may have."""
    if not mark:
        return base
    inner = subscript(base)
    joined = f"{inner},{mark}" if inner else mark
    stem = base.partition("_")[0]
    return f"{stem}_{joined}" if len(joined) == 1 else f"{stem}_{{{joined}}}"


def split_name(name: str) -> tuple[str, str]:
    """Return the base of a name and its subscript without braces."""
    base, _, mark = name.partition("_")
    return base, mark[1:-1] if mark.startswith("{") and mark.endswith("}") else mark


def numbered_names(name: str) -> Iterator[str]:
    """Yield names with the next numbers as subscripts: t₁, t₂ for t; m₂, m₃ for m₁; s_{x,2} for s_{x,1}.

    A subscript that is a number is incremented; no second number is appended.
    """
    base, mark = split_name(name)
    rest, _, last = mark.rpartition(",")
    counts = last.isdecimal() and not rest.rpartition(",")[2].isdecimal()
    first, mark = (int(last), rest) if counts else (0, mark)
    for number in count(first + 1):
        yield with_subscript(base, f"{mark},{number}" if mark else str(number))


def with_primes(name: str, primes: int = 1) -> str:
    """Return a name with primes before its subscript."""
    base, mark = split_name(name)
    return with_subscript(base + "'" * primes, mark)


MAX_PRIMES = 3


class NameAllocator:
    """An allocator of names that gives each name to one value only."""

    def __init__(self, called: Mapping[str, str] | None = None) -> None:
        """Start with no name taken; `called` maps chosen names to those of the text."""
        self._called = called
        self._taken: set[str] = set()

    def reserve(self, *names: str) -> None:
        """Exclude names from later allocation."""
        self._taken.update(map(canonical, names))

    def fresh(self, base: str, mark: str = "") -> Symbol:
        """Return an unused name: the base with a subscript, and with a number if that is taken."""
        name = with_subscript(base, mark)
        return self._take(next(each for each in chain([name], numbered_names(name)) if self._is_free(each)))

    def name_after_impact(self, base: str, mark: str = "") -> Symbol:
        """Return an unused name for a value just after an impact: v', then v'' and v''', then numbered ones."""
        name = with_subscript(base, mark)
        names = [with_primes(name, primes) for primes in range(1, MAX_PRIMES + 1)]
        return self._take(next(each for each in chain(names, numbered_names(names[0])) if self._is_free(each)))

    def _is_free(self, name: str) -> bool:
        return canonical(name) not in self._taken

    def _take(self, name: str) -> Symbol:
        self._taken.add(canonical(name))
        return Symbol((self._called or {}).get(name, name))


@dataclass
class Labels:
    """A counter of equation labels."""

    used: int = 0

    def next(self) -> str:
        """Return the next equation label, a number in parentheses such as *(3)*."""
        self.used += 1
        return f"({self.used})"
