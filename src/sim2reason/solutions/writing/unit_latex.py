"""Units in LaTeX, letters for quantities, and sentences about magnitudes."""

import re

from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.simulation.quantities import QUANTITIES

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
    found = re.search(r"(?:\\ )?((?:\\text\{[^{}]*\}(?:\^\d)?)+)(?:\^\{-(\d)\})?$", text)
    if found is None:
        return ""
    unit = re.sub(r"\\text\{([^{}]*)\}", r"\1", found[1]).strip().replace(MICRO, "u")
    return f"1/{unit}{f'^{found[2]}' if found[2] != '1' else ''}" if found[2] else unit


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


def magnitude_words(said: str, quantity: str) -> str:
    """Reword an introduction such as *The momentum is* as *The magnitude of the momentum is*, for vector quantities.

    Text that does not name `quantity` is replaced; text about a scalar is unchanged.
    """
    if quantity not in QUANTITIES or not QUANTITIES[quantity].vector:
        return said
    found, count = re.subn(rf"\b([Tt])he {quantity}\b", rf"\1he magnitude of the {quantity}", said, count=1)
    return found if count else f"The magnitude of the {quantity} is"
