"""Wrong answers that an item carries, and what of its scene it marks as having no bearing."""

from collections.abc import Iterator

from sim2reason.errors import SceneError
from sim2reason.generation.filters import Candidate
from sim2reason.generation.filters.parts.effects import Effect, effects, far_effects
from sim2reason.generation.filters.parts.numbers import elasticities, matters
from sim2reason.generation.item import Distractor
from sim2reason.scenes.dsl.entity import Part
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.text.prose.description import Description

CLEARLY = 2.0  # of the tolerance: how far every wrong answer is from the right one
APART = 1e-2  # relative: wrong answers that differ by less are one
SMALLEST, LARGEST = 1e-2, 1e3  # times the right answer: nobody would believe less or more
FEW = 1  # wrong answers: where there are fewer, time is spent on others
ENOUGH = 4  # of them, as many as stand beside the right one of five


def distractors(candidate: Candidate, description: Description, few: int = FEW) -> tuple[Distractor, ...]:
    """Return what the slips lead to that change the answer beyond the tolerance, each value once, the nearest first.

    Where they lead to fewer than `few`, answers are looked for that are far from the right one.
    """
    found = list[Effect]()
    heard = sorted((e for part in (False, True) for e in effects(candidate, part=part)), key=_place)
    for effect in (e for e in heard if e.simplification.misleads):
        _add(effect, candidate, found)
    _fill(found, ENOUGH, (e for e in heard if not e.simplification.misleads), candidate)
    _fill(found, few, far_effects(candidate), candidate)
    return tuple(_told(effect, description) for effect in sorted(found, key=_place))


def _place(effect: Effect) -> tuple[float, str]:
    """By what wrong answers are put in order."""
    return effect.change, effect.simplification.name


def _fill(found: list[Effect], enough: int, offered: Iterator[Effect], candidate: Candidate) -> None:
    """As many more as are missing, if so many are offered; no more are looked at."""
    while len(found) < enough and (effect := next(offered, None)) is not None:
        _add(effect, candidate, found)


def _add(effect: Effect, candidate: Candidate, found: list[Effect]) -> None:
    """One more, if somebody could give this answer, would be wrong, and it is not there yet."""
    value, question = effect.answer, candidate.question
    if (
        value is None
        or effect.change < CLEARLY * effect.tolerance
        or not SMALLEST < abs(value / question.answer) < LARGEST
    ):
        return
    if candidate.kind.names_one:
        if abs(value) < candidate.kind.measured(question.query).least:
            return
    elif value < 0.0 and not question.sign:  # nobody gives a size that is negative
        return
    if all(other.answer is not None and abs(value - other.answer) > APART * abs(value) for other in found):
        found.append(effect)


def _told(effect: Effect, description: Description) -> Distractor:
    assert effect.answer is not None
    name, reason = effect.simplification.name, _reason(effect, description)
    return Distractor(value=effect.answer, simplification=name, reason=reason)


def idle_parts(candidate: Candidate, description: Description) -> tuple[str, ...]:
    """Return the parts that could be held or left out, as the text calls them."""
    idle = dict.fromkeys(effect.subject for effect in effects(candidate, part=True) if effect.close)
    return tuple(_called(subject, description) for subject in idle)


def idle_numbers(candidate: Candidate, description: Description) -> tuple[str, ...]:
    """Return the addresses of the stated numbers that hardly move the answer, even when they are halved or doubled.

    A scene has more numbers than its text states: g where nothing falls, or how all begins where that is not told.
    """
    stated = frozenset(description.told)
    told = (found for found in elasticities(candidate) if not stated.isdisjoint(found.given.paths))
    idle = (found.given for found in told if not matters(candidate, found))
    return tuple(path for given in idle for path in given.paths if path in stated)


def _reason(effect: Effect, description: Description) -> str:
    said = effect.simplification.reason.format(subject=_called(effect.subject, description))
    return said[0].upper() + said[1:] + "."


def _called(subject: str, description: Description) -> str:
    """As the text calls a body, or a sentence another part; of what is neither, the name."""
    scene = description.scene
    if subject in scene.bodies:
        return description.mention(subject)
    forces = {force.name for force in scene.mechanism.forces}
    part = _at(scene, subject) if subject in forces else None
    return part.called if isinstance(part, Part) and part.called else subject


def _at(scene: Scene, address: str) -> object:
    """Return the scene's value at the address of a force; None if the force's name is no address."""
    try:
        return scene.value(address)
    except SceneError:
        return None
