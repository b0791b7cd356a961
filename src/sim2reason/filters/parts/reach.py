"""How much of a scene must move an answer, for a problem of its difficulty."""

from collections.abc import Sequence

from sim2reason.filters import Candidate
from sim2reason.filters.parts.numbers import Given

ALONE = {"easy": 2, "medium": 3, "hard": 3}  # numbers that must matter where one body moves
TOGETHER = {"easy": 3, "medium": 3, "hard": 4}  # and where several do
PARTS = 2  # of several bodies, what so many have must matter
EVER = 0.4  # of all that is told, what may be idle: no more, be it marked or cancel, or the text tells another story
MASS = "kg"


def least(candidate: Candidate) -> int:
    """How many numbers must move the answer, at least: of two bodies in an easy problem their masses are enough."""
    bodies = [body for body in candidate.study.mechanism.bodies if body.mass > 0.0 and body.coordinates]
    return (ALONE if len(bodies) < 2 or candidate.difficulty == "easy" else TOGETHER)[candidate.difficulty]


def of_question(candidate: Candidate) -> int:
    """How many numbers the question itself has: those that it states, and one that it leaves unknown."""
    moment = candidate.question.query.moment
    return len(moment.stated if moment is not None else ()) + bool(candidate.question.unknown)


def shortfall(candidate: Candidate, moving: Sequence[Given]) -> str:
    """What those that move the answer fall short of, in a few words; empty if they are enough.

    The numbers that the question itself states count as well, and what it leaves unknown; g does not.
    """
    mechanism = candidate.study.mechanism
    bodies = [body for body in mechanism.bodies if body.mass > 0.0 and body.coordinates]
    count = len(moving) + of_question(candidate)
    if len(bodies) < 2:
        return "" if count >= ALONE[candidate.difficulty] else f"{count} numbers matter"
    masses = sum(given.parameters[0].measure.unit == mechanism.units.spell(MASS) for given in moving)
    if candidate.difficulty == "easy" and masses >= 2:
        return ""
    if candidate.difficulty == "easy" and not any(given.parameters[0].measure.name == "friction" for given in moving):
        return f"{masses} masses matter"
    parts = len({given.owner for given in moving})
    enough = count >= TOGETHER[candidate.difficulty] and (parts >= PARTS or candidate.difficulty == "easy")
    return "" if enough else f"{count} numbers of {parts} parts matter"
