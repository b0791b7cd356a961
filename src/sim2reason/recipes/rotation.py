"""Rigid bodies that swing about an axle."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np

from sim2reason.dsl.entity import Named
from sim2reason.dsl.measures import Count, Range
from sim2reason.dsl.model import draw
from sim2reason.dsl.scene import Scene
from sim2reason.dsl.solids import Solid
from sim2reason.entities.parts.assembly import WeldedArm, holds_axle
from sim2reason.entities.parts.pieces import (
    OTHER,
    AxialPiece,
    BallPiece,
    BarPiece,
    CappedPiece,
    HoledPiece,
    RoundPiece,
    TiltedPiece,
    WeldedPiece,
)
from sim2reason.entities.rotation_entity import RotationEntity
from sim2reason.errors import SceneError
from sim2reason.recipes import Difficulty, recipe
from sim2reason.recipes.parts.bearing import idle
from sim2reason.recipes.parts.ranges import SIZES

NEAR = {**SIZES, "distance": Range(0.1, 0.5), "side?": 0.4, "side": (OTHER,)}
FAR = {"distance": Range(0.2, 0.8), "side?": 0.4, "side": (OTHER,)}
PUSH = Range(2.5, 6.0)  # rad/s
SOLID = {AxialPiece: 0.4, RoundPiece: 0.2, CappedPiece: 0.1, TiltedPiece: 0.1, HoledPiece: 0.1, BarPiece: 0.1}
SMALL = 0.5  # the chance that a further piece is a small ball
OWN = 0.14  # of all inertia that belongs to the pieces about their own centres: less would be forgiven
MANY = 3  # pieces, of which one may have a size without bearing
TOO_MANY = 2  # sizes without bearing, whatever the pieces
DRAWS = 200
TRIES = 60  # pieces that are drawn before all are drawn anew


@dataclass(frozen=True)
class SwingTier:
    """How hard: how many pieces, and how often they are pushed."""

    pieces: Count
    pushed: float


TIERS = {
    "easy": (SwingTier(Count(1, 1), 0.0),),
    "medium": (SwingTier(Count(2, 3), 0.0), SwingTier(Count(1, 1), 1.0)),
    "hard": (SwingTier(Count(2, 4), 0.0), SwingTier(Count(2, 3), 1.0)),  # some go over the top
}


# a period hangs neither on how it begins nor on a lone mass
WEIGHTS = {
    "sum": 0.4,
    "state": 0.3,
    "time_to_event": 0.2,
    "period": 0.5,
    "comparison": 0.3,
    "threshold": 0.4,
    "optimum": 0.1,
}


@recipe("rotation", share=2, weights=WEIGHTS)
def draw_rotation(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Up to four solid bodies fixed to a light arm: let go, or set turning."""
    tiers = TIERS[difficulty]
    tier = tiers[int(rng.integers(len(tiers)))]
    choices = {"rate?": tier.pushed, "rate": PUSH}
    for _ in range(DRAWS):
        arm = draw(RotationEntity, rng, choices, {"pieces": _pieces(tier, rng)})
        if _bears(arm):
            return Scene(entities=(Named(name="arm", entity=arm),))
    raise SceneError("arm", f"the pieces of none of {DRAWS} draws all have a bearing", "draw again")


def _pieces(tier: SwingTier, rng: np.random.Generator) -> tuple[WeldedPiece, ...]:
    """One that is large, and others, perhaps small, where there is room on the arm; last those beyond the axle."""
    count, found, tries = int(rng.integers(tier.pieces.low, tier.pieces.high + 1)), list[WeldedPiece](), 0
    shares = np.array(list(SOLID.values()))
    while len(found) < count:
        kind = BallPiece if found and rng.random() < SMALL else list(SOLID)[int(rng.choice(len(SOLID), p=shares))]
        piece = draw(kind, rng, NEAR if kind is not BallPiece else FAR, {} if found else {"side": "from the axle"})
        tries += 1
        if not holds_axle(piece) and all(is_clear(piece, other) for other in found) and _is_worth(piece, found):
            found.append(piece)
        elif tries == TRIES:  # the first ones have taken all the room
            found, tries = [], 0
    return tuple(sorted(found, key=lambda piece: piece.place < 0.0))


def _is_worth(piece: WeldedPiece, others: Sequence[WeldedPiece]) -> bool:
    """Return whether the pieces stay large with `piece` among them, and `piece` alone is large or a small ball."""
    return (isinstance(piece, BallPiece) or _is_large([piece])) and _is_large([*others, piece])


def is_clear(one: WeldedPiece, other: WeldedPiece) -> bool:
    """Return whether two pieces on one arm are beside one another, and neither reaches past the axle."""
    (low, high), (near, far) = one.span, other.span
    return (high < near or far < low) and not any(begin < 0.0 < end for begin, end in (one.span, other.span))


def _bears(arm: WeldedArm) -> bool:
    """Return whether nearly every size of an arm's pieces affects the motion; the mass of a lone piece cancels."""
    unmoved = [*islice((path for path in idle(arm, _responses) if path.startswith("pieces.")), TOO_MANY)]
    return len(unmoved) <= (len(arm.pieces) >= MANY) or unmoved == ["pieces.0.body.mass"]


def _responses(arm: WeldedArm) -> tuple[float]:
    """What its motion hangs on: the sum of m x over the moment of inertia about the axle, 1/m."""
    solids = [_solid(piece) for piece in arm.pieces]
    moment = sum(p.shape.mass * (solid.center[0] + p.place) for p, solid in zip(arm.pieces, solids, strict=True))
    return (moment / sum(_inertia(arm.pieces, solids)),)


def _is_large(pieces: Sequence[WeldedPiece]) -> bool:
    """Whether enough of the inertia belongs to the pieces about their own centres."""
    own, moved = _inertia(pieces, [_solid(piece) for piece in pieces])
    return own >= OWN * (own + moved)


def _inertia(pieces: Sequence[WeldedPiece], solids: Sequence[Solid]) -> tuple[float, float]:
    """Moments of inertia about their own centres, and what is added about the axle by the parallel-axis theorem."""
    own = moved = 0.0
    for piece, solid in zip(pieces, solids, strict=True):
        mass, (x, _, z) = piece.shape.mass, solid.center
        own += solid.inertia(mass)[1]
        moved += mass * ((piece.place + x) ** 2 + z**2)
    return own, moved


def _solid(piece: WeldedPiece) -> Solid:
    return piece.shape.solid.turned(piece.axes)
