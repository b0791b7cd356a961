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
    """Return the sum of vectors.

    Args:
        *vectors: Vectors of three components.

    Returns:
        The sum.

    Example:
        >>> from sim2reason.authoring import X, Z, add
        >>> add(X, Z, Z)
        (1.0, 0.0, 2.0)
    """
    if len(vectors) == 2:  # as nearly always
        a, b = vectors
        return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
    x = y = z = 0.0
    for vector in vectors:
        x, y, z = x + vector[0], y + vector[1], z + vector[2]
    return (x, y, z)


def scale(factor: float, vector: Vector) -> Vector:
    """Return a multiple of a vector.

    Args:
        factor: The factor.
        vector: The vector.

    Returns:
        `factor` times `vector`.

    Example:
        >>> from sim2reason.authoring import X, scale
        >>> scale(2.0, X)
        (2.0, 0.0, 0.0)
    """
    return (factor * vector[0], factor * vector[1], factor * vector[2])


def inner(a: Vector, b: Vector) -> float:
    """Return the dot product of two vectors.

    Args:
        a: The first vector.
        b: The second vector.

    Returns:
        The sum of the products of their components.

    Example:
        >>> from sim2reason.authoring import inner
        >>> inner((1.0, 2.0, 3.0), (0.0, 1.0, 1.0))
        5.0
    """
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def outer(a: Vector, b: Vector) -> Vector:
    """Return the cross product of two vectors.

    Args:
        a: The first vector.
        b: The second vector.

    Returns:
        The vector a × b, at right angles to both.

    Example:
        >>> from sim2reason.authoring import X, Y, outer
        >>> outer(X, Y)
        (0.0, 0.0, 1.0)
    """
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
