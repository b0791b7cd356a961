"""Sensitivity of an answer to the stated numbers, and the filter that counts the relevant ones."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.generation.filters.misconceptions import effects
from sim2reason.questions import SimulatedScene
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.solutions.algebra.expressions import Symbol

SHIFT_FRACTION = 1e-3  # relative change of a number
ANGLE_CHANGE = 10.0  # degrees by which an angle is changed where other numbers are halved and doubled
TIME_FACTOR = 2.2  # factor on the simulated time if a number is halved or doubled
CERTAIN_FACTOR = 3.0  # times the tolerance: an elasticity from which the number surely matters
VECTORS = "position", "velocity"  # measures whose numbers, where one thing has two, are components of one vector


@dataclass(frozen=True, slots=True)
class Given:
    """A stated number, or a vector stated by its components, with the addresses."""

    parameters: tuple[Parameter, ...]

    @property
    def paths(self) -> tuple[str, ...]:
        """Return the addresses of the numbers."""
        return tuple(parameter.path for parameter in self.parameters)

    @property
    def unit(self) -> str:
        """Return the unit of all numbers."""
        return self.parameters[0].measure.unit

    @property
    def owner(self) -> str:
        """Return the address of the object that the numbers belong to."""
        return self.paths[0].rpartition(".")[0]

    def scaled(self, factors: tuple[float, float], turn: float = 0.0) -> dict[str, float]:
        """Return the vector's components by address after multiplication by two factors in turn; angles are turned."""
        values = [(parameter.path, parameter.value or 0.0) for parameter in self.parameters]
        if self.unit == "deg" and turn:
            return {path: value + turn for path, value in values}
        return {path: factors[n % 2] * value for n, (path, value) in enumerate(values)}


@dataclass(frozen=True, slots=True)
class Elasticity:
    """The relative change of an answer per small relative change of one stated number."""

    given: Given
    size: float  # |d ln answer/d ln number|
    reordered: bool  # whether the shift changes what happens on the way, or the answer is gone


def givens(scene: Scene, left_open: Collection[str] = ()) -> list[Given]:
    """Return the stated numbers of a scene, without zeros, numbers stated by words, and unknown ones."""
    groups: dict[tuple[str, str], list[Parameter]] = {}
    for parameter in scene.parameters:
        if parameter.path not in left_open and _is_said(scene, parameter):
            name = parameter.measure.name
            owner = parameter.path.rpartition(".")[0]
            groups.setdefault((owner, name) if name in VECTORS else (parameter.path, ""), []).append(parameter)
    return [Given(tuple(parameters)) for parameters in groups.values()]


def _is_said(scene: Scene, parameter: Parameter) -> bool:
    if parameter.hidden or not parameter.value:
        return False
    owner, _, name = parameter.path.rpartition(".")
    body = scene.bodies.get(owner)
    return not (body is not None and body.is_stated_by_word(name))


def elasticities(candidate: Candidate) -> Iterator[Elasticity]:
    """Yield the elasticity (d ln answer/d ln number) of the answer for each stated number, from a shift by 0.1 %.

    Numbers that the worked solution does not use come first, so that an irrelevant one is found early.
    """
    study = candidate.study
    before = study.trace.story(candidate.time)
    used = _used(candidate)
    for given in sorted(givens(study.scene, candidate.question.left_open), key=lambda g: not used.isdisjoint(g.paths)):
        other = simulate_shifted(study, given, candidate.until)
        answer = candidate.response(other)
        if other is None or answer is None:
            yield Elasticity(given, 0.0, reordered=True)
            continue
        time = candidate.kind.time(candidate.question.query, other)
        size = candidate.change_to(answer) / SHIFT_FRACTION
        yield Elasticity(given, size, reordered=other.trace.story(time) != before)


def _used(candidate: Candidate) -> set[str]:
    """Return the addresses of all numbers that the worked solution uses; empty without a solution."""
    if candidate.words is None or candidate.solution is None:
        return set()
    relations = (relation for step in candidate.solution.steps for relation in step.relations)
    given_symbols = {relation.left for relation in relations if relation.role == "given"}
    return {path for path, symbol in candidate.words.symbols.items() if Symbol(symbol) in given_symbols}


