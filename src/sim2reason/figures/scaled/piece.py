"""Parts of a drawing to scale, labelled with the numbers that the text states about them."""

from cmath import phase
from collections.abc import Iterator
from math import degrees, dist

from sim2reason.figures.paths import PathKnot, owner_name
from sim2reason.figures.pieces import DrawingPlan, Piece, positions_around
from sim2reason.figures.plane import Polygon, box, dot, hull, unit_vector
from sim2reason.figures.scaled import bodies
from sim2reason.figures.scaled.arrows import deflections, heights, speeds, spins
from sim2reason.figures.scaled.grounds import grounds
from sim2reason.figures.scaled.lines import carried_pieces, label_positions, lines
from sim2reason.figures.scaled.pushes import fields, pushes
from sim2reason.figures.scaled.setting import SLAB, DrawingContext, vector
from sim2reason.figures.scaled.tabletop import axes
from sim2reason.figures.shapes import SIZE, SMALL, Arc, LabelRequest, LineShape, Shape, Sketch, axle_dot, outline, width
from sim2reason.scenes.dsl.body import Axial, Globe, PulleyWheel, Slender, Spherical, Tabletop, Unseen
from sim2reason.scenes.dsl.mechanism import RigidBody
from sim2reason.simulation.quantities.subjects.bodies import rim_sites

CLEAR, DIMENSION_SPACING = 0.3, 0.42  # units, from a piece to the first line of dimension and from that to the next
MIN_ANGLE = 1e-6  # degrees; a smaller angle is not drawn
ARC_MARGIN = 0.35  # units beyond the body at which an angle is marked


def sketch_numbers(setting: DrawingContext) -> Sketch:
    """Return the sketch of all stated distances, angles and friction coefficients."""
    sketch = Sketch()
    if not setting.view.level:
        for body in setting.members:
            _pieces(setting, body, sketch)
            _bearing(setting, body, sketch)
        for site, wheel in _turned(setting):
            _leaving(setting, site, wheel, sketch)
        for upper, lower in setting.stacked.items():
            _rubbing(setting, upper, lower, sketch)
    return sketch


def _pieces(setting: DrawingContext, arm: RigidBody, sketch: Sketch) -> None:
    """Draw the distances of several bodies on an arm from its axle, the shortest dimension line innermost."""
    pieces = carried_pieces(setting, arm)
    if len(pieces) < 2:
        return  # its one distance stands at the arm itself
    pivot = setting.view.at(vector(setting.frames[arm.name].origin))
    first = unit_vector(setting.at(pieces[0]) - pivot)
    out = first * (1j if (first * 1j).real >= 0.0 else -1j)
    aside = max(setting.radius(piece) for piece in pieces) + CLEAR
    for piece in sorted(pieces, key=lambda name: abs(setting.at(name) - pivot)):
        end, far = setting.at(piece), dist(setting.place(piece), vector(setting.frames[arm.name].origin))
        text = setting.stated(owner_name(piece), setting.mechanism.units.length, far)
        if text:
            _dimension(pivot, end, aside * out, text, piece, sketch)
            aside += DIMENSION_SPACING


def _dimension(start: complex, end: complex, by: complex, text: str, subject: str, sketch: Sketch) -> None:
    """Draw a double arrow beside a distance, with thin lines to both ends."""
    middle = 0.5 * (start + end) + by
    sketch.shapes += [LineShape((middle, tip + by), "hair", arrow=True) for tip in (start, end)]
    sketch.shapes += [LineShape((tip, tip + 1.05 * by), "hair") for tip in (start, end)]
    places = label_positions(start + by, end + by, text, SMALL, far=0.08)
    sketch.labels.append(LabelRequest(text, tuple(places), subject, SMALL, name=False))


