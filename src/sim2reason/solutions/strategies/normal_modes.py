"""Normal modes: several bodies on springs along lines, as sums of independent oscillations."""

from collections.abc import Callable, Sequence

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.difficulty import Need
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.strings import MostCompressed, MostStretched, NaturalLength
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.quantities.subjects.interactions import members
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.algebra.root_finding import root_sentence, roots_sentence
from sim2reason.solutions.goals import MotionPart
from sim2reason.solutions.oscillations.harmonic import measured_period
from sim2reason.solutions.oscillations.linear_motion import min_free_coordinates
from sim2reason.solutions.oscillations.linear_way import LinearMotionModel
from sim2reason.solutions.oscillations.mode_laws import Mode, acceleration, jerk, normalized_single_mode, place, speed
from sim2reason.solutions.oscillations.net_force import time_of_greatest
from sim2reason.solutions.oscillations.normal_modes import Form, NormalModes, natural_frequency
from sim2reason.solutions.oscillations.to_and_fro import BackAndForthTravel, turning_times
from sim2reason.solutions.setting import ProblemContext, capitalized, join_words
from sim2reason.solutions.strategies import STRATEGIES, Strategy, strategy
from sim2reason.solutions.strategies.oscillation import TWO_COORDINATES, no_oscillation_reason
from sim2reason.solutions.writing.notation import ACCELERATION, METRES, SECONDS, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

Law = Callable[[list[Mode], int, Symbol], Expression]
LAWS: tuple[Law, ...] = place, speed, acceleration, jerk  # each is the derivative of the one before
DERIVATIVE_LEADS = "the sum over the modes,", "differentiating,", "differentiating twice,"
ORDERS = {"s": 0, "v": 1, "a": 2}  # order of the time derivative that a goal uses


