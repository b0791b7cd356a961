"""Arithmetic of vectors in space, for those who lay scenes out."""

from math import hypot

Vector = tuple[float, float, float]
Tensor = tuple[float, float, float, float, float, float]
"""A symmetric tensor: xx, yy, zz, xy, xz, yz."""


def unit(vector: Vector) -> Vector:
    """`vector` scaled to length 1; ValueError for the zero vector."""
    length = hypot(*vector)
    if length == 0.0:
        raise ValueError("a direction can not be the zero vector")
    return (vector[0] / length, vector[1] / length, vector[2] / length)


def add(*vectors: Vector) -> Vector:
    """The sum of vectors."""
    if len(vectors) == 2:  # as nearly always
        a, b = vectors
        return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
    x = y = z = 0.0
    for vector in vectors:
        x, y, z = x + vector[0], y + vector[1], z + vector[2]
    return (x, y, z)


def scale(factor: float, vector: Vector) -> Vector:
    """`factor` times `vector`."""
    return (factor * vector[0], factor * vector[1], factor * vector[2])


def inner(a: Vector, b: Vector) -> float:
    """The scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def outer(a: Vector, b: Vector) -> Vector:
    """The vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
