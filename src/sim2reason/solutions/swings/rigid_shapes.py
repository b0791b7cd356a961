"""Shapes of rigid bodies: mean squares of distances for moments of inertia, and prisms that tip over edges.

Bodies are described in their own axes, of which z is the axis of the body: by the position along z of the centre of
mass relative to the reference point, and by the mean squares of x, y and z relative to the centre of mass, so that
I_z = m (⟨x²⟩ + ⟨y²⟩).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from math import cos, pi, prod

from sim2reason.scenes.dsl.solids import Shape
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Product, Sum, multiply_factors
from sim2reason.solutions.algebra.functions import PI, Call, Power, sum_formulas, sum_of_squares
from sim2reason.solutions.algebra.rounded_numbers import simple_fraction
from sim2reason.solutions.writing.notation import JOULES
from sim2reason.solutions.writing.steps import SolutionBuilder, record_inequality

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


def scaled_square(share: float, length: Expression) -> Expression:
    """Return the number `share` times the square of a length."""
    return Number(share) * Power(length, 2)


def combine_parts(parts: list[Part]) -> MeanSquares:
    """Combine parts of a body, displaced along z, into mean squares of the whole, by the parallel-axis theorem."""
    center, xx, zz = ZERO, ZERO, ZERO
    for part in parts:
        center = center + part.share * part.height
        xx = xx + part.share * part.spread.xx
        zz = zz + part.share * part.spread.zz + part.share * sum_of_squares([part.height])
    return MeanSquares(xx, zz - sum_of_squares([-center if center.negative else center]), center)


def _ball(radius: Expression) -> MeanSquares:
    return MeanSquares(scaled_square(0.2, radius), scaled_square(0.2, radius))


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
        f"${scaled_square(0.4, radius).latex()}$ times its mass; about the parallel line through the centre of mass "
        f"it is less by ${Power(center * radius, 2).latex()}$ times the mass."
    )
    along = scaled_square(0.2, radius) - scaled_square(9.0 / 64.0, radius)
    return MeanSquares(scaled_square(0.2, radius), along, center * radius, square=square, why=why)


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
    combined = combine_parts(
        [Part(share, spread, center) for share, (spread, center) in zip(shares, parts, strict=True)]
    )
    why = (
        "A bowl is a solid cap less a smaller one, of the same density; the moments of inertia of caps follow by "
        "integration over thin discs parallel to their flat faces."
    )
    return replace(combined, why=why, why_own=why)


def _holed_ball(size: Sizes) -> MeanSquares:
    outer, inner = size("radius"), size("hole")
    full, hole = _less(3, outer, inner)
    combined = combine_parts([Part(full, _ball(outer)), Part(hole, _ball(inner), size("offset"))])
    why = "It is a solid ball less the one that would fill the hole, of the same density."
    return replace(combined, why=why, why_own=why)


def _bored(size: Sizes) -> MeanSquares:
    """Return the mean squares of a cylinder with a parallel bore; y is the axis and z the line to the bore."""
    outer, inner = size("radius"), size("hole")
    full, hole = _less(2, outer, inner)
    discs = [MeanSquares(scaled_square(0.25, radius), scaled_square(0.25, radius)) for radius in (outer, inner)]
    spread = combine_parts([Part(full, discs[0]), Part(hole, discs[1], size("offset"))])
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
    transverse = square if simple_fraction(plain) is None else scaled_square(plain, radius)
    return MeanSquares(transverse, long, why=why + high, why_own=why + double)


def _thick(size: Sizes) -> MeanSquares:
    return MeanSquares(Number(0.25) * (Power(size("radius"), 2) + Power(size("bore"), 2)), ZERO)


TABLE: dict[str, Callable[[Sizes], MeanSquares]] = {
    "FixedBall": lambda _: MeanSquares(ZERO, ZERO),
    "Sphere": lambda size: _ball(size("radius")),
    "SphericalShell": lambda size: MeanSquares(
        scaled_square(1.0 / 3.0, size("radius")), scaled_square(1.0 / 3.0, size("radius"))
    ),
    "HollowSphere": _hollow,
    "Cylinder": lambda size: MeanSquares(
        scaled_square(0.25, size("radius")), scaled_square(1.0 / 12.0, size("height"))
    ),
    "Disc": lambda size: MeanSquares(scaled_square(0.25, size("radius")), ZERO),
    "Roller": lambda size: MeanSquares(scaled_square(0.25, size("radius")), ZERO),
    "Hoop": lambda size: MeanSquares(scaled_square(0.5, size("radius")), ZERO),
    "Pipe": lambda size: MeanSquares(scaled_square(0.5, size("radius")), ZERO),
    "ThickPipe": _thick,
    "UniformRod": lambda size: MeanSquares(ZERO, scaled_square(1.0 / 12.0, size("length"))),
    "Bar": lambda size: MeanSquares(
        scaled_square(1.0 / 12.0, size("width")),
        scaled_square(1.0 / 12.0, size("length")),
        yy=scaled_square(1.0 / 12.0, size("thickness")),
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
        long = scaled_square(1.0 / 12.0, size("height")) if name == "PolygonalPrism" else ZERO
        return _prism(size, getattr(shape, "sides", 4), long)
    builder = TABLE.get(name)
    return builder(size) if builder is not None else None


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


def _collected(expression: Expression) -> Expression:
    """Return a sum in which terms that differ only in a numerical factor are combined."""
    parts: dict[Expression, float] = {}
    for term in expression.terms if isinstance(expression, Sum) else (expression,):
        factors = term.factors if isinstance(term, Product) else (term,)
        number = prod(factor.x for factor in factors if isinstance(factor, Number))
        rest = reduce(multiply_factors, (factor for factor in factors if not isinstance(factor, Number)), ONE)
        parts[rest] = parts.get(rest, 0.0) + number
    return sum_formulas(multiply_factors(Number(number), rest) for rest, number in parts.items())


HALF = Number(0.5)


def shape_words(who: str, sides: int, turn: Expression) -> str:
    """Return the words before the moment of inertia of a regular prism about its axis."""
    return (
        "About one of its corners the moment of inertia of a uniform triangle is its mass times one sixth of the sum "
        "of three terms: the squares of the two sides that meet there, and their product times the cosine of the angle "
        f"between them. Lines from the axis to the edges divide {who} into {sides} equal triangles, with the angle "
        f"${turn.latex()}$ at the axis, so its moment of inertia about that is"
    )


def sinking_words(radius: Expression, half: Expression, slope: Expression) -> str:
    """Return a clause about the distance by which the axis sinks from one landing to the next."""
    if slope == ZERO:
        return "When the next edge lands, the axis is as high as before"
    drop = Number(2.0) * radius * Call("sin", half) * Call("sin", slope)
    moves = "the axis moves by one side of the base along the plane"
    return f"Until the next edge lands, {moves} and sinks by ${drop.latex()}$"


def landing_words(speed: Expression, turn: Expression, law: str) -> str:
    """Return the sentences before the conservation of angular momentum about a new edge."""
    fast, angle = speed.latex(), turn.latex()
    sentence = f"Just before, the axis has the speed ${fast}$, at the angle ${angle}$ to its direction just after."
    return f"{sentence} Angular momentum about the new edge is conserved: {law},"


def angle_words(half: Expression, angle: Expression) -> str:
    """Return the sentence that gives the angle of the line from edge to axis with the vertical."""
    return (
        "At the start, and whenever an edge lands, the line from the lower edge to the axis is turned uphill by "
        f"${half.latex()}$ from the perpendicular to the plane. At the moment asked about, its angle with the "
        f"vertical is ${angle.latex()}$, positive downhill."
    )


def velocities_words(turned: Expression, *, highest: bool, landed: bool) -> str:
    """Return the sentences that give the angle between the initial and final velocities of the axis.

    `turned` is the final angle turned, since the last landing if the prism has `landed`; `highest` states that the axis
    is then at the top, before any landing.
    """
    angle = f"${turned.latex()}$"
    how = f"Since the start it has turned by {angle}"
    if landed:
        how = f"Just after each landing it has its first direction again; since the last it has turned by {angle}"
    elif highest:
        how = f"At the start it makes the angle {angle} with the vertical, and in the end it is vertical"
    line = "The velocity of the axis is perpendicular to the line from the lower edge to it."
    return f"{line} {how}, so this is the angle between the initial and the final velocity."


def write_sentence(book: SolutionBuilder, sentence: str) -> None:
    """Write a step that only contains a given sentence, on which no result depends."""
    step = book.begin_step("extreme")
    step.add_text(sentence)
    step.close()


def verify_tops(
    book: SolutionBuilder, rates: Sequence[Expression], inertia: Expression, weight: Expression, begins: Expression
) -> None:
    """Schedule the verification that the axis passes over every edge from which another one is reached.

    The last of the `rates` is that after the last landing: its edge is included if the energy suffices to pass it.
    """
    if book.in_symbols or len(rates) < 2 or book.value(begins) >= 0.0:
        return

    def write() -> None:
        top = weight * (ONE - Call("cos", begins))
        over = book.value(HALF * inertia * Power(rates[-1], 2)) > book.value(top)
        smallest = min(rates if over else rates[:-1], key=book.value)
        energy = HALF * inertia * (Power(smallest, 2))
        step, names = book.begin_step("verify"), [book.fresh("K", r"\text{min}"), book.fresh("U", r"\text{top}")]
        record_inequality(book, step, energy, top)
        verified = [step.verified(name, value, JOULES) for name, value in zip(names, (energy, top), strict=True)]
        edges, landing = ("each edge", "a landing") if over else ("each edge before the last", "an earlier landing")
        step.add_text(
            f"The axis passes over {edges}, since the least kinetic energy at the start or just after {landing},"
        )
        step.add_text(f"{verified[0]}, exceeds the energy {verified[1]} by which it rises.")
        step.close()

    book.afterwards.append(write)
