"""Drawings of hanging blocks, pulleys, hooks, and hands that pull."""

from collections.abc import Iterator

from sim2reason.figures.paths import PathKnot, has_faces, is_pulley, owner_name
from sim2reason.figures.pieces import DrawingPlan, Piece, draws, positions_around
from sim2reason.figures.plane import UP, Polygon, degrees, dot, rectangle, ring, unit_vector
from sim2reason.figures.shapes import (
    MAX_LETTER_LENGTH,
    SIZE,
    SMALL,
    TINY,
    Arc,
    Area,
    LabelRequest,
    LineShape,
    Shape,
    Sketch,
    axle_dot,
    hatched_line,
    width,
)
from sim2reason.scenes.dsl.body import PulleyWheel
from sim2reason.scenes.dsl.body import Small as SmallBody
from sim2reason.scenes.dsl.mechanism import ConstantTension

BRACKET, PLATE = 0.95, 1.1  # units from an axle to its support, and width of the support
ARROW_LENGTH = 1.3
LABEL_OFFSET = 0.22  # units from the middle of a block to the name above it and to the mass below it


@draws(SmallBody)
class BlockPiece(Piece):
    """A hanging block."""

    def anchor(self, knot: PathKnot, way: complex, *, second: bool) -> complex:
        """Return the middle of the block's side at which a string segment begins."""
        del knot, second
        sizes = self.plan.sizes
        steep = abs(way.imag) * sizes.width >= abs(way.real) * sizes.height
        return way * (0.5 * sizes.height / abs(way.imag) if steep else 0.5 * sizes.width / abs(way.real))

    def hulls(self) -> list[Polygon]:
        """Return the rectangle of the block."""
        return [rectangle(0j, self.plan.sizes.width, self.plan.sizes.height)]

    def sketch(self) -> Sketch:
        """Return a rectangle with its name inside."""
        return Sketch([Area(self.hulls()[0], "block")], block_labels(self.plan, self.name, 0j))


def block_labels(
    plan: DrawingPlan, address: str, center: complex, size: tuple[float, float] | None = None
) -> list[LabelRequest]:
    """Return the labels of a block's name and mass: inside the block if they fit."""
    name, mass = plan.name(address), plan.mass(address)
    broad, tall = size or (plan.sizes.width, plan.sizes.height)
    inside, out = len(name) <= MAX_LETTER_LENGTH, 0.5 * tall + 0.3
    both = bool(mass) and inside and width(mass, TINY) < broad and tall > SIZE + 2.0 * LABEL_OFFSET
    mass_labels: list[LabelRequest] = []
    if mass:
        aside = 0.5 * (broad + width(mass, TINY)) + 0.12
        spots = tuple(
            center + spot for spot in ((-LABEL_OFFSET * 1j,) if both else ()) + (out * 1j, aside, -aside, -out * 1j)
        )
        mass_labels = [LabelRequest(mass, spots, address, TINY, name=False, anchors=(center + 0.4 * tall * 1j,))]
    if inside:
        first = center + LABEL_OFFSET * 1j if both else center
        return [LabelRequest(name, (first, center, center - out * 1j, center + out * 1j), address), *mass_labels]
    wide = width(name, SIZE)
    across, up = 0.5 * (broad + wide) + 0.15, 0.5 * tall + 0.35
    beside = [center + spot for spot in (across, -across, -1j * up, 1j * up)]
    far = 0.5 * max(broad, tall) + 0.2
    return [LabelRequest(name, (*beside, *positions_around(center, far, wide)), address), *mass_labels]


@draws(PulleyWheel)
class PulleyPiece(Piece):
    """A pulley; `address` is that of the body, which for a movable pulley is not the name of the piece."""

    def __init__(self, name: str, plan: DrawingPlan) -> None:
        """Find the pulley of this piece (it may hang from a massless carrier), its size, and where it is fixed."""
        super().__init__(name, plan)
        own = [knot.item for knots in plan.paths.knots.values() for knot in knots if knot.piece == name and knot.rim]
        self.address = own[0] if own else name
        self.bend = plan.bends.get(self.address)
        self.radius = plan.sizes.radius * plan.wider.get(name, 1.0)
        self.fixed = is_pulley(plan.scene.bodies.get(self.address), fixed=True)
        self.corners = list(self._corners()) if self.fixed else []
        self.mounted = self.fixed and not self.corners

    def _corners(self) -> Iterator[str]:
        """Yield the pieces with faces from which a string reaches the pulley; it can be mounted on their corners."""
        for strand in self.plan.paths.strands:
            for here, there in ((strand.a, strand.b), (strand.b, strand.a)):
                on_face = not there.rim and has_faces(self.plan.scene.bodies.get(there.piece))
                if here.piece == self.name and on_face and self._has_outer_string(there):
                    yield there.piece

    def _has_outer_string(self, block: PathKnot) -> bool:
        """Return whether a string passes on the outer side of the pulley, so that no bracket to a plane crosses it."""
        ways = self.plan.ends.get(block.item, ())
        if self.bend is None or not ways:
            return False
        direction = max(
            (-w for w in ways),
            key=lambda w: max(dot(w, bend_direction) for bend_direction in self.bend.directions) if self.bend else 0.0,
        )
        out = direction * 1j if (direction * 1j).imag > 0.0 else direction * -1j
        return dot(self.bend.touches(direction), out) > 0.0

    def anchor(self, knot: PathKnot, way: complex, *, second: bool) -> complex:
        """Return the point on the rim, or on the axle, where a string segment begins."""
        del way
        if not knot.rim or self.bend is None:
            return 0j
        return self.radius * self.bend.rim(second=second)

    @property
    def support(self) -> complex:
        """Return the direction of the support of a fixed pulley: up, left, right or down."""
        if self.bend is None:
            return UP
        bend = self.bend
        ways = (UP, 1.0 + 0j, -1.0 + 0j, -UP)
        return max(
            ways,
            key=lambda direction: (
                dot(direction, bend.support_direction) - 2.0 * max(0.5, *(dot(direction, w) for w in bend.directions))
            ),
        )

    @property
    def bracket(self) -> float:
        """Return the distance from the axle to the support, in units."""
        return BRACKET + self.radius - self.plan.sizes.radius

    def hulls(self) -> list[Polygon]:
        """Return the hulls of the disc and, if the pulley is fixed, of its bracket."""
        polygons = [ring(0j, self.radius + 0.05)]
        if self.mounted:
            polygons.append(rectangle(self.support * (self.bracket + 0.15), PLATE, 0.35, self.support * -1j))
        return polygons

    @property
    def level(self) -> tuple[str, float] | None:
        """Return the height of pulleys under the ceiling, which they share if possible."""
        return ("ceiling", self.bracket - BRACKET) if self.fixed and self.support == UP else None

    def sketch(self) -> Sketch:
        """Return the sketch of a circle with its axle, the string round it, and a bracket."""
        radius = self.radius
        body = self.plan.scene.bodies.get(self.address)
        massive = body is not None and isinstance(body.look, PulleyWheel) and body.look.solid
        shapes: list[Shape] = [Arc(0j, radius, fill="disc" if massive else "")]
        if self.mounted:
            shapes += plate(self.support, far=self.bracket)
        shapes += [axle_dot(0j), *self._string()]
        start = -self.bend.support_direction if self.bend is not None and not self.fixed else unit_vector(1 + 1j)
        text = self.plan.caption(self.address)
        size = SIZE if text == self.plan.name(self.address) else SMALL
        places = positions_around(0j, radius + 0.1, width(text, size), start=start)
        return Sketch(shapes, [LabelRequest(text, places, self.address, size)])

    def _string(self) -> list[Shape]:
        """Return the part of the string that lies on the rim."""
        if self.bend is None:
            return []
        return [wrapped(self.bend.rim(), self.bend.rim(second=True), self.bend.support_direction, 0j, self.radius)]


