"""The conversion of a structured question into a query, by the first kind of question that accepts the parts."""

from dataclasses import dataclass, replace

from sim2reason.errors import TextError
from sim2reason.quantities import QUANTITIES
from sim2reason.questions.following import Followed, FollowedMotion, follow
from sim2reason.questions.inversion import values_giving, why_not_one
from sim2reason.questions.kinds import KINDS
from sim2reason.questions.kinds.comparison import compared
from sim2reason.questions.kinds.limit import MASS, LimitQuery
from sim2reason.questions.kinds.optimum import OptimumQuery
from sim2reason.questions.kinds.parts.nested import stripped
from sim2reason.questions.moments.parts.reached import stated
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.query import Query
from sim2reason.questions.structured import StructuredQuestion, measured, one_of, resolved
from sim2reason.questions.study import Study
from sim2reason.questions.targets import targets
from sim2reason.questions.unknown import Unknown
from sim2reason.questions.words import Words

EXTREMES = "greatest", "least"
LIMITS = {"infinity": True, "∞": True, "0": False, "zero": False}
"""Of a mass, in a change: whether it grows without bound, or vanishes."""
PLUS = " + "
MINUS = " minus "  # between two moments, for the value at the first one less the value at the second one
AXLE = "moment of inertia about the axle"
SUMMED = ("kinetic energy", "translational kinetic energy", "rotational kinetic energy", "spring energy", "mass", AXLE)
"""Quantities whose values of several subjects add up to that of all."""
SYMBOL = "x"  # of a number that is looked for and has no other symbol


@dataclass(frozen=True)
class PosedQuestion:
    """A query; if the question asks for a number of the scene, also that number and the query's required answer.

    If the question asks for a sum over several subjects, `others` has the queries for all but the first. If it asks for
    a difference between two moments, `less` is the question for the second one.
    """

    query: Query
    unknown: Unknown | None = None
    given: float = 0.0
    others: tuple[Query, ...] = ()
    less: "PosedQuestion | None" = None

    def unit(self, words: Words) -> str:
        """Return the unit of the answer."""
        return (
            self.unknown.unit if self.unknown else words.units.spell(KINDS[self.query.kind].measured(self.query).unit)
        )

    def given_unit(self, words: Words) -> str:
        """Return the unit of the given result."""
        return words.units.spell(KINDS[self.query.kind].measured(self.query).unit)

    def followed(self, motion: FollowedMotion) -> Followed:
        """Return the answer with the motion that leads to the answer, or the reason why there is none."""
        if self.less is not None:
            return _difference(replace(self, less=None).followed(motion), self.less.followed(motion))
        if self.unknown is None:
            found = [follow(query, motion) for query in (self.query, *self.others)]
            missing = next((each for each in found if each.answer is None), None)
            return missing or found[0]._replace(answer=sum(each.answer or 0.0 for each in found))
        values = values_giving(self.query, self.given, self.unknown, motion.study)
        reason = why_not_one(self.unknown, values, motion.study.scene)
        return Followed(motion.study, None if reason else values[0], reason)

    def sentence(self, words: Words) -> str:
        """Return the question as a sentence in the library's words; empty if the library has no such sentence."""
        target = self.query.target
        noun = targets(words).get(target) if target is not None else None
        if self.unknown is not None or self.others or self.less or (target is not None and noun is None):
            return ""
        shapes = KINDS[self.query.kind].shapes(self.query, words, noun)
        return sentence(shapes[0]) if shapes else ""


def findable(words: Words) -> tuple[str, ...]:
    """Return the names of everything that can be found in a scene: quantities, functionals, times and numbers."""
    named = (name for kind in KINDS.values() for name in kind.finds(words))
    return tuple(dict.fromkeys((*named, *(unknown.path for unknown in words.unknowns))))


