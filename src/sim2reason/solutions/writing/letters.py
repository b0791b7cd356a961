"""What quantities are called in solutions: a letter of each, with the unit that its own declaration has."""

from sim2reason.quantities import QUANTITIES
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.solutions.writing.unit_latex import latex

LETTERS = {
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
"""By quantity, or by functional where that is not one of a quantity."""


def unit_of_quantity(name: str) -> str:
    """The unit of a quantity or a functional, in LaTeX."""
    declared = QUANTITIES[name] if name in QUANTITIES else FUNCTIONALS[name]
    return latex(declared.unit)