def _bearing(setting: DrawingContext, body: RigidBody, sketch: Sketch) -> None:
    """Draw the angle between the vertical and the line from a body's centre to its hole, if the text states it."""
    look = setting.look(body.name)
    if not isinstance(look, Axial | Spherical) or not look.hole or not look.offset:
        return
    at = setting.view.at(vector(setting.frames[body.name].origin))
    direction = setting.view.project_direction(setting.axes(body.name)[2 if isinstance(look, Spherical) else 0])
    if abs(direction) < 0.5:
        return
    turn = degrees(phase(unit_vector(direction))) % 360.0
    value = min((turn - 90.0) % 360.0, (90.0 - turn) % 360.0)
    text = setting.state_once(owner_name(body.name), "deg", value) if value > MIN_ANGLE else ""
    if not text:
        return
    radius, low = setting.radius(body.name), min(turn, 90.0) if turn <= 270.0 else turn - 360.0
    arc, middle = 0.35 * radius, 1j ** ((low + 0.5 * value) / 90.0)
    sketch.shapes += [
        LineShape((at, at + 1.25 * radius * 1j), "hair", dashed=True),
        LineShape((at, at + radius * unit_vector(direction)), "hair", dashed=True),
        Arc(at, arc, low, low + value, weight="thin"),
    ]
    wide = 0.5 * width(text, SMALL) * abs(middle.real) + 0.5 * SMALL * abs(middle.imag)
    places = tuple(at + (far + wide) * middle for far in (arc + 0.1, arc + 0.4, radius + 0.15, radius + 0.5))
    sketch.labels.append(LabelRequest(text, places, body.name, SMALL, name=False))


def _turned(setting: DrawingContext) -> Iterator[tuple[str, str]]:
    """Yield the points where a string leaves a body towards a fixed pulley, each with its point on that pulley."""
    for line in setting.mechanism.lines:
        for one, other in ((line.through[:2]), line.through[:-3:-1]):
            ends = setting.mechanism.site[one].body, setting.mechanism.site[other].body
            turns = len(line.through) > 2 and ends[0] is not None and ends[1] is None
            if turns and setting.owns(one) and owner_name(one) == owner_name(other):
                yield one, other


def _leaving(setting: DrawingContext, site: str, wheel: str, sketch: Sketch) -> None:
    """Draw the stated distance of the pulley that a string leads to, and the string's angle to the horizontal."""
    start, end = setting.site(site), setting.site(wheel)
    direction, owner = unit_vector(end - start), owner_name(site)
    text = setting.stated(owner, setting.mechanism.units.length, abs(end - start) / setting.view.scale)
    rim = setting.edge(site, direction)
    if text:
        sketch.labels.append(
            LabelRequest(text, tuple(label_positions(rim, end, text, SMALL)), wheel, SMALL, name=False)
        )
    raised = degrees(phase(direction if direction.real >= 0.0 else complex(-direction.real, direction.imag)))
    angle = setting.stated(owner, "deg", abs(raised))
    if not angle:
        return
    level = 0.0 if direction.real >= 0.0 else 180.0
    turn = sorted((level, raised if direction.real >= 0.0 else 180.0 - raised))
    radius = max(abs(rim - start), 0.5 * setting.sizes(setting.mechanism.site[site].body or "")[0]) + ARC_MARGIN
    middle = 1j ** (0.5 * sum(turn) / 90.0)
    beyond = radius + 0.1 + 0.5 * width(angle, SMALL) * abs(middle.real) + 0.5 * SMALL * abs(middle.imag)
    sketch.shapes.append(Arc(start, radius, *turn, weight="thin"))
    places = tuple(start + (beyond + 0.12 * n) * middle for n in range(5))
    sketch.labels.append(LabelRequest(angle, places, wheel, SMALL, name=False))


def _rubbing(setting: DrawingContext, upper: str, lower: str, sketch: Sketch) -> None:
    """Draw the stated friction coefficients between two slabs, at one end of their contact face."""
    names = sorted(setting.plan.name(address) for address in (upper, lower))
    letter = rf"$\mu_{{{names[0]}{names[1]}}}$" if max(map(len, names)) == 1 else "µ"
    text = setting.plan.friction_text(owner_name(upper), setting.mechanism.contacts[upper], letter)
    if not text:
        return
    along, at = setting.along(upper), setting.at(upper)
    normal = along * 1j if dot(at - setting.at(lower), along * 1j) >= 0.0 else along * -1j
    foot, half = at - 0.5 * SLAB * normal, 0.5 * setting.sizes(upper)[0]
    ends = tuple(foot + side * half * along for side in (-1.0, 1.0))
    sketch.labels.append(LabelRequest(text, (), upper, SMALL, name=False, anchors=ends))


MIN_PULLEY_RADIUS = 0.16  # units, the least radius of a pulley
ELSEWHERE = (Slender, Unseen, Globe, Tabletop)  # looks drawn by other modules, not at the body's position


