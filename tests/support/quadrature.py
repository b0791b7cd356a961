"""Uniform figures as clouds of weighted points by Gauss rules, without formulas of moments."""

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from sim2reason.scenes.bodies.blocks import LongPrism, PolygonalPrism
from sim2reason.scenes.bodies.eccentric_bodies import (
    BoredCylinder,
    Bowl,
    Hemisphere,
    HollowSphereWithHole,
    SphereWithHole,
    SphericalCap,
)
from sim2reason.scenes.bodies.oscillators import Bar, UniformRod
from sim2reason.scenes.bodies.round_bodies import (
    Cylinder,
    Disc,
    HollowSphere,
    Hoop,
    Pipe,
    Roller,
    Sphere,
    SphericalShell,
    ThickPipe,
)

Array = NDArray[np.float64]
Cloud = tuple[Array, Array]
"""Points (k, 3), m, and their shares of the volume, area or length (k,)."""
Square = Callable[[Array], Array]
"""The square of a radius, m², at heights, m."""


def moments(cloud: Cloud) -> tuple[float, Array, Array]:
    """Return the size, the centroid and the second moments about it, of shape (3, 3)."""
    points, shares = cloud
    size = float(shares.sum())
    center = shares @ points / size
    return size, center, (points - center).T @ ((points - center) * shares[:, None])


def gauss(low: float, high: float, count: int = 24) -> tuple[Array, Array]:
    """Return nodes and weights between two bounds."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return low + 0.5 * (high - low) * (nodes + 1.0), 0.5 * (high - low) * weights


def turned_about_z(height: Array, square: Array, shares: Array, around: int = 8) -> Cloud:
    """Return circles about the z axis, each as points on it."""
    angles = 2.0 * np.pi * np.arange(around) / around
    radius = np.sqrt(square)
    points = [np.stack([radius * np.cos(a), radius * np.sin(a), height], axis=1) for a in angles]
    return np.concatenate(points), np.tile(shares / around, around)


def lathe(outer: Square, inner: Square, breaks: Sequence[float]) -> Cloud:
    """Return a solid of revolution about z between two radii, in pieces within which they are smooth."""
    heights: list[Array] = []
    squares: list[Array] = []
    shares: list[Array] = []
    for low, high in pairwise(breaks):
        for height, weight in zip(*gauss(low, high), strict=True):
            here = np.array([height])
            far, near = float(outer(here)[0]), float(np.maximum(inner(here), 0.0)[0])
            nodes, weights = gauss(min(near, far), far, 4)
            heights.append(np.full(len(nodes), height))
            squares.append(nodes)
            shares.append(np.pi * weight * weights)
    return turned_about_z(np.concatenate(heights), np.concatenate(squares), np.concatenate(shares))


def ball(radius: float, center: float = 0.0) -> Square:
    """Return the square of the radius of a ball's cross-section, negative outside."""
    return lambda height: radius**2 - (height - center) ** 2


def nothing(height: Array) -> Array:
    """Return a radius of zero."""
    return 0.0 * height


def circle(radius: float) -> Cloud:
    """Return a thin ring."""
    return turned_about_z(np.zeros(1), np.array([radius**2]), np.array([2.0 * np.pi * radius]))


def annulus(inner: float, outer: float) -> Cloud:
    """Return a flat ring."""
    nodes, weights = gauss(inner**2, outer**2)
    return turned_about_z(0.0 * nodes, nodes, np.pi * weights)


def surface(radius: float) -> Cloud:
    """Return the surface of a sphere; equal heights have equal areas (Archimedes)."""
    height, weights = gauss(-radius, radius)
    return turned_about_z(height, radius**2 - height**2, 2.0 * np.pi * radius * weights)


def block(*sides: float) -> Cloud:
    """Return a box about the origin."""
    (x, p), (y, q), (z, r) = (gauss(-0.5 * side, 0.5 * side, 3) for side in sides)
    points = np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1).reshape(-1, 3)
    return points, np.einsum("i,j,k->ijk", p, q, r).ravel()


def line(length: float) -> Cloud:
    """Return a rod along z."""
    height, weights = gauss(-0.5 * length, 0.5 * length)
    return np.stack([0.0 * height, 0.0 * height, height], axis=1), weights


