"""Orbit: a light body around a fixed one, by energy, angular momentum and Kepler's laws."""

from collections.abc import Callable
from math import sqrt

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.angles import Orbited
from sim2reason.questions.moments.distances import Away, Closest, Farthest
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.quantities.subjects.interactions import members
from sim2reason.solutions.algebra.evaluated import QuadraticRoot
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root, sum_of_squares
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.fields.kepler import AREA, HALF, TWO, KeplerOrbit
from sim2reason.solutions.fields.orbit_place import OrbitPlace, PositionAfterTurn
from sim2reason.solutions.goals import GOALS, modulus
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.notation import METRES, PER_SECOND, SECONDS
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError


def given_apsis(orbit: KeplerOrbit, *, far: bool) -> Symbol:
    """Write the greatest or least distance of an orbit by energy conservation, linear in an unknown central mass."""
    book, mu, first = orbit.book, orbit.parameter, orbit.radius
    if book.in_symbols or not book.is_hidden(mu):
        return orbit.apsis(far=far)
    name, momentum, square = orbit.named("r"), orbit.momentum, sum_of_squares(orbit.rate)
    swift = book.magnitude(momentum) / name
    begun, there = square - TWO * mu / first, Power(swift, 2) - TWO * mu / name
    step, which = book.begin_step("apsis"), "greatest" if far else "least"
    law, star = step.law(begun, there), orbit.setting.display_name(orbit.center)
    step.add_text(
        f"At the {which} distance ${name.latex()}$ the velocity is perpendicular to the line to {star}, so by"
    )
    step.add_text(
        f"conservation of angular momentum its magnitude is ${swift.latex()}$. By conservation of energy, {law}."
    )
    step.result(name, QuadraticRoot(there - begun, name.name, _distance(orbit, far=far)), METRES)
    step.close()
    return name


def _distance(orbit: KeplerOrbit, *, far: bool) -> float:
    """Return the value, in m, of the greatest or least distance of an orbiting body from the central body."""
    mu, r, h, square = map(
        orbit.book.value, (orbit.parameter, orbit.radius, orbit.momentum, sum_of_squares(orbit.rate))
    )
    axis = 1.0 / (2.0 / r - square / mu)
    shift = sqrt(max(1.0 - h**2 / (mu * axis), 0.0))
    return axis * (1.0 + shift if far else 1.0 - shift)


class AtAnomaly(OrbitPlace):
    """The position after a known increase of the eccentric anomaly."""

    def __init__(
        self, orbit: KeplerOrbit, grown: Callable[[], Expression], radius: Callable[[], Symbol] | None = None
    ) -> None:
        """Take the increase of the anomaly, and `radius` if the distance is known without the anomaly."""
        super().__init__(orbit)
        self._grown, self._radius = grown, radius

    def _anomaly(self) -> Expression:
        """Return the known increase of the eccentric anomaly."""
        return self._grown()

    def _distance(self) -> Symbol:
        """Write the distance r = a (1 − e cos(E₀ + η)) after the increase η of the eccentric anomaly."""
        if self._radius is not None:
            return self._radius()
        orbit, angle = self.orbit, self.anomaly_increase
        near = ONE - orbit.e_cos_anomaly * Call("cos", angle) + orbit.e_sin_anomaly * Call("sin", angle)
        e = rf"${orbit.eccentricity_symbol.latex()} \cos {orbit.anomaly.latex()}$"
        grown = orbit.e_cos_anomaly * Call("cos", angle) - orbit.e_sin_anomaly * Call("sin", angle)
        text = f"There {e} is ${grown.latex()}$, so the distance from {self._star} is"
        return orbit.book.add_step("distance", text, orbit.named("r"), orbit.axis * near, METRES)

    @cached_property
    def _weights(self) -> dict[str, Symbol]:
        """Return names for Lagrange's four coefficients of initial position and velocity."""
        return {number: self.orbit.named("c", number) for number in "1234"}

    def _combined(self, numbers: str, axis: int) -> Expression:
        """Return a component of a vector: Lagrange's coefficients times initial position and velocity."""
        orbit, total = self.orbit, ZERO
        for number, part in zip(numbers, (orbit.place[axis], orbit.rate[axis]), strict=True):
            if part != ZERO:
                total = total + self._weight(number) * part
        return total

    def _weight(self, number: str) -> Symbol:
        """Write one of Lagrange's coefficients."""
        orbit, name = self.orbit, self._weights[number]
        if name.name in orbit.book.values:
            return name
        rest = ONE - Call("cos", self.anomaly_increase)
        if number in "12":
            formula = orbit.weights(self.anomaly_increase)[int(number) - 1]
        elif number == "3":
            swift = Root(orbit.parameter * orbit.axis) * Call("sin", self.anomaly_increase)
            formula = -(swift / (orbit.radius * self.radius))
        else:
            formula = ONE - orbit.axis / self.radius * rest
        vector, part = "displacement" if number in "12" else "velocity", "position" if number in "13" else "velocity"
        text = f"By Lagrange's formulas, the coefficient of the initial {part} in the {vector} is"
        unit = {"2": SECONDS, "3": PER_SECOND}.get(number, "")
        return orbit.book.add_step("weights", text, name, formula, unit)

    def _moved(self, axis: int) -> Expression:
        return self._combined("12", axis)

    def _rate(self, axis: int) -> Expression:
        return self._combined("34", axis)


