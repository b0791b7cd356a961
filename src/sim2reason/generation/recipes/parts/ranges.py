"""Ranges of the numbers in scenes of strings and planes, by difficulty."""

from collections.abc import Mapping

from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.model import Choice

WORDS: Mapping[Difficulty, int] = {"easy": 66, "medium": 135, "hard": 205}
"""The longest text of a scene, without its question."""
PRISM = 25
"""Words more for scenes that else have no room for a prism."""
TWO = 18
"""Words more for easy scenes that are always of two entities."""

NUMBERS: Mapping[Difficulty, Mapping[str, Choice]] = {
    "easy": {
        "mass": Range(0.5, 3.0),
        "pulley mass": Range(0.1, 3.0),
        "friction": Range(0.2, 0.6),
        "angle": Range(25.0, 39.0),
        "blocks": Count(1, 1),
        "left_blocks": Count(1, 1),
        "right_blocks": Count(1, 1),
    },
    "medium": {
        "mass": Range(1.0, 8.0),
        "pulley mass": Range(0.2, 8.0),
        "friction": Range(0.2, 0.5),
        "angle": Range(25.0, 65.0),
        "blocks": Count(1, 1),  # blocks that move as one add nothing but a sum of masses
        "left_blocks": Count(1, 1),
        "right_blocks": Count(1, 2),
    },
    "hard": {
        "mass": Range(2.0, 20.0),
        "pulley mass": Range(0.5, 20.0),
        "friction": Range(0.15, 0.4),
        "angle": Range(25.0, 65.0),
        "blocks": Count(1, 2),
        "left_blocks": Count(1, 2),
        "right_blocks": Count(1, 2),
    },
}

SIZES: Mapping[str, Choice] = {
    "UniformRod.length": Range(0.4, 1.2),
    "Bar.length": Range(0.4, 0.9),
    "Bar.width": Range(0.15, 0.3),
    "radius": Range(0.08, 0.2),
    "height": Range(0.2, 0.5),
    "SphericalCap.height": Range(0.06, 0.15),
    "hole": Range(0.05, 0.1),
    "offset": Range(0.05, 0.1),
    "RoundPiece.body": ("Sphere", "SphericalShell"),  # the thickness of a wall would hardly count
    "CappedPiece.body": ("Hemisphere", "SphericalCap"),
    "HoledPiece.body": ("SphereWithHole",),
}
"""Pieces of what swings, so large that their moments of inertia about their own centres count."""
