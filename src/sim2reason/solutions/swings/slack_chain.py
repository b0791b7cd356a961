"""The phases of a bob whose string goes slack: circle, projectile, circle again."""

from dataclasses import dataclass
from math import cos

import numpy as np

from sim2reason.base.lazy import cached_property
from sim2reason.simulation.trace import Event
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol, ratio
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root, squares
from sim2reason.solutions.setting import Setting, capital, joined
from sim2reason.solutions.swings.state import SwingState
from sim2reason.solutions.swings.times import SwingTime
from sim2reason.solutions.writing.steps import Book
from sim2reason.solutions.writing.unit_latex import DEGREES, METRES, SECONDS, SPEED

CIRCLE, TANGENT = "circle", "perpendicular"
HALF, TWO, THREE, FOUR = Number(0.5), Number(2.0), Number(3.0), Number(4.0)
AT_ONCE = 1e-9  # relative tolerance of times of one event
ON_CIRCLE = "is on its circle, the string taut"
FLIES = "flies freely, the string slack"


@dataclass(frozen=True, slots=True)
class Instant:
    """A position with the velocity there: components, and the speed, with any sign, if it has a symbol."""

    x: Expression
    y: Expression
    vx: Expression
    vy: Expression
    speed: Expression | None = None


class SlackChain:
    """All phases up to the moment of the question, each written when the next one needs it."""

    def __init__(self, setting: Setting, book: Book) -> None:
        """Read the parameters; raise UnreadError if one is not a simple function of the numbers in the text."""
        self.setting, self.book = setting, book
        self.swing = SwingState(setting, book)
        self.length, self.gravity = self.swing.length, self.swing.gravity
        self.side = self._side()
        self.who = setting.called(self.swing.body)

    # ---- which phases there are

    @cached_property
    def changes(self) -> list[Event]:
        """Return the events, up to the moment, at which the string goes slack or taut."""
        limit = self.setting.time * (1.0 + AT_ONCE)
        return [e for e in self.setting.motion.events if e.kind in ("slack", "taut") and 0.0 < e.time <= limit]

    @cached_property
    def slack_at_once(self) -> bool:
        """Return whether the string is slack at the start: the bob is above the fixed point and slow."""
        held = self.swing
        g, ell, v = (self.book.value(part) for part in (self.gravity, self.length, held.launch))
        return v**2 + g * ell * cos(held.began) < 0.0

    def _side(self) -> float:
        """Return the sign of the engine's x on the side on which the string first goes slack, 1 if it never does."""
        slack = [event.time for event in self.changes if event.kind == "slack"]
        return 1.0 if self._seen(slack[0] if slack and not self.slack_at_once else 0.0)[0] >= 0.0 else -1.0

    def _seen(self, time: float) -> tuple[float, float, float]:
        """Return the engine's x from the fixed point and its velocity along x and y at a time, for signs alone."""
        m = self.setting.mechanism
        state = self.setting.study.trace.sample(np.array([time]))
        center, number = state.frames.center(self.swing.body), m.line[self.swing.line or ""].through
        fixed = next(m.site[site].at for site in number if m.site[site].body is None)
        x, vx, vz = (float(np.ravel(p)[0]) for p in (center.place[0], center.velocity[0], center.velocity[2]))
        return x - fixed[0], vx, vz

    def sign(self, time: float, of: int) -> float:
        """Return the sign of the engine's x (0), or of the velocity along x (1) or y (2), at a time."""
        seen = self._seen(time)[of]
        return (1.0 if seen >= 0.0 else -1.0) * (1.0 if of == 2 else self.side)

    # ---- the start

    @cached_property
    def start(self) -> Instant:
        """Return the initial position and velocity of the bob."""
        held, ell = self.swing, self.length
        begins = self.sign(0.0, 0)
        sine = Call("sin", held.first) if held.first != ZERO else ZERO
        cosine = held.cosine_first
        forward = -begins if sine != ZERO else self.sign(0.0, 1)
        vx, vy = held.launch * cosine * forward, -(held.launch * sine)
        return Instant(ell * sine * begins, -(ell * cosine), vx, vy, held.launch)

    def tell_axes(self) -> None:
        """Write the origin and the directions of the coordinates."""
        side = "it begins" if self.slack_at_once else "the string goes slack"
        step = self.book.open("names")
        step.say(f"Let $x$ and $y$ be counted from the fixed point, $x$ horizontally to the side on which {side}, $y$")
        step.say("upward.")
        step.close()

    # ---- on the circle

    def goes_slack(self, start: Instant, time: float) -> Instant:
        """Write the position and velocity at which the string goes slack and return them."""
        book, ell, g = self.book, self.length, self.gravity
        y, v = book.fresh("y", r"\text{s}"), book.fresh("v", r"\text{s}")
        step = book.open(CIRCLE)
        square = self.squared(start)
        law = step.law(Power(v, 2) / ell, g * y / ell)
        energy = step.law(Power(v, 2), square - TWO * g * (y - start.y))
        step.say(f"The string goes slack at the height ${y.latex()}$ above the fixed point, where the tension is zero")
        step.say(f"and the component of gravity along the string alone is the centripetal acceleration: {law}.")
        step.say(f"Conservation of energy: {energy}.")
        height = ratio(square + TWO * g * start.y, THREE * g)
        step.say(f"Together, {step.result(y, height, METRES)} and {step.result(v, Root(g * y), SPEED)}.")
        if not book.is_hidden(y):
            step.say(f"As $0 < {y.latex()} < {ell.latex()}$, {self.who} gets there.")
        step.close()
        x = book.fresh("x", r"\text{s}")
        said = "Its horizontal distance from the fixed point is"
        book.told(CIRCLE, said, x, Root(Power(ell, 2) - Power(y, 2)), METRES)
        out = self.sign(time, 0)
        said = "Its velocity there is perpendicular to the string, which gives"
        vx = book.told(TANGENT, said, book.fresh("v", "x"), -(v * y / ell * out), SPEED)
        vy = book.told(TANGENT, said, book.fresh("v", "y"), v * x / ell, SPEED)
        return Instant(x if out > 0.0 else -x, y, vx, vy, v)

    def squared(self, held: Instant) -> Expression:
        """Return the square of the speed."""
        return squares([held.vx, held.vy] if held.speed is None else [held.speed])

    # ---- in flight

    def is_taut_again(self, held: Instant) -> tuple[Symbol, Instant]:
        """Write the time of flight until the string is taut, and position and velocity just before; return both."""
        book, ell, g = self.book, self.length, self.gravity
        step, t = book.open("taut"), book.fresh("t", r"\text{f}")
        across = held.x + held.vx * t
        up = held.y + held.vy * t - HALF * g * Power(t, 2)
        law = step.law(Power(across, 2) + Power(up, 2), Power(ell, 2))
        step.say(f"{capital(self.who)} now moves as a projectile. After a time ${t.latex()}$ the string is taut again:")
        step.say(f"{law}.")
        if held == self.start:
            formula = TWO * (held.vy + Root(g * held.y - squares([held.vx]))) / g
            why = "Since the velocity at first is perpendicular to the string, a quadratic equation is left"
        else:
            formula = FOUR * held.vy / g
            square = f"${g.latex()} {held.y.latex()}$"
            why = f"Since the velocity at first is perpendicular to the string and its square is {square},"
            why += f" only the terms in ${t.latex()}^3$ and ${t.latex()}^4$ are left"
        step.say(f"{why}: {step.result(t, formula, SECONDS)}.")
        step.close()
        return t, self.after(held, t, f"{capital(self.who)} is then at")

    def after(self, held: Instant, t: Expression, said: str) -> Instant:
        """Write the position and velocity after a time of flight and return them."""
        book, g = self.book, self.gravity
        x = book.told("flight", said, book.fresh("x"), held.x + held.vx * t, METRES)
        y = book.told("flight", said, book.fresh("y"), held.y + held.vy * t - HALF * g * Power(t, 2), METRES)
        said = "Its vertical velocity is then"
        vy = book.told("flight velocity", said, book.fresh("v", "y"), held.vy - g * t, SPEED)
        return Instant(x, y, held.vx, vy)

    def highest(self, held: Instant) -> Instant:
        """Write the highest point of the projectile and return its position and velocity."""
        book, g = self.book, self.gravity
        said = f"{capital(self.who)} now moves as a projectile. Where its vertical velocity is zero, its height is"
        y = book.told("top", said, book.fresh("y"), held.y + Power(held.vy, 2) / (TWO * g), METRES)
        return Instant(held.x + held.vx * held.vy / g, y, held.vx, ZERO)

    # ---- the jerk

    def radial(self, held: Instant) -> Symbol:
        """Write the velocity along the string just before it is taut and return its symbol."""
        said = "The jerk takes away the velocity along the string,"
        formula = (held.x * held.vx + held.y * held.vy) / self.length
        return self.book.told("jerk", said, self.book.fresh("w"), formula, SPEED)

    def jerked(self, held: Instant) -> tuple[Instant, Symbol]:
        """Write the velocity just after the jerk, along the circle; return it and the counter-clockwise speed."""
        book, ell = self.book, self.length
        said = "The jerk takes away the velocity along the string; the component perpendicular to it is"
        u = book.told("jerk", said, book.fresh("u"), (held.x * held.vy - held.y * held.vx) / ell, SPEED)
        vx, vy = -(u * held.y / ell), u * held.x / ell
        return Instant(held.x, held.y, vx, vy, u), u

    # ---- later on the circle

    def turns(self, held: Instant) -> Instant:
        """Write the height at which the bob comes to rest on the circle and return the position."""
        book, ell = self.book, self.length
        said = "It turns back where all its kinetic energy is used up, at the height"
        y = book.told("turning", said, book.fresh("y"), held.y + self.squared(held) / (TWO * self.gravity), METRES)
        x: Expression = Root(Power(ell, 2) - Power(y, 2))
        return Instant(x if self.sign(self.setting.time, 0) > 0.0 else -x, y, ZERO, ZERO, ZERO)

    def swung(self, held: Instant, times: SwingTime, t: Symbol) -> Instant:
        """Write the position and velocity after a time on the circle and return them."""
        book, ell, when = self.book, self.length, self.setting.time
        begins = self.side if held.x == ZERO else self._sign_of(held.x)
        angle = times.angle(t)
        x, y = ell * Call("sin", angle) * begins, -(ell * Call("cos", angle))
        step, v = book.open("energy"), book.fresh("v")
        square = self.squared(held) - TWO * self.gravity * (y - held.y)
        law = step.law(Power(v, 2), square)
        step.say(f"By conservation of energy, {law}, so {step.result(v, Root(square), SPEED)}.")
        step.close()
        across, outward, rises = (self.sign(when, n) for n in range(3))
        upper = book.value(y) > 0.0
        turns = across * rises if abs(book.value(x)) > abs(book.value(y)) else -outward if upper else outward
        return Instant(x, y, -(v * y / ell * turns), v * x / ell * turns, v)

    def _sign_of(self, held: Expression) -> float:
        return 1.0 if self.book.value(held) > 0.0 else -1.0

    def times(self, held: Instant, speed: Expression) -> SwingTime:
        """Return the relation between angle and time on the circle from a position on."""
        if held == self.start:
            return self.swing.times
        book, ell = self.book, self.length
        angle = self.angle(held, book.fresh(r"\phi"))
        size = book.magnitude(speed)
        outward = book.value(held.x) * book.value(speed) > 0.0
        return SwingTime(book, self.swing.natural, angle, size / ell, 1.0 if outward else -1.0)

    def angle(self, held: Instant, name: Symbol) -> Symbol:
        """Write the magnitude of the angle of the string with the downward vertical and return its symbol."""
        x, y = self.book.value(held.x), self.book.value(held.y)
        formula: Expression = Call("arccos", -(held.y / self.length))
        if abs(x) < abs(y):
            slope = Call("arcsin", (held.x if x > 0.0 else -held.x) / self.length)
            formula = slope if y < 0.0 else PI - slope
        said = "The string then makes with the downward vertical the angle"
        return self.book.told("angle", said, name, formula, DEGREES)