MOMENTS = (AtTime, Away, Closest, Farthest, Orbited)
QUANTITIES = ("displacement", "velocity", "acceleration", "distance", "relative speed")
FUNCTIONALS = {
    "greatest speed": ("speed", False),
    "least speed": ("speed", True),
    "greatest acceleration": ("pull", False),
    "greatest distance": ("radius", True),
    "least distance": ("radius", False),
}  # the quantity, and whether it is taken at the far apsis
ALL_ROUND, QUARTER = 360, 90


@strategy
class Orbit(Strategy):
    """The strategy for a light body on an ellipse around a fixed one, at any moment."""

    name = "orbit"
    cost = 1.0
    kinds = frozenset({"state", "event", "time_to_event", "extremum", "period", "sum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        return "" if _by_itself(mechanism) else "no light body goes round a fixed one by itself"

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query = setting.query
        if isinstance(query, PeriodQuery):
            return "" if query.measure == "period" and not query.small else "no orbital period is asked for"
        if isinstance(query, StretchQuery):
            known = query.functional in (*FUNCTIONALS, "greatest displacement", "area swept")
            return "" if known else f"no way to the {query.functional}"
        if not isinstance(query.moment, MOMENTS):
            return f"no way to the moment {type(query.moment).__name__}"
        quantity = query.target.quantity if query.target is not None else ""
        return "" if quantity in ("", *QUANTITIES) else f"no way to the quantity {quantity}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the orbit, the position on it and the answer, and return the answer's symbol."""
        return _OnOrbit(setting, book).write().name


def _by_itself(m: Mechanism) -> bool:
    """Return whether every moving body is attracted by one fixed body, and by nothing else."""
    moving = [body.name for body in m.bodies if body.coordinates]
    pulls = {body: [pull for pull in m.attractions if body in (pull.a, pull.b)] for body in moving}
    other = m.lines or m.faces or m.forces or m.burns or m.meetings or m.feet
    level = all(c.kind == "slide" and abs(c.axis[2]) < 1e-9 for c in m.coordinates)
    flat = all(len(m.body[body].coordinates) == 2 for body in moving)
    lone = all(len(attractions) == 1 and attractions[0].power == 2.0 for attractions in pulls.values())
    fixed = all(len({pull.a, pull.b} & set(moving)) == 1 for pull in m.attractions)
    return bool(moving) and lone and fixed and level and flat and not other


class _OnOrbit(StraightMotion):
    """The quantities of bodies on orbits."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Take the problem and the solution builder; no orbit or position is written yet."""
        super().__init__(setting, book)
        self._orbits: dict[str, KeplerOrbit] = {}
        self._places: dict[str, OrbitPlace] = {}

    def write(self) -> Symbol:
        """Write the answer to the query and return the answer's symbol."""
        query, target = self.query, self.target
        if isinstance(query, PeriodQuery):
            return self.orbit(query.of[0]).period
        if isinstance(query, StretchQuery):
            return self._stretch(query)
        if target is None:
            return self.time
        lone = [body for body in self._members(target.subject) if self.mechanism.body[body].coordinates]
        if len(lone) == 1 and target.sense is None:
            direct = {"velocity": "speed", "acceleration": "pull", "distance": "radius"}.get(target.quantity)
            if direct is not None:
                symbol: Symbol = getattr(self.position_of(lone[0]), direct)
                return symbol
        return GOALS[target.quantity].write(target, self)

    @staticmethod
    def _members(subject: str) -> tuple[str, ...]:
        return members(subject) if " & " in subject else (subject,)

    def _moving(self, subject: str) -> str:
        moving = [body for body in self._members(subject) if self.mechanism.body[body].coordinates]
        if len(moving) != 1:
            raise UnsolvedError("two bodies that both move, each on its own ellipse")
        return moving[0]

    # ---- orbits and places

    def orbit(self, body: str) -> KeplerOrbit:
        """Return the orbit of a body."""
        if body not in self._orbits:
            pull = next(p for p in self.mechanism.attractions if body in (p.a, p.b))
            alone = sum(bool(candidate.coordinates) for candidate in self.mechanism.bodies) == 1
            center = pull.b if pull.a == body else pull.a
            self._orbits[body] = KeplerOrbit(self.setting, self.book, body, center, alone=alone)
        return self._orbits[body]

    @property
    def _mover(self) -> str:
        """Return the body whose motion defines the moment."""
        moment = self.query.moment
        assert isinstance(moment, Away | Closest | Farthest | Orbited)
        return self._moving(moment.name)

    def position_of(self, body: str) -> OrbitPlace:
        """Return the position of a body on its orbit at the moment."""
        if body not in self._places:
            by_time = isinstance(self.query.moment, AtTime) or self._mover != body
            orbit = self.orbit(body)
            self._places[body] = AtAnomaly(orbit, lambda: orbit.to_time(self.time)) if by_time else self._there
        return self._places[body]

    @cached_property
    def _there(self) -> OrbitPlace:
        """Return the position, at the moment, of the body whose motion defines the moment."""
        moment, orbit = self.query.moment, self.orbit(self._mover)
        if isinstance(moment, Away):
            distance = self.book.fresh("d")
            self.book.state_given(distance.name, moment.value, METRES)
            return AtAnomaly(orbit, lambda: orbit.to_distance(distance))
        if isinstance(moment, Orbited):
            if moment.degrees == ALL_ROUND:
                return AtAnomaly(orbit, lambda: TWO * PI, lambda: orbit.radius)
            return PositionAfterTurn(orbit, moment.degrees // QUARTER)
        far = isinstance(moment, Farthest)
        given = self.setting.stated is not None and self.target is not None and self.target.quantity == "distance"
        return AtAnomaly(
            orbit,
            lambda: orbit.to_apsis(far=far),
            lambda: given_apsis(orbit, far=far) if given else orbit.apsis(far=far),
        )

    @cached_property
    def time(self) -> Symbol:
        """Write the time of the moment, s, and return its symbol."""
        moment = self.query.moment
        if isinstance(moment, AtTime):
            name = self.book.fresh("t")
            self.book.state_given(name.name, moment.after, SECONDS)
            return name
        orbit = self.orbit(self._mover)
        if isinstance(moment, Orbited) and moment.degrees == ALL_ROUND:
            return orbit.period
        return orbit.time(self._there.anomaly_increase)

    def _stretch(self, query: StretchQuery) -> Symbol:
        body = self._moving(query.name)
        orbit = self.orbit(body)
        if query.functional == "area swept":
            swift = modulus(orbit.momentum, self.book, of_either_sign=True)
            text = (
                "The area swept out per unit of time is half the magnitude of the angular momentum per unit mass, so in"
            )
            round_once = isinstance(query.moment, Orbited) and query.moment.degrees == ALL_ROUND
            text = f"{text} {'one period' if round_once else 'this time'} it is"
            return orbit.book.add_step("area", text, orbit.named("A"), HALF * swift * self.time, AREA)
        if query.functional == "greatest displacement":
            return orbit.farthest()
        which, far = FUNCTIONALS[query.functional]
        part = isinstance(query.moment, Orbited) and query.moment.degrees < ALL_ROUND
        if part or isinstance(query.moment, Farthest | Closest):
            orbit.write_approach(far=far)
        if which in ("speed", "pull"):
            step, where = self.book.begin_step("extreme"), "greatest" if far else "least"
            superlative, why = query.functional.partition(" ")[0], "the inverse-square law"
            why, what = ("conservation of energy", "speed") if which == "speed" else (why, "acceleration")
            step.add_text(f"By {why}, the {what} is {superlative} at the {where} distance.")
            step.close()
        given = self.setting.stated is not None and which == "radius"
        at = AtAnomaly(
            orbit,
            lambda: orbit.to_apsis(far=far),
            lambda: given_apsis(orbit, far=far) if given else orbit.apsis(far=far),
        )
        symbol: Symbol = getattr(at, which)
        return symbol

    # ---- for goals

    @property
    def newton(self) -> Newton:
        """Raise UnsolvedError, since the mass of the orbiting body is not given."""
        raise UnsolvedError("the mass of what is attracted is not said")

    def force(self, kind: str, name: str) -> Symbol:
        """Raise UnsolvedError, since no contact or string exerts a force."""
        raise UnsolvedError(f"no {kind} of {name}")

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return a component of a displacement, velocity or acceleration."""
        body = self.mechanism.coordinates[k].body
        if not self.mechanism.body[body].coordinates:
            return NIL
        axis = self.orbit(body).numbers.index(k)
        component: Expression = self.position_of(body).component(kind, axis)
        return Polynomial.from_expression(component)
