"""Numeric: where only integration answers, the equations of motion, how it begins, and what integration gives."""

from math import radians

import numpy as np

from sim2reason.dsl.state import State
from sim2reason.dsl.vectors import inner
from sim2reason.lazy import cached_property
from sim2reason.questions import KINDS
from sim2reason.questions.period_words import PeriodQuery
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.laws.equations_of_motion import Names
from sim2reason.solutions.laws.integrated import IntegratedLaws
from sim2reason.solutions.setting import LEVEL, Setting, capital, joined
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.lexicon import Both
from sim2reason.solutions.writing.steps import Book, UnsolvedError, Writing
from sim2reason.solutions.writing.unit_latex import (
    ACCELERATION,
    ANGULAR_ACCELERATION,
    ANGULAR_SPEED,
    DEGREES,
    METRES,
    RADIANS,
    SECONDS,
    SPEED,
    latex,
)

NONE = {"place": 1e-12, "rate": 1e-12, "acceleration": 1e-9}  # in SI units: what rounding has left of zero
STATE = 8  # digits of a state: what is close to something else differs little from it
SLIDES = {"place": METRES, "rate": SPEED, "acceleration": ACCELERATION}
HINGES = {"place": RADIANS, "rate": ANGULAR_SPEED, "acceleration": ANGULAR_ACCELERATION}
WHENCE = ("state", "event", "start", "time_to_event", "sum", "extremum", "count", "period")


@strategy
class Integration(Strategy):
    """Any motion: its equations, integrated; no derivation."""

    name = "integration"
    cost = 100.0
    kinds = frozenset(WHENCE)
    integrates = True

    def refusal(self, setting: Setting) -> str:
        """Why it does not apply."""
        query = setting.query
        if isinstance(query, PeriodQuery) and query.small:
            return "no motion is integrated for small oscillations"
        return "" if setting.answer is not None else "there is no answer"

    def write(self, setting: Setting, book: Book) -> str:
        """Names, equations, the beginning, the result; where symbols make the equations too long, in numbers."""
        try:
            _Integrated(setting, book.copy()).write()
        except UnsolvedError:
            return _Integrated(setting, book, plain=True).write()
        return _Integrated(setting, book).write()