def posed(asked: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the query for a structured question about a scene; TextError for a part that has no meaning there."""
    if asked.given:
        return _reversed(asked, motion, words)
    find = one_of("find", asked.find, findable(words))
    if MINUS in asked.when:
        return _between(asked, motion, words)
    if PLUS in asked.of:
        return _summed(asked, motion, words)
    if asked.change:
        inner = posed(replace(asked, change=""), motion, words).query
        return PosedQuestion(_changed(inner, asked, motion.study, words))
    kinds = (kind for kind in KINDS.values() if find in kind.finds(words))
    query = next((query for kind in kinds if (query := kind.posed(asked, motion.study, words)) is not None), None)
    if query is None:
        remedy = "name a moment, see: sim2reason list moments; of a number of the scene, say what it makes so, by given"
        raise TextError("when", f"{asked.find} is not found {asked.when or 'without a moment'}", remedy)
    return PosedQuestion(query)


def _between(asked: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the question for a difference between two moments, such as *second bounced minus bounced*."""
    if asked.change:
        raise TextError("when", "a difference between two moments is not compared", "ask for each of the two moments")
    first, second = (posed(replace(asked, when=when), motion, words) for when in asked.when.rsplit(MINUS, 1))
    target = first.query.target
    if target is not None and target.sense is None and QUANTITIES[target.quantity].vector and asked.find != "speed":
        raise TextError("along", f"{asked.find} may change its direction", "name a direction, by along")
    return replace(first, less=second)


def _difference(first: Followed, second: Followed) -> Followed:
    """Return the difference of two answers; the one that is missing, if one is."""
    if first.answer is None or second.answer is None:
        return first if first.answer is None else second
    return first._replace(answer=first.answer - second.answer)


def _summed(asked: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the queries for a sum over several subjects, such as *block A + block B*."""
    if asked.find not in SUMMED or asked.change:
        raise TextError("of", f"{asked.find} of several does not add up", f"ask for one, or for: {', '.join(SUMMED)}")
    first, *others = (posed(replace(asked, of=of.strip()), motion, words).query for of in asked.of.split(PLUS))
    return PosedQuestion(first, others=tuple(others))


def _reversed(asked: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the query for the value of a number of the scene that leads to a given result or an extreme value."""
    scene = motion.study.scene
    paths = {parameter.path: words.symbols.get(parameter.path, SYMBOL) for parameter in scene.parameters}
    offered = {unknown.path: unknown for unknown in Words.of(scene, words.mentions, paths).unknowns}
    unknown = offered[one_of("find", asked.find, offered)]
    result, _, value = (part.strip() for part in asked.given.partition("="))
    if value in EXTREMES:
        inner = posed(replace(asked, find=result, given=""), motion, words).query
        return PosedQuestion(_optimum(inner, unknown.path, motion.study, greatest=value == EXTREMES[0]))
    if result == "time":
        query = posed(replace(asked, find="time", given=""), motion, words).query
        return PosedQuestion(query, unknown, measured("given", value, words.units.time))
    target, wanted = stated(asked, asked.given, words, "given")
    along = target.sense.positive if target.sense is not None else ""
    inner = replace(asked, find=target.quantity, of=target.subject, along=along, given="")
    return PosedQuestion(posed(inner, motion, words).query, unknown, wanted)


def _changed(inner: Query, asked: StructuredQuestion, study: Study, words: Words) -> Query:
    """Return the query for an answer's change with a number, limit for a large or small mass, or extreme value."""
    number, _, value = (part.strip() for part in asked.change.partition("="))
    if value in (*LIMITS, *EXTREMES):
        held = {p.path: p for p in study.scene.parameters if p.value}
        path = resolved("change", number, {path: words.named.get(path, path) for path in held})
        if value in EXTREMES:
            return _optimum(inner, path, study, greatest=value == EXTREMES[0], asks_place=False)
        if held[path].measure.unit == MASS:
            return LimitQuery("limit", inner.target, inner.moment, stripped(inner), path, large=LIMITS[value])
    return compared(inner, asked, study, words)


def _optimum(inner: Query, path: str, study: Study, *, greatest: bool, asks_place: bool = True) -> OptimumQuery:
    unit = next(p.measure.unit for p in study.scene.parameters if p.path == path)
    return OptimumQuery("optimum", inner.target, inner.moment, stripped(inner), path, unit, greatest, asks_place)
