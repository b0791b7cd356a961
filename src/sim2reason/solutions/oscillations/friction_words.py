"""Kinetic friction on bodies on springs, in words: how large it is, and which way it acts."""

from sim2reason.solutions.oscillations.harmonic import Harmonic
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.oscillations.linear_way import LinearWay
from sim2reason.solutions.setting import joined


def friction_words(way: LinearWay, motion: LinearMotion) -> str:
    """Return on whom kinetic friction acts, and which way: on block A up the slope, and on block B to the left."""
    ways: dict[str, list[str]] = {}
    for face, side in motion.laws.rough.items():
        found = [(k, radius) for k, radius in _slip(motion, face) if motion.ratios[k]]
        if side and found:
            k, radius = found[0]
            against = way.towards(k, forward=side * radius < 0.0)
            ways.setdefault(against, []).append(motion.mechanism.faces[face].subject)
    return joined([f"on {way.setting.listed(bodies)} {against}" for against, bodies in ways.items()])


def swing_words(way: LinearWay, held: Harmonic, number: int) -> list[str]:
    """Return what friction does until a swing ends, the first of which has the number 0, and how it moves then."""
    motion = held.motion
    assert isinstance(motion, LinearMotion)
    who, acts = way.who(motion.free[0]), friction_words(way, motion)
    halves = "half an oscillation, symmetric about the point at which the net force is zero"
    if number:
        begun = way.first(motion.free[0]) and number == 1
        whole = f"From one moment of rest to the next the motion is {halves}." if begun else ""
        here = f"Let ${held.name.name}$ be the displacement from here."
        return [f"Until {who} next comes to rest, friction acts {acts} and is constant.", here, whole]
    lead = f"Until {who} first comes to rest, kinetic friction{_size(motion)} acts {acts} and is constant"
    half = "half of a harmonic oscillation, symmetric" if not held.first else "harmonic"
    return [f"{lead}, so the motion is {half} about the point at which the net force is zero."]


def _size(motion: LinearMotion) -> str:
    """Return how large kinetic friction is, where it acts on one body alone."""
    faces = [face for face, side in motion.laws.rough.items() if side]
    if len(faces) != 1:
        return ""
    return f" of magnitude ${(motion.laws.coefficient(faces[0]) * motion.normal(faces[0])).factored().latex()}$"


def _slip(motion: LinearMotion, face: int) -> list[tuple[int, float]]:
    """Return the coordinates along which a body slides on a face, with what each adds to the slip."""
    m = motion.mechanism
    pairs = [(m.number[name], radius) for name, radius in m.faces[face].slip]
    return [(k, radius) for k, radius in pairs if m.coordinates[k].kind == "slide"]
