"""Apsidal distance of an ellipse if the question gives it and the central mass is unknown."""

from math import sqrt

from sim2reason.solutions.algebra.evaluated import QuadraticRoot
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.functions import Power, sum_of_squares
from sim2reason.solutions.fields.kepler import TWO, KeplerOrbit
from sim2reason.solutions.writing.unit_latex import METRES


def given_apsis(orbit: KeplerOrbit, *, far: bool) -> Symbol:
    """Write the greatest or least distance of an orbit by energy conservation, linear in an unknown central mass."""
    book, mu, first = orbit.book, orbit.parameter, orbit.radius
    if book.in_symbols or not book.is_hidden(mu):
        return orbit.apsis(far=far)
    name, momentum, square = orbit.named("r"), orbit.momentum, sum_of_squares(orbit.rate)
    swift = book.magnitude(momentum) / name
    begun, there = square - TWO * mu / first, Power(swift, 2) - TWO * mu / name
    step, which = book.begin_step("apsis"), "greatest" if far else "least"
    law, star = step.law(begun, there), orbit.setting.display_name(orbit.center)
    step.add_text(
        f"At the {which} distance ${name.latex()}$ the velocity is perpendicular to the line to {star}, so by"
    )
    step.add_text(
        f"conservation of angular momentum its magnitude is ${swift.latex()}$. By conservation of energy, {law}."
    )
    step.result(name, QuadraticRoot(there - begun, name.name, _distance(orbit, far=far)), METRES)
    step.close()
    return name


def _distance(orbit: KeplerOrbit, *, far: bool) -> float:
    """Return the value, in m, of the greatest or least distance of an orbiting body from the central body."""
    mu, r, h, square = map(
        orbit.book.value, (orbit.parameter, orbit.radius, orbit.momentum, sum_of_squares(orbit.rate))
    )
    axis = 1.0 / (2.0 / r - square / mu)
    shift = sqrt(max(1.0 - h**2 / (mu * axis), 0.0))
    return axis * (1.0 + shift if far else 1.0 - shift)
