"""Drawings of surfaces and the blocks on them: fixed planes, wedges on a floor, and prisms on a floor."""

from cmath import rect
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import atan2, radians, tan
from math import degrees as to_degrees

from sim2reason.figures import shapes
from sim2reason.figures.hanging import block_labels, wrapped
from sim2reason.figures.paths import PathKnot, flat, is_plane, owner_name
from sim2reason.figures.pieces import Bend, DrawingPlan, Piece, draws
from sim2reason.figures.plane import (
    RIGHT,
    ZERO_COMPONENT_TOL,
    Polygon,
    box,
    cross,
    dot,
    drawn_direction,
    hull,
    mirror,
    rectangle,
    ring,
    unit_vector,
)
from sim2reason.figures.shapes import (
    SIZE,
    SMALL,
    Arc,
    Area,
    LabelRequest,
    LineShape,
    Shape,
    Sketch,
    hatched_line,
    rough,
    width,
)
from sim2reason.scenes.dsl.body import FixedPlane, MovingSlope

HEAD, TOE, TOE_SITE = 0.95, 1.25, 1.6  # of a face that is free above its highest and below its lowest thing
SHORTEST, LONGER = 3.8, 1.7  # of a face; and by what factor it may be stretched to reach the floor
SLAB_THICKNESS = 0.35  # thickness of a level plane
FLOOR_MARGIN = 0.9  # units by which a floor extends beyond a wedge
ZERO_SLOPE_TOL = 1e-6


@dataclass(frozen=True)
class Facet:
    """A face of a plane or wedge: its blocks with distances from the upper end, and the pulleys at its ends."""

    uphill: complex
    normal: complex
    blocks: dict[str, float]
    foot: str = ""  # the site of a small pulley at the lower end
    top: str = ""
    length: float = 0.0

    def at(self, down: float) -> complex:
        """Return the point of the face at a distance from its upper end."""
        return -down * self.uphill


