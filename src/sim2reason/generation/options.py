"""Distractors of a problem, and the options of a multiple-choice item."""

from collections.abc import Iterator, Sequence
from hashlib import blake2b

from sim2reason.errors import SceneError
from sim2reason.generation.filters import Candidate
from sim2reason.generation.filters.misconceptions import Effect, effects, find_far_effects
from sim2reason.generation.filters.sensitivity import elasticities, matters
from sim2reason.generation.item import Answer, Distractor, Item, grade_answer
from sim2reason.questions.prompt_formats import LETTERS, format_numbers
from sim2reason.scenes.dsl.entity import Part
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.text.prose.description import Description

MIN_DISTANCE = 2.0  # times the tolerance: distance of a distractor from the correct answer
SAME_ANSWER_RTOL = 1e-2  # relative; distractors that differ by less are merged
SMALLEST, LARGEST = 1e-2, 1e3  # times the right answer: nobody would believe less or more
MIN_DISTRACTORS = 1  # distractors; if there are fewer, a longer search runs
MAX_DISTRACTORS = 4  # distractors: as many as beside the correct answer among five options


def distractors(candidate: Candidate, description: Description, few: int = MIN_DISTRACTORS) -> tuple[Distractor, ...]:
    """Return the distinct distractors from misconceptions, nearest first, at least `few` if possible.

    If misconceptions give fewer than `few`, a longer search includes answers far from the correct one.
    """
    selected = list[Effect]()
    ranked = sorted((e for part in (False, True) for e in effects(candidate, part=part)), key=_sort_key)
    for effect in (e for e in ranked if e.simplification.misleads):
        _add(effect, candidate, selected)
    _fill(selected, MAX_DISTRACTORS, (e for e in ranked if not e.simplification.misleads), candidate)
    _fill(selected, few, find_far_effects(candidate), candidate)
    return tuple(_told(effect, description) for effect in sorted(selected, key=_sort_key))


def _sort_key(effect: Effect) -> tuple[float, str]:
    """Return the key by which distractors are sorted: the distance from the correct answer, then the misconception."""
    return effect.change, effect.simplification.name


def _fill(selected: list[Effect], enough: int, offered: Iterator[Effect], candidate: Candidate) -> None:
    """Add further wrong answers from `offered` to `selected` until there are `enough`."""
    while len(selected) < enough and (effect := next(offered, None)) is not None:
        _add(effect, candidate, selected)


def _add(effect: Effect, candidate: Candidate, selected: list[Effect]) -> None:
    """Add a distractor if it is believable, incorrect and new."""
    value, question = effect.answer, candidate.question
    if (
        value is None
        or effect.change < MIN_DISTANCE * effect.tolerance
        or not SMALLEST < abs(value / question.answer) < LARGEST
    ):
        return
    if candidate.kind.names_one:
        if abs(value) < candidate.kind.measured(question.query).least:
            return
    elif value < 0.0 and not question.sign:  # nobody gives a size that is negative
        return
    if all(
        other.answer is not None and abs(value - other.answer) > SAME_ANSWER_RTOL * abs(value) for other in selected
    ):
        selected.append(effect)


def _told(effect: Effect, description: Description) -> Distractor:
    assert effect.answer is not None
    name, reason = effect.simplification.name, _reason(effect, description)
    return Distractor(value=effect.answer, simplification=name, reason=reason)


def idle_parts(candidate: Candidate, description: Description) -> tuple[str, ...]:
    """Return the names of parts that can be held fixed or omitted without effect."""
    idle = dict.fromkeys(effect.subject for effect in effects(candidate, part=True) if effect.is_accepted)
    return tuple(_subject_name(subject, description) for subject in idle)


def idle_numbers(candidate: Candidate, description: Description) -> tuple[str, ...]:
    """Return the addresses of stated numbers that hardly change the answer when halved or doubled.

    Numbers that the text does not state, such as g where nothing falls, are excluded.
    """
    stated = frozenset(description.told)
    mentioned = (elasticity for elasticity in elasticities(candidate) if not stated.isdisjoint(elasticity.given.paths))
    idle = (elasticity.given for elasticity in mentioned if not matters(candidate, elasticity))
    return tuple(path for given in idle for path in given.paths if path in stated)


def _reason(effect: Effect, description: Description) -> str:
    said = effect.simplification.reason.format(subject=_subject_name(effect.subject, description))
    return said[0].upper() + said[1:] + "."


