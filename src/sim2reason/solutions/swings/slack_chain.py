"""The phases of a bob whose string goes slack: circle, projectile, circle again."""

from dataclasses import dataclass
from math import cos

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.simulation.trace import Event
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol, ratio
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root, sum_of_squares
from sim2reason.solutions.setting import ProblemContext, capitalized, join_words
from sim2reason.solutions.swings.pendulum import SwingState
from sim2reason.solutions.swings.times import SwingTime
from sim2reason.solutions.writing.notation import DEGREES, METRES, SECONDS, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder

CIRCLE, TANGENT = "circle", "perpendicular"
HALF, TWO, THREE, FOUR = Number(0.5), Number(2.0), Number(3.0), Number(4.0)
EVENT_TIME_RTOL = 1e-9  # relative tolerance of times of one event
ON_CIRCLE = "is on its circle, the string taut"
FREE_FLIGHT_PHRASE = "flies freely, the string slack"


@dataclass(frozen=True, slots=True)
class MotionState:
    """A position with the velocity there: components, and the speed, with any sign, if it has a symbol."""

    x: Expression
    y: Expression
    vx: Expression
    vy: Expression
    speed: Expression | None = None


class SlackSwingPhases:
    """All phases up to the moment of the question, each written when the next one needs it."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Read the parameters; raise UnreadError if one is not a simple function of the numbers in the text."""
        self.setting, self.book = setting, book
        self.swing = SwingState(setting, book)
        self.length, self.gravity = self.swing.length, self.swing.gravity
        self.side = self._side()
        self.who = setting.display_name(self.swing.body)

    # ---- which phases there are

    @cached_property
    def changes(self) -> list[Event]:
        """Return the events, up to the moment, at which the string goes slack or taut."""
        limit = self.setting.time * (1.0 + EVENT_TIME_RTOL)
        return [e for e in self.setting.motion.events if e.kind in ("slack", "taut") and 0.0 < e.time <= limit]

    @cached_property
    def slack_at_once(self) -> bool:
        """Return whether the string is slack at the start: the bob is above the fixed point and slow."""
        swing = self.swing
        g, ell, v = (self.book.value(part) for part in (self.gravity, self.length, swing.launch))
        return v**2 + g * ell * cos(swing.initial_angle_value) < 0.0

    def _side(self) -> float:
        """Return the sign of x, by the engine, where the string first goes slack, or at the start if it stays taut."""
        slack = [event.time for event in self.changes if event.kind == "slack"]
        return 1.0 if self._engine_states(slack[0] if slack and not self.slack_at_once else 0.0)[0] >= 0.0 else -1.0

    def _engine_states(self, time: float) -> tuple[float, float, float]:
        """Return the engine's x from the fixed point and its velocity along x and y at a time, for signs alone."""
        m = self.setting.mechanism
        state = self.setting.study.trace.sample(np.array([time]))
        center, number = state.frames.center(self.swing.body), m.line[self.swing.line or ""].through
        fixed = next(m.site[site].at for site in number if m.site[site].body is None)
        x, vx, vz = (float(np.ravel(p)[0]) for p in (center.place[0], center.velocity[0], center.velocity[2]))
        return x - fixed[0], vx, vz

    def sign(self, time: float, of: int) -> float:
        """Return the sign of the engine's x (0), or of the velocity along x (1) or y (2), at a time."""
        seen = self._engine_states(time)[of]
        return (1.0 if seen >= 0.0 else -1.0) * (1.0 if of == 2 else self.side)

    # ---- the start

    @cached_property
    def start(self) -> MotionState:
        """Return the initial position and velocity of the bob."""
        swing, ell = self.swing, self.length
        begins = self.sign(0.0, 0)
        sine = Call("sin", swing.initial_angle) if swing.initial_angle != ZERO else ZERO
        cosine = swing.cosine_first
        forward = -begins if sine != ZERO else self.sign(0.0, 1)
        vx, vy = swing.launch * cosine * forward, -(swing.launch * sine)
        return MotionState(ell * sine * begins, -(ell * cosine), vx, vy, swing.launch)

    def write_axes(self) -> None:
        """Write the origin and the directions of the coordinates."""
        side = "it begins" if self.slack_at_once else "the string goes slack"
        step = self.book.begin_step("names")
        step.add_text(
            f"Let $x$ and $y$ be counted from the fixed point, $x$ horizontally to the side on which {side}, $y$"
        )
        step.add_text("upward.")
        step.close()

    # ---- on the circle

    def goes_slack(self, start: MotionState, time: float) -> MotionState:
        """Write the position and velocity at which the string goes slack and return them."""
        book, ell, g = self.book, self.length, self.gravity
        y, v = book.fresh("y", r"\text{s}"), book.fresh("v", r"\text{s}")
        step = book.begin_step(CIRCLE)
        square = self.squared(start)
        law = step.law(Power(v, 2) / ell, g * y / ell)
        energy = step.law(Power(v, 2), square - TWO * g * (y - start.y))
        step.add_text(
            f"The string goes slack at the height ${y.latex()}$ above the fixed point, where the tension is zero"
        )
        step.add_text(f"and the component of gravity along the string alone is the centripetal acceleration: {law}.")
        step.add_text(f"Conservation of energy: {energy}.")
        height = ratio(square + TWO * g * start.y, THREE * g)
        step.add_text(f"Together, {step.result(y, height, METRES)} and {step.result(v, Root(g * y), SPEED)}.")
        if not book.is_hidden(y):
            step.add_text(f"As $0 < {y.latex()} < {ell.latex()}$, {self.who} gets there.")
        step.close()
        x = book.fresh("x", r"\text{s}")
        text = "Its horizontal distance from the fixed point is"
        book.add_step(CIRCLE, text, x, Root(Power(ell, 2) - Power(y, 2)), METRES)
        out = self.sign(time, 0)
        text = "Its velocity there is perpendicular to the string, which gives"
        vx = book.add_step(TANGENT, text, book.fresh("v", "x"), -(v * y / ell * out), SPEED)
        vy = book.add_step(TANGENT, text, book.fresh("v", "y"), v * x / ell, SPEED)
        return MotionState(x if out > 0.0 else -x, y, vx, vy, v)

    def squared(self, held: MotionState) -> Expression:
        """Return the square of the speed."""
        return sum_of_squares([held.vx, held.vy] if held.speed is None else [held.speed])

    # ---- in flight

    def is_taut_again(self, held: MotionState) -> tuple[Symbol, MotionState]:
        """Write the time of flight until the string is taut, and position and velocity just before; return both."""
        book, ell, g = self.book, self.length, self.gravity
        step, t = book.begin_step("taut"), book.fresh("t", r"\text{f}")
        across = held.x + held.vx * t
        up = held.y + held.vy * t - HALF * g * Power(t, 2)
        law = step.law(Power(across, 2) + Power(up, 2), Power(ell, 2))
        step.add_text(
            f"{capitalized(self.who)} now moves as a projectile. After a time ${t.latex()}$ the string is taut again:"
        )
        step.add_text(f"{law}.")
        if held == self.start:
            formula = TWO * (held.vy + Root(g * held.y - sum_of_squares([held.vx]))) / g
            why = "Since the velocity at first is perpendicular to the string, a quadratic equation is left"
        else:
            formula = FOUR * held.vy / g
            square = f"${g.latex()} {held.y.latex()}$"
            why = f"Since the velocity at first is perpendicular to the string and its square is {square},"
            why += f" only the terms in ${t.latex()}^3$ and ${t.latex()}^4$ are left"
        step.add_text(f"{why}: {step.result(t, formula, SECONDS)}.")
        step.close()
        return t, self.after(held, t, f"{capitalized(self.who)} is then at")

    def after(self, held: MotionState, t: Expression, said: str) -> MotionState:
        """Write the position and velocity after a free flight of duration `t` and return them."""
        book, g = self.book, self.gravity
        x = book.add_step("flight", said, book.fresh("x"), held.x + held.vx * t, METRES)
        y = book.add_step("flight", said, book.fresh("y"), held.y + held.vy * t - HALF * g * Power(t, 2), METRES)
        said = "Its vertical velocity is then"
        vy = book.add_step("flight velocity", said, book.fresh("v", "y"), held.vy - g * t, SPEED)
        return MotionState(x, y, held.vx, vy)

    def highest(self, held: MotionState) -> MotionState:
        """Write the highest point of the projectile and return its position and velocity."""
        book, g = self.book, self.gravity
        text = f"{capitalized(self.who)} now moves as a projectile. Where its vertical velocity is zero, its height is"
        y = book.add_step("top", text, book.fresh("y"), held.y + Power(held.vy, 2) / (TWO * g), METRES)
        return MotionState(held.x + held.vx * held.vy / g, y, held.vx, ZERO)

    # ---- the jerk

    def radial(self, held: MotionState) -> Symbol:
        """Write the velocity component along the string just before it becomes taut, and return its symbol."""
        text = "The jerk takes away the velocity along the string,"
        formula = (held.x * held.vx + held.y * held.vy) / self.length
        return self.book.add_step("jerk", text, self.book.fresh("w"), formula, SPEED)

    def write_jerk(self, held: MotionState) -> tuple[MotionState, Symbol]:
        """Write the velocity just after the jerk, along the circle; return it and the counter-clockwise speed."""
        book, ell = self.book, self.length
        text = "The jerk takes away the velocity along the string; the component perpendicular to it is"
        u = book.add_step("jerk", text, book.fresh("u"), (held.x * held.vy - held.y * held.vx) / ell, SPEED)
        vx, vy = -(u * held.y / ell), u * held.x / ell
        return MotionState(held.x, held.y, vx, vy, u), u

    # ---- later on the circle

    def turns(self, held: MotionState) -> MotionState:
        """Write the height at which the bob comes to rest on the circle and return the position."""
        book, ell = self.book, self.length
        text = "It turns back where all its kinetic energy is used up, at the height"
        y = book.add_step("turning", text, book.fresh("y"), held.y + self.squared(held) / (TWO * self.gravity), METRES)
        x: Expression = Root(Power(ell, 2) - Power(y, 2))
        return MotionState(x if self.sign(self.setting.time, 0) > 0.0 else -x, y, ZERO, ZERO, ZERO)

    def write_circular_motion(self, held: MotionState, times: SwingTime, t: Symbol) -> MotionState:
        """Write the position and velocity after a time on the circle and return them."""
        book, ell, when = self.book, self.length, self.setting.time
        begins = self.side if held.x == ZERO else self._sign_of(held.x)
        angle = times.angle(t)
        x, y = ell * Call("sin", angle) * begins, -(ell * Call("cos", angle))
        step, v = book.begin_step("energy"), book.fresh("v")
        square = self.squared(held) - TWO * self.gravity * (y - held.y)
        law = step.law(Power(v, 2), square)
        step.add_text(f"By conservation of energy, {law}, so {step.result(v, Root(square), SPEED)}.")
        step.close()
        across, outward, rises = (self.sign(when, n) for n in range(3))
        upper = book.value(y) > 0.0
        turns = across * rises if abs(book.value(x)) > abs(book.value(y)) else -outward if upper else outward
        return MotionState(x, y, -(v * y / ell * turns), v * x / ell * turns, v)

    def _sign_of(self, held: Expression) -> float:
        return 1.0 if self.book.value(held) > 0.0 else -1.0

    def times(self, held: MotionState, speed: Expression) -> SwingTime:
        """Return the relation between angle and time for a motion on the circle that begins at a position."""
        if held == self.start:
            return self.swing.times
        book, ell = self.book, self.length
        angle = self.angle(held, book.fresh(r"\phi"))
        size = book.magnitude(speed)
        outward = book.value(held.x) * book.value(speed) > 0.0
        return SwingTime(book, self.swing.small_oscillation_frequency, angle, size / ell, 1.0 if outward else -1.0)

    def angle(self, held: MotionState, name: Symbol) -> Symbol:
        """Write the magnitude of the angle of the string with the downward vertical and return its symbol."""
        x, y = self.book.value(held.x), self.book.value(held.y)
        formula: Expression = Call("arccos", -(held.y / self.length))
        if abs(x) < abs(y):
            slope = Call("arcsin", (held.x if x > 0.0 else -held.x) / self.length)
            formula = slope if y < 0.0 else PI - slope
        text = "The string then makes with the downward vertical the angle"
        return self.book.add_step("angle", text, name, formula, DEGREES)


