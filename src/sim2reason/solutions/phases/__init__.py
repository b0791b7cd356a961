"""Phases of a motion: the equations of each, the events between them, and the values at its end."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from math import isnan, radians

import numpy as np

from sim2reason.questions import KINDS, StatedResult, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.reached import Reached
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.laws.dynamics import gravitational_constant
from sim2reason.solutions.laws.equations_of_motion import UNREAD, Names
from sim2reason.solutions.phases.conditions import event_condition, given_symbol, locate_condition, moment_conditions
from sim2reason.solutions.phases.coordinates import HINGE_UNITS, SLIDE_UNITS, choose
from sim2reason.solutions.phases.end_state import formula_of, write_quantity
from sim2reason.solutions.phases.equations import PhaseEquations, amid
from sim2reason.solutions.phases.extremes import (
    ACCUMULATION_RATES,
    PhaseInterval,
    asked_time,
    end_sentence,
    moment_words,
    phase_intervals,
    rate_formulas,
    rate_of,
    refine_zero,
    value_of,
    write_problem,
)
from sim2reason.solutions.phases.forces import ForceSymbols, initial_rates, write_jump
from sim2reason.solutions.phases.steady import SteadyPhase, prune_steps, with_used_contacts
from sim2reason.solutions.setting import ProblemContext, join_words
from sim2reason.solutions.solution import Accumulated, Condition, Coordinate, Integration, Phase
from sim2reason.solutions.writing.notation import DEGREES, NEWTONS, SECONDS, latex, split_name, unit_of_quantity
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

ZERO_TOLERANCE = 1e-12  # in SI units: tolerance of zero
EXTREME_SEARCH_RTOL = 2e-3  # half-width of the search for an extreme value, relative to the time of the question
QUESTION_MOMENT = "the moment asked about"
FORCES = frozenset(
    {"acceleration", "angular acceleration", "tension", "normal force", "friction force", "net force", "torque"}
)
INTRODUCTION = "The equations of motion are integrated numerically."


def _excess(inner: PhaseEquations, target: Target, given: StatedResult) -> Expression:
    """Return the formula of a quantity minus the value that the question states for it, recorded as a given number."""
    unit = unit_of_quantity(target.quantity)
    value = radians(given.value) if unit == DEGREES else given.value
    return formula_of(inner, target) - given_symbol(inner, "c", value, unit)


class IntegratedPhases:
    """The solution of a problem phase by phase: closed form at constant acceleration, else integrated."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder, *, integrates: bool = True) -> None:
        """Choose coordinates; unless `integrates`, accelerations must be constant in each phase."""
        self._integrates = integrates
        self.setting, self.book, self.mechanism = setting, book, setting.mechanism
        chosen = choose(setting, book)
        self.names, self._chosen = chosen.names, chosen
        self._forces = ForceSymbols(setting, book)
        self.time = asked_time(setting)
        self._begin: Expression = Number(0.0)
        self._places = [origin.expression() for origin in self.names.origins]
        self._rates = initial_rates(setting.lexicon, self.names.senses)
        self._sum: Symbol | None = None
        self._composed: dict[int, Callable[[frozenset[str]], str]] = {}  # last sentence of a step, by its number
        self._introduced = 0  # number of the step that names coordinates

    def write(self) -> str:
        """Write all steps and return the symbol of the answer; UnsolvedError if an equation cannot be written."""
        intervals = phase_intervals(self.setting, self.time)
        self._introduce()
        end: PhaseEquations | None = None
        for number, stretch in enumerate(intervals):
            self.book.phase = number
            end = self._phase(stretch, last=number == len(intervals) - 1, several=len(intervals) > 1)
        assert end is not None
        answer = self._answer(end)
        self._compose(answer)
        self._check_names()
        return answer if not self.setting.unknown else self.book.sought

    def _check_names(self) -> None:
        """Raise UnsolvedError if an equation has a name without a value in the numbers of the text."""
        names = {name for step in self.book.steps for name in step.symbols()}
        self._refuse_unread(names)
        if unknown := sorted(names - {*self.book.values, *self.book.observed}):
            raise UnsolvedError(f"the equations have no number for {', '.join(unknown)}")

    @staticmethod
    def _refuse_unread(names: Iterable[str]) -> None:
        if unread := sorted({name.removeprefix(UNREAD) for name in names if name.startswith(UNREAD)}):
            raise UnsolvedError(f"the text does not give {', '.join(unread)}, which the equations hold")

    def _introduce(self) -> None:
        book, constant = self.book, self.setting.lexicon.constant
        if constant is not None:
            gravitational_constant(book, constant)
        step = book.begin_step("names")
        step.add_text(self._chosen.sentence)
        if self.setting.unknown:
            name, stated = Symbol(book.sought), self.setting.stated
            given = f", {stated.digits} {stated.unit}".rstrip() if stated is not None else ""
            book.hidden.discard(name.name)
            step.add_text(
                f"The equations hold for any ${name.name}$; it is varied until the result is that given{given},"
            )
            step.add_text(f"which leads to {step.trial(name)}. With this value:")
        step.close()
        self._introduced = self.book.steps[-1].id

    # ---- one phase

    def _phase(self, stretch: PhaseInterval, *, last: bool, several: bool) -> PhaseEquations:
        """Write one phase and the event at its end; return its equations in the symbols of that instant."""
        inner = self._inner(stretch.segment)
        if stretch.events:
            conditions = [event_condition(inner, event) for event in stretch.events]
            formulas, happens = [formula for formula, _ in conditions], join_words([phrase for _, phrase in conditions])
        else:
            formulas, happens = self._moment_formulas(inner), moment_words(self.setting)
        sides = [side for law in inner.laws for side in (law.left, law.right)]
        self._refuse_unread(name for formula in (*formulas, *sides) for name in formula.symbols())
        for name, value, unit in inner.stated:
            self.book.reserve(name)
            self.book.state_given(name, value, unit)
        if self.setting.query.kind == "extremum" and last:
            self.time = refine_zero(inner, formulas[-1], self.time, EXTREME_SEARCH_RTOL * self.setting.time)
            stretch = replace(stretch, ends=self.time)
        until = locate_condition(inner, formulas, stretch.segment.start, stretch.ends)
        names, forces = self._ended(inner, stretch)
        if several:
            self._announce(happens)
        if inner.steady and not self._adds_up:
            start = self._begin, self._places, self._rates
            SteadyPhase(inner, start).write(self.book, names, forces, until.expression, happens or QUESTION_MOMENT)
        elif not self._integrates:
            raise UnsolvedError("accelerations change during a phase")
        else:
            self._integrate(inner, until, (names, forces), stretch.ends, happens if not several else "")
        self._begin, self._places, self._rates = names.time, list(names.places), list(names.rates)
        outer = PhaseEquations(self.setting, self.book, stretch.segment, names, forces)
        return self._handed_on(outer, stretch)

    def _announce(self, happens: str) -> None:
        """Write the heading of a phase."""
        phases, number = self.book.phases, self.book.phase
        phases.append(Phase(phases[-1].ends if phases else "the start", happens or QUESTION_MOMENT))
        step = self.book.begin_step("phase")
        step.add_text(f"Phase {number + 1}, until {phases[-1].ends}.")
        step.close()

    def _handed_on(self, outer: PhaseEquations, stretch: PhaseInterval) -> PhaseEquations:
        """Write the velocity changes at the event that ends a phase, unless the question is about the instant before.

        Return the equations in the symbols of the instant of the question, if it is this one.
        """
        query, moment = self.setting.query, self.setting.query.moment
        following = next((s for s in self.setting.motion.segments if s.start == stretch.ends), None)
        is_last = stretch.ends >= self.time
        after = query.kind == "event" and moment is not None and bool(moment.sided)
        if not stretch.events or following is None or (is_last and not after):
            return outer
        new = write_jump(outer, following, stretch.events, self.book.phase)
        self._rates = list(new) if new is not None else self._rates
        if not is_last:
            return outer
        if self.setting.target is not None and self.setting.target.quantity in FORCES:
            raise UnsolvedError("it asks for a force or an acceleration just after an event")
        names = outer.names if new is None else replace(outer.names, rates=new)
        return PhaseEquations(self.setting, self.book, stretch.segment, names, outer.forces)

    def _inner(self, segment: Segment) -> PhaseEquations:
        """Return the equations of a segment, whose symbols have the values in the middle of the segment."""
        draft = self.book.copy()
        equations = PhaseEquations(self.setting, draft, segment, self.names, self._forces.force_symbols(segment))
        for name, values in equations.sampled(amid(self.setting, segment).times).items():
            if name not in draft.values and np.isfinite(values[0]):
                draft.set_value(name, float(values[0]))
        return equations

    def _moment_formulas(self, inner: PhaseEquations) -> list[Expression]:
        setting, query = self.setting, self.setting.query
        if query.kind == "extremum" and isinstance(query, StretchQuery):
            return rate_formulas(inner, query.functional, query.name)
        if setting.sought is not None and not setting.unknown and setting.stated is not None and setting.target:
            if not isinstance(query.moment, AtTime):
                raise UnsolvedError("it asks for no time")
            return [_excess(inner, setting.target, setting.stated)]
        if isinstance(query.moment, Reached) and query.target != query.moment.target:
            return [_excess(inner, query.moment.target, query.moment.given)]
        return moment_conditions(inner, query.moment)

    def _ended(self, inner: PhaseEquations, stretch: PhaseInterval) -> tuple[Names, dict[str, Symbol]]:
        """Return the symbols of coordinates and forces at the end of a phase, with the engine's values."""
        names = self.names
        side = float(np.nextafter(stretch.ends, 0.0)) if stretch.events else stretch.ends
        sampled = inner.sampled(np.array([side]))
        units = [HINGE_UNITS if c.kind == "hinge" else SLIDE_UNITS for c in self.mechanism.coordinates]
        places, rates, accelerations = (
            tuple(self._value(symbol, sampled, unit[n]) for symbol, unit in zip(symbols, units, strict=True))
            for n, symbols in enumerate((names.places, names.rates, names.accelerations))
        )
        time = self._value(names.time, sampled, SECONDS)
        forces = {key: self._value(symbol, sampled, NEWTONS) for key, symbol in inner.forces.items()}
        return Names(places, rates, accelerations, time, names.senses, names.origins), forces

    def _value(self, symbol: Symbol, sampled: dict[str, Array], unit: str) -> Symbol:
        base, mark = split_name(symbol.name)
        name = self.book.fresh(base, ",".join(part for part in (mark, str(self.book.phase + 1)) if part))
        value = float(sampled[symbol.name][0])
        if not isnan(value):  # the engine does not record the forces of all constraints
            self.book.set_value(name.name, value if abs(value) > ZERO_TOLERANCE else 0.0, self.book.unit_in_text(unit))
        return name

    # ---- numerical integration

    def _integrate(
        self,
        inner: PhaseEquations,
        until: Condition,
        end: tuple[Names, dict[str, Symbol]],
        time: float,
        happens: str,
    ) -> None:
        """Write the initial-value problem of a phase; the text of its results follows when all phases are written."""
        own, (names, forces) = self.names, end
        inside = (own.time, *own.places, *own.rates, *own.accelerations, *(inner.forces[key] for key in forces))
        outside = (names.time, *names.places, *names.rates, *names.accelerations, *forces.values())
        ends = [(a.name, b.name) for a, b in zip(inside, outside, strict=True) if b.name in self.book.values]
        accumulated = self._accumulated(inner, time)
        if self._sum is not None:
            ends.append((accumulated[0].name, self._sum.name))
        coordinates = zip(own.places, own.rates, own.accelerations, self._places, self._rates, strict=True)
        integration = Integration(
            own.time.name,
            self._begin,
            tuple(Coordinate(q.name, v.name, a.name, position, rate) for q, v, a, position, rate in coordinates),
            tuple(symbol.name for symbol in inner.forces.values()),
            tuple(inner.laws),
            until,
            tuple(ends),
            accumulated,
        )
        step = self.book.begin_step("integration")
        introduced = self._forces.introductions()
        if introduced:
            step.add_text(f"Let {join_words([part.replace('$ ', '$ be ', 1) for part in introduced])}.")
        letter = "r" if self.mechanism.attractions else r"\ell"
        write_problem(self.book, step, integration, first=not self.book.phase, letter=letter)
        step.integrate(integration)
        step.close()
        self._composed[self.book.steps[-1].id] = lambda used: end_sentence(self.book, integration, happens, used)

    @property
    def _adds_up(self) -> bool:
        """Return whether the question asks for a quantity that accumulates over the motion."""
        query = self.setting.query
        return isinstance(query, StretchQuery) and query.functional in ACCUMULATION_RATES

    def _accumulated(self, inner: PhaseEquations, ends: float) -> tuple[Accumulated, ...]:
        query = self.setting.query
        if not isinstance(query, StretchQuery) or not self._adds_up:
            return ()
        rate = rate_of(query.functional, query.name, inner)
        before: Expression = self._sum if self._sum is not None else Number(0.0)
        value = value_of(query.functional, query.name, self.setting.study.trace, ends)
        self._sum = self.book.fresh("X", str(self.book.phase + 1))
        self.book.set_value(self._sum.name, value, self.book.unit_in_text(self._measured_unit))
        return (Accumulated("X", rate, before),)

    @property
    def _measured_unit(self) -> str:
        return latex(KINDS[self.setting.query.kind].measured(self.setting.query).unit)

    def _compose(self, answer: str) -> None:
        """Complete the text of each phase with the values that later steps use."""
        used = frozenset(name for step in self.book.steps for name in step.symbols()) | {answer}
        for number, text in self._composed.items():
            step = self.book.steps[number]
            self.book.steps[number] = replace(step, text=f"{step.text} {text(used)}")
        self.book.steps[:] = prune_steps(self.book.steps, answer, self.book.values)
        step = self.book.steps[self._introduced]
        if self._composed:
            self.book.steps[self._introduced] = replace(step, text=f"{INTRODUCTION} {step.text}")
        else:
            names = {name for step in self.book.steps for name in step.symbols()} | {answer}
            own = {name for name in names if not self.setting.is_given(name)}
            text = step.text.replace(self._chosen.sentence, self._chosen.used(own)).strip()
            self.book.steps[self._introduced] = replace(step, text=text)
            self.book.steps[:] = with_used_contacts(self.book.steps)

    # ---- the answer

    def _answer(self, end: PhaseEquations) -> str:
        """Write the answer from the state at the end of the last phase, and return the answer's symbol."""
        setting, query = self.setting, self.setting.query
        if self._sum is not None:
            symbol = self._sum
        elif query.kind == "time_to_event" or (setting.sought is not None and not setting.unknown):
            symbol = end.names.time
        else:
            symbol = write_quantity(setting, self.book, end)
        if setting.unknown and setting.stated is not None:
            value = radians(setting.stated.value) if setting.unit == DEGREES else setting.stated.value
            step = self.book.begin_step("given")
            step.add_text(f"This is the given result: {step.given_result(symbol, value)}.")
            step.close()
        return symbol.name