def matters(candidate: Candidate, elasticity: Elasticity) -> bool:
    """Return whether halving or doubling a number (or rotating an angle) changes the answer beyond the tolerance.

    If the motion becomes slower, it is simulated for longer; if the answer is still not reached, the test is
    inconclusive.
    """
    if elasticity.reordered or elasticity.size >= CERTAIN_FACTOR * candidate.tolerance:
        return True
    study, given, time = candidate.study, elasticity.given, candidate.time or 0.0
    until = None if candidate.time is None else TIME_FACTOR * time
    for factor, turn in ((2.0, ANGLE_CHANGE), (0.5, -ANGLE_CHANGE)):
        other = study.with_values(given.scaled((factor, factor), turn), until)
        answer = candidate.response(other)
        if answer is None and (other is None or other.trace.stable_until < TIME_FACTOR * time):
            continue
        if candidate.change_to(answer) > candidate.tolerance:
            return True
    return False


def simulate_shifted(study: SimulatedScene, given: Given, until: float | None) -> SimulatedScene | None:
    """Return the motion after a number is shifted by 0.1 %, downwards if upwards is invalid; None if neither is valid.

    The components of a vector are shifted in opposite directions, which rotates it.
    """
    for factors in ((1.0 + SHIFT_FRACTION, 1.0 - SHIFT_FRACTION), (1.0 - SHIFT_FRACTION, 1.0 + SHIFT_FRACTION)):
        other = study.with_values(given.scaled(factors), until)
        if other is not None:
            return other
    return None


MIN_SINGLE_BODY = {"easy": 2, "medium": 3, "hard": 3}  # numbers that must matter if one body moves
MIN_SEVERAL_BODIES = {"easy": 3, "medium": 3, "hard": 4}  # numbers that must matter if several bodies move
MIN_RELEVANT_PARTS = 2  # of several bodies, the number that must have a relevant number
MAX_IDLE_SHARE = 0.4  # largest fraction of stated numbers that may be irrelevant, even if marked
MASS = "kg"


def minimum_relevant(candidate: Candidate) -> int:
    """Return the minimum count of numbers in the text that must change the answer, by difficulty."""
    bodies = [body for body in candidate.study.mechanism.bodies if body.mass > 0.0 and body.coordinates]
    return (MIN_SINGLE_BODY if len(bodies) < 2 or candidate.difficulty == "easy" else MIN_SEVERAL_BODIES)[
        candidate.difficulty
    ]


def question_number_count(candidate: Candidate) -> int:
    """Return the count of the question's own numbers: those it states, and its unknown."""
    moment = candidate.question.query.moment
    return len(moment.stated if moment is not None else ()) + bool(candidate.question.unknown)


def shortfall(candidate: Candidate, moving: Sequence[Given]) -> str:
    """Return in a few words why too few numbers change the answer; empty if there are enough.

    The numbers stated in the question and its unknown count as well; g does not.
    """
    mechanism = candidate.study.mechanism
    bodies = [body for body in mechanism.bodies if body.mass > 0.0 and body.coordinates]
    count = len(moving) + question_number_count(candidate)
    if len(bodies) < 2:
        return "" if count >= MIN_SINGLE_BODY[candidate.difficulty] else f"{count} numbers matter"
    masses = sum(given.parameters[0].measure.unit == mechanism.units.spell(MASS) for given in moving)
    if candidate.difficulty == "easy" and masses >= 2:
        return ""
    if candidate.difficulty == "easy" and not any(given.parameters[0].measure.name == "friction" for given in moving):
        return f"{masses} masses matter"
    parts = len({given.owner for given in moving})
    enough = count >= MIN_SEVERAL_BODIES[candidate.difficulty] and (
        parts >= MIN_RELEVANT_PARTS or candidate.difficulty == "easy"
    )
    return "" if enough else f"{count} numbers of {parts} parts matter"