def size_of(one: Expression, other: Expression) -> Expression:
    """Return the magnitude of a vector by its components; a single component keeps its sign."""
    return one + other if ZERO in (one, other) else Root(squares([one, other]))


def change(book: Book, there: Instant, start: Instant) -> Expression:
    """Return the magnitude of the change of velocity, from differences that are not negative."""
    pairs = ((there.vx, start.vx), (there.vy, start.vy))
    return size_of(*(one - two if book.value(one - two) >= 0.0 else two - one for one, two in pairs))


def tell_velocities(book: Book, there: Instant, start: Instant, *, flies: bool) -> None:
    """Write the initial and final velocities between which the momentum changes."""
    step = book.open("extreme")
    first = [f"${v.latex()}$ along {axis}" for v, axis in ((start.vx, "x"), (start.vy, "y")) if v != ZERO]
    step.say(f"The initial velocity is {joined(first)}." if first else "")
    step.close()
    if flies:
        tell_flight(book, there)


def tell_flight(book: Book, there: Instant) -> None:
    """Write that the horizontal velocity is constant in free flight, and the vertical one zero at the top."""
    step = book.open("extreme")
    at = ", and the vertical one is zero at the highest point" if there.vy == ZERO else ""
    step.say(f"In free flight the horizontal velocity stays ${there.vx.latex()}${at}.")
    step.close()
