"""Mean squares of distances in uniform bodies, in the symbols of the text, for moments of inertia.

In the body's own axes, of which z is its axis: the position along z of the centre of mass relative to the reference
point, and the mean squares of x, y and z relative to the centre of mass, so that I_z = m (⟨x²⟩ + ⟨y²⟩).
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import reduce
from math import cos, pi, prod

from sim2reason.scenes.dsl.solids import Shape
from sim2reason.solutions.algebra.digits import simple_fraction
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Product, Sum, multiplied
from sim2reason.solutions.algebra.functions import PI, Call, Power, sum_of_squares, summed

Sizes = Callable[[str], Expression]  # from a parameter of the body to its symbol


@dataclass(frozen=True, slots=True)
class MeanSquares:
    """The mean squares of distances in a body with an axis; `yy` differs from `xx` only for a bar."""

    xx: Expression
    zz: Expression
    center: Expression = ZERO
    yy: Expression | None = None
    square: Expression | None = None  # mean square distance from a line across its axis, if it is not to be a sum
    why: str = ""  # the derivation of the value for a line across its axis, if tables lack it
    why_own: str = ""  # the same for its axis

    @property
    def yy_or_xx(self) -> Expression:
        """Return the mean square ⟨y²⟩, by default equal to ⟨x²⟩."""
        return self.xx if self.yy is None else self.yy


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a body, or a hole in it: its share of the mass, negative for a hole."""

    share: Expression
    spread: MeanSquares
    height: Expression = ZERO  # of the centre of mass along z


def of(share: float, length: Expression) -> Expression:
    """Return the number `share` times the square of a length."""
    return Number(share) * Power(length, 2)


def joined(parts: list[Part]) -> MeanSquares:
    """Combine parts of a body, displaced along z, into mean squares of the whole, by the parallel-axis theorem."""
    center, xx, zz = ZERO, ZERO, ZERO
    for part in parts:
        center = center + part.share * part.height
        xx = xx + part.share * part.spread.xx
        zz = zz + part.share * part.spread.zz + part.share * sum_of_squares([part.height])
    return MeanSquares(xx, zz - sum_of_squares([-center if center.negative else center]), center)


def _ball(radius: Expression) -> MeanSquares:
    return MeanSquares(of(0.2, radius), of(0.2, radius))


def _less(power: int, outer: Expression, inner: Expression) -> tuple[Expression, Expression]:
    """Return the shares of mass of a full body and, negative, of its hole; volumes are sizes to the `power`."""
    rest = Power(outer, power) - Power(inner, power)
    return Power(outer, power) / rest, -(Power(inner, power) / rest)


def _hollow(size: Sizes) -> MeanSquares:
    outer = size("radius")
    inner = outer - size("thickness")
    ratio = (Power(outer, 5) - Power(inner, 5)) / (Power(outer, 3) - Power(inner, 3))
    why = "A hollow sphere is a solid ball less the one that would fill it, of the same density."
    return MeanSquares(Number(0.2) * ratio, Number(0.2) * ratio, why=why, why_own=why)


def _segment(radius: Expression, height: Expression) -> tuple[MeanSquares, Expression]:
    """Return the mean squares of a solid spherical cap, and the height of its centre of mass above the flat face."""
    r, h = radius, height
    below = 3.0 * r - h
    center = h * (4.0 * r - h) / (4.0 * below)
    across = h * (20.0 * Power(r, 2) - 15.0 * r * h + 3.0 * Power(h, 2)) / (20.0 * below)
    depth = h * (8.0 * r - 3.0 * h) / (4.0 * below)
    along = 3.0 * Power(h, 2) * (5.0 * r - 2.0 * h) / (10.0 * below) - Power(depth, 2)
    return MeanSquares(across, along), center


def _hemisphere(size: Sizes) -> MeanSquares:
    radius, center = size("radius"), Number(3.0 / 8.0)
    square = (Number(0.4) - Power(center, 2)) * Power(radius, 2)
    why = (
        "About a diameter of its flat face the moment of inertia of a hemisphere is, as that of a ball, "
        f"${of(0.4, radius).latex()}$ times its mass; about the parallel line through the centre of mass "
        f"it is less by ${Power(center * radius, 2).latex()}$ times the mass."
    )
    along = of(0.2, radius) - of(9.0 / 64.0, radius)
    return MeanSquares(of(0.2, radius), along, center * radius, square=square, why=why)


def _cap(size: Sizes) -> MeanSquares:
    spread, center = _segment(size("radius"), size("height"))
    why = "The moments of inertia of a cap follow by integration over thin discs parallel to its flat face."
    return replace(spread, center=center, why=why, why_own=why)


def _bowl(size: Sizes) -> MeanSquares:
    outer, height, wall = size("radius"), size("height"), size("thickness")
    inner, low = outer - wall, height - wall
    volumes = [Power(h, 2) * (3.0 * r - h) for r, h in ((outer, height), (inner, low))]
    parts = [_segment(outer, height), _segment(inner, low)]
    rest = volumes[0] - volumes[1]
    shares = [volumes[0] / rest, -(volumes[1] / rest)]
    found = joined([Part(share, spread, center) for share, (spread, center) in zip(shares, parts, strict=True)])
    why = (
        "A bowl is a solid cap less a smaller one, of the same density; the moments of inertia of caps follow by "
        "integration over thin discs parallel to their flat faces."
    )
    return replace(found, why=why, why_own=why)


def _holed_ball(size: Sizes) -> MeanSquares:
    outer, inner = size("radius"), size("hole")
    whole, hole = _less(3, outer, inner)
    found = joined([Part(whole, _ball(outer)), Part(hole, _ball(inner), size("offset"))])
    why = "It is a solid ball less the one that would fill the hole, of the same density."
    return replace(found, why=why, why_own=why)


