"""Units as solutions write them, in LaTeX."""

import re

DEGREES = r"^\circ"

MICRO = "\N{MICRO SIGN}"


def latex(unit: str) -> str:
    """A unit in LaTeX with the space before it, the words upright; nothing for a pure number."""
    if unit == "deg":
        return DEGREES
    if unit.startswith("1/"):
        base, _, power = unit[2:].partition("^")
        return f"{latex(base)}^{{-{power or 1}}}"
    text = re.sub(r"\bu(?=[A-Za-z])", MICRO, unit.replace("*", " "))
    text = re.sub(r"\^(\d)", r"}^\1\\text{", text)
    return rf"\ \text{{{text}}}".replace(r"\text{}", "") if unit else ""


def unit_of(text: str) -> str:
    """The unit with which a text in LaTeX ends; empty for none."""
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
CANONICAL = {latex(name): name for name in MECHANICAL}  # by their LaTeX