MIN_COUNT_NUMBERS = 2  # numbers that must be able to change a count
MAX_IDLE_FRACTION = {"easy": 0.0, "medium": 0.1, "hard": 0.1}  # fraction of irrelevant numbers allowed without a mark


class Sensitivity(Filter):
    """Filter for questions with too few numbers that change the answer, or too many that do not.

    Not counted as irrelevant: numbers of parts that the item marks as distractions, the mass and charge of the subject
    and the radius of a rolling body, which may cancel, and numbers to which the question kind is indifferent.
    """

    order = 7

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if too few numbers change the answer beyond the tolerance when halved or doubled."""
        scene, query = candidate.study.scene, candidate.question.query
        given = [given for given in givens(scene, candidate.question.left_open) if given.owner != "world"]
        aside = [effect.subject for effect in effects(candidate, part=True) if effect.is_accepted]
        own = {path for name in query.subjects for path in _cancelling(candidate.study.mechanism, name)}
        excused = [g for g in given if own & {*g.paths} or any(_belongs(g, name) for name in aside)]
        counted = candidate.kind.measured(query).whole  # which changes with some of the numbers only
        total = len(given) + question_number_count(candidate)
        moving, idle, unmarked = list[Given](), list[Given](), list[Given]()
        for number, elasticity in ((each.given, each) for each in elasticities(candidate) if each.given in given):
            if matters(candidate, elasticity):
                moving.append(number)
                continue
            idle.append(number)
            if len(idle) > MAX_IDLE_SHARE * total:
                return f"idle numbers: {_paths(idle)}"
            if number not in excused and not _is_indifferent(candidate, number):
                unmarked.append(number)
            if not counted and len(unmarked) > MAX_IDLE_FRACTION[candidate.difficulty] * len(given):
                return f"idle numbers: {_paths(unmarked)}"
        if counted:
            return "" if len(moving) >= MIN_COUNT_NUMBERS else f"reach: the count changes with {len(moving)} numbers"
        short = shortfall(candidate, moving)
        return f"reach: {short}" if short else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: the sensitivity of the answer to each stated number."""
        for elasticity in elasticities(candidate):
            paths = ", ".join(elasticity.given.paths)
            moved = "matters" if matters(candidate, elasticity) else "does not matter"
            yield f"{paths}: |d ln answer / d ln number| = {elasticity.size:.3g}; it {moved}"


def _paths(numbers: list[Given]) -> str:
    return ", ".join(path for given in numbers for path in given.paths)


def _is_indifferent(candidate: Candidate, given: Given) -> bool:
    """Return whether a change of a number cannot change answers of this kind, such as of the amplitude for a period."""
    other = simulate_shifted(candidate.study, given, candidate.until)
    return other is not None and candidate.kind.indifferent(candidate.question.query, candidate.study, other)


def _cancelling(mechanism: Mechanism, subject: str) -> set[str]:
    """Return the addresses of numbers that may cancel: the subject's mass and charge, and its radius if it rolls."""
    body = _rigid_mass(mechanism, subject)
    rolls = body in mechanism.contacts and len(mechanism.contacts[body].slip) > 1
    return {f"{body}.mass", f"{body}.charge", *([f"{body}.radius"] if rolls else [])}


def _rigid_mass(mechanism: Mechanism, subject: str) -> str:
    """Return the only body with mass that moves rigidly with the subject, such as a pendulum bob; else the subject."""
    frame = _carrier(mechanism, subject)
    names = [body.name for body in mechanism.bodies if body.mass and _carrier(mechanism, body.name) == frame]
    return names[0] if frame and len(names) == 1 else subject


def _carrier(mechanism: Mechanism, name: str | None) -> str:
    """Return the moving body that a body is, or is fixed to; empty if it is not a body or does not move."""
    body = mechanism.body.get(name or "")
    if body is None:
        return ""
    return body.name if body.coordinates else _carrier(mechanism, body.parent)


def _belongs(given: Given, name: str) -> bool:
    """Return whether a number belongs to the part of that name."""
    return any(path.startswith(f"{name}.") for path in given.paths)


FILTERS.add("sensitivity", Sensitivity())