@draws(FixedPlane, MovingSlope)
class FacePiece(Piece):
    """A plane, wedge or prism with its blocks: one face, or two that meet at the top, which is the origin."""

    def __init__(self, name: str, plan: DrawingPlan) -> None:
        """Distribute the blocks and pulleys over the faces in the order that they have in the mechanism."""
        super().__init__(name, plan)
        body = plan.scene.bodies[name]
        self.fixed = is_plane(body)
        self.faces = [self._spread(face) for face in self._find_faces()]
        if name in plan.mirrored:
            self.faces = [_mirrored(face) for face in self.faces]
        self.mirrors = len(self.faces) == 1 and abs(self.faces[0].uphill.imag) > ZERO_SLOPE_TOL
        self._stand()

    # -- reading the mechanism ---------------------------------------------------------------------

    def _find_faces(self) -> Iterator[Facet]:
        """Yield the faces with their blocks, lowest block first, at the distances of the mechanism."""
        mechanism = self.plan.paths.mechanism
        groups: dict[complex, tuple[complex, list[tuple[float, str]]]] = {}
        for block, carrier in self.plan.paths.carriers.items():
            if carrier == self.name:
                body = mechanism.body[block]
                along = mechanism.contacts[block].slip[0][0]
                axis = next(c.axis for c in body.coordinates if c.name == along)
                up = flat(axis)
                up = -up if up.imag < -ZERO_COMPONENT_TOL or (up.imag <= ZERO_COMPONENT_TOL and up.real < 0.0) else up
                groups.setdefault(drawn_direction(up), (up, []))[1].append((dot(flat(body.at), up), block))
        if not groups:
            bare = rect(1.0, radians(getattr(self.plan.scene.bodies[self.name], "angle", 0.0)))
            groups[drawn_direction(bare)] = bare, []
        for uphill, (up, members) in groups.items():
            sites = self._sites(up)
            inside = [s for s, _ in members]
            foot = max(((s, site) for s, site in sites if s < min(inside, default=0.0)), default=(0.0, ""))[1]
            top = min(((s, site) for s, site in sites if s > max(inside, default=0.0)), default=(0.0, ""))[1]
            normal = uphill * 1j if (uphill * 1j).imag > 0.0 else uphill * -1j
            yield Facet(uphill, normal, {block: s for s, block in sorted(members)}, foot, top)

    def _sites(self, uphill: complex) -> list[tuple[float, str]]:
        """Return the points on a face at which strings bend: pairs of position along the face and name."""
        rims = {knot.item for knots in self.plan.paths.knots.values() for knot in knots if knot.rim}
        sites = [s for s in self.plan.paths.mechanism.sites if s.body == self.name and s.name in rims]
        return [(dot(flat(s.at), uphill), s.name) for s in sites if abs(cross(flat(s.at), uphill)) < 1e-6]

    def _spread(self, face: Facet) -> Facet:
        """Return the face with distances suited to the drawing in place of those of the mechanism."""
        sizes = self.plan.sizes
        down, places = HEAD + (0.35 if face.top else 0.0), dict[str, float]()
        for block in reversed(face.blocks):
            places[block] = down + 0.5 * sizes.width
            down += sizes.width + sizes.link
        length = max(SHORTEST, down - sizes.link + (TOE_SITE if face.foot else TOE))
        return Facet(face.uphill, face.normal, places, face.foot, face.top, length)

    def _stand(self) -> None:
        """Extend the shorter of two faces to the floor below the longer one, unless that stretches it too much."""
        deep = max(face.length * face.uphill.imag for face in self.faces)
        stretched: list[Facet] = []
        for face in self.faces:
            wish = deep / face.uphill.imag if face.uphill.imag > ZERO_SLOPE_TOL else face.length
            length = wish if wish <= LONGER * face.length else face.length
            stretched.append(Facet(face.uphill, face.normal, face.blocks, face.foot, face.top, length))
        self.faces = stretched
        self.base = -deep if deep > ZERO_SLOPE_TOL else -SLAB_THICKNESS

    # -- what others ask ---------------------------------------------------------------------------

    def _face(self, item: str) -> Facet:
        return next(f for f in self.faces if item in f.blocks or item in (f.foot, f.top))

    def center(self, block: str) -> complex:
        """Return the centre of a block."""
        face = self._face(block)
        return face.at(face.blocks[block]) + 0.5 * self.plan.sizes.height * face.normal

    def wheel(self, site: str) -> complex:
        """Return the centre of a small pulley; its string runs parallel to the face at half the blocks' height."""
        bend, face = self.plan.bends[site], self._face(site)
        heights = [self._lift(f, bend) for f in self.faces if site in (f.foot, f.top)]
        if len(heights) == 2:  # over the apex: at the right height above both faces
            one, other = self.faces
            middle = unit_vector(one.normal + other.normal)
            return middle * heights[0] / dot(middle, one.normal)
        return (face.at(face.length - 0.3) if site == face.foot else 0j) + heights[0] * face.normal

    def _lift(self, face: Facet, bend: Bend) -> float:
        along = max(bend.directions, key=lambda direction: abs(dot(direction, face.uphill)))
        return 0.5 * self.plan.sizes.height - self.plan.sizes.small * dot(bend.touches(along), face.normal)

    def anchor(self, knot: PathKnot, way: complex, *, second: bool) -> complex:
        """Return the point where a string segment begins: on a small pulley's rim, or at the side of a block."""
        if knot.rim:
            return self.wheel(knot.item) + self.plan.sizes.small * self.plan.bends[knot.item].rim(second=second)
        if knot.item not in self.plan.paths.carriers:
            return 0j
        face = self._face(knot.item)
        side = 1.0 if dot(way, face.uphill) > 0.0 else -1.0
        return self.center(knot.item) + 0.5 * side * self.plan.sizes.width * face.uphill

    def lead(self, knot: PathKnot, way: complex) -> float:
        """Return the length of the part of a string segment that lies over this piece's face or floor."""
        start = self.anchor(knot, way, second=False)
        if knot.rim:
            left, _, right, _ = box([*self.outline(), 0j])
            return max(0.0, (right if way.real > 0.0 else -left) - start.real * (1 if way.real > 0.0 else -1)) + 0.1
        face = self._face(knot.item)
        end = 0.0 if dot(way, face.uphill) > 0.0 else -face.length
        return abs(end - dot(start, face.uphill))

    def edge(self, way: complex) -> complex | None:
        """Return the upper or lower end of the face, by the given direction."""
        face = max(self.faces, key=lambda f: abs(dot(way, f.uphill)))
        return 0j if dot(way, face.uphill) > 0.0 else face.at(face.length)

    @property
    def level(self) -> tuple[str, float] | None:
        """Return the height of the floor, which all wedges share if possible."""
        return None if self.fixed else ("floor", self.base)

    # -- the drawing -------------------------------------------------------------------------------

    def outline(self) -> Polygon:
        """Return the outline of the solid, counterclockwise from its lower left corner."""
        ends = [face.at(face.length) for face in self.faces]
        if len(ends) == 1:
            ends.append(0j)
        ends.sort(key=lambda end: end.real)
        left, right = ends
        corners = [complex(left.real, self.base), complex(right.real, self.base), right, 0j, left]
        kept = [a for a, b in pairwise([*corners, corners[0]]) if abs(a - b) > 1e-6]
        return tuple(kept)

    def hulls(self) -> list[Polygon]:
        """Return the hulls of the solid with its floor, and of the blocks on its faces."""
        solid = self.outline()
        left, low, right, _ = box(solid)
        extra = 0.0 if self.fixed else FLOOR_MARGIN
        sizes = self.plan.sizes
        blocks = [
            rectangle(self.center(block), sizes.width, sizes.height, face.uphill)
            for face in self.faces
            for block in face.blocks
        ]
        floor = rectangle(complex(0.5 * (left + right), low - 0.1), right - left + 2.0 * extra, 0.2)
        wheels = [ring(self.wheel(site), sizes.small) for site in self._wheels()]
        return [hull(solid), floor, *blocks, *wheels]

    def _wheels(self) -> list[str]:
        return list(dict.fromkeys(s for f in self.faces for s in (f.foot, f.top) if s in self.plan.bends))

    def sketch(self) -> Sketch:
        """Return the sketch of the solid, its floor, its angles, its blocks and small pulleys."""
        solid = self.outline()
        combined = Sketch([Area(solid, "fixed" if self.fixed else "wedge")])
        left, low, right, _ = box(solid)
        extra = 0.0 if self.fixed else FLOOR_MARGIN
        combined.shapes += hatched_line(complex(left - extra, low), complex(right + extra, low))
        for site in self._wheels():
            combined.shapes += self._small(site)
        for face in self.faces:
            if face.uphill.imag > ZERO_SLOPE_TOL:
                self._angle(face, combined)
            for block in face.blocks:
                center = self.center(block)
                sizes = self.plan.sizes
                combined.shapes.append(Area(rectangle(center, sizes.width, sizes.height, face.uphill), "block"))
                combined.labels += block_labels(self.plan, block, center)
        self._rough(combined)
        if not self.fixed:
            combined.labels.append(self._name())
        return combined

    def _small(self, site: str) -> Iterator[Shape]:
        """Yield the shapes of a small pulley on its bracket, with the string round it."""
        center, bend, radius = self.wheel(site), self.plan.bends[site], self.plan.sizes.small
        face = self._face(site)
        foot = face.at(face.length - 0.3) if site == face.foot else 0j
        yield Arc(center, radius, fill="disc")
        yield LineShape((foot, center), "edge")
        yield shapes.axle_dot(center, 0.03)
        yield wrapped(bend.rim(), bend.rim(second=True), -sum(bend.directions), center, radius)

    def _angle(self, face: Facet, found: Sketch) -> None:
        """Draw the angle at the foot of a face, with its value."""
        foot, side = face.at(face.length), 1.0 if face.uphill.real > 0.0 else -1.0
        value = to_degrees(atan2(face.uphill.imag, abs(face.uphill.real)))
        text = self.plan.stated(owner_name(self.name), "deg", value)
        if not text:
            return
        wide, half = width(text, SMALL), radians(0.5 * value)
        room = (0.5 * SMALL + 0.09) / tan(half) - 0.1  # where a text of this height fits in
        radius = min(max(0.75, room), max(0.3, 0.9 * face.length * abs(face.uphill.real) - wide))
        start, stop = (0.0, value) if side > 0.0 else (180.0 - value, 180.0)
        found.shapes.append(Arc(foot, radius, start, stop, weight="thin"))
        if foot.imag > self.base + 0.05:
            found.shapes.append(LineShape((foot, foot + side * RIGHT * 1.3), "hair", dashed=True))
        middle = unit_vector(face.uphill + side * RIGHT)
        reach = radius + 0.5 * wide * abs(middle.real) + 0.5 * SMALL * abs(middle.imag) + 0.1
        inside = tuple(foot + middle * (reach + 0.1 * step) for step in range(8))
        outside = tuple(foot + complex(-side * (0.5 * wide + 0.1 + 0.2 * n), 0.25 + 0.1 * n) for n in range(4))
        found.labels.append(LabelRequest(text, inside + outside, self.name, SMALL, name=False))

    def _rough(self, found: Sketch) -> None:
        """Draw dots under faces with friction, and the friction coefficient as in the text."""
        lying = [self.plan.paths.mechanism.contacts[b] for face in self.faces for b in face.blocks]
        if not any(contact.friction for contact in lying):
            return
        for face in self.faces:
            found.shapes.append(rough(face.at(face.length), 0j, face.normal))
        owner = owner_name(self.name)
        text = next((coefficient for contact in lying if (coefficient := self.plan.friction_text(owner, contact))), "")
        if text:
            solid = self.outline()
            left, low, right, _ = box(solid)
            middle, wide = sum(solid) / len(solid), 0.5 * width(text, SMALL)
            inside = tuple(
                middle + complex(dx, dy) for dy in (-0.15, 0.2, -0.45) for dx in (0.0, 0.35, -0.35, 0.7, -0.7)
            )
            outside = tuple(complex(x, low + dy) for dy in (0.3, 0.6) for x in (right + 0.3 + wide, left - 0.3 - wide))
            below = tuple(complex(x, low - 0.5) for x in (0.5 * (left + right), right - wide, left + wide, left))
            found.labels.append(LabelRequest(text, (*inside, *below, *outside), self.name, SMALL, name=False))

    def _name(self) -> LabelRequest:
        """Return the label of the body, near the middle of the solid."""
        corners = self.outline()
        middle = sum(corners) / len(corners)
        text = self.plan.caption(self.name)
        size = SIZE if text == self.plan.name(self.name) else SMALL
        wide = 0.5 * width(text, size)
        steps = (0, -0.35, 0.35, -0.7, 0.7, -1.05, 1.05, -1.4, 1.4)
        spots = tuple(middle + dx + 1j * dy for dy in (0, -0.25, 0.25) for dx in steps[:7])
        left, low, right, _ = box(corners)
        beside = tuple(complex(x, low + dy) for dy in (0.35, 0.7, 1.1) for x in (right + 0.3 + wide, left - 0.3 - wide))
        return LabelRequest(text, (*spots[:7], *beside, *spots[7:]), self.name, size)


def _mirrored(face: Facet) -> Facet:
    return Facet(mirror(face.uphill), mirror(face.normal), face.blocks, face.foot, face.top, face.length)
