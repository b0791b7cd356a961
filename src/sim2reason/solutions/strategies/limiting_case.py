"""Limiting case: the onset of slipping or rising, with friction at its greatest and zero acceleration."""

from dataclasses import replace

from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.outcomes.sliding import Slides
from sim2reason.questions.outcomes.strings import Rises
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.engines.exact.engine import motion
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import ZERO
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.laws.limiting_balance import LimitingBalance, LimitingDynamics
from sim2reason.solutions.laws.written_dynamics import WrittenDynamics
from sim2reason.solutions.reverse import Inversion
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy, varying_acceleration
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError
from sim2reason.solutions.writing.unit_latex import ACCELERATION

THRESHOLD_OFFSET = 1e-5  # relative distance from the threshold at which the motion is simulated
INSTANT = 1e-6  # s, duration of that simulation
THRESHOLD_RTOL = 1e-3  # relative tolerance between the thresholds of the laws and of the engine


@strategy
class LimitingCase(Strategy):
    """The strategy for the threshold value at which a body begins to slip on its face or to rise."""

    name = "limiting case"
    cost = 1.0
    kinds = frozenset({"threshold"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that no body released at rest could slip or be lifted; empty if a body could."""
        lifted = mechanism.lines or mechanism.forces
        if any(c.speed for c in mechanism.coordinates) or not (lifted or any(f.friction for f in mechanism.faces)):
            return "nothing is let go that could stay at rest"
        return varying_acceleration(mechanism)

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query = setting.query
        if not isinstance(query, ThresholdQuery) or not isinstance(query.outcome, Slides | Rises):
            return "the outcome does not show at once"
        return "" if setting.sought is not None else "there is no such value"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write Newton's laws for impending motion with zero acceleration; return the symbol of the threshold."""
        path, sought = setting.unknown, book.sought
        query = setting.query
        assert isinstance(query, ThresholdQuery)
        draft = book.copy()
        try:
            self._balanced(setting, query, draft)
            write = self._balanced
        except UnsolvedError:
            draft = book.copy()
            self._accelerated(setting, query, draft)
            write = self._accelerated
        if abs(draft.values[sought] - book.values[sought]) > THRESHOLD_RTOL * abs(book.values[sought]):
            raise UnsolvedError("in the limiting case the unknown has another value")
        value = draft.values[sought] / setting.lexicon.givens[path].scale
        book.values[sought] = draft.values[sought]  # the engine has it as well as it sees what moves
        return write(replace(setting, scene=setting.scene.having(path, value)), query, book)

    def _balanced(self, setting: ProblemContext, query: ThresholdQuery, book: SolutionBuilder) -> str:
        """Write Newton's laws without the acceleration that is zero at the threshold; return the threshold's symbol."""
        assert query.outcome is not None
        balance = LimitingBalance(setting, book, _moving(setting, query), query.outcome.name)
        return balance.write(slides=isinstance(query.outcome, Slides))

    def _accelerated(self, setting: ProblemContext, query: ThresholdQuery, book: SolutionBuilder) -> str:
        """Write the acceleration of a body that just moves, and that it is zero at the threshold; return its symbol."""
        assert query.outcome is not None
        dynamics, name = LimitingDynamics(setting, book, _moving(setting, query)), query.outcome.name
        goals = _rate(dynamics, name, slides=isinstance(query.outcome, Slides))
        dynamics.reach([f"q{k}" for k in goals])
        rate = total(dynamics.names[f"q{k}"] * part for k, part in goals.items())
        who = setting.display_name(name)
        step = book.begin_step("limit")
        what = "slip: friction has its greatest value" if isinstance(query.outcome, Slides) else "move up"
        step.add_text(f"In the limiting case {who} is just about to {what}, and its acceleration is still zero:")
        symbol = rate.symbol
        if symbol is None:
            symbol = book.fresh("a", r"\text{rel}")
            step.add_text(f"{step.result(symbol, rate.expression(), ACCELERATION, law=True)}, and")
        step.add_text(f"{step.law(symbol, ZERO)}.")
        step.close()
        return Inversion(book, symbol.name, 0.0, book.sought).write()


def _moving(setting: ProblemContext, query: ThresholdQuery) -> Segment:
    """Return the initial segment of the motion for a parameter just beyond the threshold, where the body moves."""
    trial, limit = query.trial(setting.study), float(setting.scene.value(query.parameter))
    for side in (1.0 + THRESHOLD_OFFSET, 1.0 - THRESHOLD_OFFSET):
        if trial(limit * side):
            scene = setting.scene.having(query.parameter, limit * side)
            return motion(scene.mechanism, INSTANT).segments[0]
    raise UnsolvedError("it comes about on neither side of the limit")


def _rate(dynamics: WrittenDynamics, name: str, *, slides: bool) -> dict[int, Polynomial]:
    """Return weights, by coordinate, of the accelerations that add up to that of a slip or of a body on its line."""
    if slides:
        face = next(n for n, held in enumerate(dynamics.mechanism.faces) if held.subject == name)
        found = dynamics.newton.slip(face)
        for k in list(found):
            if k in dynamics.carried:
                j, sign = dynamics.carried[k]
                found[j] = found.get(j, Polynomial({})) - found[k].scaled(sign)
        return found
    own = dynamics.sufficient_coordinates(dynamics.newton.moving_coordinates(name))
    if len(own) != 1:
        raise UnsolvedError("it moves along no line of its own")
    return {own[0]: Polynomial.of(1.0)}