def _bored(size: Sizes) -> MeanSquares:
    """Return the mean squares of a cylinder with a parallel bore; y is the axis and z the line to the bore."""
    outer, inner = size("radius"), size("hole")
    whole, hole = _less(2, outer, inner)
    discs = [MeanSquares(of(0.25, radius), of(0.25, radius)) for radius in (outer, inner)]
    spread = joined([Part(whole, discs[0]), Part(hole, discs[1], size("offset"))])
    return MeanSquares(spread.xx, spread.zz, spread.center, ZERO)


def _prism(size: Sizes, sides: int, long: Expression) -> MeanSquares:
    """Return the mean squares of a regular prism; simple fractions for triangles, squares and hexagons."""
    radius, turn = size("radius"), 2.0 * PI / Number(float(sides))
    plain = (2.0 + cos(2.0 * pi / sides)) / 12.0
    square = Number(1.0 / 12.0) * (Number(2.0) + Call("cos", turn)) * Power(radius, 2)
    general = r"\tfrac{1}{12} \left(2 + \cos\left(\frac{2\,\pi}{n}\right)\right) " + Power(radius, 2).latex()
    why = (
        "About any line through its centre and in its plane a thin regular plate with $n$ corners at the distance "
        f"${radius.latex()}$ from the centre has the moment of inertia ${general}$ times its mass; here $n = {sides}$."
    )
    high = f" The height adds ${long.latex()}$ times the mass, as the length of a rod does." if long != ZERO else ""
    double = " About the axis of the prism it is twice as large, by the perpendicular-axis theorem."
    found = square if simple_fraction(plain) is None else of(plain, radius)
    return MeanSquares(found, long, why=why + high, why_own=why + double)


def _thick(size: Sizes) -> MeanSquares:
    return MeanSquares(Number(0.25) * (Power(size("radius"), 2) + Power(size("bore"), 2)), ZERO)


TABLE: dict[str, Callable[[Sizes], MeanSquares]] = {
    "FixedBall": lambda _: MeanSquares(ZERO, ZERO),
    "Sphere": lambda size: _ball(size("radius")),
    "SphericalShell": lambda size: MeanSquares(of(1.0 / 3.0, size("radius")), of(1.0 / 3.0, size("radius"))),
    "HollowSphere": _hollow,
    "Cylinder": lambda size: MeanSquares(of(0.25, size("radius")), of(1.0 / 12.0, size("height"))),
    "Disc": lambda size: MeanSquares(of(0.25, size("radius")), ZERO),
    "Roller": lambda size: MeanSquares(of(0.25, size("radius")), ZERO),
    "Hoop": lambda size: MeanSquares(of(0.5, size("radius")), ZERO),
    "Pipe": lambda size: MeanSquares(of(0.5, size("radius")), ZERO),
    "ThickPipe": _thick,
    "UniformRod": lambda size: MeanSquares(ZERO, of(1.0 / 12.0, size("length"))),
    "Bar": lambda size: MeanSquares(
        of(1.0 / 12.0, size("width")), of(1.0 / 12.0, size("length")), yy=of(1.0 / 12.0, size("thickness"))
    ),
    "Hemisphere": _hemisphere,
    "SphericalCap": _cap,
    "Bowl": _bowl,
    "SphereWithHole": _holed_ball,
    "BoredCylinder": _bored,
}


def mean_squares(shape: Shape, size: Sizes) -> MeanSquares | None:
    """Return the mean squares of distances in a body of a tabulated shape; None for other shapes."""
    name = type(shape).__name__
    if name in ("PolygonalPrism", "LongPrism"):
        long = of(1.0 / 12.0, size("height")) if name == "PolygonalPrism" else ZERO
        return _prism(size, getattr(shape, "sides", 4), long)
    found = TABLE.get(name)
    return found(size) if found is not None else None


def candidates(spread: MeanSquares) -> list[Expression]:
    """Return moments of inertia per mass about the x axis, the symmetry axis z and the y axis of a body."""
    x, y, z = spread.xx, spread.yy_or_xx, spread.zz
    across = spread.square
    return [across or _collected(x + z), _collected(x + y), across or _collected(y + z)]


def tilted(spread: MeanSquares, angle: Expression) -> tuple[Expression, str]:
    """Return the moment of inertia per mass about a line at 90° minus an angle to the body's axis, and the reason."""
    across, own, _ = candidates(spread)
    along, beside = Power(Call("cos", angle), 2), Power(Call("sin", angle), 2)
    if own == ZERO:
        size = f"its length times ${Call('cos', angle).latex()}$"
        return across * along, f"Only the extension of the rod perpendicular to the axle matters, {size}."
    why = (
        f"With the axle at $90^\\circ - {angle.latex()}$ to its axis, the moment of inertia is that across this axis "
        f"times ${along.latex()}$ plus that about it times ${beside.latex()}$."
    )
    return across * along + own * beside, f"{spread.why_own or spread.why} {why}".lstrip()


def _collected(held: Expression) -> Expression:
    """Return a sum in which terms that differ only in a numerical factor are combined."""
    parts: dict[Expression, float] = {}
    for term in held.terms if isinstance(held, Sum) else (held,):
        factors = term.factors if isinstance(term, Product) else (term,)
        number = prod(factor.x for factor in factors if isinstance(factor, Number))
        rest = reduce(multiplied, (factor for factor in factors if not isinstance(factor, Number)), ONE)
        parts[rest] = parts.get(rest, 0.0) + number
    return summed(multiplied(Number(number), rest) for rest, number in parts.items())
