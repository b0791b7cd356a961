"""Rocket: thrust µu on what is left of the mass; u ln(m₀/m) less what gravity takes (Tsiolkovsky)."""

from functools import cached_property

from sim2reason.dsl.frames import start
from sim2reason.dsl.mechanism import Attraction, Burn, Mechanism
from sim2reason.dsl.vectors import Vector
from sim2reason.questions.moments.at_start import AtStart
from sim2reason.questions.moments.at_time import AtTime
from sim2reason.questions.moments.burned_out import BurnedOut
from sim2reason.questions.moments.moved import Moved
from sim2reason.solutions.book import Book, UnsolvedError
from sim2reason.solutions.expressions import Expression, Symbol, added, multiplied, ratio
from sim2reason.solutions.functions import Call
from sim2reason.solutions.lexicon import Both
from sim2reason.solutions.newton import Newton
from sim2reason.solutions.polynomials import NIL, Polynomial
from sim2reason.solutions.setting import Setting, capital
from sim2reason.solutions.shared import NEWTONS, PER_SQUARE_SECOND
from sim2reason.solutions.stage import METRES, SECONDS, SPEED
from sim2reason.solutions.strategies import Strategy, no_goal, strategy
from sim2reason.solutions.way import Way
from sim2reason.solutions.worked import NumericRoot

KILOGRAMS = r"\ \text{kg}"
MOMENTS = (AtStart, AtTime, BurnedOut, Moved)


@strategy
class RocketFlight(Strategy):
    """A lone rocket with its engine on: in empty space, in a uniform field, and at the start on a planet."""

    name = "rocket"
    cost = 1.0

    def unfit(self, mechanism: Mechanism) -> str:
        """Whether there is no lone rocket."""
        moving = [body for body in mechanism.bodies if body.coordinates]
        alone = len(mechanism.burns) == len(moving) == len(mechanism.coordinates) == 1
        return "" if alone else "there is no lone rocket"

    def refusal(self, setting: Setting) -> str:
        """Why it does not apply."""
        m = setting.mechanism
        if unknown := no_goal(setting, MOMENTS):
            return unknown
        if m.attractions and not isinstance(setting.query.moment, AtStart | BurnedOut):
            return "the pull of the planet changes as it rises"
        if setting.motion.segments[0].a[0] <= 0.0:
            return "it waits on the ground until it is light enough"
        return "its engine is off by then" if setting.time > m.burns[0].until * (1.0 + 1e-9) else ""

    def write(self, setting: Setting, book: Book) -> str:
        """The mass that is left, then what is asked."""
        return _Burning(setting, book).write()


