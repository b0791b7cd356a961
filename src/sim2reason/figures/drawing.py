"""From a scene to a drawing of its initial state, labelled as its text names things."""

from collections.abc import Iterable, Sequence

from sim2reason.bodies.block import Block
from sim2reason.bodies.puck import Puck, Table
from sim2reason.bodies.pulley import FixedPulley, MovablePulley
from sim2reason.dsl.measures import Speed
from sim2reason.dsl.scene import Scene
from sim2reason.errors import UnsupportedError
from sim2reason.figures import faces
from sim2reason.figures.arrange import Arranger
from sim2reason.figures.hanging import HandPiece, HookPiece, PulleyPiece, plate, said
from sim2reason.figures.labels import placed
from sim2reason.figures.layout_cost import Layout
from sim2reason.figures.paths import FACES, Paths, Strand, flat, whole
from sim2reason.figures.pieces import PIECES, DrawingPlan, Piece, Sizes
from sim2reason.figures.shapes import SMALL, Drawing, Line, Shape, Sketch, Wanted, outline, width
from sim2reason.figures.table import table
from sim2reason.figures.vectors import box, mirrored
from sim2reason.prose.writer import Description, describe

BETWEEN = 1.2  # parts of a scene that no string joins
MOUNT = 1.9  # the longest bracket from a corner to a pulley
FLAT_BODIES = (Puck, Table)
assert faces  # its import enters what it draws


def drawing(scene: Scene, description: Description | None = None, *, numbers: bool = False) -> Drawing:
    """Draw the initial state: angles are right, lengths are not.

    `description` gives the names, by default the text with seed 0; `numbers` adds masses.

    Raises:
        UnsupportedError: a body of the scene has no known look.
    """
    description = description or describe(scene)
    strangers = [
        type(b).__name__ for b in scene.bodies.values() if type(b) not in PIECES and not isinstance(b, FLAT_BODIES)
    ]
    if strangers:
        raise UnsupportedError(f"no figure shows a body of the type {strangers[0]}; give it a piece in figures")
    sizes = Sizes(width=1.6, height=1.4) if numbers else Sizes()
    plan = DrawingPlan(whole(scene), Paths(whole(scene)), description, sizes, numbers)
    parts = [_finished(Arranger(plan, *part, make).best(), plan) for part in _components(plan)]
    parts += [table(plan, address) for address, body in scene.bodies.items() if isinstance(body, Table)]
    sketch = _beside(parts)
    return Drawing(tuple(sketch.shapes), placed(sketch.labels, sketch.shapes))


def make(name: str, plan: DrawingPlan) -> Piece:
    """The piece at an address, by the class of its body."""
    if name in plan.scene.bodies:
        return PIECES[type(plan.scene.bodies[name])](name, plan)
    if name in plan.paths.mechanism.body:
        return PulleyPiece(name, plan)
    return (HandPiece if name in plan.scene.builder.hands else HookPiece)(name, plan)


def _components(plan: DrawingPlan) -> Iterable[tuple[list[str], list[Strand]]]:
    """Pieces that strings hold together, with their strands."""
    strands = plan.paths.strands
    names = list(dict.fromkeys([*_standing(plan), *(k.piece for s in strands for k in (s.a, s.b))]))
    leader = {name: name for name in names}
    for strand in strands:
        old, new = leader[strand.b.piece], leader[strand.a.piece]
        leader = {name: new if held == old else held for name, held in leader.items()}
    for head in dict.fromkeys(leader.values()):
        members = [name for name in names if leader[name] == head]
        yield members, [strand for strand in strands if strand.a.piece in members]


def _standing(plan: DrawingPlan) -> list[str]:
    """Pieces that need no string: what has faces, blocks without one, and pulleys that no string passes."""
    carried = plan.paths.carriers
    rims = {knot.item for knots in plan.paths.knots.values() for knot in knots if knot.rim}
    return [
        address
        for address, body in plan.scene.bodies.items()
        if isinstance(body, FACES)
        or (isinstance(body, Block) and address not in carried)
        or (isinstance(body, FixedPulley | MovablePulley) and address not in rims)
    ]


def _finished(layout: Layout, plan: DrawingPlan) -> Sketch:
    """Everything at its place: the pieces, the strings, and the brackets that hold pulleys at corners."""
    found = Sketch()
    for name, piece in layout.pieces.items():
        if isinstance(piece, PulleyPiece) and piece.corners:
            found.shapes += _mounted(layout, name, piece)
        part = piece.sketch().moved(layout.at[name])
        found.shapes += part.shapes
        found.labels += part.labels
    for _, a, b in layout.strands:
        found.shapes.append(Line((a, b), "string"))
    _speeds(layout, plan, found)
    return found


def _mounted(layout: Layout, name: str, piece: PulleyPiece) -> list[Shape]:
    """A bracket to the nearest corner of a plane, or a plate if all are far."""
    here = layout.at[name]
    ends = [
        layout.at[corner] + edge
        for corner in piece.corners
        for way in (1.0 + 0j, -1.0 + 0j)
        if (edge := layout.pieces[corner].edge(way)) is not None
    ]
    nearest = min(ends, key=lambda end: abs(end - here))
    if abs(nearest - here) <= MOUNT:
        return [Line((nearest, here), "edge")]
    return plate(piece.support, here)


def _speeds(layout: Layout, plan: DrawingPlan, found: Sketch) -> None:
    """An arrow beside every block that moves at the start."""
    for block, carrier in plan.paths.carriers.items():
        body, piece = plan.paths.mechanism.body[block], layout.pieces.get(carrier)
        moving = [c for c in body.coordinates if c.speed != 0.0]
        if piece is None or not moving or not isinstance(piece, faces.FacePiece):
            continue
        way = flat(moving[0].axis) * (1.0 if moving[0].speed > 0.0 else -1.0)
        way = mirrored(way) if carrier in piece.plan.mirrored else way
        out = way * 1j if (way * 1j).imag > 0.0 or abs(way.imag) > 0.999 else way * -1j
        start = layout.at[carrier] + piece.center(block) + out * (0.5 * plan.sizes.height + 0.22) - 0.45 * way
        found.shapes.append(Line((start, start + 0.9 * way), "thin", arrow=True))
        text = said(Speed, abs(moving[0].speed))
        wide = 0.5 * width(text, SMALL)
        spots = [
            start + along * way + complex(out.real * (wide + 0.1), out.imag * 0.36) for along in (0.45, 0.0, 0.9, 1.4)
        ]
        found.labels.append(Wanted(text, tuple(spots), block, SMALL, name=False))


def _beside(parts: Sequence[Sketch]) -> Sketch:
    """Parts from left to right, on one ground."""
    found, right = Sketch(), 0.0
    for part in parts:
        left, low, end, _ = box(point for shape in part.shapes for point in outline(shape))
        part = part.moved(complex(right - left, -low))  # noqa: PLW2901 - the same part, in its place
        found.shapes += part.shapes
        found.labels += part.labels
        right += end - left + BETWEEN
    return found
