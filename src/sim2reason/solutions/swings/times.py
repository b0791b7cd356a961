"""Times in the swing of a pendulum: sin(φ/2) = k sin θ makes the time an elliptic integral (Landau and Lifshitz, § 11).

½ φ̇² = 2 ω₀² (k² − sin²(φ/2)): below k = 1 it swings, ω₀ t = F(θ, k); above it goes round, with θ = φ/2 and
k ω₀ t = F(θ, 1/k).
"""

from math import sin

from sim2reason.base.records import cached_property
from sim2reason.solutions.algebra.evaluated import Amplitude, CompleteElliptic, IncompleteElliptic, SpecialFunction
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.writing.notation import ANGULAR_SPEED, DEGREES, RADIANS, SECONDS
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

TWO = Number(2.0)
PHASE_TOLERANCE = 1e-6  # tolerance, in rad or relative


class SwingTime:
    """The relation between angle and time of a pendulum; angles are positive on the initial side."""

    def __init__(self, book: SolutionBuilder, natural: Symbol, first: Expression, rate: Expression, way: float) -> None:
        """Take ω₀ as `natural`, the initial angle `first`, the angular speed `rate` and its sign `way`, ±1."""
        self.book, self.natural, self.first, self.rate = book, natural, first, rate
        self.way = way if first != ZERO else 1.0
        self.side = 1.0 if first != ZERO else way

    @cached_property
    def modulus(self) -> Symbol:
        """Write the modulus k from the energy and return its symbol."""
        half = Call("sin", self.first / TWO) if self.first != ZERO else ZERO
        formula = half
        if self.rate != ZERO:
            part = self.rate / (TWO * self.natural)
            formula = Root(Power(part, 2) + Power(half, 2)) if half != ZERO else part
        name, step = self.book.fresh("k"), self.book.begin_step("modulus")
        equation = step.result(name, formula, "", law=True)
        k, rate = name.latex(), self.natural.latex()
        step.add_text(r"Let $\varphi$ be the angle from the lowest position.")
        step.add_text(rf"By conservation of energy, $\dot\varphi^{{2}}$ equals $4 {rate}^{{2}} ({k}^{{2}} - \sin^{{2}}")
        step.add_text(rf"(\varphi/2))$ with {equation}.")
        if self.book.values[name.name] > 1.0:
            text = rf"With $\psi$ for $\varphi/2$, the time since the lowest position is $\frac{{1}}{{{k} {rate}}}"
            text += rf" \operatorname{{F}}(\psi, 1/{k})$"
            square = rf"\sin^{{2}}\vartheta/{k}^{{2}}"
        else:
            text = rf"With ${k} \sin\psi$ for $\sin(\varphi/2)$, the time since the lowest position is"
            text += rf" $\frac{{1}}{{{rate}}} \operatorname{{F}}(\psi, {k})$"
            square = rf"{k}^{{2}} \sin^{{2}}\vartheta"
        step.add_text(f"{text}, where $\\operatorname{{F}}$ is the elliptic integral of the first kind,")
        step.add_text(rf"$\int_0^{{\psi}} d\vartheta / \sqrt{{1 - {square}}}$.")
        if not self.book.is_hidden(name):
            over = self.book.values[name.name] > 1.0
            reach = "> 1$, the energy suffices" if over else "< 1$, the energy does not suffice"
            step.add_text(f"As ${k} {reach} to reach the top of the circle.")
        step.close()
        return name

    @cached_property
    def makes_full_turns(self) -> bool:
        """Return whether the pendulum goes right round."""
        return self.book.values[self.modulus.name] > 1.0

    @cached_property
    def integral_rate(self) -> Expression:
        """Return the rate of increase of the elliptic integral F(θ) with time, rad/s: ω₀, or k ω₀ for full turns."""
        return self.modulus * self.natural if self.makes_full_turns else self.natural

    # ---- elliptic integrals

    @property
    def _elliptic_modulus(self) -> Expression:
        return ONE / self.modulus if self.makes_full_turns else self.modulus

    @cached_property
    def complete(self) -> Symbol:
        """Write K, the complete integral of a quarter oscillation or a half turn, and return its symbol."""
        part = (
            "from straight down to straight up" if self.makes_full_turns else "from the lowest point to a turning point"
        )
        formula = CompleteElliptic(self._elliptic_modulus)
        return self._special(f"The complete integral, {part}, is", self.book.fresh("K"), formula, "")

    def _integral(self, angle: Symbol) -> Symbol:
        """Write the incomplete integral F(θ) and return its symbol."""
        text, formula = f"The integral up to ${angle.latex()}$ is", IncompleteElliptic(angle, self._elliptic_modulus)
        return self._special(text, self.book.fresh("u"), formula, "")

    def _amplitude(self, integral: Symbol) -> Symbol:
        """Write the angle θ at which the elliptic integral F(θ) has a given value, and return its symbol."""
        text = f"The angle up to which the integral is ${integral.latex()}$ is"
        formula = Amplitude(integral, self._elliptic_modulus)
        return self._special(text, self.book.fresh(r"\psi"), formula, RADIANS)

    def _special(self, said: str, name: Symbol, formula: SpecialFunction, unit: str) -> Symbol:
        """Write the value of a special function, or only its symbol if it depends on the unknown; return that."""
        step = self.book.begin_step("elliptic")
        equation = step.result(name, formula, unit, law=True)
        step.add_text(f"{said} {f'${name.latex()}$' if self.book.is_hidden(formula) else equation}.")
        step.close()
        return name

    # ---- an angle as a multiple of a half turn of θ, and the integral of what is left

    def _left(self, angle: Expression, value: float) -> Polynomial:
        """Return the elliptic integral F(θ) for the least θ ≥ 0 at which the pendulum has a given angle."""
        if abs(value) < PHASE_TOLERANCE:
            return NIL
        if self.makes_full_turns:
            formula = angle / TWO
        else:
            over = sin(0.5 * value) / self.book.values[self.modulus.name]
            if abs(over - 1.0) < PHASE_TOLERANCE**2:
                return self._quarters(1)
            formula = Call("arcsin", Call("sin", angle / TWO) / self.modulus)
        text = "Half the angle is" if self.makes_full_turns else "The angle in the integral is"
        theta = self.book.add_step("angle", text, self.book.fresh(r"\psi"), formula, RADIANS)
        return Polynomial.from_expression(self._integral(theta))

    def _quarters(self, count: int) -> Polynomial:
        """Return the complete elliptic integral K times an integer."""
        return Polynomial.from_expression(self.complete).scale(float(count)) if count else NIL

    @cached_property
    def begins(self) -> Polynomial:
        """Return the elliptic integral F(θ) at the start, from which it increases in proportion to the time."""
        if self.first == ZERO:
            return NIL
        if self.rate == ZERO:
            return self._quarters(1)
        left = self._left(self.first, self.book.value(self.first))
        if self.way > 0.0:
            return left
        return left.scale(-1.0) if self.makes_full_turns else self._quarters(2) - left

    def reaches(self, angle: Expression, time: float) -> Symbol:
        """Write the time near a given one at which the pendulum is at an angle and return its symbol."""
        value = self.book.value(angle)
        size = angle if value >= 0.0 else -angle
        left = self._left(size, abs(value))
        full = 2.0 * self.book.values[self.complete.name]
        now = self.book.value(self.begins.expression()) + self.book.value(self.integral_rate) * time
        part = self.book.value(left.expression())
        candidates = [(sign, round((now - sign * part) / full)) for sign in (1.0, -1.0)]
        off = [abs(sign * part + turns * full - now) for sign, turns in candidates]
        sign, turns = candidates[off.index(min(off))]
        if min(off) > PHASE_TOLERANCE * full:
            raise UnsolvedError("the angle at that moment is not known")
        return self._after(self._quarters(2 * turns) + left.scale(sign))

    def write_vertical_time(self, time: float) -> Symbol:
        """Write the time of a passage through the lowest or highest point, or of a turning point; return its symbol."""
        quarter = self.book.values[self.complete.name]
        now = self.book.value(self.begins.expression()) + self.book.value(self.integral_rate) * time
        count = round(now / quarter)
        if abs(count * quarter - now) > PHASE_TOLERANCE * quarter:
            raise UnsolvedError("the angle at that moment is not known")
        return self._after(self._quarters(count))

    def _after(self, integral: Polynomial) -> Symbol:
        text = "Hence"
        formula = (integral - self.begins).expression() / self.integral_rate
        return self.book.add_step("time", text, self.book.fresh("t"), formula, SECONDS)

    @property
    def frequency(self) -> Symbol:
        """Write the angular frequency of the motion, from the period 4K/ω₀, or 2K/(kω₀) for full turns; return it."""
        share = 1.0 if self.makes_full_turns else 0.5
        formula = Number(share) * PI * self.integral_rate / self.complete
        quarter, rate = self.complete.latex(), self.natural.latex()
        text = f"The period is $4 {quarter}/{rate}$"
        if self.makes_full_turns:
            text = f"A whole turn takes the time $2 {quarter}/({self.modulus.latex()} {rate})$"
        text += ", so the angular frequency is"
        return self.book.add_step("oscillation", text, self.book.fresh(r"\omega"), formula, ANGULAR_SPEED)

    def angle(self, time: Symbol) -> Symbol:
        """Write the angle at a time and return its symbol."""
        _ = self.modulus
        begins, grown, name = self.begins.expression(), self.integral_rate * time, self.book.fresh("u", "t")
        inward = self.way < 0.0 and not self.makes_full_turns and self.rate != ZERO
        text = f"At first the integral is ${begins.latex()}${', as it moves inwards' if inward else ''}; it"
        text = f"{text if self.begins else 'The integral'} grows at the rate ${self.integral_rate.latex()}$, up to"
        integral_value = begins + grown if self.begins else grown
        theta = self._amplitude(self.book.add_step("elliptic", text, name, integral_value, ""))
        self._tell_turns(name)
        if self.makes_full_turns:
            formula: Expression = TWO * theta if self.way * self.side > 0.0 else -(TWO * theta)
        else:
            formula = TWO * Call("arcsin", self.modulus * Call("sin", theta))
            formula = formula if self.side > 0.0 else -formula
        text = "The angle with the vertical is then"
        return self.book.add_step("angle", text, self.book.fresh(r"\phi", "t"), formula, DEGREES)

    def _tell_turns(self, integral: Symbol) -> None:
        """Write how many turning points precede the time at which the elliptic integral has a given value."""
        if self.makes_full_turns or self.book.is_hidden(integral):
            return
        quarter, begun = self.book.value(self.complete), self.book.value(self.begins.expression())
        turns = [
            n
            for n in range(1, 2 * int(self.book.value(integral) / quarter) + 4, 2)
            if n * quarter > begun + PHASE_TOLERANCE
        ]
        before = sum(n * quarter < self.book.value(integral) for n in turns)
        step, name = self.book.begin_step("verify"), self.book.fresh("u", r"\text{turn}")
        formula = Number(float(turns[before])) * self.complete
        often = {0: "not at all", 1: "once", 2: "twice"}.get(before, f"{before} times")
        verified, k = step.verified(name, formula, ""), self.complete.latex()
        step.add_text(
            f"It turns back where the integral is ${k}$, $3 {k}$, $5 {k}$ and so on, next at {verified}: until then it"
        )
        step.add_text(f"has turned back {often} since the start.")
        step.close()
