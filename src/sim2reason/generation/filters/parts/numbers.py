"""How an answer changes with the stated numbers, and how many of them it needs."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from sim2reason.generation.filters import Candidate
from sim2reason.questions import Study
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.solutions.algebra.expressions import Symbol

SHIFT = 1e-3  # relative
TURN = 10.0  # deg: how far an angle is moved either way, where other numbers are halved and doubled
SLOWER = 2.2  # times: a motion with a number halved or doubled may take so much longer
ENOUGH = 3.0  # times the tolerance: a number with such an elasticity moves the answer beyond it when it is doubled
VECTORS = "position", "velocity"  # measures whose numbers, where one thing has two, are components of one vector


@dataclass(frozen=True, slots=True)
class Given:
    """A stated number, or a vector stated by its components, at one or more addresses."""

    parameters: tuple[Parameter, ...]

    @property
    def paths(self) -> tuple[str, ...]:
        """Return where the numbers stand."""
        return tuple(parameter.path for parameter in self.parameters)

    @property
    def unit(self) -> str:
        """Of all of them."""
        return self.parameters[0].measure.unit

    @property
    def owner(self) -> str:
        """The address of what they belong to."""
        return self.paths[0].rpartition(".")[0]

    def at(self, scene: Scene, factors: tuple[float, float], turn: float = 0.0) -> dict[str, float]:
        """Their values with components times two factors in turn, or angles turned by some degrees."""
        values = [float(scene.value(path)) for path in self.paths]
        if self.unit == "deg" and turn:
            return {path: value + turn for path, value in zip(self.paths, values, strict=True)}
        return {path: factors[n % 2] * value for n, (path, value) in enumerate(zip(self.paths, values, strict=True))}


@dataclass(frozen=True, slots=True)
class Elasticity:
    """What a small relative shift of what is given does to an answer."""

    given: Given
    size: float  # |d ln answer/d ln number|
    reordered: bool  # whether the shift changes what happens on the way, or the answer is gone


def givens(scene: Scene, left_open: Collection[str] = ()) -> list[Given]:
    """Return what the text says in numbers; zeros, what a word tells and what it has `left_open` are not among it."""
    found: dict[tuple[str, str], list[Parameter]] = {}
    for parameter in scene.parameters:
        if parameter.path not in left_open and _is_said(scene, parameter):
            name = parameter.measure.name
            owner = parameter.path.rpartition(".")[0]
            found.setdefault((owner, name) if name in VECTORS else (parameter.path, ""), []).append(parameter)
    return [Given(tuple(parameters)) for parameters in found.values()]


def _is_said(scene: Scene, parameter: Parameter) -> bool:
    if parameter.hidden or not parameter.value:
        return False
    owner, _, name = parameter.path.rpartition(".")
    body = scene.bodies.get(owner)
    return not (body is not None and body.told_by_word(name))


def elasticities(candidate: Candidate) -> Iterator[Elasticity]:
    """Yield that of the answer to all that is given, each shifted by one part in a thousand.

    Numbers that the worked solution does not use come first: one that has no bearing is found without the others.
    """
    study = candidate.study
    before = study.trace.story(candidate.time)
    used = _used(candidate)
    for given in sorted(givens(study.scene, candidate.question.left_open), key=lambda g: not used.isdisjoint(g.paths)):
        other = shifted(study, given, candidate.until)
        answer = candidate.response(other)
        if other is None or answer is None:
            yield Elasticity(given, 0.0, reordered=True)
            continue
        time = candidate.kind.time(candidate.question.query, other)
        size = candidate.change_to(answer) / SHIFT
        yield Elasticity(given, size, reordered=other.trace.story(time) != before)


def _used(candidate: Candidate) -> set[str]:
    """Return the addresses of all numbers that the worked solution takes from the text; none without a solution."""
    if candidate.words is None or candidate.solution is None:
        return set()
    relations = (relation for step in candidate.solution.steps for relation in step.relations)
    said = {relation.left for relation in relations if relation.role == "given"}
    return {path for path, symbol in candidate.words.symbols.items() if Symbol(symbol) in said}


def matters(candidate: Candidate, found: Elasticity) -> bool:
    """Whether the answer moves beyond the tolerance when a number is halved or doubled (an angle turned either way).

    Where the motion then is slower, it is followed for longer; where it was not followed for long enough to tell, that
    tells nothing.
    """
    if found.reordered or found.size >= ENOUGH * candidate.tolerance:
        return True
    study, given, time = candidate.study, found.given, candidate.time or 0.0
    until = None if candidate.time is None else SLOWER * time
    for factor, turn in ((2.0, TURN), (0.5, -TURN)):
        other = study.with_values(given.at(study.scene, (factor, factor), turn), until)
        answer = candidate.response(other)
        if answer is None and (other is None or other.trace.stable_until < SLOWER * time):
            continue
        if candidate.change_to(answer) > candidate.tolerance:
            return True
    return False


def shifted(study: Study, given: Given, until: float | None) -> Study | None:
    """Return the motion with a number shifted, or None if there is none; the other way if this one is not valid.

    The components of a vector are shifted to opposite sides, so that it turns.
    """
    for factors in ((1.0 + SHIFT, 1.0 - SHIFT), (1.0 - SHIFT, 1.0 + SHIFT)):
        other = study.with_values(given.at(study.scene, factors), until)
        if other is not None:
            return other
    return None


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
    """Return how many numbers the question itself has: those that it states, and one that it leaves unknown."""
    moment = candidate.question.query.moment
    return len(moment.stated if moment is not None else ()) + bool(candidate.question.unknown)


def shortfall(candidate: Candidate, moving: Sequence[Given]) -> str:
    """Return what those that move the answer fall short of, in a few words; empty if they are enough.

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
