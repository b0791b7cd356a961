"""The angle of a swing on a carriage at the moment of the question, and the conserved quantities."""

from math import pi

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.times import AtStart
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, sum_of_squares
from sim2reason.solutions.oscillations.net_force import time_of_greatest
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.swings.angle import ANGLE_TOLERANCE, SwingAngle
from sim2reason.solutions.swings.carriage import Carriage
from sim2reason.solutions.writing.notation import DEGREES, METRES
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

TWO = Number(2.0)
REST_RATE = 1e-4  # rad/s, tolerance for times found by a search
SEARCH_TOLERANCE = 1e-3  # rad, tolerance for times found by a search


class CarriageAngle(SwingAngle):
    """The angle of an arm on a carriage, positive on its initial side, written as needed."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Read the parameters; raise UnreadError if one is not a simple function of the numbers in the text."""
        super().__init__(setting, book)
        self.carriage = Carriage(setting, book)
        self.arm = self.carriage.arm
        self.initial_angle, self.gravity = self.arm.initial_angle, self.arm.gravity
        self.initial_angle_value = book.value(self.initial_angle)
        query = setting.query
        searched = isinstance(query, StretchQuery) and query.kind == "extremum"
        moment = query.moment
        when = (
            time_of_greatest(setting)
            if searched
            else moment.evaluation_time(setting.time)
            if moment is not None
            else 0.0
        )
        self.moment_angle, self.turned, self.turning = self.arm.at(when)
        self.initial_rate_sign = -1.0
        self.begins = isinstance(moment, AtStart) or when == 0.0

    # ---- members of SwingAngle

    _far: Symbol | None = None  # the displacement of the carriage, if it is given
    _is_hanging_written = False

    @property
    def goes_round(self) -> bool:
        """Return False, since a swing from rest does not go round."""
        return False

    @property
    def is_at_rest(self) -> bool:
        """Return whether the arm is at rest relative to the carriage at the moment."""
        return abs(self.turning) <= REST_RATE

    @cached_property
    def small_oscillation_frequency(self) -> Symbol:
        """Raise UnsolvedError, since times have no closed form."""
        raise UnsolvedError("only integration gives the time")

    @cached_property
    def initial_angular_speed(self) -> Expression:
        """Return zero, since the arm begins at rest."""
        return ZERO

    @cached_property
    def angle(self) -> Expression:
        """Write the angle at the moment, if necessary, and return it."""
        moment = self.setting.query.moment
        if self.begins:
            return self.initial_angle
        if isinstance(moment, Moved) and not self.extreme:
            return self._where_moved(moment)
        return super().angle

    def _at_extreme(self) -> Expression:
        if abs(self.moment_angle) < SEARCH_TOLERANCE:
            self._tell_greatest()
            self._write_extreme(f"{self.swings} hangs straight down")
            return ZERO
        if not self.is_at_rest:
            raise UnsolvedError("the greatest value is taken somewhere on the way")
        self._write_extreme(f"{self.swings} turns back")
        return self._write_turning_angle()

    def _tell_greatest(self) -> None:
        """Write why the carriage is fastest where the arm hangs straight down."""
        if self.setting.query.subject not in self.carriage.moving_along or self.driving_force != ZERO:
            return
        step, angle, total = self.book.begin_step("extreme"), self.book.fresh(r"\varphi"), self.carriage.total_mass
        if self.is_single_body:
            inertia = self.carriage.sliding_mass + self.mass * Power(Call("sin", angle), 2)
        else:
            inertia = total * self.arm.inertia - Power(self.moment * Call("cos", angle), 2)
        fallen = Power(Call("cos", angle), 2) * (Call("cos", angle) - self.cosine_first)
        step.add_text(
            f"Where {self.swings} makes the angle ${angle.name}$ with the downward vertical, momentum and energy"
        )
        step.add_text(
            f"make the square of the speed of {self.carriage.noun} proportional to ${(fallen / inertia).latex()}$."
        )
        step.add_text(f"The numerator is greatest, and the denominator least, at ${angle.name} = 0$.")
        step.close()

    def _hanging(self) -> list[str]:
        """Return the sentences about bodies that hang from strings of the carriage, at the first call only."""
        sentences = [] if self._is_hanging_written else [*self.carriage.hanging_body_sentences()]
        self._is_hanging_written = True
        return sentences

    @property
    def swings(self) -> str:
        """Return the noun phrase of the arm, such as *the rod*."""
        return "the rod" if self.arm.carrier in self.arm.bodies else self.setting.display_name(self.arm.carrier)

    def _write_extreme(self, where: str) -> None:
        query = self.setting.query
        assert isinstance(query, StretchQuery)
        superlative, _, noun = query.functional.partition(" ")
        step = self.book.begin_step("extreme")
        whose = f" of {self.setting.display_name(query.subject)}" if noun in ("speed", "kinetic energy") else ""
        step.add_text(f"The {noun}{whose} is {superlative} where {where}.")
        step.close()

    def _write_extreme_position(self, quantity: str) -> None:
        """Write nothing, since the steps for the angle already give the position of the extreme value."""
        del quantity

    def _write_turning_angle(self) -> Expression:
        """Write the angle at which the arm turns back, symmetric about the effective gravity, and return it."""
        if abs(self.moment_angle - self.initial_angle_value) < SEARCH_TOLERANCE:
            return self.initial_angle
        if self.driving_force == ZERO:
            return -self.initial_angle
        tilt = self.book.fresh(r"\beta")
        formula = Call("arctan", self.driving_force / (self.carriage.total_mass * self.gravity))
        lead = "In the frame that accelerates along the rail with the common centre of mass,"
        text = " ".join([*self._hanging(), lead, "the effective gravity is tilted by the angle"])
        self.book.add_step("tilt", text, tilt, formula, DEGREES)
        text, turning_angle = (
            f"About this direction {self.swings} oscillates symmetrically, so it turns back at",
            self.initial_angle + TWO * tilt,
        )
        beyond = self.book.value(turning_angle) > 0.0  # on the other side of the lowest point
        name = self.book.add_step(
            "turning", text, self.book.fresh(r"\phi"), turning_angle if beyond else -turning_angle, DEGREES
        )
        return -name if beyond else name

    def _where_moved(self, moment: Moved) -> Expression:
        """Write the angle at which the carriage has moved a stated distance, and return its symbol."""
        if moment.name not in self.carriage.moving_along:
            raise UnsolvedError("only integration gives the time")
        self.unloaded()
        far, name = self.book.fresh("d"), self.book.fresh(r"\phi")
        self.book.state_given(far.name, moment.value, METRES)
        formula = Call("arcsin", self.sine_first - far * self.carriage.total_mass / self.moment)
        step = self.book.begin_step("place")
        gone = self.moment * (self.sine_first - Call("sin", name))
        law = step.law(self.carriage.total_mass * far, gone)
        step.add_text(
            f"Let ${name.name}$ be the angle of {self.swings} with the downward vertical at this moment, positive"
        )
        step.add_text("on the side on which it begins.")
        if self.initial_angle_value < 0.5 * pi and not self.book.in_symbols:
            start = self.initial_angle.latex()
            step.add_text(f"It rises no higher than at the start, so $|{name.name}| \\le {start} < 90^\\circ$.")
        text = "No external force acts along the rail, so the common centre of mass does not move along it:"
        step.add_text(f"{text} {law}, so {step.result(name, formula, DEGREES)}.")
        self._far = far
        step.close()
        if abs(self.book.values[name.name] - self.moment_angle) > ANGLE_TOLERANCE:
            raise UnsolvedError("the arm is above its axle")
        return name

    # ---- what does not change

    @property
    def driving_force(self) -> Expression:
        """Return the force along the rail, in N."""
        return self.carriage.driving_force

    def unloaded(self) -> None:
        """Raise UnsolvedError if a string pulls the carriage, since its motion then depends on the time."""
        if self.driving_force != ZERO:
            raise UnsolvedError("how fast and how far the carriage moves takes the time")

    @cached_property
    def is_single_body(self) -> bool:
        """Return whether one small body swings, for which the laws are shorter."""
        return self.carriage.is_single_body

    @cached_property
    def length(self) -> Expression:
        """Return the distance from the axle to the single body, m."""
        return self.arm.piece(self.arm.bodies[0]).place

    @cached_property
    def mass(self) -> Expression:
        """Return the swinging mass, in kg."""
        return self.carriage.swinging_mass

    @cached_property
    def moment(self) -> Expression:
        """Return Σ m r of the swinging bodies, with distances r from the axle, kg m."""
        return self.mass * self.length if self.is_single_body else self.arm.moment

    @property
    def sine_first(self) -> Expression:
        """Return the sine of the angle at the start."""
        return Call("sin", self.initial_angle) if self.initial_angle != ZERO else ZERO

    @property
    def signed_sine(self) -> Expression:
        """Return the sine of the angle at the moment, with its sign."""
        if self.sine == ZERO:
            return ZERO
        return self.sine if self.book.value(self.angle) >= 0.0 else -self.sine

    @cached_property
    def effective_inertia(self) -> Expression:
        """Return the effective inertia of the motion along the rail: M + m sin² φ, or (M + m) I − S² cos² φ."""
        across = sum_of_squares([self.sine])
        if self.is_single_body:
            return self.carriage.sliding_mass + self.mass * across
        return self.carriage.total_mass * self.arm.inertia - Power(self.moment * self.cosine, 2)
