"""Times in the swing of a pendulum: sin(φ/2) = k sin θ makes the time an elliptic integral (Landau and Lifshitz, § 11).

½ φ̇² = 2 ω₀² (k² − sin²(φ/2)): below k = 1 it swings, ω₀ t = F(θ, k); above it goes round, with θ = φ/2 and
k ω₀ t = F(θ, 1/k).
"""

from math import sin

from sim2reason.lazy import cached_property
from sim2reason.solutions.algebra.elliptic import Elliptic
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.writing.steps import Book, UnsolvedError
from sim2reason.solutions.writing.unit_latex import ANGULAR_SPEED, DEGREES, RADIANS, SECONDS

TWO = Number(2.0)
NEAR = 1e-6  # rad or relative


class SwingTime:
    """From an angle to the time and back; angles are from the lowest point, positive where it begins."""

    def __init__(self, book: Book, natural: Symbol, first: Expression, rate: Expression, way: float) -> None:
        """`natural` is ω₀, `first` the angle at the start, `rate` the angular speed then, `way` ±1 its sign."""
        self.book, self.natural, self.first, self.rate = book, natural, first, rate
        self.way = way if first != ZERO else 1.0
        self.side = 1.0 if first != ZERO else way
        self.elliptic = Elliptic(book, self.modulus if not self.rounds else ONE / self.modulus)

    @cached_property
    def modulus(self) -> Symbol:
        """k, by the energy."""
        half = Call("sin", self.first / TWO) if self.first != ZERO else ZERO
        formula = half
        if self.rate != ZERO:
            part = self.rate / (TWO * self.natural)
            formula = Root(Power(part, 2) + Power(half, 2)) if half != ZERO else part
        name, step = self.book.fresh("k"), self.book.open("modulus")
        step.say("By energy, the square of the angular speed is")
        step.say(
            f"$4 {self.natural.latex()}^{{2}} (k^{{2}} - \\sin^{{2}}(\\varphi/2))$ with".replace(
                "k^", f"{name.latex()}^"
            )
        )
        step.say(f"{step.result(name, formula, '', law=True)}.")
        step.close()
        return name

    @cached_property
    def rounds(self) -> bool:
        """Whether it goes round."""
        return self.book.values[self.modulus.name] > 1.0

    @cached_property
    def pace(self) -> Expression:
        """How fast the integral grows."""
        return self.modulus * self.natural if self.rounds else self.natural

    # ---- an angle as a multiple of a half turn of θ, and the integral of what is left

    def _left(self, angle: Expression, value: float) -> Polynomial:
        """F of the first angle θ ≥ 0 at which it is at an angle, of its size."""
        if abs(value) < NEAR:
            return NIL
        if self.rounds:
            formula = angle / TWO
        else:
            over = sin(0.5 * value) / self.book.values[self.modulus.name]
            if abs(over - 1.0) < NEAR**2:
                return self._quarters(1)
            formula = Call("arcsin", Call("sin", angle / TWO) / self.modulus)
        said = "The angle of the integral is" if not self.rounds else "Half the angle is"
        theta = self.book.told("angle", said, self.book.fresh(r"\theta"), formula, RADIANS)
        return Polynomial.of(self.elliptic.integral(theta))

    def _quarters(self, count: int) -> Polynomial:
        """So many times K."""
        return Polynomial.of(self.elliptic.complete).scaled(float(count)) if count else NIL

    @cached_property
    def begins(self) -> Polynomial:
        """The integral at the start."""
        if self.first == ZERO:
            return NIL
        if self.rate == ZERO:
            return self._quarters(1)
        left = self._left(self.first, self.book.value(self.first))
        if self.way > 0.0:
            return left
        return left.scaled(-1.0) if self.rounds else self._quarters(2) - left

    def reaches(self, angle: Expression, time: float) -> Symbol:
        """Write when it is at an angle, near a time."""
        value = self.book.value(angle)
        size = angle if value >= 0.0 else -angle
        left = self._left(size, abs(value))
        full = 2.0 * self.book.values[self.elliptic.complete.name]
        now = self.book.value(self.begins.expression()) + self.book.value(self.pace) * time
        part = self.book.value(left.expression())
        found = [(sign, round((now - sign * part) / full)) for sign in (1.0, -1.0)]
        off = [abs(sign * part + turns * full - now) for sign, turns in found]
        sign, turns = found[off.index(min(off))]
        if min(off) > NEAR * full:
            raise UnsolvedError("the angle at that moment is not known")
        return self._after(self._quarters(2 * turns) + left.scaled(sign))

    def upright(self, time: float) -> Symbol:
        """Write when it is at the lowest point, or turns back, or is at the top."""
        quarter = self.book.values[self.elliptic.complete.name]
        now = self.book.value(self.begins.expression()) + self.book.value(self.pace) * time
        count = round(now / quarter)
        if abs(count * quarter - now) > NEAR * quarter:
            raise UnsolvedError("the angle at that moment is not known")
        return self._after(self._quarters(count))

    def _after(self, integral: Polynomial) -> Symbol:
        said = "The time is the integral over the angular frequency,"
        formula = (integral - self.begins).expression() / self.pace
        return self.book.told("time", said, self.book.fresh("t"), formula, SECONDS)

    @property
    def frequency(self) -> Symbol:
        """Write the angular frequency of the whole motion: 4 K to and fro, 2 K once round."""
        share = 1.0 if self.rounds else 0.5
        formula = Number(share) * PI * self.pace / self.elliptic.complete
        said = "To and fro takes four such quarters, so that the angular frequency is"
        said = "Once round takes two such quarters, so that the angular frequency is" if self.rounds else said
        return self.book.told("oscillation", said, self.book.fresh(r"\omega"), formula, ANGULAR_SPEED)

    def angle(self, time: Symbol) -> Symbol:
        """Write the angle at a time."""
        _ = self.modulus
        grown = self.pace * time
        name = self.book.fresh("F", "t")
        whole = self.begins.expression() + grown if self.begins else grown
        said = "With time it grows to"
        theta = self.elliptic.amplitude(self.book.told("elliptic", said, name, whole, ""))
        if self.rounds:
            formula: Expression = TWO * theta if self.way * self.side > 0.0 else -(TWO * theta)
        else:
            formula = TWO * Call("arcsin", self.modulus * Call("sin", theta))
            formula = formula if self.side > 0.0 else -formula
        said = "The angle from the vertical is then"
        return self.book.told("angle", said, self.book.fresh(r"\varphi"), formula, DEGREES)
