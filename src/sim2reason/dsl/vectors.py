"""Arithmetic of vectors in space, for those who lay scenes out."""

from math import hypot

from sim2reason.dsl.mechanism import Vector


def unit(vector: Vector) -> Vector:
    """`vector` scaled to length 1; ValueError for the zero vector."""
    length = hypot(*vector)
    if length == 0.0:
        raise ValueError("a direction can not be the zero vector")
    return (vector[0] / length, vector[1] / length, vector[2] / length)


def add(*vectors: Vector) -> Vector:
    """The sum of vectors."""
    x = y = z = 0.0
    for vector in vectors:
        x, y, z = x + vector[0], y + vector[1], z + vector[2]
    return (x, y, z)


def scale(factor: float, vector: Vector) -> Vector:
    """`factor` times `vector`."""
    return (factor * vector[0], factor * vector[1], factor * vector[2])
