"""Layout search: chooses lengths of strings and orientations of pieces so that nothing overlaps.

Strings never form closed loops, so any choice of lengths is possible; the search minimises overlaps, size and uneven
levels. Its effort is counted in steps and its random seed is fixed, so that a scene always looks the same.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from random import Random

from sim2reason.figures.layout_cost import Layout, Pose, cost
from sim2reason.figures.paths import Strand, has_faces
from sim2reason.figures.pieces import Bend, DrawingPlan, Piece
from sim2reason.figures.vectors import RIGHT, UP, mirrored

LINK = (0.55, 0.8, 1.2, 2.0)  # lengths tried between neighbouring blocks
FACE_END_LENGTHS = (0.45, 0.9, 1.6, 2.6, 4.0, 6.0, 8.5)  # lengths tried from the end of a face to the next piece
FREE = (1.5, 2.1, 2.8, 3.7, 4.8, 6.2, 8.0, 10.5, 13.5)  # lengths tried elsewhere
WIDER = (1.0, 1.6, 2.4)  # factors on the radius of pulleys with parallel strands
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
        self.counts = [2] * self.flips + [len(held) for held in self.options] + [len(WIDER)] * len(self.wheels)
        self.weights = [FLIPPED] * self.flips + [LONGER] * len(self.outer) + [WIDENED] * len(self.wheels)
        self._poses: dict[tuple[Choice, Choice], Pose] = {}

    # -- what can be turned round ------------------------------------------------------------------

    def _mirror_groups(self) -> list[frozenset[str]]:
        """Return the groups of pieces that are mirrored together because an inclined or level string joins them."""
        leader = {name: name for name in self.names}
        for strand in self.outer:
            if (
                strand.way is not None
                and abs(strand.way.real) > 1e-9
                and self._directed(strand.a.piece)
                and self._directed(strand.b.piece)
            ):
                old, new = leader[strand.a.piece], leader[strand.b.piece]
                leader = {name: new if held == old else held for name, held in leader.items()}
        groups: dict[str, set[str]] = {}
        for name, held in leader.items():
            groups.setdefault(held, set()).add(name)
        bare = {
            name: self.make(name, self._bent(self.plan, [s.way or RIGHT for s in self.strands])) for name in self.names
        }
        shaped = [group for group in groups.values() if any(type(bare[n]).__name__ == "FacePiece" for n in group)]
        return [frozenset(g) for g in shaped if all(bare[n].mirrors or not self._directed(n) for n in g)]

    def _directed(self, name: str) -> bool:
        return name in self.plan.paths.home.values() or has_faces(self.plan.scene.bodies.get(name))

    def _swaps(self) -> list[str]:
        """Return the names of pulleys and undirected string segments whose left and right can be exchanged."""
        rims = dict.fromkeys(k.item for s in self.outer for k in (s.a, s.b) if k.rim and not self._directed(k.piece))
        free = [_key(strand) for strand in self.outer if strand.way is None]
        return [*rims, *free]

    def _wheels(self) -> list[str]:
        """Return the names of the pulleys that may be enlarged to separate the bodies on their two sides."""
        return list(
            dict.fromkeys(k.piece for s in self.outer for k in (s.a, s.b) if k.rim and not self._directed(k.piece))
        )

    # -- one try -----------------------------------------------------------------------------------

    def ways(self, turned: frozenset[str], swapped: frozenset[str]) -> list[complex]:
        """Return the direction of each straight string segment, chosen here where the scene fixes none."""
        known = [self._turned(strand, turned) for strand in self.strands]
        return [way if way is not None else self._free(number, known, swapped) for number, way in enumerate(known)]

    @staticmethod
    def _turned(strand: Strand, turned: frozenset[str]) -> complex | None:
        if strand.way is None:
            return None
        return mirrored(strand.way) if strand.a.piece in turned or strand.b.piece in turned else strand.way

    def _free(self, number: int, known: Sequence[complex | None], swapped: frozenset[str]) -> complex:
        """Choose the direction of a string segment between pulleys, hands, hooks: level, else down, else sideways."""
        strand = self.strands[number]
        side = -1.0 if _key(strand) in swapped else 1.0
        if strand.a.rim and strand.b.rim:
            return side * RIGHT
        others = (known[n] for n in (number - 1, number + 1) if 0 <= n < len(known) and self._joined(number, n))
        upwards = any(way is not None and abs(way.imag) > 0.7 and self._leaves_up(number, way) for way in others)
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
        for strand, way in zip(self.strands, ways, strict=True):
            for knot, away in ((strand.a, way), (strand.b, -way)):
                ends[knot.item] = (*ends.get(knot.item, ()), away)
            if before is not None and before[0].string == strand.string and strand.a.rim:
                side = strand.a.side * (-1.0 if strand.a.item in swapped else 1.0)
                bends[strand.a.item] = Bend((-before[1], way), side)
            before = (strand, way)
        return replace(plan, bends=bends, ends=ends, mirrored=turned)

    def pose(self, choice: Choice) -> Pose:
        """Return all pieces for a candidate's orientations and pulley sizes, before they are placed."""
        flips, wider = choice[: self.flips], choice[self.flips + len(self.outer) :]
        if (flips, wider) not in self._poses:
            turned = frozenset[str]().union(*(group for group, flip in zip(self.groups, flips, strict=False) if flip))
            swapped = frozenset(name for name, flip in zip(self.swaps, flips[len(self.groups) :], strict=True) if flip)
            ways = self.ways(turned, swapped)
            sizes = {name: WIDER[number] for name, number in zip(self.wheels, wider, strict=True)}
            plan = replace(self._bent(self.plan, ways, turned, swapped), wider=sizes)
            self._poses[flips, wider] = Pose({name: self.make(name, plan) for name in self.names}, self.strands, ways)
        return self._poses[flips, wider]

    def _lengths(self, strand: Strand) -> tuple[float, ...]:
        """Return the lengths to try for a string segment between two pieces, without its part over the pieces."""
        bodies = self.plan.scene.bodies
        ends = [bodies.get(knot.piece) for knot in (strand.a, strand.b)]
        if all(not knot.rim and body is not None for knot, body in zip((strand.a, strand.b), ends, strict=True)):
            return LINK
        sloped = any(has_faces(body) and not knot.rim for knot, body in zip((strand.a, strand.b), ends, strict=True))
        return FACE_END_LENGTHS if sloped else FREE

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
        found = self._descend((0,) * len(self.counts))
        idle = 0
        for _ in range(ROUNDS if self.outer else 0):
            layout = self._descend(tuple(self._drawn(random)))
            idle += 1
            if layout.cost < found.cost - LEAST:
                found, idle = layout, 0
            if idle >= PATIENCE and found.cost < GOOD:
                break
        return found

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
                    tried = self.place(other) if other != choice else layout
                    if tried.cost < layout.cost - LEAST:
                        choice, layout, better = other, tried, True
        return layout


def _key(strand: Strand) -> str:
    return f"{strand.string}#{strand.number}"