def _subject_name(subject: str, description: Description) -> str:
    """Return the name of a body or other part in the text; else the name in the scene."""
    scene = description.scene
    if subject in scene.bodies:
        return description.mention(subject)
    forces = {force.name for force in scene.mechanism.forces}
    part = _at(scene, subject) if subject in forces else None
    return part.called if isinstance(part, Part) and part.called else subject


def _at(scene: Scene, address: str) -> object:
    """Return the object at the address of a force; None if the name of the force is no address."""
    try:
        return scene.value(address)
    except SceneError:
        return None


REQUIRED_DISTRACTORS = 3  # distractors
OPTION_RTOL = 0.1  # relative difference between any two options, at least
OPTION_ROUNDING_RTOL = 0.01  # relative: half a per cent for each of two rounded numbers
LACKS = f"it needs a number as its answer, and {REQUIRED_DISTRACTORS} wrong ones, all a tenth apart"

OTHER, NAMES_OTHER = "other of two", "It names the other of the two."
RIGHT_NAME = "It names the right one of the two all the same."

Options = tuple[Distractor | None, ...]
"""In their order; None stands for the right one."""


def options(answer: Answer, wrong: Sequence[Distractor], name: str) -> Options | None:
    """Return the correct answer and distractors in a random order seeded by `name`; None for too few.

    In three digits, the grader accepts only the correct option, and all options differ by at least a tenth. Every
    position of the correct option is equally likely.
    """
    if answer.formula is not None or answer.parts:
        return None
    chosen: list[Distractor | None] = [None]
    for each in wrong:
        if len(chosen) < len(LETTERS) and _is_distinct(answer, each, chosen):
            chosen.append(each)
    if len(chosen) <= REQUIRED_DISTRACTORS or not _graded(answer, format_numbers(values(answer, chosen))):
        return None
    return _ordered(chosen, name)


def options_of_two(answer: Answer, wrong: Sequence[Distractor], name: str) -> Options | None:
    """Return four options that each state a name and a number: two names, each with the right and a wrong number.

    Negative numbers belong to the second name. None if no wrong number is distinct from the correct one.
    """
    size = answer.model_copy(update={"value": abs(answer.value)})
    sizes = (each.model_copy(update={"value": abs(each.value)}) for each in wrong)
    pairs = zip(wrong, sizes, strict=True)
    number = next((each for each, positive in pairs if _is_distinct(size, positive, [None])), None)
    if number is None:
        return None
    other = Distractor(value=-answer.value, simplification=OTHER, reason=NAMES_OTHER)
    twin = number.model_copy(update={"value": -number.value, "reason": f"{number.reason} {_beside(number, answer)}"})
    return _ordered((None, other, number, twin), name)


def _beside(number: Distractor, answer: Answer) -> str:
    """Return the reason why an option is wrong that states `number` with the other of the two possible names."""
    return NAMES_OTHER if number.value * answer.value > 0.0 else RIGHT_NAME


def _ordered(chosen: Sequence[Distractor | None], name: str) -> Options:
    """Return options in a random order that depends only on `name`."""
    order = [blake2b(f"{name}\n{number}".encode()).digest() for number in range(len(chosen))]
    return tuple(chosen[number] for number in sorted(range(len(chosen)), key=lambda number: order[number]))


def item_options(item: Item) -> Options | None:
    """Return the options of a multiple-choice item, or those that another item could have; None for too few."""
    if not item.answer.letter:
        return options(item.answer, item.distractors, item.id)
    label, wrong = LETTERS.index(item.answer.letter), iter(item.distractors)
    return tuple(None if number == label else next(wrong) for number in range(len(item.answer.options)))


def values(answer: Answer, chosen: Sequence[Distractor | None]) -> list[float]:
    """Return the number that each option states."""
    return [answer.value if wrong is None else wrong.value for wrong in chosen]


def _is_distinct(answer: Answer, wrong: Distractor, chosen: Sequence[Distractor | None]) -> bool:
    """Return whether a wrong answer differs clearly from the correct one and from all chosen options."""
    separation = max(OPTION_RTOL, answer.tolerance) + OPTION_ROUNDING_RTOL
    others = values(answer, chosen)
    return all(abs(wrong.value - other) > separation * max(abs(wrong.value), abs(other)) for other in others)


def _graded(answer: Answer, texts: list[str]) -> bool:
    """Return whether the grader accepts only the first text as correct."""
    rewards = [grade_answer(answer, rf"\boxed{{{text}}}").reward for text in texts]
    return rewards == [1.0, *(0.0 for _ in texts[1:])]