def wrapped(first: complex, last: complex, middle: complex, center: complex, radius: float) -> Shape:
    """Return the arc of a string along a rim from one tangent point to the other, by way of `middle`."""
    low, high = sorted((degrees(first), degrees(last)))
    inside = low <= degrees(middle) <= high
    start, stop = (low, high) if inside or high - low < 1e-6 else (high, low + 360.0)
    return Arc(center, radius, start, stop, weight="string")


def plate(direction: complex, start: complex = 0j, far: float = BRACKET, wide: float = PLATE) -> list[Shape]:
    """Return the shapes of a bracket from `start` along `direction` to a hatched support."""
    end, half = start + direction * far, 0.5 * wide * direction * 1j
    return [LineShape((start, end), "edge"), *hatched_line(end - half, end + half)]


class EndPiece(Piece):
    """A piece at the end of a string, in line with the string."""

    @property
    def direction(self) -> complex:
        """Return the direction from the string outwards."""
        ends = self.plan.ends.get(self.name, ())
        return -ends[0] if ends else UP

    def anchor(self, knot: PathKnot, way: complex, *, second: bool) -> complex:
        """Return the point where the string ends."""
        del knot, way, second
        return 0j


class HookPiece(EndPiece):
    """A hook fixed to the surroundings."""

    def hulls(self) -> list[Polygon]:
        """Return the hull of the hook with its plate."""
        return [rectangle(self.direction * 0.25, 1.0, 0.6, self.direction * -1j)]

    @property
    def level(self) -> tuple[str, float] | None:
        """Return the height of hooks in the ceiling, which they share with the pulleys there."""
        return ("ceiling", 0.35 - BRACKET) if self.direction.imag > 0.99 else None

    def sketch(self) -> Sketch:
        """Return the sketch of a ring with a hatched support."""
        return Sketch([*plate(self.direction, self.direction * 0.1, 0.25, 1.0), Arc(0j, 0.1)])


class HandPiece(EndPiece):
    """A hand or winch, drawn as an arrow with its force or speed."""

    def hulls(self) -> list[Polygon]:
        """Return the hulls of the arrow and its label."""
        return [rectangle(self.direction * 0.5 * ARROW_LENGTH, ARROW_LENGTH, 0.5, self.direction)]

    def sketch(self) -> Sketch:
        """Return the sketch of a grip, an arrow, and the force or speed as in the text."""
        text = pull_text(self.plan, self.name)
        grip = Area(rectangle(0j, 0.14, 0.4, self.direction), "ink")
        wide = width(text, SMALL)
        places = tuple(
            self.direction * along + complex(across.real * (0.5 * wide + 0.16), across.imag * 0.38)
            for along in (0.75, 1.1, 0.4)
            for across in (self.direction * 1j, self.direction * -1j)
        ) + positions_around(self.direction * ARROW_LENGTH, 0.15, wide, start=self.direction)
        label = LabelRequest(text, places, self.name, SMALL, name=False)
        return Sketch([LineShape((0j, self.direction * ARROW_LENGTH), "string", arrow=True), grip], [label])


def pull_text(plan: DrawingPlan, hand: str) -> str:
    """Return the label of a hand's force or a winch's speed; with a letter if there is only one."""
    drawing = plan.scene.builder.drawing
    law = drawing[hand]
    alone = sum(type(other) is type(law) for other in drawing.values()) == 1
    letter, unit_vector, value = ("F", "N", law.force) if isinstance(law, ConstantTension) else ("v", "m/s", law.reel)
    text = plan.stated(owner_name(hand), unit_vector, value)
    return plan.labelled_number(letter, text) if alone else text
