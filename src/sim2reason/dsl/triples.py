"""Vectors of any kind of number: floats, arrays or symbols; only + − × are asked of them."""

from typing import Any, Protocol, TypeAlias

from sim2reason.dsl.vectors import Tensor

Number: TypeAlias = Any  # a float, an array or a symbol; arithmetic is all that is asked of it
Triple: TypeAlias = tuple[Number, Number, Number]


class Maths(Protocol):
    """The functions of one kind of number: the modules `math` and `numpy`, or a tape of symbols."""

    def sqrt(self, x: Number, /) -> Number:
        """The square root."""
        ...

    def sin(self, x: Number, /) -> Number:
        """The sine of an angle, rad."""
        ...

    def cos(self, x: Number, /) -> Number:
        """The cosine of an angle, rad."""
        ...


def product(a: Triple, b: Triple) -> Number:
    """The scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Triple, b: Triple) -> Triple:
    """The vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def plus(a: Triple, b: Triple) -> Triple:
    """The sum of two vectors."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def minus(a: Triple, b: Triple) -> Triple:
    """The first vector less the second."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def times(factor: Number, a: Triple) -> Triple:
    """A vector times a number."""
    return (factor * a[0], factor * a[1], factor * a[2])


def applied(tensor: Tensor, vector: Triple) -> Triple:
    """A symmetric tensor times a vector."""
    xx, yy, zz, xy, xz, yz = tensor
    return (product((xx, xy, xz), vector), product((xy, yy, yz), vector), product((xz, yz, zz), vector))
