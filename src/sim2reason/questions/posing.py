"""Conversion of a structured question into a query, by the first kind of question that accepts the parts."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial

from sim2reason.errors import SceneError, SimulationError, TextError, UnsupportedError
from sim2reason.questions.following import FollowedMotion, SimulatedAnswer, simulate_scene, simulate_until_answer
from sim2reason.questions.inversion import is_one_of_a_range, values_giving, why_not_one
from sim2reason.questions.kinds import KINDS
from sim2reason.questions.kinds.comparison import build_comparison
from sim2reason.questions.kinds.limit import MASS, LimitQuery
from sim2reason.questions.kinds.nested import without_target_and_moment
from sim2reason.questions.kinds.optimum import OptimumQuery
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.moments.reached import stated
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.query import Query, quantities_named, targets
from sim2reason.questions.structured import StructuredQuestion, one_of, parse_amount, resolve_name
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.unknown import Unknown, derived_numbers, number_at
from sim2reason.questions.variation import SceneChange, is_removal, variation, words_in
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.quantities import QUANTITIES

EXTREMES = GREATEST, LEAST = "greatest", "least"
LIMIT_KEYWORDS = {"infinity": True, "∞": True, "0": False, "zero": False}
"""Of a mass, in a change: whether it grows without bound, or vanishes."""
PLUS = " + "
MINUS = " minus "  # between two moments, for the value at the first one less the value at the second one
FRICTION_HEAT = "energy dissipated by friction"
AXLE = "moment of inertia about the axle"
KINETIC = "kinetic energy", "translational kinetic energy", "rotational kinetic energy"
ADDITIVE_QUANTITIES = (*KINETIC, "spring energy", "mass", AXLE, FRICTION_HEAT)
"""What can be found whose values of several subjects add up to that of all."""
RATIO, DIFFERENCE, VALUE = COMPARED = "ratio", "difference", "value"
"""Forms of a changed answer, or of a number that is found: compared with the one in the scene, or the value itself."""
SYMBOL = "x"  # of a number that is looked for and has no other symbol


@dataclass(frozen=True)
class PosedQuestion:
    """A query; if the question asks for a number of the scene, also that number and the query's required answer.

    If the question asks for a sum over several subjects, `others` has the queries for all but the first. If it asks
    for a difference between two moments, `less` is the question for the second one. With an `end`, *least* or
    *greatest*, the answer is the least or the greatest of several values. With a `varied` scene, the answer is the one
    in that scene. With `compare`, *ratio* or *difference*, the answer is compared with that in the scene as it is, or
    with the number that the scene has.
    """

    query: Query
    unknown: Unknown | None = None
    given: float = 0.0
    others: tuple[Query, ...] = ()
    less: "PosedQuestion | None" = None
    end: str = ""
    varied: SceneChange | None = None
    compare: str = VALUE

    def unit(self, words: Words) -> str:
        """Return the unit of the answer."""
        if self.compare == RATIO:
            return ""
        return self.unknown.unit if self.unknown else self.given_unit(words)

    def given_unit(self, words: Words) -> str:
        """Return the unit of the given result."""
        return words.units.spell(KINDS[self.query.kind].measured(self.query).unit)

    def simulate_answer(self, motion: FollowedMotion) -> SimulatedAnswer:
        """Return the answer with the motion that leads to it, or the reason why there is none."""
        if self.compare != VALUE or self.varied is not None:
            return self._compared(motion)
        if self.less is not None:
            return _difference(replace(self, less=None).simulate_answer(motion), self.less.simulate_answer(motion))
        if self.unknown is None:
            answers = [simulate_until_answer(query, motion) for query in (self.query, *self.others)]
            missing = next((each for each in answers if each.answer is None), None)
            return missing or answers[0]._replace(answer=sum(each.answer or 0.0 for each in answers))
        values = sorted(values_giving(self.query, self.given, self.unknown, motion.study))
        if self.end and values:
            values = [values[0 if self.end == LEAST else -1]]
        reason = why_not_one(self.unknown, values, motion.study.scene)
        if not reason and is_one_of_a_range(values[0], self.query, self.given, self.unknown, motion.study):
            reason = f"a whole range of values of {self.unknown.symbol} does"
        return SimulatedAnswer(motion.study, None if reason else values[0], reason)

    def _compared(self, motion: FollowedMotion) -> SimulatedAnswer:
        """Return the answer in the varied scene, compared with the answer or the number in the scene as it is."""
        plain, scene = replace(self, varied=None, compare=VALUE), motion.study.scene
        try:
            there = motion if self.varied is None else simulate_scene(self.varied.applied(scene))
        except (SceneError, SimulationError, UnsupportedError, ValueError) as error:
            return SimulatedAnswer(motion.study, None, f"with the change there is no such motion: {error}")
        after = plain.simulate_answer(there)
        if self.compare == VALUE or after.answer is None:
            return after
        path = self._number
        before = plain.simulate_answer(motion).answer if not path else number_at(scene, path)
        if before is None or (self.compare == RATIO and not before):
            return SimulatedAnswer(motion.study, None, "in the scene as it is there is nothing to compare it with")
        return after._replace(answer=after.answer / before if self.compare == RATIO else after.answer - before)

    @property
    def _number(self) -> str:
        """Return the address of the number that the question asks for; empty if it asks for another quantity."""
        if self.unknown is not None:
            return self.unknown.path
        return self.query.parameter if isinstance(self.query, ThresholdQuery) else ""

    def sentence(self, words: Words) -> str:
        """Return the question as a sentence; empty if the library has no sentence for a question of this form."""
        target = self.query.target
        noun = targets(words).get(target) if target is not None else None
        if self.compare != VALUE or self.varied is not None:
            return ""
        if self.unknown is not None or self.others or self.less or (target is not None and noun is None):
            return ""
        shapes = KINDS[self.query.kind].shapes(self.query, words, noun)
        return sentence(shapes[0]) if shapes else ""


def findable_names(words: Words) -> tuple[str, ...]:
    """Return the names of everything that can be found in a scene: quantities, functionals, times and numbers."""
    named = (name for kind in KINDS.values() for name in kind.finds(words))
    return tuple(dict.fromkeys((*named, *(unknown.path for unknown in words.unknowns))))


def pose_question(question: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the query for a structured question about a scene; TextError for a part that has no meaning there."""
    if question.given:
        return replace(_reversed(question, motion, words), compare=answer_form(question, VALUE))
    find = one_of("find", question.find, findable_names(words))
    if MINUS in question.when:
        return _between(question, motion, words)
    if PLUS in question.of and not question.change:
        return _summed(question, motion, words)
    if question.change:
        return _changed(question, motion, words)
    kinds = sorted((kind for kind in KINDS.values() if find in kind.finds(words)), key=lambda kind: not kind.names_one)
    query = next((query for kind in kinds if (query := kind.posed(question, motion.study, words)) is not None), None)
    if query is None:
        remedy = "name a moment, see: sim2reason list moments; of a number of the scene, say what it makes so, by given"
        raise TextError("when", f"{question.find} is not found {question.when or 'without a moment'}", remedy)
    return PosedQuestion(query, compare=answer_form(question, VALUE) if question.find in numbers(words) else VALUE)