def vector_magnitude(one: Expression, other: Expression) -> Expression:
    """Return the magnitude of a vector by its components; a single component keeps its sign."""
    return one + other if ZERO in (one, other) else Root(sum_of_squares([one, other]))


def change(book: SolutionBuilder, there: MotionState, start: MotionState) -> Expression:
    """Return the magnitude of the change of velocity between two states, with differences of positive sign."""
    pairs = ((there.vx, start.vx), (there.vy, start.vy))
    return vector_magnitude(*(one - two if book.value(one - two) >= 0.0 else two - one for one, two in pairs))


def write_velocities(book: SolutionBuilder, there: MotionState, start: MotionState, *, flies: bool) -> None:
    """Write the initial velocity and, in free flight, the final one, for the change of momentum."""
    step = book.begin_step("extreme")
    first = [f"${v.latex()}$ along {axis}" for v, axis in ((start.vx, "x"), (start.vy, "y")) if v != ZERO]
    step.add_text(f"The initial velocity is {join_words(first)}." if first else "")
    step.close()
    if flies:
        write_free_flight(book, there)


def write_free_flight(book: SolutionBuilder, there: MotionState) -> None:
    """Write that the horizontal velocity is constant in free flight, and the vertical one zero at the top."""
    step = book.begin_step("extreme")
    at = ", and the vertical one is zero at the highest point" if there.vy == ZERO else ""
    step.add_text(f"In free flight the horizontal velocity stays ${there.vx.latex()}${at}.")
    step.close()