def column(sides: int, radius: float, height: float) -> Cloud:
    """Return a regular prism, sector by sector, from its axis to its faces."""
    points: list[Array] = []
    shares: list[Array] = []
    half = np.pi / sides
    for turn in 2.0 * half * np.arange(sides):
        for angle, weight in zip(*gauss(-half, half, 16), strict=True):
            far, weights = gauss(0.0, radius * np.cos(half) / np.cos(angle), 4)
            for z, part in zip(*gauss(-0.5 * height, 0.5 * height, 3), strict=True):
                points.append(np.stack([far * np.cos(turn + angle), far * np.sin(turn + angle), 0.0 * far + z], axis=1))
                shares.append(weight * part * weights * far)
    return np.concatenate(points), np.concatenate(shares)


def flat(cloud: Cloud) -> Cloud:
    """Return a figure 1 m high, flattened to z = 0."""
    points, shares = cloud
    return points * np.array([1.0, 1.0, 0.0]), shares


def bored(body: BoredCylinder) -> Cloud:
    """Return a disc in the xz plane less its hole, from the hole's centre outwards."""
    points: list[Array] = []
    shares: list[Array] = []
    count = 200
    for angle in 2.0 * np.pi * np.arange(count) / count:
        aside = body.offset * np.sin(angle)
        far, weights = gauss(body.hole, -body.offset * np.cos(angle) + float(np.sqrt(body.radius**2 - aside**2)), 4)
        points.append(np.stack([far * np.sin(angle), 0.0 * far, body.offset + far * np.cos(angle)], axis=1))
        shares.append(2.0 * np.pi / count * weights * far)
    return np.concatenate(points), np.concatenate(shares)


def lens(radius: float, other: float, distance: float) -> Cloud:
    """Return the intersection of two balls, one about the origin, one about z = distance."""
    one, two = ball(radius), ball(other, distance)
    meet = (radius**2 - other**2 + distance**2) / (2.0 * distance)
    low, high = max(-radius, distance - other), min(radius, distance + other)
    breaks = sorted({low, high, *([meet] if low < meet < high else [])})
    return lathe(lambda z: np.minimum(one(z), two(z)), nothing, breaks)


def opened(body: HollowSphereWithHole) -> Cloud:
    """Return a spherical shell less a ball, with a new piece wherever one sphere meets another or the axis."""
    wide, narrow, hole, d = body.radius, body.radius - body.thickness, body.hole, body.offset
    cavity, cut = ball(narrow), ball(hole, d)
    meet = [(radius**2 - hole**2 + d**2) / (2.0 * d) for radius in (wide, narrow)]
    breaks = sorted({-wide, wide, -narrow, narrow, *(z for z in (d - hole, d + hole, *meet) if -wide < z < wide)})
    return lathe(ball(wide), lambda z: np.maximum(cavity(z), cut(z)), breaks)


def holed(body: SphereWithHole) -> Cloud:
    """Return a ball less another within it."""
    r, hole, d = body.radius, body.hole, body.offset
    return lathe(ball(r), ball(hole, d), (-r, d - hole, d + hole, r))


def cup(body: Bowl) -> Cloud:
    """Return the solid between two concentric spheres, on one side of a plane."""
    middle = body.height - body.radius
    outer, inner = ball(body.radius, middle), ball(body.radius - body.thickness, middle)
    return lathe(outer, inner, (0.0, body.height - body.thickness, body.height))


CLOUDS: dict[type, Callable[..., Cloud]] = {
    Sphere: lambda body: lathe(ball(body.radius), nothing, (-body.radius, body.radius)),
    SphericalShell: lambda body: surface(body.radius),
    HollowSphere: lambda body: lathe(
        ball(body.radius),
        ball(body.radius - body.thickness),
        (-body.radius, body.thickness - body.radius, body.radius - body.thickness, body.radius),
    ),
    SphereWithHole: holed,
    HollowSphereWithHole: opened,
    Hemisphere: lambda body: lathe(ball(body.radius), nothing, (0.0, body.radius)),
    SphericalCap: lambda body: lathe(ball(body.radius, body.height - body.radius), nothing, (0.0, body.height)),
    Bowl: cup,
    Cylinder: lambda body: lathe(lambda z: 0.0 * z + body.radius**2, nothing, (-0.5 * body.height, 0.5 * body.height)),
    Roller: lambda body: annulus(0.0, body.radius),
    Disc: lambda body: annulus(0.0, body.radius),
    Hoop: lambda body: circle(body.radius),
    Pipe: lambda body: circle(body.radius),
    ThickPipe: lambda body: annulus(body.bore, body.radius),
    UniformRod: lambda body: line(body.length),
    Bar: lambda body: block(body.width, body.thickness, body.length),
    PolygonalPrism: lambda body: column(body.sides, body.radius, body.height),
    LongPrism: lambda body: flat(column(body.sides, body.radius, 1.0)),
    BoredCylinder: bored,
}
