"""Rocket: thrust µu on the remaining mass, and the speed u ln(m₀/m) less the effect of gravity (Tsiolkovsky)."""

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.times import AtStart, AtTime, BurnedOut
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol, multiply_factors, ratio, sum_terms
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.laws.rocket import Burning, exclude_burning, tell_in_the_air
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, missing_goal, strategy
from sim2reason.solutions.writing.notation import ACCELERATION, KILOGRAMS, METRES, NEWTONS, SECONDS, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

MOMENTS = (AtStart, AtTime, BurnedOut, Moved, Stopped)
HALF = Number(0.5)


@strategy
class RocketFlight(Strategy):
    """The strategy for a single rocket in empty space, in a uniform field, or at the start on a planet."""

    name = "rocket"
    cost = 1.0
    kinds = Strategy.kinds | {"extremum"}

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        moving = [body for body in mechanism.bodies if body.coordinates]
        alone = len(mechanism.burns) == len(moving) == len(mechanism.coordinates) == 1
        return "" if alone else "there is no lone rocket"

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: all, or none above a planet, whose pull varies."""
        return frozenset[str]() if mechanism.attractions else self.kinds

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        m = setting.mechanism
        if isinstance(setting.query, StretchQuery):
            unsuitable = m.attractions or not any(m.gravity) or not _tops(setting)
            return "it is not about the highest point of a flight in a uniform field" if unsuitable else ""
        if unknown := missing_goal(setting, MOMENTS):
            return unknown
        if m.attractions and not isinstance(setting.query.moment, AtStart | BurnedOut):
            return "the pull of the planet changes as it rises"
        return ""

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the remaining mass and the answer, and return the answer's symbol."""
        return _Burning(setting, book).write()


