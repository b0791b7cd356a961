"""Kepler orbits: the ellipse of a light body about a fixed centre, and its position at a given time.

The variable is the increase of the eccentric anomaly, η = E − E₀. With p = e cos E₀ = 1 − r₀/a and
q = e sin E₀ = r₀·v₀/√(µa), Kepler's equation reads n t = η − p sin η + q (1 − cos η), and the position is
c₁ r₀ + c₂ v₀ with Lagrange's coefficients (Bate, Mueller and White, *Fundamentals of Astrodynamics*, 4.4).
"""

from collections.abc import Callable
from math import cos, pi, sin

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.vectors import subtract_triples
from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root, sum_of_squares, vector_length
from sim2reason.solutions.algebra.root_finding import SMALLEST, root_sentence
from sim2reason.solutions.fields.initial_anomaly import InitialAnomaly
from sim2reason.solutions.laws.dynamics import gravitational_constant
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.writing.lexicon import DualValue
from sim2reason.solutions.writing.notation import ANGULAR_SPEED, METRES, RADIANS, SECONDS, latex
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, UnsolvedError, record_inequality

PARAMETER, AREAL, AREA = latex("m^3/s^2"), latex("m^2/s"), latex("m^2")
ROUNDS, PIECES = 60, 720
TWO, HALF = Number(2.0), Number(0.5)