def numbers(words: Words) -> frozenset[str]:
    """Return the addresses of the numbers of a scene that can be found."""
    return frozenset(unknown.path for unknown in words.unknowns)


def answer_form(question: StructuredQuestion, usual: str) -> str:
    """Return the form of an answer: *ratio*, *difference* or *value*, or else the usual one; TextError for others."""
    return one_of("compare", question.compare or usual, COMPARED)


def _between(question: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the question for a difference between two moments, such as *second bounced minus bounced*."""
    if question.change:
        raise TextError("when", "a difference between two moments is not compared", "ask for each of the two moments")
    first, second = (
        pose_question(replace(question, when=when), motion, words) for when in question.when.rsplit(MINUS, 1)
    )
    target = first.query.target
    if target is not None and target.sense is None and QUANTITIES[target.quantity].vector and question.find != "speed":
        raise TextError("along", f"{question.find} may change its direction", "name a direction, by along")
    return replace(first, less=second)


def _difference(first: SimulatedAnswer, second: SimulatedAnswer) -> SimulatedAnswer:
    """Return the difference of two answers, or the missing one if either is missing."""
    if first.answer is None or second.answer is None:
        return first if first.answer is None else second
    return first._replace(answer=first.answer - second.answer)


def _summed(question: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the question for a sum over several subjects, such as *block A + block B*, with one query per subject."""
    if question.find not in ADDITIVE_QUANTITIES or question.change:
        raise TextError(
            "of",
            f"{question.find} of several does not add up",
            f"ask for one, or for: {', '.join(ADDITIVE_QUANTITIES)}",
        )
    first, *others = (
        pose_question(replace(question, of=of.strip()), motion, words).query for of in question.of.split(PLUS)
    )
    return PosedQuestion(first, others=tuple(others))


def _reversed(question: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the query for the value of a number of the scene that leads to a given result or an extreme value."""
    scene = motion.study.scene
    offered = numbers_offered(scene, words)
    unknown = offered[one_of("find", question.find, offered)]
    result, _, value = (part.strip() for part in question.given.partition("="))
    if value in EXTREMES:
        inner = pose_question(replace(question, find=result, given="", compare=""), motion, words).query
        return PosedQuestion(_optimum(inner, unknown.path, motion.study, greatest=value == GREATEST))
    value, _, end = value.partition(", ")
    end = one_of("given", end, EXTREMES) if end else ""
    if not value or result in quantities_named(words.mechanism) or " of " in result or " along " in result:
        target, wanted = stated(question, f"{result} = {value}" if value else question.given, words, "given")
        along = target.sense.positive if target.sense is not None else ""
        inner = replace(question, find=target.quantity, of=target.subject, along=along, given="", compare="")
        return PosedQuestion(pose_question(inner, motion, words).query, unknown, wanted, end=end)
    query = pose_question(replace(question, find=result, given="", compare=""), motion, words).query
    unit = words.units.spell(KINDS[query.kind].measured(query).unit)
    return PosedQuestion(query, unknown, parse_amount("given", value, unit), end=end)


def numbers_offered(scene: Scene, words: Words) -> Mapping[str, Unknown]:
    """Return all numbers of a scene that a question may ask for, derived ones included, by address."""
    paths = {parameter.path: words.symbols.get(parameter.path, SYMBOL) for parameter in scene.parameters}
    offered = {unknown.path: unknown for unknown in Words.of(scene, words.mentions, paths).unknowns}
    for path, number in derived_numbers(scene).items():
        offered[path] = Unknown(path, "speed", number.unit, f"${SYMBOL}$", (f"${SYMBOL}$",))
    return offered


def _changed(question: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the question for an answer's change with a number, its limit for an extreme mass, or its extreme value."""
    study = motion.study
    if is_removal(question.change):
        return _after_removal(question, motion, words)
    inner = pose_question(replace(question, change="", compare=""), motion, words)
    compare = answer_form(question, RATIO)
    number, _, value = (part.strip() for part in question.change.partition("="))
    if value in (*LIMIT_KEYWORDS, *EXTREMES):
        parameters = {p.path: p for p in study.scene.parameters if p.value}
        path = resolve_name("change", number, {path: words.named.get(path, path) for path in parameters})
        if value in EXTREMES:
            return PosedQuestion(_optimum(inner.query, path, study, greatest=value == GREATEST, asks_place=False))
        if parameters[path].measure.unit == MASS:
            query, large = inner.query, LIMIT_KEYWORDS[value]
            return PosedQuestion(
                LimitQuery("limit", query.target, query.moment, without_target_and_moment(query), path, large=large)
            )
    varied = variation(question.change, study.scene, words, partial(_time_of, motion=motion, words=words))
    if compare == VALUE or inner.others or inner.less or not _is_plain_change(varied, study.scene):
        return replace(inner, varied=varied, compare=compare)
    return PosedQuestion(build_comparison(inner.query, question, study, words))


def _after_removal(question: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the question about the motion after an object is removed; TextError if the answer is to be compared."""
    if answer_form(question, VALUE) != VALUE:
        raise TextError("compare", "what follows a removal is not compared with what goes before", "take the value")
    scene = motion.study.scene
    varied = variation(question.change, scene, words, partial(_time_of, motion=motion, words=words))
    try:
        there = simulate_scene(varied.applied(scene))
    except (SceneError, SimulationError, UnsupportedError, ValueError) as error:
        raise TextError("change", f"nothing follows: {error}", "remove it at another moment") from None
    inner = pose_question(replace(question, change="", compare=""), there, words_in(there.study.scene, words))
    return replace(inner, varied=varied)


def _time_of(when: str, change: SceneChange, *, motion: FollowedMotion, words: Words) -> float:
    """Return the time of a moment, in seconds or the scene's unit of time, in a changed scene."""
    there = simulate_scene(change.applied(motion.study.scene)) if change.values or change.fixed else motion
    simulated = pose_question(StructuredQuestion("time", when=when), there, words).simulate_answer(there)
    if simulated.answer is None:
        raise TextError("change", f"{when!r} never comes: {simulated.reason}", "name a moment of the motion")
    return simulated.answer


def _is_plain_change(varied: SceneChange, scene: Scene) -> bool:
    """Return whether a variation multiplies a single declared number by a factor other than zero."""
    path, value = varied.values[0] if varied.values else ("", 0.0)
    alone = len(varied.values) == 1 and not varied.fixed and path not in derived_numbers(scene)
    return alone and bool(value) and bool(number_at(scene, path))


def _optimum(
    inner: Query, path: str, study: SimulatedScene, *, greatest: bool, asks_place: bool = True
) -> OptimumQuery:
    unit = next(p.measure.unit for p in study.scene.parameters if p.path == path)
    return OptimumQuery(
        "optimum", inner.target, inner.moment, without_target_and_moment(inner), path, unit, greatest, asks_place
    )
