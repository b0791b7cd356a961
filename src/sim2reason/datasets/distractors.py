"""Wrong answers that an item carries, and what of its scene it marks as having no bearing."""

from sim2reason.datasets.item import Distractor
from sim2reason.dsl.entity import Part
from sim2reason.filters import Candidate
from sim2reason.filters.parts.effects import Effect, effects
from sim2reason.filters.parts.numbers import elasticities, matters
from sim2reason.prose.description import Description

APART = 1e-2  # relative: wrong answers that differ by less are one
SMALLEST, LARGEST = 1e-2, 1e3  # times the right answer: nobody would believe less or more


def distractors(candidate: Candidate, description: Description) -> tuple[Distractor, ...]:
    """What the slips lead to that change the answer beyond the tolerance, each value once, the nearest first."""
    answer = candidate.question.answer
    found: list[Distractor] = []
    every = [*effects(candidate, part=False), *effects(candidate, part=True)]
    for effect in sorted((e for e in every if _misleads(e, answer)), key=lambda e: (e.change, e.simplification.name)):
        value = effect.answer
        assert value is not None
        if all(abs(value - other.value) > APART * abs(value) for other in found):
            found.append(
                Distractor(value=value, simplification=effect.simplification.name, reason=_reason(effect, description))
            )
    return tuple(found)


def idle_parts(candidate: Candidate, description: Description) -> tuple[str, ...]:
    """The parts that could be held or left out, as the text calls them."""
    idle = dict.fromkeys(effect.subject for effect in effects(candidate, part=True) if effect.close)
    return tuple(_called(subject, description) for subject in idle)


def idle_numbers(candidate: Candidate, description: Description) -> tuple[str, ...]:
    """The addresses of the stated numbers that hardly move the answer, even when they are halved or doubled.

    A scene has more numbers than its text states: g where nothing falls, or how all begins where that is not told.
    """
    stated = frozenset(description.told)
    told = (found for found in elasticities(candidate) if not stated.isdisjoint(found.given.paths))
    idle = (found.given for found in told if not matters(candidate, found))
    return tuple(path for given in idle for path in given.paths if path in stated)


def _misleads(effect: Effect, answer: float) -> bool:
    """Whether somebody could give this answer, and would be wrong."""
    if effect.answer is None or effect.close or not effect.simplification.misleads:
        return False
    return SMALLEST < abs(effect.answer / answer) < LARGEST


def _reason(effect: Effect, description: Description) -> str:
    said = effect.simplification.reason.format(subject=_called(effect.subject, description))
    return said[0].upper() + said[1:] + "."


def _called(subject: str, description: Description) -> str:
    """As the text calls a body, or a sentence another part; of what is neither, the name."""
    scene = description.scene
    if subject in scene.bodies:
        return description.mention(subject)
    forces = {force.name for force in scene.mechanism.forces}
    part = scene.value(subject) if subject in forces else None
    return part.called if isinstance(part, Part) and part.called else subject
