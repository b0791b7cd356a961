"""How the mass of a uniform body is spread, in the symbols of the text: what tables of moments of inertia say.

In the body's own axes, of which z is its axis: how far along z its centre of mass lies from what the text calls its
centre, and the mean squares of the distances along x, y and z from the centre of mass, so that I_z = m (⟨x²⟩ + ⟨y²⟩).
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce
from math import cos, pi, prod

from sim2reason.dsl.shape import Shape
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Product, Sum, multiplied
from sim2reason.solutions.algebra.functions import Power, squares, summed

Sizes = Callable[[str], Expression]  # the symbol of a parameter of the body


@dataclass(frozen=True, slots=True)
class MassSpread:
    """Of a body with an axis; `yy` differs from `xx` only of a bar."""

    xx: Expression
    zz: Expression
    center: Expression = ZERO
    yy: Expression | None = None

    @property
    def yy_or_xx(self) -> Expression:
        """⟨y²⟩."""
        return self.xx if self.yy is None else self.yy


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a body, or a hole in it: its share of the mass, negative of a hole."""

    share: Expression
    spread: MassSpread
    height: Expression = ZERO  # of the centre of mass, along z


def of(share: float, length: Expression) -> Expression:
    """A part of a square."""
    return Number(share) * Power(length, 2)


def joined(parts: list[Part]) -> MassSpread:
    """Parts of one density as one body: Steiner's theorem along z."""
    center, xx, zz = ZERO, ZERO, ZERO
    for part in parts:
        center = center + part.share * part.height
        xx = xx + part.share * part.spread.xx
        zz = zz + part.share * part.spread.zz + part.share * squares([part.height])
    return MassSpread(xx, zz - squares([-center if center.negative else center]), center)


def _ball(radius: Expression) -> MassSpread:
    return MassSpread(of(0.2, radius), of(0.2, radius))


def _less(power: int, outer: Expression, inner: Expression) -> tuple[Expression, Expression]:
    """The shares of a whole figure and of its hole, by their volumes."""
    rest = Power(outer, power) - Power(inner, power)
    return Power(outer, power) / rest, -(Power(inner, power) / rest)


def _hollow(size: Sizes) -> MassSpread:
    outer = size("radius")
    inner = outer - size("thickness")
    ratio = (Power(outer, 5) - Power(inner, 5)) / (Power(outer, 3) - Power(inner, 3))
    return MassSpread(Number(0.2) * ratio, Number(0.2) * ratio)


def _segment(radius: Expression, height: Expression) -> tuple[MassSpread, Expression]:
    """A solid cap above its flat face, and the height of its centre of mass."""
    r, h = radius, height
    below = 3.0 * r - h
    center = h * (4.0 * r - h) / (4.0 * below)
    across = h * (20.0 * Power(r, 2) - 15.0 * r * h + 3.0 * Power(h, 2)) / (20.0 * below)
    depth = h * (8.0 * r - 3.0 * h) / (4.0 * below)
    along = 3.0 * Power(h, 2) * (5.0 * r - 2.0 * h) / (10.0 * below) - Power(depth, 2)
    return MassSpread(across, along), center


def _hemisphere(size: Sizes) -> MassSpread:
    radius = size("radius")
    return MassSpread(of(0.2, radius), of(0.2, radius) - of(9.0 / 64.0, radius), Number(3.0 / 8.0) * radius)


def _cap(size: Sizes) -> MassSpread:
    spread, center = _segment(size("radius"), size("height"))
    return MassSpread(spread.xx, spread.zz, center)


def _bowl(size: Sizes) -> MassSpread:
    outer, height, wall = size("radius"), size("height"), size("thickness")
    inner, low = outer - wall, height - wall
    volumes = [Power(h, 2) * (3.0 * r - h) for r, h in ((outer, height), (inner, low))]
    parts = [_segment(outer, height), _segment(inner, low)]
    rest = volumes[0] - volumes[1]
    shares = [volumes[0] / rest, -(volumes[1] / rest)]
    return joined([Part(share, spread, center) for share, (spread, center) in zip(shares, parts, strict=True)])


