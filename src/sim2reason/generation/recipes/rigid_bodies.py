"""Rigid bodies that swing about an axle, roll, slip, rock or tumble."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import islice
from math import copysign, floor, nan, sqrt
from typing import NamedTuple

import numpy as np

from sim2reason.errors import SceneError
from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.ranges import SIZES, Idea, draw_idea, idle_numbers
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.model import draw
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.solids import Solid
from sim2reason.scenes.entities.pendulums import RotationEntity, holds_axle
from sim2reason.scenes.entities.pieces import (
    FIRST,
    OTHER_SIDE,
    AxialPiece,
    BallPiece,
    BarPiece,
    CappedPiece,
    HoledPiece,
    RoundPiece,
    TiltedPiece,
    WeldedPiece,
)
from sim2reason.scenes.entities.rolling import RollingEntity

NEAR = Range(0.1, 0.5)  # m, from the axle, for what has a size
FAR = Range(0.2, 0.8)  # m, for small balls
PUSH = Range(2.5, 6.0)  # rad/s
SOLID = {AxialPiece: 0.5, RoundPiece: 0.2, CappedPiece: 0.05, TiltedPiece: 0.05, HoledPiece: 0.05, BarPiece: 0.15}
SMALL_BALL_PROBABILITY = 0.7  # probability that a further piece is a small ball
MIN_IMBALANCE = 0.3  # smallest |Σ m x| / Σ m |x|; arms near balance are ill-conditioned
MIN_OWN_INERTIA = 0.175  # smallest fraction of the inertia from rotation of pieces about their own centres
MOVED = (
    1.0 / MIN_OWN_INERTIA - 1.0
)  # largest ratio of the inertia from the distances of pieces to that about their own centres
MIN_AXLE_CLEARANCE = 0.02  # m, from the axle to the surface of a piece
MANY_PIECES = 3  # pieces, from which on the size of one may be irrelevant
PIECE_TRIES = 10  # draws of a single piece before all are drawn again
DRAWS = 60 * PIECE_TRIES


@dataclass(frozen=True)
class SwingTier:
    """The difficulty settings of rotation: number of pieces, and probability of a push."""

    pieces: Count
    pushed: float


ROTATION_TIERS = {
    "easy": (SwingTier(Count(1, 1), 0.0),),
    "medium": (SwingTier(Count(2, 3), 0.0), SwingTier(Count(1, 1), 1.0)),
    "hard": (SwingTier(Count(2, 3), 0.0), SwingTier(Count(2, 3), 1.0)),  # some go over the top
}


# a period hangs neither on how it begins nor on a lone mass
ROTATION_WEIGHTS = {
    "sum": 0.1,
    "state": 0.3,
    "time_to_event": 0.2,
    "period": 0.5,
    "comparison": 0.2,
    "threshold": 0.4,
    "optimum": 0.02,
    "numeric.sum": 0.05,
    "numeric.comparison": 0.1,
}


@recipe("rotation", share=2, weights=ROTATION_WEIGHTS)
def draw_rotation(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Up to three solid bodies fixed to a light arm on an axle: released, or set in rotation."""
    tiers = ROTATION_TIERS[difficulty]
    tier = tiers[int(rng.integers(len(tiers)))]
    choices = {"rate?": tier.pushed, "rate": PUSH}
    arm = draw(RotationEntity, rng, choices, {"pieces": _pieces(tier, rng)})
    return Scene(entities=(Named(name="arm", entity=arm),))


def _pieces(tier: SwingTier, rng: np.random.Generator) -> tuple[WeldedPiece, ...]:
    """Return random pieces on an arm, a large one first and those beyond the axle last."""
    count, pieces = 0, list[WeldedPiece]()
    kinds, chances = [*SOLID], np.array([*SOLID.values()])
    for attempt in range(DRAWS):
        if attempt % PIECE_TRIES == 0:  # the first ones may have taken all the room
            count, pieces = int(rng.integers(tier.pieces.low, tier.pieces.high + 1)), []
        kind = (
            BallPiece
            if pieces and rng.random() < SMALL_BALL_PROBABILITY
            else kinds[int(rng.choice(len(kinds), p=chances))]
        )
        piece = _drawn_near(kind, rng, pieces)
        if piece is not None and _fits(piece, pieces) and _bear([*pieces, piece], unmoved=count >= MANY_PIECES):
            pieces.append(piece)
        if len(pieces) == count and _is_unbalanced(pieces):
            return tuple(sorted(pieces, key=lambda piece: piece.place < 0.0))
        if len(pieces) == count:
            pieces.pop()
    raise SceneError("arm", f"{DRAWS} draws gave too few pieces that all have a bearing", "draw again")