class _Integrated:
    """The text about one integration."""

    def __init__(self, setting: Setting, book: Book, *, plain: bool = False) -> None:
        self.setting, self.book, self.mechanism = setting, book, setting.mechanism
        moment = setting.query.moment
        side = moment.side(setting.time) if moment is not None else setting.time
        self.state: State = setting.motion.state(np.array([side]))  # with its segments, to the last digit of a time
        segment = [s for s in setting.motion.segments if s.start <= side][-1]
        self.laws = IntegratedLaws(setting, book, segment, self.state, self.names, plain=plain)

    @cached_property
    def names(self) -> Names:
        """Of all coordinates."""
        places, rates, accelerations = list[Symbol](), list[Symbol](), list[Symbol]()
        for c in self.mechanism.coordinates:
            several = len(self.mechanism.body[c.body].coordinates) > 1
            mark = self.setting.mark(c.body)
            hinge = c.kind == "hinge"
            label = c.label if several and not hinge and len(c.label) == 1 else ""
            marks = ",".join(part for part in (mark, label) if part)
            places.append(self.book.fresh(r"\varphi" if hinge else label or "s", mark if label else marks))
            rates.append(self.book.fresh(r"\omega" if hinge else "v", marks))
            accelerations.append(self.book.fresh(r"\alpha" if hinge else "a", marks))
        time = self.book.fresh("t")
        return Names(tuple(places), tuple(rates), tuple(accelerations), time)

    def write(self) -> str:
        """All of it."""
        self._introduce()
        self._know()
        self.laws.write()
        self._beginning()
        self._result()
        return self._answer()

    def _introduce(self) -> None:
        step = self.book.open("names")
        step.say("The motion follows from its equations by numerical integration, not from a formula.")
        said: list[str] = []
        for number, c in enumerate(self.mechanism.coordinates):
            name, who = self.names.places[number].name, self.setting.called(c.body)
            if c.kind == "hinge":
                said.append(f"${name}$ is the angle through which {who} has turned")
                continue
            if any(burn.body == c.body for burn in self.mechanism.burns):
                said.append(f"${name}$ is how far {who} has moved from its starting point")
                continue
            parent = self.mechanism.body[c.body].parent
            off = any(abs(inner(foot.normal, c.axis)) > 1.0 - LEVEL for foot in self.mechanism.feet)
            way = "off the plane" if off else self.setting.towards(c.axis, on=parent)
            on = f" relative to {self.setting.called(parent)}" if parent is not None else ""
            said.append(f"${name}$ is how far {who} has moved {way}{on}")
        rates = [f"${symbol.name}$" for symbol in self.names.rates]
        turned = [f"${symbol.name}$" for symbol in self.names.accelerations]
        step.say(
            f"{capital(joined(said))}; {joined(rates)} {'are' if len(rates) > 1 else 'is'} the first"
            f" and {joined(turned)} the second derivative{'s' if len(rates) > 1 else ''}."
        )
        step.close()

    def _know(self) -> None:
        """What the engine has at the moment, for all names."""
        names, state = self.names, self.state
        for number, coordinate in enumerate(self.mechanism.coordinates):
            units = HINGES if coordinate.kind == "hinge" else SLIDES
            for symbol, values, unit in (
                (names.places[number], state.q, "place"),
                (names.rates[number], state.v, "rate"),
                (names.accelerations[number], state.a, "acceleration"),
            ):
                value = float(values[0, number])
                self.book.know(
                    symbol.name, value if abs(value) > NONE[unit] else 0.0, self.book.unit_in_text(units[unit])
                )
        self.book.know(names.time.name, float(state.times[0]), self.book.unit_in_text(SECONDS))

    def _beginning(self) -> None:
        """How it begins, in words: each name has one value in the text, that of the moment."""
        step, lexicon = self.book.open("beginning"), self.setting.lexicon
        pairs = zip(self.names.rates, lexicon.mechanism.coordinates, lexicon.twin.coordinates, strict=True)
        moving: list[str] = []
        for name, here, there in pairs:
            if here.speed:
                speed = self.laws.equations.number(Both(here.speed, there.speed)).expression()
                moving.append(f"${name.name}$ at {step.stated(speed, self.book.units[name.name])}")
        step.say(f"All begin at zero{f', but {joined(moving)}' if moving else ''}.")
        step.close()

    def _result(self) -> None:
        """What the equations need of the state, and the accelerations that then follow from them."""
        step, names = self.book.open("integration"), self.names
        used = {name for held in self.book.steps for relation in held.relations for name in relation.symbols()}
        needed = [name for name in (*names.places, *names.rates, names.time) if name.name in used]
        until = "the moment in question"
        if needed:
            step.say(f"Integrated numerically to {until}: {joined([self._told(step, name) for name in needed])}.")
        else:
            step.say(f"They are integrated to {until}.")
        step.close()
        step = self.book.open("accelerations")
        found = [name for name in (*names.accelerations, *self.laws.pulls) if name.name in used]
        if found:
            step.say(f"There {joined([step.stated(name, self.book.units[name.name]) for name in found])}.")
        step.close()

    def _told(self, step: Writing, name: Symbol) -> str:
        return step.integrated(name, self.book.values[name.name], STATE)

    def _answer(self) -> str:
        """What is asked for, as the integration gives it."""
        setting, book = self.setting, self.book
        assert setting.answer is not None
        step = book.open("answer")
        if setting.unknown:
            name = Symbol(book.sought)
            book.hidden.discard(name.name)
            step.say(f"Repeated for other values of ${name.name}$ until the result is what is given:")
        else:
            measured = KINDS[setting.query.kind].measured(setting.query)
            time = setting.sought is not None
            unit = SECONDS if time else book.unit_in_text(latex(measured.unit))
            name = book.fresh("t" if time else "X")
            book.know(name.name, radians(setting.answer) if unit == DEGREES else setting.answer, unit)
            step.say(f"From this follows the {'time' if time else measured.name}:")
        step.say(f"{step.integrated(name, book.values[name.name])}.")
        step.close()
        return name.name