class _Burning(Way):
    """What goals ask, of a rocket whose engine is on."""

    def write(self) -> str:
        """The time, or the goal."""
        if self.mechanism.attractions and self.uses in ("v", "s") and self.target is not None:
            raise UnsolvedError("the pull of the planet changes as it rises")
        if self.target is None or self.goal is None:
            return self.time.name
        return self.goal.write(self.target, self).name

    @property
    def newton(self) -> Newton:
        """None is needed."""
        raise UnsolvedError("a rocket has no law of constant mass")

    def force(self, kind: str, name: str) -> Symbol:
        """None."""
        raise UnsolvedError(f"no {kind} of {name}")

    # ---- numbers

    def _both(self, here: float, there: float) -> Polynomial:
        return self.setting.lexicon.read(Both(here, there))

    @property
    def burns(self) -> tuple[Burn, Burn]:
        """The engine, here and in the twin."""
        return self.setting.lexicon.mechanism.burns[0], self.setting.lexicon.twin.burns[0]

    @cached_property
    def rate_of_burning(self) -> Expression:
        """µ."""
        return self._both(*(burn.rate for burn in self.burns)).expression()

    @cached_property
    def exhaust(self) -> Expression:
        """U."""
        return self._both(*(burn.exhaust for burn in self.burns)).expression()

    @cached_property
    def full(self) -> Expression:
        """m₀."""
        lexicon, name = self.setting.lexicon, self.burns[0].body
        return self._both(lexicon.mechanism.body[name].mass, lexicon.twin.body[name].mass).expression()

    @cached_property
    def dry(self) -> Expression:
        """The mass without fuel."""
        lexicon, name = self.setting.lexicon, self.burns[0].body
        pairs = zip((lexicon.mechanism, lexicon.twin), self.burns, strict=True)
        return self._both(*(m.body[name].mass - burn.rate * burn.until for m, burn in pairs)).expression()

    @property
    def gravity(self) -> Polynomial:
        """Of the ground, or of the planet at its surface."""
        lexicon = self.setting.lexicon
        return self._both(_pull(lexicon.mechanism), _pull(lexicon.twin))

    # ---- the moment

    @cached_property
    def time(self) -> Symbol:
        """When the moment comes."""
        moment = self.query.moment
        if isinstance(moment, BurnedOut):
            step, name = self.book.open("time"), self.book.fresh("t")
            formula = ratio(added(self.full, -self.dry), self.rate_of_burning)
            step.say(f"The fuel lasts for {step.result(name, formula, SECONDS, law=True)}.")
            step.close()
            return name
        if isinstance(moment, AtTime):
            name = self.book.fresh("t")
            self.book.say_given(name.name, moment.after, SECONDS)
            return name
        assert isinstance(moment, Moved)
        return self._after(moment)

    def _after(self, moment: Moved) -> Symbol:
        distance, name = self.book.fresh("d"), self.book.fresh("t")
        self.book.say_given(distance.name, moment.value, METRES)
        left = added(self.full, -multiplied(self.rate_of_burning, name))
        path = self._path(left, name)
        step = self.book.open("time")
        law = step.law(distance, path)
        root = NumericRoot(added(path, -distance), name.name, self.setting.time)
        who = capital(self.setting.called(self.burns[0].body))
        step.say(f"{who} has moved so far when {law}; found numerically, {step.result(name, root, SECONDS)}.")
        step.close()
        return name

    @cached_property
    def left(self) -> Expression:
        """The mass at the moment."""
        moment = self.query.moment
        if isinstance(moment, AtStart):
            return self.full
        if isinstance(moment, BurnedOut):
            return self.dry
        step, name = self.book.open("mass"), self.book.fresh("m", r"\text{left}")
        formula = added(self.full, -multiplied(self.rate_of_burning, self.time))
        step.say(f"By then its mass is {step.result(name, formula, KILOGRAMS, law=True)}.")
        step.close()
        return name

    def mass(self, body: str) -> Polynomial:
        """What is left of it."""
        del body
        left = self.left
        assert isinstance(left, Symbol)
        return Polynomial.of(left)

    # ---- the motion

    def _path(self, left: Expression, time: Expression) -> Expression:
        """Its distance: u t − (u m/µ) ln(m₀/m) − ½ g t²."""
        u, log = self.exhaust, Call("ln", ratio(self.full, left))
        path = added(multiplied(u, time), -multiplied(ratio(multiplied(u, left), self.rate_of_burning), log))
        fall = self.gravity.scaled(-0.5).expression()
        return added(path, multiplied(fall, multiplied(time, time)) if self.gravity else NIL.expression())

    def rate(self, kind: str, k: int) -> Polynomial:
        """Along its way up."""
        del k
        if kind == "a":
            return Polynomial.of(self._a)
        return Polynomial.of(self._v if kind == "v" else self._s)

    @cached_property
    def _a(self) -> Symbol:
        thrust, name = self.book.fresh("F"), self.book.fresh("a")
        force = multiplied(self.rate_of_burning, self.exhaust)
        left = self.left
        step = self.book.open("newton")
        step.say(f"The thrust is {step.result(thrust, force, NEWTONS, law=True)}.")
        formula = added(ratio(thrust, left), -self.gravity.expression())
        step.say(f"So {step.result(name, formula, PER_SQUARE_SECOND, law=True)}.")
        step.close()
        return name

    @cached_property
    def _v(self) -> Symbol:
        log = Call("ln", ratio(self.full, self.left))
        formula = multiplied(self.exhaust, log)
        if self.gravity:
            formula = added(formula, -multiplied(self.gravity.expression(), self.time))
        step, name = self.book.open("velocity"), self.book.fresh("v")
        told = "The burning mass gives" if not self.gravity else "The burning mass gives, less what gravity takes,"
        step.say(f"{told} {step.result(name, formula, SPEED, law=True)}.")
        step.close()
        return name

    @cached_property
    def _s(self) -> Symbol:
        left, time = self.left, self.time
        if isinstance(self.query.moment, Moved):
            return Symbol(next(iter(self.book.stated)))
        step, name = self.book.open("distance"), self.book.fresh("s")
        step.say(f"Integrated over the time, {step.result(name, self._path(left, time), METRES, law=True)}.")
        step.close()
        return name

    def component(self, kind: str, body: str, way: Vector) -> Polynomial:
        """Along its way."""
        axis = self.mechanism.coordinates[0].axis
        along = sum(a * b for a, b in zip(axis, way, strict=True))
        return self.rate(kind, 0).scaled(round(along)) if abs(along) > 0.5 and body == self.burns[0].body else NIL


def _pull(mechanism: Mechanism) -> float:
    """The acceleration of free fall along the rocket's way, at the start."""
    axis = mechanism.coordinates[0].axis
    found = -sum(a * b for a, b in zip(axis, mechanism.gravity, strict=True))
    frames = start(mechanism)
    for pull in mechanism.attractions:
        found += _attracted(mechanism, pull, frames.center(pull.a).place, frames.center(pull.b).place)
    return found


def _attracted(mechanism: Mechanism, pull: Attraction, one: Vector, other: Vector) -> float:
    apart = sum((a - b) ** 2 for a, b in zip(one, other, strict=True)) ** 0.5
    heavy = max(mechanism.body[pull.a].mass, mechanism.body[pull.b].mass)
    return pull.constant * heavy / apart**pull.power