def _drawn_near(kind: type[WeldedPiece], rng: np.random.Generator, others: Sequence[WeldedPiece]) -> WeldedPiece | None:
    """Draw a piece so close to the axle that the size of each piece matters; None if impossible."""
    distances = FAR if kind is BallPiece else NEAR
    choices = {**SIZES, "side?": 0.4, "side": (OTHER_SIDE,), "distance": distances}
    piece = draw(kind, rng, choices, {} if others else {"side": FIRST})
    farthest = _farthest(piece, others)
    if piece.distance > farthest > distances.low:
        kept = {name: value for name, value in piece if name != "distance"}
        piece = draw(kind, rng, {"distance": Range(distances.low, farthest)}, kept)
    return piece if piece.distance <= farthest else None


def _farthest(piece: WeldedPiece, others: Sequence[WeldedPiece]) -> float:
    """Return the largest distance from the axle, m, at which the size of the piece still matters for the inertia.

    Any distance suffices for a piece that is not a small ball; NaN if there is no such distance.
    """
    solid, mass, share, before = _solid(piece), piece.shape.mass, _share(piece), _total(map(_share, others))
    most = MOVED * (before.own + share.own) - before.moved
    if not isinstance(piece, BallPiece):
        most = min(most, MOVED * share.own)
    x, _, z = solid.center
    squared = most / mass - z**2
    if squared < 0.0:
        return nan
    return floor(1e2 * (sqrt(squared) - copysign(x, x * piece.place))) / 1e2  # as many places as a text has


def _fits(piece: WeldedPiece, others: Sequence[WeldedPiece]) -> bool:
    """Return whether a piece clears the axle and overlaps no other piece."""
    clear = min(map(abs, piece.span)) >= MIN_AXLE_CLEARANCE
    return clear and not holds_axle(piece) and all(are_clear(piece, other) for other in others)


def are_clear(one: WeldedPiece, other: WeldedPiece) -> bool:
    """Return whether two pieces on one arm do not overlap, and neither extends past the axle."""
    (low, high), (near, far) = one.span, other.span
    return (high < near or far < low) and not any(begin < 0.0 < end for begin, end in (one.span, other.span))


def _bear(pieces: Sequence[WeldedPiece], *, unmoved: int) -> bool:
    """Return whether all numbers of the pieces, except at most `unmoved` of them, affect the motion of the arm.

    The mass of a single piece cancels.
    """
    shares = [_share(piece) for piece in pieces]
    for number, piece in enumerate(pieces):
        others = _total([*shares[:number], *shares[number + 1 :]])
        paths = (
            path for path in idle_numbers(piece, partial(_responses, others)) if len(pieces) > 1 or path != "body.mass"
        )
        unmoved -= sum(1 for _ in islice(paths, unmoved + 1))
        if unmoved < 0:
            return False
    return True


def _is_unbalanced(pieces: Sequence[WeldedPiece]) -> bool:
    moments = [_share(piece).moment for piece in pieces]
    return abs(sum(moments)) >= MIN_IMBALANCE * sum(map(abs, moments))


class _Share(NamedTuple):
    """The contribution of pieces to Σ m x and to the moment of inertia about the axle."""

    moment: float  # m x, kg·m
    own: float  # moment of inertia about their own centres, kg·m²
    moved: float  # what the parallel-axis theorem adds, kg·m²


def _share(piece: WeldedPiece) -> _Share:
    solid, mass = _solid(piece), piece.shape.mass
    x, z = solid.center[0] + piece.place, solid.center[2]
    return _Share(mass * x, solid.inertia(mass)[1], mass * (x * x + z * z))


