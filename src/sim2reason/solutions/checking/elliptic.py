"""Elliptic integrals of the first kind and Jacobi's amplitude by Gaussian quadrature, with derivatives."""

import math
from itertools import pairwise

import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(20)
HALVINGS = 40  # bisections of the distance to 90°, where the integrand varies fast for moduli close to 1
ITERATIONS = 60  # of Newton's method
CONVERGED = 1e-15  # relative
Derived = tuple[float, tuple[float, ...]]
"""A value with its derivatives by the arguments."""


def complete(modulus: float) -> Derived:
    """Return K(k) = ∫ dθ/√(1 − k² sin² θ) from 0 to 90° and its derivative; ValueError unless 0 ≤ k < 1."""
    value, (_, slope) = incomplete(0.5 * math.pi, modulus)
    return value, (slope,)


def incomplete(angle: float, modulus: float) -> Derived:
    """Return F(θ, k), the integral up to an angle in radians, and its derivatives; ValueError unless 0 ≤ k < 1."""
    if not 0.0 <= modulus < 1.0:
        raise ValueError(f"an elliptic integral of the modulus {modulus:g}")
    turns = round(angle / math.pi)
    rest = angle - turns * math.pi
    whole, by_modulus = _quadrature(abs(rest), modulus)
    if turns:
        quarter, slope = _quadrature(0.5 * math.pi, modulus)
        whole, by_modulus = math.copysign(whole, rest) + 2.0 * turns * quarter, math.copysign(by_modulus, rest)
        by_modulus += 2.0 * turns * slope
    else:
        whole, by_modulus = math.copysign(whole, rest), math.copysign(by_modulus, rest)
    return whole, (1.0 / math.sqrt(1.0 - (modulus * math.sin(angle)) ** 2), by_modulus)


def amplitude(integral: float, modulus: float) -> Derived:
    """Return am(u, k), the angle in radians with F(θ, k) = u, by Newton's method; ValueError unless 0 ≤ k < 1."""
    quarter, _ = complete(modulus)
    angle = 0.5 * math.pi * integral / quarter
    for _ in range(ITERATIONS):
        value, (slope, by_modulus) = incomplete(angle, modulus)
        step = (value - integral) / slope
        angle -= step
        if abs(step) <= CONVERGED * max(1.0, abs(angle)):
            break
    value, (slope, by_modulus) = incomplete(angle, modulus)
    return angle, (1.0 / slope, -by_modulus / slope)


def _quadrature(angle: float, modulus: float) -> tuple[float, float]:
    """Return the integral up to an angle of at most 90°, and its derivative with respect to the modulus."""
    ends = [0.5 * math.pi * (1.0 - 0.5**n) for n in range(HALVINGS)]
    places = [end for end in ends if end < angle] + [angle]
    value, slope = 0.0, 0.0
    for begin, end in pairwise(places):
        half = 0.5 * (end - begin)
        square = np.sin(begin + half * (1.0 + NODES)) ** 2
        root = np.sqrt(1.0 - modulus**2 * square)
        value += half * float(WEIGHTS @ (1.0 / root))
        slope += half * float(WEIGHTS @ (modulus * square / root**3))
    return value, slope


SPECIAL = {"elliptic K": complete, "elliptic F": incomplete, "amplitude": amplitude}
ARITY = {"elliptic K": 1, "elliptic F": 2, "amplitude": 2}
