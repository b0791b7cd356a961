"""Elliptic integrals of the first kind and their inverse, as formulas.

Their values come from the arithmetic-geometric mean: Abramowitz and Stegun, Handbook of Mathematical Functions, 17.6
(complete: 17.6.3, incomplete: 17.6.8) and 16.4.
"""

import cmath
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import pi

from sim2reason.solutions.algebra.expressions import Expression, Scalar, Values

MEANS = 40  # steps of the arithmetic-geometric mean, at most; six suffice for nearly all moduli
CLOSE = 1e-17  # relative: how far the two means are apart at last


class SpecialFunction(Expression):
    """A function that is not elementary; its value is found numerically or in tables."""


@dataclass(frozen=True, slots=True)
class CompleteElliptic(SpecialFunction):
    """The complete elliptic integral of the first kind, K(k), of a modulus k between 0 and 1."""

    modulus: Expression

    @property
    def parts(self) -> tuple[Expression, ...]:
        """The modulus."""
        return (self.modulus,)

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """The integral of another modulus."""
        (modulus,) = parts
        return CompleteElliptic(modulus)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """π/(2 a), a being the mean of 1 and √(1 − k²)."""
        return _real_if(0.5 * pi / _means(self.modulus.value(at, digits))[-1][0])

    def latex(self) -> str:
        """As tables have it."""
        return rf"\operatorname{{K}}\left({self.modulus.latex()}\right)"


@dataclass(frozen=True, slots=True)
class _OfTwo(SpecialFunction):
    """A function of an argument and of a modulus k between 0 and 1."""

    argument: Expression
    modulus: Expression

    @property
    def parts(self) -> tuple[Expression, ...]:
        """The argument and the modulus."""
        return self.argument, self.modulus

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """The function of others."""
        argument, modulus = parts
        return type(self)(argument, modulus)


@dataclass(frozen=True, slots=True)
class IncompleteElliptic(_OfTwo):
    """The incomplete elliptic integral of the first kind, F(θ, k), of an angle θ in radians."""

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """θ′/(2ⁿ a) by Landen's transformation, tan(θ′ − θ) = (b/a) tan θ."""
        angle = complex(self.argument.value(at, digits))
        means = _means(self.modulus.value(at, digits))
        for a, b in means[:-1]:
            angle += cmath.atan(b / a * cmath.tan(angle)) + pi * round(angle.real / pi)
        return _real_if(angle / (2.0 ** (len(means) - 1) * means[-1][0]))

    def latex(self) -> str:
        """As tables have it."""
        return rf"\operatorname{{F}}\left({self.argument.latex()}, {self.modulus.latex()}\right)"


@dataclass(frozen=True, slots=True)
class Amplitude(_OfTwo):
    """Jacobi's amplitude am(u, k), in radians: the angle whose incomplete elliptic integral of the first kind is u."""

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Sin(2θ − θ′) = (c′/a′) sin θ′, from 2ⁿ a u back."""
        means = _means(self.modulus.value(at, digits))
        angle = 2.0 ** (len(means) - 1) * means[-1][0] * complex(self.argument.value(at, digits))
        for (a, b), (mean, _) in reversed(list(pairwise(means))):
            angle = 0.5 * (angle + cmath.asin(0.5 * (a - b) / mean * cmath.sin(angle)))
        return _real_if(angle)

    def latex(self) -> str:
        """As tables have it."""
        return rf"\operatorname{{am}}\left({self.argument.latex()}, {self.modulus.latex()}\right)"


def _means(modulus: Scalar) -> list[tuple[complex, complex]]:
    """The arithmetic and geometric means from 1 and √(1 − k²) on; ValueError unless 0 ≤ k < 1."""
    if not 0.0 <= modulus.real < 1.0:
        raise ValueError(f"an elliptic integral of the modulus {modulus.real:g}")
    found = [(complex(1.0), cmath.sqrt(1.0 - complex(modulus) ** 2))]
    while len(found) < MEANS and abs(found[-1][0] - found[-1][1]) > CLOSE:
        a, b = found[-1]
        found.append((0.5 * (a + b), cmath.sqrt(a * b)))
        if found[-1][0] == a:  # as close as numbers come
            break
    return found


def _real_if(value: complex) -> Scalar:
    """A float unless there is an imaginary part, by which derivatives are taken."""
    return value if value.imag else value.real
