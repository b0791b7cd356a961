"""Sentences about the size and the direction of kinetic friction in oscillations."""

from sim2reason.solutions.laws.sliding import sliding_coordinates
from sim2reason.solutions.oscillations.fastest_place import swings_on
from sim2reason.solutions.oscillations.harmonic import Harmonic
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.oscillations.linear_way import LinearWay
from sim2reason.solutions.setting import capital, joined


def friction_words(way: LinearWay, motion: LinearMotion) -> str:
    """Return which way kinetic friction acts, in words; and on whom, unless that is what moves with `motion`."""
    ways: dict[str, list[str]] = {}
    for face, side in motion.laws.rough.items():
        found = [(k, radius) for k, radius in sliding_coordinates(motion.mechanism, face) if motion.ratios[k]]
        if side and found:
            k, radius = found[0]
            against = way.towards(k, forward=side * radius < 0.0)
            ways.setdefault(against, []).append(motion.mechanism.faces[face].subject)
    if [body for bodies in ways.values() for body in bodies] == [motion.mechanism.coordinates[motion.free[0]].body]:
        return next(iter(ways))
    return joined([f"on {way.setting.listed(bodies)} {against}" for against, bodies in ways.items()])


def first_friction(way: LinearWay, motion: LinearMotion) -> str:
    """Return the sentence, without its full stop, about kinetic friction in motion that begins from rest."""
    acts = f"friction acts {friction_words(way, motion)}"
    return f"Until {way.who(motion.free[0])} first comes to rest, {acts}" if swings_on(way.setting) else capital(acts)


def swing_words(way: LinearWay, held: Harmonic, number: int) -> list[str]:
    """Return sentences about the friction in one half oscillation and the motion in it; the first has the number 0."""
    motion = held.motion
    assert isinstance(motion, LinearMotion)
    who, acts = way.who(motion.free[0]), friction_words(way, motion)
    half = "half an oscillation, symmetric about the point at which the net force is zero"
    if number:
        begun = way.first(motion.free[0]) and number == 1
        counted = f"let ${held.name.name}$ be the displacement {way.towards(motion.free[0])} from here"
        return [
            f"Until it next comes to rest, friction acts {acts}; {counted}.",
            f"The motion is then {half}." if begun else "",
        ]
    whole = half if not held.first else "harmonic about the point at which the net force is zero"
    friction = f"constant friction{_size(motion)} acts {acts}"
    return [f"Until {who} first comes to rest, {friction}, so the motion is {whole}."]


def _size(motion: LinearMotion) -> str:
    """Return how large kinetic friction is, after a space, where it acts on one body alone."""
    faces = [face for face, side in motion.laws.rough.items() if side]
    if len(faces) != 1:
        return ""
    return f" ${(motion.laws.coefficient(faces[0]) * motion.normal(faces[0])).factored().latex()}$"
