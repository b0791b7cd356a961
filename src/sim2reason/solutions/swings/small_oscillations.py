"""Small oscillations of a rigid body about a horizontal axle, by the equation of motion."""

from sim2reason.questions.period_words import PeriodQuery
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.functions import Call, Root
from sim2reason.solutions.oscillations.measured_period import measured_period
from sim2reason.solutions.swings.arm import Arm
from sim2reason.solutions.writing.steps import Book
from sim2reason.solutions.writing.unit_latex import ANGULAR_SPEED

HARMONIC = "This is the moment of inertia times the angular acceleration, so"


def small_oscillations(arm: Arm, book: Book, query: PeriodQuery) -> Symbol:
    """Write the period, with ω² = m g d/I; the text need not give the angle at the start."""
    size = book.magnitude(arm.moment)
    torque, inertia, angle = size * arm.gravity, arm.inertia, book.fresh(r"\varphi")
    step, exact, near = book.open("torque"), -(torque * Call("sin", angle)), -(torque * angle)
    step.say(
        f"At the angle ${angle.name}$ from the stable equilibrium the torque of gravity is ${exact.latex()}$, nearly "
        f"${near.latex()}$ where the angle is small."
    )
    step.close()
    said = f"{HARMONIC} the oscillation is harmonic with the angular frequency"
    rate = book.told("oscillation", said, book.fresh(r"\omega"), Root(torque / inertia), ANGULAR_SPEED)
    return measured_period(book, query, rate)
