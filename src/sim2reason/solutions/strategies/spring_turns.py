"""Spring that turns: energy and angular momentum of a body that is sent off on a single spring in any direction.

The force points to the fixed end, so that r × v is kept, and with it v² = u² + (h/r)² at any length r of the spring,
which changes at the rate u.
"""

from functools import cached_property

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.springs import SpringLength
from sim2reason.questions.moments.most_compressed import MostCompressed
from sim2reason.questions.moments.most_stretched import MostStretched
from sim2reason.questions.moments.natural_length import NaturalLength
from sim2reason.solutions.book import Book, UnsolvedError
from sim2reason.solutions.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.functions import Power, Root, squares
from sim2reason.solutions.kepler import AREAL
from sim2reason.solutions.lone_spring import LoneSpring, begins_at_rest, is_lone_spring
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.told_root import told_root
from sim2reason.solutions.unit_latex import JOULES, METRES, MOMENTUM, NEWTONS, SPEED

HALF = Number(0.5)
EXTREMES = MostCompressed, MostStretched


@strategy
class SpringTurns(Strategy):
    """A body on a level table, sent off on a single spring without friction."""

    name = "energy and angular momentum on a spring"
    cost = 1.0
    kinds = frozenset({"event"})

    def unfit(self, mechanism: Mechanism) -> str:
        """Whether there is no lone body on a spring, or it is let go at rest."""
        fits = is_lone_spring(mechanism) and not begins_at_rest(mechanism)
        return "" if fits else "no lone body is sent off on a single spring"

    def refusal(self, setting: Setting) -> str:
        """Why it does not apply."""
        query = setting.query
        if not isinstance(query.moment, (NaturalLength, *EXTREMES)):
            return f"no way to the moment {type(query.moment).__name__}"
        target = query.target
        if target is None or target.quantity not in _Turning.WAYS:
            return f"no way to the quantity {target.quantity if target is not None else ''}"
        return "a component in a direction that is not known" if target.sense is not None else ""

    def write(self, setting: Setting, book: Book) -> str:
        """What is kept, the length of the spring, and what is asked."""
        return _Turning(setting, book).write().name


class _Turning(LoneSpring):
    """What is asked of it at some length of the spring."""

    def write(self) -> Symbol:
        """By the quantity."""
        target = self.setting.query.target
        assert target is not None
        kind, base, unit, said = self.WAYS[target.quantity]
        found: Expression = getattr(self, kind)()
        if self.book.value(found) < 0.0:
            found = -found
        return (
            found if isinstance(found, Symbol) else self.book.told("answer", said, self.book.fresh(base), found, unit)
        )

    @cached_property
    def momentum(self) -> Symbol:
        """The angular momentum about the fixed end, for each unit of mass; positive."""
        (x, y), (along, across) = self.apart, self.first
        formula = x * across - y * along
        if formula == ZERO or not self.book.value(formula):
            raise UnsolvedError("it is sent off along the spring")
        said = (
            "The force of the spring has no moment about its fixed end, so that the angular momentum about that is "
            "kept; for each unit of mass it is"
        )
        formula = formula if self.book.value(formula) > 0.0 else -formula
        return self.book.told("angular momentum", said, self.book.fresh("h"), formula, AREAL)

    @cached_property
    def energy(self) -> Expression:
        """Twice the energy for each unit of mass: v² + k x²/m."""
        strained = self.stiffness / self.mass * Power(self.length - self.natural, 2)
        return squares(self.first) + strained

    @cached_property
    def radius(self) -> Expression:
        """How long the spring is then."""
        if isinstance(self.setting.query.moment, NaturalLength):
            return self.natural
        _ = self.length, self.momentum
        name, step = self.book.fresh("r"), self.book.open("turning point")
        there = Power(self.momentum / name, 2) + self.stiffness / self.mass * Power(name - self.natural, 2)
        step.say("There the length of the spring does not change, and the velocity h/r is at right angles to it:")
        step.say(f"{step.law(there, self.energy)}.")
        step.say(told_root(self.book, step, name, there - self.energy, self._length_then, METRES, "Numerically,"))
        step.close()
        return name

    @property
    def _length_then(self) -> float:
        """By the engine, m."""
        setting = self.setting
        state = setting.study.trace.sample(np.array([setting.time]))
        return float(SpringLength.evaluate(state, setting.mechanism.lines[0].name)[0])

    @cached_property
    def speed(self) -> Symbol:
        """Of the body then."""
        if isinstance(self.setting.query.moment, EXTREMES):
            said = "The angular momentum gives"
            return self.book.told("speed", said, self.book.fresh("v", "1"), self.momentum / self.radius, SPEED)
        _ = self.length
        step, name = self.book.open("energy"), self.book.fresh("v", "1")
        law = step.law(Power(name, 2), self.energy)
        step.say(f"Then the spring stores nothing, and the energy is all kinetic: {law},")
        step.say(f"so {step.result(name, Root(self.energy), SPEED)}.")
        step.close()
        return name

    def _speed(self) -> Expression:
        return self.speed

    def _momentum(self) -> Expression:
        return self.mass * self.speed

    def _kinetic(self) -> Expression:
        return HALF * self.mass * Power(self.speed, 2)

    def _growth(self) -> Expression:
        if isinstance(self.setting.query.moment, EXTREMES):
            raise UnsolvedError("it is zero there")
        across = self.book.told(
            "across",
            "By the angular momentum the part of the velocity across the spring is",
            self.book.fresh(r"v", r"\perp"),
            self.momentum / self.radius,
            SPEED,
        )
        return Root(Power(self.speed, 2) - Power(across, 2))

    def _extension(self) -> Expression:
        return self.radius - self.natural

    def _length(self) -> Expression:
        return self.radius

    def _pull(self) -> Expression:
        return self.stiffness * self._extension()

    def _stored(self) -> Expression:
        return HALF * self.stiffness * Power(self._extension(), 2)

    WAYS = {  # noqa: RUF012 - by quantity: which formula, its letter, its unit, what is said
        "velocity": ("_speed", "v", SPEED, "It moves at"),
        "momentum": ("_momentum", "p", MOMENTUM, "Mass times velocity:"),
        "kinetic energy": ("_kinetic", "K", JOULES, "The kinetic energy is"),
        "extension rate": ("_growth", "u", SPEED, "The rest of the velocity is along the spring:"),
        "extension": ("_extension", "x", METRES, "It is longer or shorter than when relaxed by"),
        "spring length": ("_length", r"\ell", METRES, "It is as long as"),
        "spring force": ("_pull", "F", NEWTONS, "The spring pulls or pushes with"),
        "net force": ("_pull", "F", NEWTONS, "The force of the spring is"),
        "spring energy": ("_stored", "U", JOULES, "It stores"),
    }