class _Burning(Burning):
    """The quantities of a rocket during and after the burn."""

    def write(self) -> str:
        """Write the time, the greatest height or the quantity asked for, and return its symbol."""
        if isinstance(self.query, StretchQuery):
            return self._s.name
        if self.mechanism.attractions and self.uses in ("v", "s") and self.target is not None:
            raise UnsolvedError("the pull of the planet changes as it rises")
        if self.target is None or self.goal is None:
            return self.time.name
        answer = self.goal.write(self.target, self).name
        above = self.uses == "s" and self.mechanism.coordinates[0].lower == 0.0  # the ground
        if above or not self.gravity or not self.is_burned_out:  # it never moves backwards
            self.book.sign_chosen = 0
        return answer

    # ---- the moment

    @cached_property
    def time(self) -> Symbol:
        """Write the time of the moment, s, and return its symbol."""
        moment = self.query.moment
        if isinstance(moment, BurnedOut):
            return self.burned
        if isinstance(moment, AtTime):
            name = self.book.fresh("t")
            self.book.state_given(name.name, moment.after, SECONDS)
            return name
        if isinstance(moment, Stopped):
            return self._stopping
        if self.is_burned_out:
            return self.book.add_step(
                "time", "The total time is", self.book.fresh("t"), self.burned + self.coast, SECONDS
            )
        if not isinstance(moment, Moved):
            raise UnsolvedError("no way to the time of that moment")
        return self._after(moment)

    @cached_property
    def _stopping(self) -> Symbol:
        """Write the time at which gravity has used up the speed gained in the burn, and return its symbol."""
        name, step = self.book.fresh("t"), self.book.begin_step("time")
        g, given = self.gravity.expression(), self.exhaust * Call("ln", ratio(self.lift_off_mass, self.dry_mass))
        risen = self._risen(name)
        law = step.law(given, g * risen)
        formula = given / g + self._wait if self.waits_on_ground else given / g
        velocity = (given - g * risen).latex()
        step.add_text("While the engine is on after lift-off, the thrust exceeds the weight, so the speed grows and")
        step.add_text(
            f"{self.name} can come to rest only after burnout. By the rocket equation with gravity, its velocity"
        )
        step.add_text(
            f"is then ${velocity}$ at the time ${name.latex()}$. {self.capitalized_name} comes to rest when {law},"
        )
        step.add_text(f"so {step.result(name, formula, SECONDS)}.")
        step.close()
        if self.waits_on_ground and self.book.is_hidden(self.initial_mass) and not self.book.is_hidden(given):
            self.book.afterwards.append(lambda: self.exclude_rising(name, given / g))
        return name

    def _after(self, moment: Moved) -> Symbol:
        distance, name = self.book.fresh("d"), self.book.fresh("t")
        self.book.state_given(distance.name, moment.value, METRES)
        left = self.initial_mass - self.rate_of_burning * name
        path, course = self._path(left, self._risen(name)), self.course
        step = self.book.begin_step("time")
        step.add_text(f"{course}.")
        law = step.law(distance, path)
        root = NumericRoot(path - distance, name.name, self.setting.time)
        step.add_text(f"By integration, {self.name} has covered the distance ${distance.latex()}$ when {law};")
        step.add_text(f"the numerical solution is {step.result(name, root, SECONDS)}.")
        step.close()
        spent = (self.initial_mass - self.dry_mass) / self.rate_of_burning
        self.write_when_known(lambda: self.verify_burning(name, spent), name, spent)
        return name

    @cached_property
    def coast(self) -> Expression:
        """Write the time since burnout, s, and return it."""
        moment, name = self.query.moment, self.book.fresh("t", r"\text{off}")
        g, (fast, high) = self.gravity.expression(), self._at_end
        if isinstance(moment, Stopped) or isinstance(self.query, StretchQuery):
            return self.book.add_step("time", "Gravity then stops it after a further", name, fast / g, SECONDS)
        if isinstance(moment, AtTime):
            if self.book.is_hidden(self.time - self.burned):
                self.write_burnout(self.time)
                self.book.afterwards.append(lambda: exclude_burning(self, self.time))
            text = f"{self.capitalized_name} then moves with its engine off for"
            return self.book.add_step("time", text, name, self.time - self.burned, SECONDS)
        assert isinstance(moment, Moved)
        distance = self.book.fresh("d")
        self.book.state_given(distance.name, moment.value, METRES)
        rest = distance - high
        self.write_when_known(lambda: self.verify_farther(distance, high), distance, high)
        if not self.gravity:
            far, speed = distance.latex(), fast.latex()
            text = f"{self.capitalized_name} covers the rest of the distance ${far}$ at the speed ${speed}$, in"
            return self.book.add_step("time", text, name, rest / fast, SECONDS)
        later = self.setting.time - self.burn.until
        falls = later > self.book.value(fast) / self.book.value(g)
        root = Root(Power(fast, 2) - 2.0 * g * rest)
        which = "later of the two times, on the way down," if falls else "earlier of the two times, on the way up,"
        return self._fallen(name, distance, (fast + root if falls else fast - root) / g, which)

    def _fallen(self, name: Symbol, distance: Symbol, formula: Expression, which: str) -> Symbol:
        """Write the time since burnout at which the rocket has covered a distance, and return its symbol."""
        step = self.book.begin_step("time")
        law = step.law(distance, self._thrown(name))
        step.add_text(f"With its engine off {self.name} moves under gravity alone and has covered")
        step.add_text(
            f"the distance ${distance.latex()}$ when {law}. The {which} is {step.result(name, formula, SECONDS)}."
        )
        step.close()
        return name

    def _thrown(self, time: Expression) -> Expression:
        """Return the distance of the rocket from its start, m, at a time after burnout."""
        fast, high = self._at_end
        path = high + fast * time
        return path - HALF * self.gravity.expression() * Power(time, 2) if self.gravity else path

    @cached_property
    def remaining_mass(self) -> Expression:
        """Write the mass at the moment, kg, and return it."""
        moment = self.query.moment
        if isinstance(moment, AtStart):
            return self.lift_off_mass
        if isinstance(moment, BurnedOut) or self.is_burned_out:
            return self.dry_mass
        step, name = self.book.begin_step("mass"), self.book.fresh("m", r"\text{left}")
        formula = sum_terms(self.initial_mass, -multiply_factors(self.rate_of_burning, self.time))
        step.add_text(f"The mass of {self.name} is then {step.result(name, formula, KILOGRAMS, law=True)}.")
        step.close()
        return name

    def mass(self, body: str) -> Polynomial:
        """Return the mass of the rocket at the moment, in kg."""
        del body
        left = self.remaining_mass
        assert isinstance(left, Symbol)
        return Polynomial.from_expression(left)

    # ---- the motion

    def _path(self, left: Expression, time: Expression) -> Expression:
        """Return the distance covered in the burn: u t − (u m/µ) ln(m₀/m) − ½ g t²."""
        u, log = self.exhaust, Call("ln", ratio(self.lift_off_mass, left))
        path = sum_terms(
            multiply_factors(u, time), -multiply_factors(ratio(multiply_factors(u, left), self.rate_of_burning), log)
        )
        fall = self.gravity.scale(-0.5).expression()
        return sum_terms(path, multiply_factors(fall, Power(time, 2)) if self.gravity else NIL.expression())

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return the acceleration, velocity or displacement of the rocket along its line."""
        del k
        if kind == "a":
            return Polynomial.from_expression(self._a)
        return Polynomial.from_expression(self._v if kind == "v" else self._s)

    @cached_property
    def _a(self) -> Symbol:
        if self.is_burned_out:
            text, formula = "With its engine off, gravity alone acts:", -self.gravity.expression()
            return self.book.add_step("newton", text, self.book.fresh("a"), formula, ACCELERATION)
        thrust, name = self.book.fresh("F"), self.book.fresh("a")
        force = multiply_factors(self.rate_of_burning, self.exhaust)
        left = self.remaining_mass
        step = self.book.begin_step("newton")
        step.add_text(f"The thrust is {step.result(thrust, force, NEWTONS, law=True)}.")
        formula = sum_terms(ratio(thrust, left), -self.gravity.expression())
        step.add_text(f"So {step.result(name, formula, ACCELERATION, law=True)}.")
        step.close()
        return name

    @cached_property
    def _at_end(self) -> tuple[Symbol, Symbol]:
        """Write the speed and the distance at burnout, and return their symbols."""
        mark = r"\text{out}"
        return self._burnt(self.ascent_duration, "v", mark), self._write_ascent_distance(self.ascent_duration, mark)

    def _burnt(self, risen: Expression, base: str, mark: str, before: str = "") -> Symbol:
        """Write the speed after an ascent of duration `risen` with the engine on; return its symbol."""
        left = self.dry_mass if self.is_burned_out else self.remaining_mass
        formula = self.exhaust * Call("ln", ratio(self.lift_off_mass, left))
        if self.gravity:
            formula = formula - self.gravity.expression() * risen
        when = "at burnout is" if mark else f"at ${self.time.name}$ is" if self.is_burned_out else "is then"
        text = f"{before}{self.rocket_equation}, the velocity {when}"
        return self.book.add_step("velocity", text, self.book.fresh(base, mark), formula, SPEED)

    def _write_ascent_distance(self, risen: Expression, mark: str) -> Symbol:
        """Write the distance covered in an ascent of duration `risen` with the engine on; return its symbol."""
        left = self.dry_mass if self.is_burned_out else self.remaining_mass
        path, by_then = self._path(left, risen), " by burnout" if mark else ""
        text = f"{self.course}. {self.integrated(left, risen)} So the distance covered{by_then} is"
        return self.book.add_step("distance", text, self.book.fresh("s", mark), path, METRES)

    @cached_property
    def _v(self) -> Symbol:
        if not self.is_burned_out:
            return self._burnt(self._now, "v", "")
        if self.gravity and isinstance(self.query.moment, AtTime):
            text = "" if self.write_burnout(self.time) else self.assumed_at(self.time)
            speed, risen = self._burnt(self._risen(self.time), "v", "", text), self._risen(self.time)
            if not self.mechanism.attractions:
                self.write_when_known(
                    lambda: tell_in_the_air(self, speed, risen), speed, risen, self.dry_mass, self.exhaust
                )
            return speed
        fast = self._at_end[0]
        if not self.gravity:
            return fast
        text, formula = "Its velocity is then", fast - self.gravity.expression() * self.coast
        return self.book.add_step("velocity", text, self.book.fresh("v"), formula, SPEED)

    @cached_property
    def _s(self) -> Symbol:
        if isinstance(self.query.moment, Moved) and not isinstance(self.query, StretchQuery):
            _ = self.time
            return Symbol(next(iter(self.book.stated)))
        if not self.is_burned_out:
            return self._write_ascent_distance(self._now, "")
        name, (fast, high) = self.book.fresh("s"), self._at_end
        if isinstance(self.query.moment, Stopped) or isinstance(self.query, StretchQuery):
            text, fall = f"With its engine off {self.name} rises on to", 2.0 * self.gravity.expression()
            if isinstance(self.query.moment, Stopped):
                powered = "While the engine is on after lift-off, the thrust exceeds the weight, so the speed grows and"
                text = f"{powered} {self.name} can come to rest only after burnout. {text}"
            return self.book.add_step("distance", text, name, high + Power(fast, 2) / fall, METRES)
        text = "height above the ground" if self.gravity else "distance from its starting point"
        return self.book.add_step("distance", f"Its {text} is then", name, self._thrown(self.coast), METRES)

    @property
    def _now(self) -> Expression:
        """Return the time from lift-off to the moment of the question, at most to burnout, s."""
        return self.ascent_duration if isinstance(self.query.moment, BurnedOut) else self._risen(self.time)

    def component(self, kind: str, body: str, way: Vector) -> Polynomial:
        """Return the component of a vector of the rocket along a direction."""
        axis = self.mechanism.coordinates[0].axis
        along = sum(a * b for a, b in zip(axis, way, strict=True))
        return self.rate(kind, 0).scale(round(along)) if abs(along) > 0.5 and body == self.burn.body else NIL


def _tops(setting: ProblemContext) -> bool:
    """Return whether a greatest displacement or height is asked for, of a rocket that falls again at the end."""
    query = setting.query
    asks_greatest = isinstance(query, StretchQuery) and query.functional in ("greatest displacement", "greatest height")
    return asks_greatest and float(setting.motion.state(np.array([setting.time])).v[0, 0]) < 0.0
