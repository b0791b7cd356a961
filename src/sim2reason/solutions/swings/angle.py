"""The angle of a swing about an axle at the moment of the question."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from math import pi
from typing import ClassVar

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.angles import Deflected, TurnedThrough
from sim2reason.questions.moments.strings import WentSlack
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import HighestPoint, LowestPoint, Stopped
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol, sum_terms
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root
from sim2reason.solutions.oscillations.net_force import is_slow_at_greatest
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.swings.asked import (
    COMPONENT_LEADS,
    EXTREMES,
    PLACES,
    Ends,
    of_components,
    quantity_of,
    where_extreme,
    write_other_end,
)
from sim2reason.solutions.swings.times import SwingTime
from sim2reason.solutions.writing.notation import DEGREES, QUANTITY_SYMBOLS, SECONDS, magnitude_words
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

REST_SPEED_RTOL, ANGLE_TOLERANCE = 1e-5, 1e-6  # tolerance relative to the greatest speed; tolerance in rad
TWO = Number(2.0)
UP = (0.0, 0.0, 1.0)
SMALL_OSCILLATIONS_LEAD = "The angular frequency of small oscillations is"
PASSED_LOWEST_LEAD = "Having passed the lowest point, it has turned through"
HEIGHT_LOST_LEAD = "The height lost is"  # where it is below its starting point
FormulaMethod = tuple[str, str]  # the method that gives a formula, and what is said before it


class SwingAngle(ABC):
    """A swing's angle from the downward vertical, positive on its initial side, written as needed.

    Subclasses set `initial_angle`, the angle at the start, `initial_angle_value`, its value, `moment_angle` and
    `turning`, the angle at the moment and its rate, `turned`, the angle turned through, and `initial_rate_sign`, the
    initial sign of the rate. Values only determine signs. `METHOD_BY_QUANTITY` maps each quantity to its formula and
    words.
    """

    initial_angle: Expression
    initial_angle_value: float
    moment_angle: float
    turned: float
    turning: float
    initial_rate_sign: float
    METHOD_BY_QUANTITY: ClassVar[Mapping[str, FormulaMethod]]
    senses: ClassVar[tuple[Vector, ...]] = (UP,)  # directions of available components
    one_point = True  # a single small body swings
    is_falling = True  # the centre of mass is on the side from which the angle is measured

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Take a question, without writing anything."""
        self.setting, self.book = setting, book

    @cached_property
    def extreme(self) -> str:
        """Return *fastest* or *slowest*: where the swing has the extreme value asked for; empty for other questions."""
        query = self.setting.query
        if not isinstance(query, StretchQuery) or query.functional not in EXTREMES:
            return ""
        entry = EXTREMES[query.functional]
        turns = entry[0] == "acceleration" and is_slow_at_greatest(self.setting, self.setting.query.subject)
        return "slowest" if turns else entry[1]

    @property
    def is_at_rest(self) -> bool:
        """Return whether the body is at rest at the moment, if only for an instant."""
        moment = self.setting.query.moment
        if self.extreme:
            return self.extreme == "slowest" and not self.goes_round
        return isinstance(moment, HighestPoint | LowestPoint | Stopped) and abs(self.turning) <= REST_SPEED_RTOL

    @property
    @abstractmethod
    def goes_round(self) -> bool:
        """Return whether the energy suffices to pass the highest point."""

    # ---- times

    @cached_property
    @abstractmethod
    def small_oscillation_frequency(self) -> Symbol:
        """Return the angular frequency of small oscillations, rad/s."""

    @cached_property
    @abstractmethod
    def initial_angular_speed(self) -> Expression:
        """Return the angular speed at the start, rad/s."""

    @cached_property
    def times(self) -> SwingTime:
        """Return the solver that relates time and the angle of the centre of mass by elliptic integrals."""
        initial_angle, sense = (
            (self.initial_angle, self.initial_rate_sign)
            if self.is_falling
            else (sum_terms(PI, -self.initial_angle), -self.initial_rate_sign)
        )
        return SwingTime(self.book, self.small_oscillation_frequency, initial_angle, self.initial_angular_speed, sense)

    def _when(self) -> Symbol:
        """Write the time of the moment and return its symbol."""
        time = self.setting.time
        if isinstance(self.setting.query.moment, Deflected):
            return self.times.reaches(self._stated, time)
        if isinstance(self.setting.query.moment, TurnedThrough | WentSlack):
            return self.times.reaches(self.angle if self.is_falling else sum_terms(PI, -self.angle), time)
        return self.times.write_vertical_time(time)

    def _at_time(self, moment: AtTime) -> Expression:
        name = self.book.fresh("t")
        self.book.state_given(name.name, moment.after, SECONDS)
        angle = self.times.angle(name)
        return angle if self.is_falling else sum_terms(PI, -angle)

    @cached_property
    def angle(self) -> Expression:
        """Write the angle at the moment, if necessary, and return it."""
        moment = self.setting.query.moment
        if self.extreme:
            return self._at_extreme()
        if isinstance(moment, AtStart):
            return self.initial_angle
        if isinstance(moment, AtTime):
            return self._at_time(moment)
        if isinstance(moment, Deflected | TurnedThrough):
            turns = isinstance(moment, TurnedThrough)
            size = self._stated if turns or self.is_falling else PI - self._stated
            signed = size if (self.turned > 0.0 if turns else self.moment_angle >= 0.0) else -size
            return sum_terms(self.initial_angle, signed) if turns else signed
        if isinstance(moment, WentSlack):
            return self._slack()
        return self._write_turning_angle() if self.is_at_rest else self._upright()

    def _upright(self) -> Expression:
        """Return the angle of a swing at its lowest point, 0, or at its highest point, π."""
        if abs(self.moment_angle) < ANGLE_TOLERANCE:
            return ZERO
        if abs(abs(self.moment_angle) - pi) > ANGLE_TOLERANCE:
            raise UnsolvedError("the angle at that moment is not known")
        return Number(pi)

    def _at_extreme(self) -> Expression:
        if self.extreme == "fastest":
            return ZERO if self.is_falling else Number(pi)
        if self.goes_round:
            return Number(pi) if self.is_falling else ZERO
        return self._write_turning_angle()

    @cached_property
    def _stated(self) -> Symbol:
        """Return the symbol of the angle that the question states: a deflection or an angle turned."""
        moment, name = self.setting.query.moment, self.book.fresh(r"\phi")
        assert isinstance(moment, Deflected | TurnedThrough)
        self.book.state_given(name.name, float(np.radians(moment.value)), DEGREES)
        return name

    @abstractmethod
    def _write_turning_angle(self) -> Expression:
        """Write the angle of the turning point and return it with its sign."""

    @cached_property
    def reach(self) -> Expression:
        """Return the magnitude of the angle at the turning point."""
        angle = self.initial_angle if self.initial_angular_speed == ZERO else self._write_turning_angle()
        return -angle if angle.latex().startswith("-") else angle

    def _slack(self) -> Expression:
        """Write the angle at which the string goes slack; UnsolvedError without a string."""
        raise UnsolvedError("it hangs on no string")

    # ---- sines and cosines

    @property
    def cosine_first(self) -> Expression:
        """Return the cosine of the angle at the start."""
        return Call("cos", self.initial_angle) if self.initial_angle != ZERO else ONE

    @property
    def cosine(self) -> Expression:
        """Return the cosine of the angle at the moment."""
        if self.angle == ZERO:
            return ONE
        if isinstance(self.angle, Number):
            return Number(-1.0)
        return Call("cos", -self.angle if self.angle.negative else self.angle)

    @property
    def sine(self) -> Expression:
        """Return the magnitude of the sine of the angle at the moment."""
        if isinstance(self.angle, Number):
            return ZERO
        negative = self.angle.negative
        sine = Call("sin", -self.angle if negative else self.angle)
        return sine if self.book.value(sine) >= 0.0 else -sine

    @property
    def between(self) -> Expression:
        """Return the magnitude of the angle turned since the start."""
        difference = sum_terms(self.angle, -self.initial_angle)
        return difference if self.book.value(difference) >= 0.0 else -difference

    _law_of_cosines = ""  # beginning of a sentence about the change in momentum, if the velocity changes direction

    def change(self, begun: Expression, speed: Expression) -> Expression:
        """Return the magnitude, m/s, of the change of velocity on the arc from the speed `begun` to `speed`."""
        if ZERO in (begun, speed):
            return speed if begun == ZERO else begun
        bent = self.cosine * self.cosine_first if self.sine == ZERO else Call("cos", self.between)
        along = TWO * begun * speed * bent
        onward = self.initial_rate_sign * self.turning > 0.0
        along = along if onward else -along
        if self.sine != ZERO:
            turned = f"${self.between.latex()}$" if onward else f"$180^\\circ - {self.between.latex()}$"
            text = f"The two velocities make the angle {turned}, so by the law of cosines the impulse,"
            self._law_of_cosines = f"{text} which is the change in momentum, has the magnitude"
        return Root(Power(begun, 2) + Power(speed, 2) - along)

    # ---- what is asked

    def write(self) -> Symbol:
        """Write the answer to the query and return the answer's symbol."""
        quantity, target = quantity_of(self.setting), self.setting.query.target
        if not quantity:
            return self._when()
        sense = target.sense if target is not None else None
        if sense is not None and any(sense.vector) and sense.vector not in self.senses:
            raise UnsolvedError(f"no way to the component along {sense.positive}")
        self._write_extreme_position(quantity)
        formula: Expression = getattr(self, self.METHOD_BY_QUANTITY[quantity][0])()
        formula = -formula if (turned := sense is None and self.book.value(formula) < 0.0) else formula
        if isinstance(formula, Symbol) and (self.setting.unit != DEGREES or self.book.units[formula.name] == DEGREES):
            return formula  # an angle that the text says is counted in radians
        text = self.lead_text(quantity) or "So"
        text = (
            HEIGHT_LOST_LEAD if turned and quantity == "height" else magnitude_words(text, quantity) if turned else text
        )
        answer = self.book.add_step(
            "answer", text, self.book.fresh(QUANTITY_SYMBOLS[quantity]), formula, self.setting.unit
        )
        self._compare_ends(quantity, answer)
        return answer

    @property
    def components(self) -> tuple[Expression, Expression] | None:
        """Return centripetal and tangential acceleration of the centre of mass; None if it moves on no circle."""
        return None

    def lead_text(self, quantity: str) -> str:
        """Return the words before the formula of a quantity; those of an acceleration name its components."""
        if quantity in COMPONENT_LEADS and not self.vertical and (components := self.components) is not None:
            return of_components(quantity, *components, begins=not self.is_at_rest)
        if quantity == "impulse of the net force" and self._law_of_cosines:
            return self._law_of_cosines
        passed = quantity == "angle turned" and self.initial_angle != ZERO and self.angle.negative
        return PASSED_LOWEST_LEAD if passed else self.METHOD_BY_QUANTITY[quantity][1]

    def _write_extreme_position(self, quantity: str) -> None:
        """Write where the quantity is extreme and why; nothing for an extreme angle, height or displacement."""
        query = self.setting.query
        if not self.extreme or not isinstance(query, StretchQuery) or quantity in PLACES:
            return
        superlative, _, noun = query.functional.partition(" ")
        at = "at the {} point" if self.one_point else "where the centre of mass is {}"
        lowest, highest = at.format("lowest"), at.format("highest")
        still = highest if self.goes_round else "at the turning points"
        where, step = lowest if self.extreme == "fastest" else still, self.book.begin_step("extreme")
        step.add_text(
            where_extreme(quantity, noun, superlative, where, loops=self.goes_round, free=self.book.in_symbols)
        )
        step.close()

    def _compare_ends(self, quantity: str, found: Symbol) -> None:
        """Write the acceleration at the other end of a swing that turns back, as soon as its numbers are known."""
        book, swings = self.book, bool(self.extreme) and not self.goes_round
        if quantity != "acceleration" or not swings or book.in_symbols or (ends := self.ends) is None:
            return
        if book.is_hidden(found) or any(map(book.is_hidden, ends)):
            book.afterwards.append(lambda: write_other_end(book, found, ends))
        else:
            write_other_end(book, found, ends)

    @property
    def ends(self) -> Ends | None:
        """Return the terms of the accelerations at the lowest and at a turning point; None if the path is no circle."""
        return None

    @property
    def vertical(self) -> bool:
        """Return whether the question asks for the upward component of a vector."""
        sense = target.sense if (target := self.setting.query.target) is not None else None
        return sense is not None and sense.vector == UP

    def _deflection(self) -> Expression:
        if isinstance(self.angle, Number):
            raise UnsolvedError("the angle is that of the lowest or highest point")
        size = -self.angle if self.angle.negative else self.angle
        return size if self.is_falling else PI - size

    def _between(self) -> Expression:
        return self.between