def _holed_ball(size: Sizes) -> MassSpread:
    outer, inner = size("radius"), size("hole")
    whole, hole = _less(3, outer, inner)
    return joined([Part(whole, _ball(outer)), Part(hole, _ball(inner), size("offset"))])


def _bored(size: Sizes) -> MassSpread:
    """About an axis along its length, called y; the line to the hole is z."""
    outer, inner = size("radius"), size("hole")
    whole, hole = _less(2, outer, inner)
    discs = [MassSpread(of(0.25, radius), of(0.25, radius)) for radius in (outer, inner)]
    spread = joined([Part(whole, discs[0]), Part(hole, discs[1], size("offset"))])
    return MassSpread(spread.xx, spread.zz, spread.center, ZERO)


def _prism(size: Sizes, sides: int) -> Expression:
    return of((2.0 + cos(2.0 * pi / sides)) / 12.0, size("radius"))


def _thick(size: Sizes) -> MassSpread:
    return MassSpread(Number(0.25) * (Power(size("radius"), 2) + Power(size("bore"), 2)), ZERO)


TABLE: dict[str, Callable[[Sizes], MassSpread]] = {
    "FixedBall": lambda _: MassSpread(ZERO, ZERO),
    "Sphere": lambda size: _ball(size("radius")),
    "SphericalShell": lambda size: MassSpread(of(1.0 / 3.0, size("radius")), of(1.0 / 3.0, size("radius"))),
    "HollowSphere": _hollow,
    "Cylinder": lambda size: MassSpread(of(0.25, size("radius")), of(1.0 / 12.0, size("height"))),
    "Disc": lambda size: MassSpread(of(0.25, size("radius")), ZERO),
    "Roller": lambda size: MassSpread(of(0.25, size("radius")), ZERO),
    "Hoop": lambda size: MassSpread(of(0.5, size("radius")), ZERO),
    "Pipe": lambda size: MassSpread(of(0.5, size("radius")), ZERO),
    "ThickPipe": _thick,
    "UniformRod": lambda size: MassSpread(ZERO, of(1.0 / 12.0, size("length"))),
    "Bar": lambda size: MassSpread(
        of(1.0 / 12.0, size("width")), of(1.0 / 12.0, size("length")), yy=of(1.0 / 12.0, size("thickness"))
    ),
    "Hemisphere": _hemisphere,
    "SphericalCap": _cap,
    "Bowl": _bowl,
    "SphereWithHole": _holed_ball,
    "BoredCylinder": _bored,
}


def mass_spread(shape: Shape, size: Sizes) -> MassSpread | None:
    """What the table has for a body; None if it is not in it."""
    name = type(shape).__name__
    if name in ("PolygonalPrism", "LongPrism"):
        long = of(1.0 / 12.0, size("height")) if name == "PolygonalPrism" else ZERO
        return MassSpread(_prism(size, getattr(shape, "sides", 4)), long)
    found = TABLE.get(name)
    return found(size) if found is not None else None


def candidates(spread: MassSpread) -> list[Expression]:
    """The moment of inertia over the mass about each of its own axes, and across it."""
    x, y, z = spread.xx, spread.yy_or_xx, spread.zz
    return [_collected(x + z), _collected(x + y), _collected(y + z)]


def _collected(held: Expression) -> Expression:
    """A sum in which terms that differ by a number alone are one."""
    parts: dict[Expression, float] = {}
    for term in held.terms if isinstance(held, Sum) else (held,):
        factors = term.factors if isinstance(term, Product) else (term,)
        number = prod(factor.x for factor in factors if isinstance(factor, Number))
        rest = reduce(multiplied, (factor for factor in factors if not isinstance(factor, Number)), ONE)
        parts[rest] = parts.get(rest, 0.0) + number
    return summed(multiplied(Number(number), rest) for rest, number in parts.items())