@strategy
class SeveralModes(Strategy):
    """The strategy for several free coordinates on springs."""

    name = "normal modes"
    cost = 1.5
    kinds = frozenset({"state", "event", "time_to_event", "extremum", "period", "sum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        return no_oscillation_reason(mechanism)

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: ``period`` for at most two modes, else none."""
        return frozenset({"period"} if min_free_coordinates(mechanism) <= TWO_COORDINATES else ())

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that an oscillation strategy does not apply to a question; else empty."""
        return STRATEGIES["oscillation"].why_not_applicable(setting)

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the modes, their excitation, the moment and the answer, and return the answer's symbol."""
        return _Modal(setting, book).write().name


class _Modal(LinearMotionModel):
    """A motion model with displacements as sums over modes."""

    @cached_property
    def _all(self) -> NormalModes:
        motion = self.linear
        if not motion.free:
            raise UnsolvedError("nothing moves")
        if motion.damped or any(motion.laws.slip_directions.values()):
            raise UnsolvedError("it is damped")
        marks = {i: self.setting.subscript_of(self.mechanism.coordinates[i].body) for i in motion.free}
        self.names = {i: self.book.fresh("x", mark) for i, mark in marks.items()}
        small = isinstance(self.query, PeriodQuery)
        self.introduce(self.names, " from equilibrium" if small else "")
        first = [NIL if small else self.initial_rate(i) for i in motion.free]
        return NormalModes(self.book, motion, first, [*self.names.values()], loaded=not small)

    @cached_property
    def _modes(self) -> list[Mode]:
        return self._all.excited(self._forms)

    @cached_property
    def _forms(self) -> list[Form]:
        """Return the weighted sums of displacements or their derivatives on which the moment and the answer depend."""
        forms = self._sought
        if self.target is not None and self.goal is not None:
            lines = self.goal.lines(self.target)
            own = [self._grows(lines[0])] if lines else [{k: 1.0} for k in (*self.asked_coordinates(), *self.gaining)]
            forms += [(self._order, parts) for parts in own]
        return self._as_forms(forms)

    @property
    def _sought(self) -> list[tuple[int, dict[int, float]]]:
        """Return the sum that is zero at the moment as [(derivative order, weights by coordinate)]; else []."""
        if isinstance(self.query.moment, AtTime) and not self.greatest:
            return []
        _, parts, law = self._condition
        return [(LAWS.index(law), parts)]

    def _as_forms(self, found: Sequence[tuple[int, dict[int, float]]]) -> list[Form]:
        ratio, free = self.motion.ratio, self.motion.free
        return [(np.array([sum(w * ratio(k, i) for k, w in of.items()) for i in free]), order) for order, of in found]

    @property
    def _order(self) -> int:
        """Return the order of the lowest time derivative of displacements on which the goal depends."""
        assert self.target is not None
        assert self.goal is not None
        order = ORDERS.get(self.goal.uses, 0)
        on_a_ring = any(self._ring(body) is not None for body in self.goal.bodies(self.target))
        return min(order, 1) if on_a_ring else order

    def write(self) -> Symbol:
        """Write the answer to the query and return the answer's symbol."""
        query = self.query
        if isinstance(query, PeriodQuery):
            return measured_period(self.book, query, natural_frequency(self._all, query))
        self._refuse_roots()
        _ = self._modes
        if self.target is None or self.goal is None:
            return self._time
        return self.goal.write(self.target, self)

    def _refuse_roots(self) -> None:
        """Raise UnsolvedError, before writing, if a numerical root is needed but not allowed."""
        if self.book.most >= Need.ROOT:
            return
        modes = self._all
        rates = [n for n in modes.contributing_modes(self._as_forms(self._sought)) if n >= modes.zeros]
        if modes.size - modes.zeros > TWO_COORDINATES or len(rates) > 1:
            raise UnsolvedError(f"it needs more: {Need.ROOT.label}")

    # ---- the moment

    @cached_property
    def _time(self) -> Symbol:
        """Write the time of the moment, s, given or as a root, and return its symbol."""
        moment, name = self.query.moment, self.book.fresh("t")
        if isinstance(moment, AtTime) and not self.greatest:
            self.book.state_given(name.name, moment.after, SECONDS)
            return name
        text, weights, law = self._condition
        modes = self._modes if self._goes_on != ZERO else normalized_single_mode(self._modes)
        value: Expression = ZERO
        for k, part in weights.items():
            for i, ratio in self.motion.ratios[k].items():
                value = value + Number(part * ratio) * law(modes, self.motion.free.index(i), name)
        if value == ZERO:
            raise UnsolvedError("nothing changes what the moment is about")
        if modes is not self._modes:
            value = law(modes, 0, name)
        value = value + self._goes_on
        step = self.book.begin_step("time")
        step.add_text(f"{capitalized(text)} when {step.law(value, ZERO)}.")
        near = time_of_greatest(self.setting) if self.greatest else self.setting.time
        step.add_text(root_sentence(self.book, step, name, value, near, SECONDS, "The numerical solution is"))
        step.close()
        return name

    @cached_property
    def _goes_on(self) -> Expression:
        """Return the constant term, m, in the equation for the time: an initial extension, a distance, or zero."""
        moment = self.query.moment
        if self.greatest:
            return ZERO
        if isinstance(moment, NaturalLength):
            return self.spring("strain", moment.name).expression()
        if isinstance(moment, Moved):
            k, *_ = self.moving([moment.name])
            name = self._distance
            there = self.setting.motion.state(np.array([self.setting.time])).q[0, k]
            return -name if there > 0.0 else name
        return ZERO

    @cached_property
    def _distance(self) -> Symbol:
        """Return the symbol of the stated distance of a body from its starting point, m."""
        assert isinstance(self.query.moment, Moved)
        name = self.book.fresh("d")
        self.book.state_given(name.name, self.query.moment.value, METRES)
        return name

    @cached_property
    def _condition(self) -> tuple[str, dict[int, float], Law]:
        """Return what defines the moment: event in words, weights by coordinate, and function of time to be summed."""
        moment = self.query.moment
        if self.greatest:
            return self._extreme()
        if isinstance(moment, Moved):
            k, *_ = self.moving([moment.name])
            return moment.told(self.setting.words, f"${self._distance.name}$"), {k: 1.0}, place
        if isinstance(moment, Stopped):
            k, *_ = self.moving([moment.name])
            return f"{self.setting.display_name(moment.name)} comes to rest", {k: 1.0}, speed
        if isinstance(moment, NaturalLength):
            name = self.setting.spring_phrases[moment.name]
            return f"{name} has its natural length", self._grows(moment.name), place
        if isinstance(moment, MostStretched | MostCompressed):
            name = self.setting.spring_phrases[moment.name]
            return f"{name} is no longer growing or shrinking", self._grows(moment.name), speed
        raise UnsolvedError(f"no way to the moment {type(moment).__name__}")

    def _grows(self, line: str) -> dict[int, float]:
        number = self._number(line)
        return {i: part for i in self.motion.free if (part := self.motion.extension_ratio(number, i))}

    def _extreme(self) -> tuple[str, dict[int, float], Law]:
        """Return what defines a greatest value: words, weights by coordinate, derivative whose sum is zero there."""
        assert self.target is not None
        assert self.goal is not None
        if self.goal.uses not in ORDERS:
            raise UnsolvedError("the greatest value is of a force")
        law, text = LAWS[ORDERS[self.goal.uses] + 1], "The greatest value is taken"
        lines, bodies = [*self.goal.lines(self.target)], [*self.goal.bodies(self.target)]
        if lines:
            return text, self._grows(lines[0]), law
        weights: dict[int, float] = {}
        for body, sign in zip(bodies, (-1.0, 1.0) if len(bodies) > 1 else (1.0,), strict=True):
            own = self.moving([body])
            if len(own) != 1 or (len(bodies) > 1 and self._ring(body) is not None):
                raise UnsolvedError("what has its greatest value is no sum of places")
            weights[own[0]] = sign
        if "distance" in self.target.quantity and len(members(self.target.subject)) != len(bodies):
            raise UnsolvedError("a distance of something else")
        return text, weights, law

    # ---- what goals ask

    def moment_time(self) -> Symbol:
        """Return the time of the moment."""
        return self._time

    @property
    def motion_parts(self) -> Sequence[MotionPart]:
        """Return the whole motion, with the turning points of the body in question."""
        assert self.target is not None
        own = self.moving([self.target.subject])
        if len(own) != 1 or own[0] not in self.motion.free:
            raise UnsolvedError("its path is no line of its own")
        i, last = own[0], self._time
        times = self._write_turning_times(i)
        return [BackAndForthTravel(self, [ZERO, *self._at(i, [*times, last])])]

    def _write_turning_times(self, i: int) -> list[Symbol]:
        """Write the times at which a free coordinate turns back before the moment."""
        nears = turning_times(self.setting.study.trace, i, self.setting.time)
        if not nears:
            return []
        step, names = self.book.begin_step("turning"), [self.book.fresh("t") for _ in nears]
        rates = [speed(self._modes, self.motion.free.index(i), name) for name in names]
        equations = join_words([step.law(rate, ZERO) for rate in rates])
        step.add_text(f"It turns back {'when' if len(names) == 1 else 'at the roots of'} {equations}.")
        roots = list(zip(names, rates, nears, strict=True))
        step.add_text(roots_sentence(self.book, step, roots, SECONDS, "The numerical solution is"))
        step.close()
        return names

    def _at(self, i: int, times: list[Symbol]) -> list[Symbol]:
        """Write the values of a free coordinate at some times, and return their symbols."""
        step, names = self.book.begin_step("place"), [self.book.fresh("x") for _ in times]
        formulas = [place(self._modes, self.motion.free.index(i), time) for time in times]
        equations = [step.result(n, formula, METRES, law=True) for n, formula in zip(names, formulas, strict=True)]
        step.add_text(f"Its displacement is then {join_words(equations)}.")
        step.close()
        return names

    def _write_mode_sum(self, order: int, i: int, base: str, unit: str) -> Polynomial:
        """Write the displacement as a sum over modes, or its derivative of some order, once; return its symbol."""
        if (base, i) not in self._known:
            body, number = self.mechanism.coordinates[i].body, self.motion.free.index(i)
            own = base == "x" and self.setting.stated is None  # a value that is given is no function of time
            name = self.names[i] if own else self.book.fresh(base, self.setting.subscript_of(body))
            mode_sum, formula = (LAWS[n](self._modes, number, self._time) for n in (0, order))
            course = f"${mode_sum.latex()}$; " if order else ""
            qualifier = ", apart from the common motion," if self._all.common else ""
            text = (
                f"The displacement of {self.setting.display_name(body)}{qualifier} is {course}{DERIVATIVE_LEADS[order]}"
            )
            self._known[base, i] = Polynomial.from_expression(
                self.book.add_step("sum of modes", text, name, formula, unit)
            )
        return self._known[base, i]

    def place(self, i: int) -> Polynomial:
        """Return the displacement of a free coordinate, in m."""
        return self._write_mode_sum(0, i, "x", METRES)

    def speed(self, i: int) -> Polynomial:
        """Return the velocity of a free coordinate, in m/s."""
        return self._write_mode_sum(1, i, "v", SPEED)

    def acceleration(self, i: int) -> Polynomial:
        """Return the acceleration of a free coordinate, in m/s²."""
        return self._write_mode_sum(2, i, "a", ACCELERATION)

    @cached_property
    def _known(self) -> dict[tuple[str, int], Polynomial]:
        return {}