def _total(shares: Iterable[_Share]) -> _Share:
    return _Share(*map(sum, zip(*shares, strict=True))) if (shares := [*shares]) else _Share(0.0, 0.0, 0.0)


def _responses(others: _Share, piece: WeldedPiece) -> tuple[float]:
    """Return the number that determines an arm's motion: Σ m x over the moment of inertia about the axle, 1/m."""
    total = _total((others, _share(piece)))
    return (total.moment / (total.own + total.moved),)


def _solid(piece: WeldedPiece) -> Solid:
    return piece.shape.solid.turned(piece.axes)


ROLLING, TUMBLING = "RollingEntity", "TumblingPrism"
CENTRED = ("Sphere", "SphericalShell", "Roller", "Pipe", "Disc", "Hoop")
ANY_ROUND = (*CENTRED, "HollowSphere", "ThickPipe")  # the thickness of the wall matters if the body is set spinning
HOLED = ("BoredCylinder", "SphereWithHole")
ROLLS = {"body": CENTRED, "grip": ("NoSlipping",), "way": ("up the slope", "down the slope"), "start": ("Rolling",)}
LEVEL = {
    "body": ANY_ROUND,
    "HollowSphere.thickness": Range(0.02, 0.04),
    "grip": ("Rough",),
    "angle": 0.0,
    "start?": 1.0,
    "way": ("to the right",),
}
ROCKS = {  # with a hole so large, a centre of mass so low, and on so gentle a slope, that it counts
    "body": HOLED,
    "hole?": 1.0,
    "towards?": 1.0,
    "grip": ("NoSlipping",),
    "bearing": Range(15.0, 60.0),
    "radius": Range(0.15, 0.2),
    "hole": Range(0.11, 0.15),
    "offset": Range(0.03, 0.055),
}
MIN_INERTIA_RATIO = 1.22  # least ratio of the moments of inertia with and without the hole


def _hole_counts(entity: RollingEntity) -> bool:
    """Return whether omitting the hole from the moment of inertia changes the answer."""
    solid, plain = (shape.inertia(1.0)[1] for shape in (entity.body.solid, entity.body.plainer["hole"]))
    return solid >= MIN_INERTIA_RATIO * plain


LIVELY = {
    **ROLLS,
    "grip": ("Rough",),
    "angle": Range(20.0, 42.0),
    "start?": 1.0,
    "start": ("Sliding", "Spinning", "Spinning"),
}
ROLLING_IDEAS = {
    "easy": (
        Idea(ROLLING, {**ROLLS, "start?": 0.0}),
        Idea(ROLLING, {**ROLLS, "start?": 1.0}),
    ),
    "medium": (  # it slips until it rolls, slips all the way on too steep a slope, or has its weight on one side
        Idea(ROLLING, {**LEVEL, "start": ("Sliding", "Spinning", "Spinning")}, 1.2),
        Idea(
            ROLLING, {**ROLLS, "grip": ("Rough",), "start?": 0.0}, 0.3
        ),  # few questions about it take more than two laws
        Idea(ROLLING, {**ROCKS, "angle": 0.0, "towards": ("right",)}, 0.6, _hole_counts),
    ),
    "hard": (
        Idea(ROLLING, {**ROCKS, "angle": Range(2.0, 12.0), "towards": ("uphill", "downhill")}, 1.0, _hole_counts),
        Idea(ROLLING, LIVELY, 4.0),
        Idea(
            TUMBLING,
            {"rate?": 1.0, "rate": Range(4.5, 6.0), "angle": Range(6.0, 12.0), "shape": ("octagonal", "decagonal")},
            0.7,
        ),
    ),
}


# a period hangs neither on how it begins nor on the mass
ROLLING_WEIGHTS = {
    "start": 0.4,
    "period": 0.1,
    "extremum": 0.1,
    "limit": 0.1,
    "optimum": 0.1,
    "numeric.period": 0.0,
    "symbolic.optimum": 0.1,  # of formulas that are too long
}


@recipe("rolling", share=2, weights=ROLLING_WEIGHTS)
def draw_rolling(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A sphere, cylinder, hoop or prism on a plane, perhaps with a hole beside its axis."""
    return draw_idea(ROLLING_IDEAS[difficulty], rng, "roller")