class KeplerOrbit:
    """The elliptic orbit of one body, whose elements are written as they are needed."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder, body: str, center: str, *, alone: bool) -> None:
        """Read the initial state; with `alone`, there is no other orbit, so that names need no label of the body."""
        self.setting, self.book, self.body, self.center = setting, book, body, center
        self._mark = "" if alone else setting.subscript_of(body)
        lexicon = setting.lexicon
        sides = [(m, initial_frames(m)) for m in (lexicon.mechanism, lexicon.twin)]
        places = [subtract_triples(f.center(body).place, f.center(center).place) for _, f in sides]
        self.numbers = [lexicon.mechanism.number[c.name] for c in lexicon.mechanism.body[body].coordinates]
        rates = [[m.coordinates[k].speed for k in self.numbers] for m, _ in sides]
        axis = [[abs(part) > 0.5 for part in lexicon.mechanism.coordinates[k].axis].index(True) for k in self.numbers]
        self.place = [lexicon.read(DualValue(float(places[0][n]), float(places[1][n]))).expression() for n in axis]
        self.rate = [lexicon.read(DualValue(*pair)).expression() for pair in zip(*rates, strict=True)]
        masses = [m.body[center].mass for m, _ in sides]
        self._heavy = lexicon.read(DualValue(masses[0], masses[1])).expression()

    def named(self, base: str, mark: str = "") -> Symbol:
        """Return a new symbol, labelled with the body if there are several orbits."""
        return self.book.fresh(base, ",".join(part for part in (mark, self._mark) if part))

    # ---- the ellipse

    @cached_property
    def parameter(self) -> Symbol:
        """Return µ = G M, the gravitational constant times the central mass."""
        constant = gravitational_constant(self.book, self.setting.mechanism.attractions[0].constant)
        return self.book.add_step("parameter", "Let", self.named(r"\mu"), constant * self._heavy, PARAMETER)

    @cached_property
    def radius(self) -> Symbol:
        """Return the initial distance from the central body, m."""
        formula = vector_length(self.place)
        text = f"The initial distance of {self.setting.display_name(self.body)} is"
        return self.book.add_step("distance", text, self.named("r", "0"), formula, METRES)

    @cached_property
    def axis(self) -> Symbol:
        """Return the semi-major axis, from the energy; UnsolvedError if the orbit is no ellipse."""
        square = sum_of_squares(self.rate)
        formula = ONE / (TWO / self.radius - square / self.parameter)
        if self.book.value(formula) <= 0.0:
            raise UnsolvedError("its orbit is no ellipse")
        step, name = self.book.begin_step("energy"), self.named("a")
        energy = HALF * square - self.parameter / self.radius
        law = step.law(energy, -(self.parameter / (TWO * name)))
        step.add_text(f"The energy per unit mass gives the semi-major axis ${name.name}$: {law},")
        step.add_text(f"so {step.result(name, formula, METRES)}.")
        step.close()
        return name

    @cached_property
    def period(self) -> Symbol:
        """Return the period by Kepler's third law."""
        formula = TWO * PI * Root(Power(self.axis, 3) / self.parameter)
        return self.book.add_step("period", "By Kepler's third law, the period is", self.named("T"), formula, SECONDS)

    @cached_property
    def mean_motion(self) -> Symbol:
        """Return the mean motion √(µ/a³)."""
        formula = Root(self.parameter / Power(self.axis, 3))
        return self.book.add_step("mean motion", "The mean motion is", self.named("n"), formula, ANGULAR_SPEED)

    @cached_property
    def position_dot_velocity(self) -> Expression:
        """Return r₀·v₀, the scalar product of initial position and initial velocity."""
        return self.place[0] * self.rate[0] + self.place[1] * self.rate[1]

    @cached_property
    def momentum(self) -> Symbol:
        """Return the angular momentum per unit mass, positive about z."""
        formula = self.place[0] * self.rate[1] - self.place[1] * self.rate[0]
        text = f"The angular momentum per unit mass about {self.setting.display_name(self.center)} is"
        return self.book.add_step("angular momentum", text, self.named("h"), formula, AREAL)

    @cached_property
    def e_cos_anomaly(self) -> Symbol:
        """Return the symbol of e cos E₀, where E₀ is the initial eccentric anomaly."""
        E, e, a, star = (
            self.anomaly.latex(),
            self.eccentricity_symbol.latex(),
            self.axis,
            self.setting.display_name(self.center),
        )
        text = rf"The distance from {star} is ${a.latex()} \left(1 - {e} \cos {E}\right)$, so the initial value of"
        return self.book.add_step("anomaly", rf"{text} ${e} \cos {E}$ is", self.named("p"), ONE - self.radius / a)

    @cached_property
    def anomaly(self) -> Symbol:
        """Write the definition of the eccentric anomaly and return its symbol."""
        step, name = self.book.begin_step("names"), self.named("E")
        whose = f" of {self.setting.display_name(self.body)}" if self._mark else ""
        step.add_text(f"Let ${name.latex()}$ be the eccentric anomaly{whose}, zero at the nearest point,")
        step.add_text(f"and ${self.eccentricity_symbol.latex()}$ the eccentricity.")
        step.close()
        return name

    @cached_property
    def e_sin_anomaly(self) -> Expression:
        """Return e sin E₀, where E₀ is the initial eccentric anomaly."""
        if self.position_dot_velocity == ZERO:
            return ZERO  # the start is an apsis
        E, e, root = self.anomaly.latex(), self.eccentricity_symbol.latex(), Root(self.parameter * self.axis)
        text = rf"The distance times the radial velocity is ${root.latex()}\,{e} \sin {E}$, so the initial value of"
        return self.book.add_step(
            "anomaly", rf"{text} ${e} \sin {E}$ is", self.named("q"), self.position_dot_velocity / root
        )

    @cached_property
    def eccentricity_symbol(self) -> Symbol:
        """Return the symbol of the eccentricity, which need not have a value."""
        return self.named("e")

    @cached_property
    def eccentricity(self) -> Symbol:
        """Return the eccentricity, from energy and angular momentum."""
        formula = Root(ONE - Power(self.momentum, 2) / (self.parameter * self.axis))
        return self.book.add_step("eccentricity", "The eccentricity is", self.eccentricity_symbol, formula)

    def apsis(self, *, far: bool) -> Symbol:
        """Return the greatest or the least distance from the central body."""
        e, which = self.eccentricity, "greatest" if far else "least"
        formula = self.axis * (ONE + e if far else ONE - e)
        return self.book.add_step("apsis", f"The {which} distance is", self.named("r"), formula, METRES)

    def write_approach(self, *, far: bool) -> None:
        """Write that the body reaches an apsis within half a turn, if it initially moves towards it."""
        if (
            self.position_dot_velocity == ZERO
            or self.book.is_hidden(self.position_dot_velocity)
            or (self._at(self.position_dot_velocity) > 0.0) != far
        ):
            return
        step = self.book.begin_step("extreme")
        text, which = capitalized(self._radial(step)), "greatest" if far else "least"
        step.add_text(f"{text}, so within half a turn it comes to the {which} distance.")
        step.close()

    # ---- how far it has come

    def to_time(self, time: Expression) -> Symbol:
        """Write Kepler's equation, and return the increase of the eccentric anomaly up to a time, in radians."""
        p, q, n, name = self.e_cos_anomaly, self.e_sin_anomaly, self.mean_motion, self.named(r"\eta")
        right = self._grown(name)
        near = _rising(lambda x: x - self._at(p) * sin(x) + self._at(q) * (1.0 - cos(x)) - self._at(n * time))
        step = self.book.begin_step("Kepler's equation")
        law = step.law(n * time, right)
        step.add_text(f"{self._mean(name)}, so {law}.")
        step.add_text(
            root_sentence(self.book, step, name, right - n * time, near, RADIANS, "The numerical solution is")
        )
        step.close()
        return name

    def time(self, grown: Expression) -> Symbol:
        """Return the time at which the eccentric anomaly has increased by an angle."""
        if grown == TWO * PI:
            return self.period
        if grown == PI:
            text = "From one end of the major axis to the other it takes half a period,"
            return self.book.add_step("time", text, self.named("t"), HALF * self.period, SECONDS)
        formula = self._grown(grown) / self.mean_motion
        return self.book.add_step("time", f"{self._mean(grown)}, so the time is", self.named("t"), formula, SECONDS)

    def _mean(self, angle: Expression) -> str:
        """Return sentences with Kepler's equation and the change of e sin E while E increases by an angle."""
        E, product = self.anomaly.latex(), rf"{self.eccentricity_symbol.latex()} \sin {self.anomaly.latex()}"
        grown = self.e_cos_anomaly * Call("sin", angle) + self.e_sin_anomaly * Call("cos", angle)
        text = (
            rf"By Kepler's equation, ${E} - {product}$ increases at the rate ${self.mean_motion.latex()}$. When ${E}$"
        )
        text = (
            f"{text} has increased by ${angle.latex()}$, ${product}$ has changed from ${self.e_sin_anomaly.latex()}$ to"
        )
        return f"{text} ${grown.latex()}$"

    def _grown(self, angle: Expression) -> Expression:
        """Return by how much the mean anomaly increases when the eccentric anomaly increases by an angle."""
        return angle - self.e_cos_anomaly * Call("sin", angle) + self.e_sin_anomaly * (ONE - Call("cos", angle))

    def to_apsis(self, *, far: bool) -> Expression:
        """Return the increase of the eccentric anomaly up to the next perihelion or aphelion, in radians."""
        if self.position_dot_velocity == ZERO:
            begins_far = self._at(self.e_cos_anomaly) < 0.0
            return TWO * PI if begins_far == far else PI
        begins = self._begins
        turn = PI if far else TWO * PI if self._at(begins) > 0.0 else ZERO
        formula = turn - begins
        where = "farthest from" if far else "nearest to"
        which, E = r"180^\circ" if far else "0" if turn == ZERO else r"360^\circ", self.anomaly.latex()
        body, center = self.setting.display_name(self.body), self.setting.display_name(self.center)
        text = f"{capitalized(body)} is next {where} {center}"
        text = f"{text} where ${E}$ is ${which}$, so ${E}$ has increased by"
        return self.book.add_step("apsis", text, self.named(r"\eta"), formula, RADIANS)

    @cached_property
    def _begins(self) -> Symbol:
        """Return the initial eccentric anomaly."""
        p, q = self.e_cos_anomaly, self.e_sin_anomaly
        initial_anomaly = InitialAnomaly(self.book, p, q, ONE - self.radius / self.axis, self._radial)
        return initial_anomaly.write(self.named("E", "0"), self.anomaly)

    def _radial(self, step: StepBuilder) -> str:
        """Return a clause that the body initially recedes or approaches, with a comparison if numbers are known."""
        recedes = self._at(self.position_dot_velocity) > 0.0
        text = f"{self.setting.display_name(self.body)} at first {'recedes' if recedes else 'approaches'}"
        (x, y), (u, v) = self.place, self.rate
        if self.book.is_hidden(self.position_dot_velocity):
            return text
        record_inequality(
            self.book, step, *((self.position_dot_velocity, ZERO) if recedes else (ZERO, self.position_dot_velocity))
        )
        return f"{text} (${(x * u + y * v).latex()} {'>' if recedes else '<'} 0$)"

    def to_distance(self, distance: Symbol) -> Symbol:
        """Write the increase of the eccentric anomaly, in radians, until the body is at a distance from its start."""
        name = self.named(r"\eta")
        square = self._away(name)
        level = self.book.value(distance) ** 2
        near = _rising(lambda x: square.value({**self.book.values, name.name: x}).real - level)
        step = self.book.begin_step("distance")
        law = step.law(square, Power(distance, 2))
        who = capitalized(self.setting.display_name(self.body))
        step.add_text(
            f"{self._lagrange(name)} {who} is at the distance ${distance.latex()}$ from its starting point when"
        )
        residual = square - Power(distance, 2)
        step.add_text(f"{law}.", root_sentence(self.book, step, name, residual, near, RADIANS, SMALLEST))
        step.close()
        return name

    def farthest(self) -> Symbol:
        """Return the greatest distance from the start, where displacement and velocity are perpendicular."""
        name, angle = self.named("d"), self.named(r"\eta")
        if self.position_dot_velocity == ZERO:
            text = "It starts at an end of the major axis, and the other end is farthest away:"
            return self.book.add_step("distance", text, name, TWO * self.axis, METRES)
        sine, cosine = Call("sin", angle), Call("cos", angle)
        turned = (self.radius / self.axis * cosine + self.e_sin_anomaly * sine) / self.mean_motion
        less, more = self.weights(angle)
        both = list(zip(self.place, self.rate, strict=True))
        ways = [less * position + more * rate for position, rate in both]
        rates = [turned * rate - self.axis / self.radius * sine * position for position, rate in both]
        residual = ways[0] * rates[0] + ways[1] * rates[1]
        square = self._away(angle)
        angles = (2.0 * pi * (number + 0.5) / PIECES for number in range(PIECES))
        there = max(angles, key=lambda x: square.value({**self.book.values, angle.name: x}).real)
        near = NumericRoot(residual, angle.name, there).value(self.book.values).real
        step = self.book.begin_step("farthest")
        law = step.law(residual, ZERO)
        step.add_text(f"{self._lagrange(angle)} It is perpendicular to the velocity if {law}.")
        step.add_text(root_sentence(self.book, step, angle, residual, near, RADIANS, "The numerical solution is"))
        step.close()
        return self.book.add_step("distance", "There the distance is", name, Root(square), METRES)

    def _lagrange(self, angle: Expression) -> str:
        """Return a sentence with the displacement after the eccentric anomaly has increased by an angle."""
        less, more = self.weights(angle)
        text = f"When ${self.anomaly.latex()}$ has increased by ${angle.latex()}$, the displacement is, by Lagrange's"
        text = f"{text} formulas, the sum of the initial position times ${less.latex()}$ and the initial velocity times"
        return f"{text} ${more.latex()}$."

    def _away(self, angle: Expression) -> Expression:
        """Return the squared distance from the start after the eccentric anomaly has increased by an angle."""
        less, more = self.weights(angle)
        return sum_of_squares(
            [less * position + more * rate for position, rate in zip(self.place, self.rate, strict=True)]
        )

    def weights(self, angle: Expression) -> tuple[Expression, Expression]:
        """Return the coefficients of initial position and velocity in Lagrange's formula for the displacement."""
        rest = ONE - Call("cos", angle)
        ahead = (self.radius / self.axis * Call("sin", angle) + self.e_sin_anomaly * rest) / self.mean_motion
        return -(self.axis / self.radius * rest), ahead

    def _at(self, held: Expression) -> float:
        return self.book.value(held)


def _rising(residual: Callable[[float], float]) -> float:
    """Return the first positive zero, in radians, of a function of an angle that is negative at zero."""
    step, low = 0.01, 0.0
    while residual(low + step) < 0.0:
        low += step
        if low > 40.0 * pi:
            raise UnsolvedError("it never comes so far")
    high = low + step
    for _ in range(ROUNDS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if residual(middle) < 0.0 else (low, middle)
    return high
