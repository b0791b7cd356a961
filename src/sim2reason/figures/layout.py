"""Layout of a drawing: lengths of strings and orientations of pieces of least cost, so that nothing overlaps.

Strings never form closed loops, so any choice of lengths is possible; the search minimises overlaps, size and uneven
levels. Its effort is counted in steps and its random seed is fixed, so that a scene always looks the same.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from random import Random

from sim2reason.figures.paths import Strand, has_faces
from sim2reason.figures.pieces import Bend, DrawingPlan, Piece
from sim2reason.figures.plane import RIGHT, UP, Box, Polygon, box, crosses, depth, mirror

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
        self.joints = [self._joint(strand, direction) for strand, direction in zip(strands, ways, strict=True)]
        self.solids = {name: [(p, box(p)) for p in piece.hulls()] for name, piece in pieces.items()}
        self.boxes = {name: box(p for polygon, _ in hulls for p in polygon) for name, hulls in self.solids.items()}
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
    pairs = (abs(a - b) for heights in levels.values() for a, b in combinations(heights, 2))
    return sum(min(MOST_RAGGED, RAGGED * difference) for difference in pairs)


def _moved(area: Box, by: complex) -> Box:
    return area[0] + by.real, area[1] + by.imag, area[2] + by.real, area[3] + by.imag


def _close(one: Box, other: Box, gap: float) -> bool:
    return one[0] - gap < other[2] and other[0] - gap < one[2] and one[1] - gap < other[3] and other[1] - gap < one[3]


LINK_LENGTHS = (0.55, 0.8, 1.2, 2.0)  # lengths tried between neighbouring blocks
FACE_END_LENGTHS = (0.45, 0.9, 1.6, 2.6, 4.0, 6.0, 8.5)  # lengths tried from the end of a face to the next piece
FREE_LENGTHS = (1.5, 2.1, 2.8, 3.7, 4.8, 6.2, 8.0, 10.5, 13.5)  # lengths tried elsewhere
PULLEY_FACTORS = (1.0, 1.6, 2.4)  # factors on the radius of pulleys with parallel strands
ROUNDS, PATIENCE, GOOD = 14, 4, 60.0  # restarts of the search, how many may bring nothing, and when that is enough
FLIPPED, LONGER, WIDENED, LEAST = 0.6, 0.12, 1.5, 1e-9  # what it costs to turn, lengthen, enlarge; the least gain


Choice = tuple[int, ...]
"""One try: for every flip, strand and wheel, in this order, the number of its option."""


class Arranger:
    """The layout search for one connected part of a scene."""

    def __init__(
        self,
        plan: DrawingPlan,
        names: Sequence[str],
        strands: Sequence[Strand],
        make: Callable[[str, DrawingPlan], Piece],
    ) -> None:
        """Store the names of the drawn pieces, and the straight string segments between or inside them."""
        self.plan, self.names, self.strands, self.make = plan, names, strands, make
        self.outer = [strand for strand in strands if not strand.inner]
        self.groups = self._mirror_groups()
        self.swaps = self._swaps()
        self.wheels = self._wheels()
        self.options = [self._lengths(strand) for strand in self.outer]
        self.flips = len(self.groups) + len(self.swaps)
        factor_counts = [len(PULLEY_FACTORS)] * len(self.wheels)
        self.counts = [2] * self.flips + [len(lengths) for lengths in self.options] + factor_counts
        self.weights = [FLIPPED] * self.flips + [LONGER] * len(self.outer) + [WIDENED] * len(self.wheels)
        self._poses: dict[tuple[Choice, Choice], Pose] = {}

    # -- what can be turned round ------------------------------------------------------------------

    def _mirror_groups(self) -> list[frozenset[str]]:
        """Return the groups of pieces that are mirrored together because an inclined or level string joins them."""
        leader = {name: name for name in self.names}
        for strand in self.outer:
            ends = strand.a.piece, strand.b.piece
            if strand.direction is not None and abs(strand.direction.real) > 1e-9 and all(map(self._directed, ends)):
                old, new = (leader[name] for name in ends)
                leader = {name: new if root == old else root for name, root in leader.items()}
        groups: dict[str, set[str]] = {}
        for name, root in leader.items():
            groups.setdefault(root, set()).add(name)
        plan = self._bent(self.plan, [strand.direction or RIGHT for strand in self.strands])
        bare = {name: self.make(name, plan) for name in self.names}
        shaped = [group for group in groups.values() if any(type(bare[n]).__name__ == "FacePiece" for n in group)]
        return [frozenset(g) for g in shaped if all(bare[n].mirrors or not self._directed(n) for n in g)]

    def _directed(self, name: str) -> bool:
        return name in self.plan.paths.home.values() or has_faces(self.plan.scene.bodies.get(name))

    def _swaps(self) -> list[str]:
        """Return the names of pulleys and undirected string segments whose left and right can be exchanged."""
        rims = dict.fromkeys(k.item for s in self.outer for k in (s.a, s.b) if k.rim and not self._directed(k.piece))
        free = [_key(strand) for strand in self.outer if strand.direction is None]
        return [*rims, *free]

    def _wheels(self) -> list[str]:
        """Return the names of the pulleys that may be enlarged to separate the bodies on their two sides."""
        return list(
            dict.fromkeys(k.piece for s in self.outer for k in (s.a, s.b) if k.rim and not self._directed(k.piece))
        )

    # -- one try -----------------------------------------------------------------------------------

    def directions(self, turned: frozenset[str], swapped: frozenset[str]) -> list[complex]:
        """Return the direction of each straight string segment, chosen here where the scene fixes none."""
        known = [self._turned(strand, turned) for strand in self.strands]
        return [
            direction if direction is not None else self._free_direction(number, known, swapped)
            for number, direction in enumerate(known)
        ]

    @staticmethod
    def _turned(strand: Strand, turned: frozenset[str]) -> complex | None:
        if strand.direction is None:
            return None
        return mirror(strand.direction) if strand.a.piece in turned or strand.b.piece in turned else strand.direction

    def _free_direction(self, number: int, known: Sequence[complex | None], swapped: frozenset[str]) -> complex:
        """Choose the direction of a string segment between pulleys, hands, hooks: level, else down, else sideways."""
        strand = self.strands[number]
        side = -1.0 if _key(strand) in swapped else 1.0
        if strand.a.rim and strand.b.rim:
            return side * RIGHT
        others = (known[n] for n in (number - 1, number + 1) if 0 <= n < len(known) and self._joined(number, n))
        upwards = any(
            direction is not None and abs(direction.imag) > 0.7 and self._leaves_up(number, direction)
            for direction in others
        )
        down = side * RIGHT if upwards else -UP
        return down if strand.a.rim else -down

    def _joined(self, one: int, other: int) -> bool:
        return self.strands[one].string == self.strands[other].string

    def _leaves_up(self, number: int, way: complex) -> bool:
        """Return whether a neighbouring string segment leaves the pulley that both share upwards."""
        return (way.imag > 0.0) != self.strands[number].a.rim

    def _bent(
        self,
        plan: DrawingPlan,
        ways: Sequence[complex],
        turned: frozenset[str] = frozenset(),
        swapped: frozenset[str] = frozenset(),
    ) -> DrawingPlan:
        """Return the plan with the directions of all segments at each bend and each end of a string."""
        bends: dict[str, Bend] = {}
        ends: dict[str, tuple[complex, ...]] = {}
        before: tuple[Strand, complex] | None = None
        for strand, direction in zip(self.strands, ways, strict=True):
            for knot, away in ((strand.a, direction), (strand.b, -direction)):
                ends[knot.item] = (*ends.get(knot.item, ()), away)
            if before is not None and before[0].string == strand.string and strand.a.rim:
                side = strand.a.side * (-1.0 if strand.a.item in swapped else 1.0)
                bends[strand.a.item] = Bend((-before[1], direction), side)
            before = (strand, direction)
        return replace(plan, bends=bends, ends=ends, mirrored=turned)

    def pose(self, choice: Choice) -> Pose:
        """Return all pieces for a candidate's orientations and pulley sizes, before they are placed."""
        flips, wider = choice[: self.flips], choice[self.flips + len(self.outer) :]
        if (flips, wider) not in self._poses:
            turned = frozenset[str]().union(*(group for group, flip in zip(self.groups, flips, strict=False) if flip))
            swapped = frozenset(name for name, flip in zip(self.swaps, flips[len(self.groups) :], strict=True) if flip)
            ways = self.directions(turned, swapped)
            sizes = {name: PULLEY_FACTORS[number] for name, number in zip(self.wheels, wider, strict=True)}
            plan = replace(self._bent(self.plan, ways, turned, swapped), wider=sizes)
            self._poses[flips, wider] = Pose({name: self.make(name, plan) for name in self.names}, self.strands, ways)
        return self._poses[flips, wider]

    def _lengths(self, strand: Strand) -> tuple[float, ...]:
        """Return the lengths to try for a string segment between two pieces, without its part over the pieces."""
        bodies = self.plan.scene.bodies
        ends = [bodies.get(knot.piece) for knot in (strand.a, strand.b)]
        if all(not knot.rim and body is not None for knot, body in zip((strand.a, strand.b), ends, strict=True)):
            return LINK_LENGTHS
        sloped = any(has_faces(body) and not knot.rim for knot, body in zip((strand.a, strand.b), ends, strict=True))
        return FACE_END_LENGTHS if sloped else FREE_LENGTHS

    def place(self, choice: Choice) -> Layout:
        """Place all pieces by following the string segments, with a candidate's lengths, from piece to piece."""
        pose = self.pose(choice)
        outer = [joint for joint in pose.joints if not joint.strand.inner]
        numbers = choice[self.flips : self.flips + len(outer)]
        steps = [
            (j.strand.a.piece, j.strand.b.piece, j.start + (options[number] + j.lead) * j.way - j.stop)
            for j, options, number in zip(outer, self.options, numbers, strict=True)
        ]
        at: dict[str, complex] = {self.names[0]: 0j}
        while len(at) < len(self.names):
            for a, b, step in steps:
                if a in at:
                    at.setdefault(b, at[a] + step)
                elif b in at:
                    at[a] = at[b] - step
        layout = Layout(pose, at)
        layout.cost = cost(layout) + sum(weight * number for weight, number in zip(self.weights, choice, strict=True))
        return layout

    # -- the search --------------------------------------------------------------------------------

    def best(self) -> Layout:
        """Return the best layout of several local searches; the first one starts from the shortest string segments."""
        random = Random(0)  # noqa: S311 - it chooses where to look
        best_layout = self._descend((0,) * len(self.counts))
        idle = 0
        for _ in range(ROUNDS if self.outer else 0):
            layout = self._descend(tuple(self._drawn(random)))
            idle += 1
            if layout.cost < best_layout.cost - LEAST:
                best_layout, idle = layout, 0
            if idle >= PATIENCE and best_layout.cost < GOOD:
                break
        return best_layout

    def _drawn(self, random: Random) -> Iterator[int]:
        """Yield the components of a random candidate layout, biased to short string segments and small pulleys."""
        for number, count in enumerate(self.counts):
            wheel = number >= self.flips + len(self.outer)
            yield int(random.random() * (1.3 if wheel else min(4, count)))

    def _descend(self, choice: Choice) -> Layout:
        """Change one orientation, length or pulley size of a candidate after another until the cost no longer falls."""
        layout, better = self.place(choice), True
        while better:
            better = False
            for index, count in enumerate(self.counts):
                for number in range(count):
                    other = (*choice[:index], number, *choice[index + 1 :])
                    trial = self.place(other) if other != choice else layout
                    if trial.cost < layout.cost - LEAST:
                        choice, layout, better = other, trial, True
        return layout


def _key(strand: Strand) -> str:
    return f"{strand.string}#{strand.number}"