def sketch_to_scale(setting: DrawingContext) -> Sketch:
    """Return the sketch of some entities and connections, drawn to scale."""
    sketch, front = Sketch(), Sketch()
    sketch.extend(fields(setting))
    sketch.extend(axes(setting))
    sketch.extend(grounds(setting))
    sketch.extend(lines(setting, front))
    for address, body in setting.bodies.items():
        if isinstance(body.look, PulleyWheel):
            sketch.extend(_pulley(setting, address))
        elif address not in setting.drawn and not isinstance(body.look, ELSEWHERE) and setting.stands(address):
            sketch.extend(bodies.body(setting, address, setting.along(address)))
    sketch.extend(front)
    sketch.extend(deflections(setting))
    sketch.extend(sketch_numbers(setting))
    sketch.extend(pushes(setting))
    sketch.extend(speeds(setting))
    sketch.extend(spins(setting))
    sketch.extend(heights(setting))
    _strangers(setting, sketch)
    _legend(setting, sketch)
    return sketch


def _pulley(setting: DrawingContext, address: str) -> Sketch:
    """Return the sketch of a pulley between the two points of its rim, with its axle and name."""
    sides = rim_sites(setting.mechanism, address)
    if sides is None:
        return Sketch()
    left, right = (setting.site(site) for site in sides)
    middle, radius = 0.5 * (left + right), max(MIN_PULLEY_RADIUS, 0.5 * abs(right - left))
    look = setting.bodies[address].look
    solid = isinstance(look, PulleyWheel) and look.solid
    shapes: list[Shape] = [Arc(middle, radius, fill="disc" if solid else ""), axle_dot(middle, 0.05)]
    text = setting.plan.caption(address)
    size = SIZE if text == setting.plan.name(address) else SMALL
    setting.drawn.add(address)
    return Sketch(
        shapes,
        [LabelRequest(text, positions_around(middle, radius + 0.1, width(text, size), start=1 + 1j), address, size)],
    )


def _strangers(setting: DrawingContext, sketch: Sketch) -> None:
    """Draw the bodies of the text that nothing above has drawn, below everything else."""
    left, low, _, _ = box([point for shape in sketch.shapes for point in outline(shape)] or [0j])
    named = {wanted.subject for wanted in sketch.labels if wanted.name}
    missing = [a for a, body in setting.bodies.items() if body.letters and a not in named]
    missing += [a for a, body in setting.bodies.items() if body.look is None and a not in named and a not in missing]
    for number, address in enumerate(missing):
        sketch.extend(bodies.undeclared_body(setting, address, complex(left + 1.0 + 2.4 * number, low - 0.9)))


def _legend(setting: DrawingContext, sketch: Sketch) -> None:
    """Draw the scale of the velocities, below the right end of the drawing."""
    if setting.legend is None:
        return
    long, text = setting.legend
    left, low, right, _ = box(point for shape in sketch.shapes for point in outline(shape))
    low = min([low, *(wanted.places[0].imag for wanted in sketch.labels)])
    start = complex(max(left, right - long - 0.3 - width(text, SMALL)), low - 0.55)
    sketch.shapes.append(LineShape((start, start + long), "thin", arrow=True))
    sketch.labels.append(LabelRequest(text, (start + long + 0.2 + 0.5 * width(text, SMALL),), "", SMALL, name=False))


class ScaledPiece(Piece):
    """A group of entities drawn to scale, whose shape the layout does not change."""

    def __init__(self, name: str, plan: DrawingPlan, group: frozenset[str]) -> None:
        """Draw the group once; a layout only moves this drawing."""
        super().__init__(name, plan)
        self.setting = DrawingContext(plan, group)
        self.picture = sketch_to_scale(self.setting)
        solid = (s for s in self.picture.shapes if not isinstance(s, LineShape) or s.weight != "hair")
        self.outlines = [polygon for shape in solid if len(polygon := hull(outline(shape))) > 1]

    def anchor(self, knot: PathKnot, way: complex, *, second: bool) -> complex:
        """Return the point where a string leaves the group: at the port, or at the outline of the body there."""
        return self.setting.edge(knot.leaves if second else knot.arrives, way)

    def hulls(self) -> list[Polygon]:
        """Return the outlines of all shapes."""
        return self.outlines

    def sketch(self) -> Sketch:
        """Return the drawing to scale."""
        return self.picture
