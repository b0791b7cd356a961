"""Cost of a layout: overlaps, crossings, size and unequal levels as one number."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

from sim2reason.figures.paths import Strand
from sim2reason.figures.pieces import Piece
from sim2reason.figures.vectors import Box, Polygon, box, crosses, depth

PIECE_GAP, ASIDE = 0.25, 0.12  # units between pieces, and between a piece and a string, at least
OVERLAP, PIERCED, CROSSED = 40.0, 15.0, 12.0
ACROSS, UPWARDS, RAGGED, MOST_RAGGED = 0.5, 0.6, 0.8, 2.5  # for each unit of width, height, unequal level


@dataclass(frozen=True)
class DrawnJoint:
    """A string segment between two pieces: its end points relative to the pieces, and its length over them."""

    strand: Strand
    way: complex
    start: complex
    stop: complex
    lead: float


class Pose:
    """All pieces in one choice of orientations and sizes, with their outlines, before they are placed."""

    def __init__(self, pieces: Mapping[str, Piece], strands: Sequence[Strand], ways: Sequence[complex]) -> None:
        """Compute the outlines of pieces and the ends of string segments, which do not depend on segment lengths."""
        self.pieces = pieces
        self.joints = [self._joint(strand, way) for strand, way in zip(strands, ways, strict=True)]
        self.solids = {name: [(p, box(p)) for p in piece.hulls()] for name, piece in pieces.items()}
        self.boxes = {name: box(p for polygon, _ in held for p in polygon) for name, held in self.solids.items()}
        self.levels = {name: level for name, piece in pieces.items() if (level := piece.level) is not None}

    def _joint(self, strand: Strand, way: complex) -> DrawnJoint:
        a, b = self.pieces[strand.a.piece], self.pieces[strand.b.piece]
        start, stop = a.anchor(strand.a, way, second=True), b.anchor(strand.b, -way, second=False)
        lead = 0.0 if strand.inner else a.lead(strand.a, way) + b.lead(strand.b, -way)
        return DrawnJoint(strand, way, start, stop, lead)


@dataclass
class Layout:
    """All pieces with their positions in the drawing, and the cost of this arrangement."""

    pose: Pose
    at: dict[str, complex]
    cost: float = 0.0

    @property
    def pieces(self) -> Mapping[str, Piece]:
        """Return the pieces by name."""
        return self.pose.pieces

    @property
    def strands(self) -> list[tuple[Strand, complex, complex]]:
        """Return all straight string segments with their end points in the drawing."""
        return [
            (j.strand, self.at[j.strand.a.piece] + j.start, self.at[j.strand.b.piece] + j.stop)
            for j in self.pose.joints
        ]


def cost(layout: Layout) -> float:
    """Return the cost of a layout: mainly overlaps, then crossings, size and unequal levels."""
    pose, at = layout.pose, layout.at
    boxes = {name: _moved(held, at[name]) for name, held in pose.boxes.items()}
    total = 0.0
    for one, other in combinations(boxes, 2):
        if _close(boxes[one], boxes[other], PIECE_GAP):
            total += _overlap(pose.solids[one], pose.solids[other], at[other] - at[one])
    total += _strands(layout, boxes)
    left, low = min(b[0] for b in boxes.values()), min(b[1] for b in boxes.values())
    right, high = max(b[2] for b in boxes.values()), max(b[3] for b in boxes.values())
    return total + ACROSS * (right - left) + UPWARDS * (high - low) + _ragged(layout)


def _overlap(one: list[tuple[Polygon, Box]], other: list[tuple[Polygon, Box]], by: complex) -> float:
    """Return the overlap cost of one piece's hulls and another's, the latter moved by `by`."""
    total = 0.0
    for theirs, area in other:
        around = _moved(area, by)
        near = [mine for mine, held in one if _close(held, around, PIECE_GAP)]
        if near:
            placed = tuple(point + by for point in theirs)
            total += sum(OVERLAP * (0.3 + d) for mine in near if (d := depth(mine, placed) + PIECE_GAP) > 0.0)
    return total


def _strands(layout: Layout, boxes: dict[str, Box]) -> float:
    """Return the cost of strings that cross pieces or each other."""
    total, drawn = 0.0, layout.strands
    for strand, a, b in drawn:
        around = box((a, b))
        for name, area in boxes.items():
            if name not in (strand.a.piece, strand.b.piece) and _close(area, around, ASIDE):
                here = (a - layout.at[name], b - layout.at[name])
                total += sum(PIERCED for polygon, _ in layout.pose.solids[name] if depth(polygon, here) + ASIDE > 0.0)
    return total + CROSSED * sum(crosses(a, b, c, d) for (_, a, b), (_, c, d) in combinations(drawn, 2))


def _ragged(layout: Layout) -> float:
    levels: dict[str, list[float]] = {}
    for name, (kind, offset) in layout.pose.levels.items():
        levels.setdefault(kind, []).append(layout.at[name].imag + offset)
    pairs = (abs(a - b) for held in levels.values() for a, b in combinations(held, 2))
    return sum(min(MOST_RAGGED, RAGGED * apart) for apart in pairs)


def _moved(area: Box, by: complex) -> Box:
    return area[0] + by.real, area[1] + by.imag, area[2] + by.real, area[3] + by.imag


def _close(one: Box, other: Box, gap: float) -> bool:
    return one[0] - gap < other[2] and other[0] - gap < one[2] and one[1] - gap < other[3] and other[1] - gap < one[3]
