"""Normal modes, in which all parts oscillate with one frequency, and their equations.

(K − λM) a = 0 gives λ = ω² and the shape a of each. See Goldstein, Poole and Safko, Classical Mechanics, § 6.3.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.evaluated import NumericFormula, QuadraticRoot
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.fractions import reduced_quotient, signed_permutations
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.algebra.root_finding import root_sentence
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.writing.notation import PER_SECOND_SQUARED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

UNNAMED = Symbol("q")


@dataclass
class Mode:
    """A normal mode: λ = ω² (ω: angular frequency), mode shape, and coefficients from the initial state."""

    number: int
    square: Expression  # λ; zero without a restoring force
    first: int = 0  # the free coordinate of the largest share, which is 1
    shape: list[Expression] = field(default_factory=list[Expression])
    name: Symbol = UNNAMED  # symbol of its coordinate ξ
    rate: Symbol | None = None
    rise: Expression = ZERO  # equilibrium value of ξ, q/µλ; without a restoring force, the acceleration q/µ
    swing: Expression = ZERO  # amplitude p/µω of the sine; without a restoring force, the velocity p/µ


def _summed(modes: Sequence[Mode], i: int, t: Symbol, order: int) -> Expression:
    """Return a free coordinate's displacement as a sum over modes, or its time derivative of the given `order`."""
    mode_sum: Expression = ZERO
    for mode in modes:
        inner = _free(mode, t, order) if mode.rate is None else _swung(mode, mode.rate, t, order)
        mode_sum = mode_sum + mode.shape[i] * inner
    return mode_sum


def _free(mode: Mode, t: Symbol, order: int) -> Expression:
    """Return c t + b t²/2, a mode without a restoring force, or its time derivative of the given `order`."""
    if order == 0:
        return mode.swing * t + 0.5 * mode.rise * Power(t, 2)
    if order == 1:
        return mode.swing + mode.rise * t
    return mode.rise if order == 2 else ZERO


def _swung(mode: Mode, rate: Symbol, t: Symbol, order: int) -> Expression:
    """Return b (1 − cos ωt) + c sin ωt, an oscillating mode, or its time derivative of the given `order`."""
    cosine, sine = Call("cos", rate * t), Call("sin", rate * t)
    rises = {0: ONE - cosine, 1: sine, 2: cosine, 3: -sine}[order]
    swings = {0: sine, 1: cosine, 2: -sine, 3: -cosine}[order]
    combination = mode.rise * rises + mode.swing * swings
    return combination if order == 0 else (Power(rate, order) if order > 1 else rate) * combination


def place(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """Return the displacement of a free coordinate, given by its index, at a time."""
    return _summed(modes, i, t, 0)


def speed(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """Return the velocity of a free coordinate, given by its index, at a time."""
    return _summed(modes, i, t, 1)


def acceleration(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """Return the acceleration of a free coordinate, given by its index, at a time."""
    return _summed(modes, i, t, 2)


def jerk(modes: Sequence[Mode], i: int, t: Symbol) -> Expression:
    """Return the jerk of a free coordinate, given by its index, at a time."""
    return _summed(modes, i, t, 3)


def normalized_single_mode(modes: list[Mode]) -> list[Mode]:
    """Return modes with the same zeros in time: a single pure sine or 1 − cosine loses its constant factors."""
    if len(modes) != 1 or modes[0].rate is None or ZERO not in (modes[0].rise, modes[0].swing):
        return modes
    only = modes[0]
    rise, swing = (ONE if part != ZERO else ZERO for part in (only.rise, only.swing))
    return [replace(only, shape=[ONE for _ in only.shape], rise=rise, swing=swing)]


ZERO_MODE_RTOL = 1e-9  # relative to the largest λ: a smaller one means no restoring force
MAX_COEFFICIENT_LENGTH = 160  # maximum length of the LaTeX of coefficients that are written as formulas
TWO_COORDINATES = 2  # number of free coordinates with which a mode shape has one unknown share
EXCITATION_RTOL = 1e-10  # relative to the largest part: below it the start does not excite a mode


class ModeLaws:
    """The normal modes of a linear motion from Newton's laws, with their frequencies."""

    def __init__(
        self,
        book: SolutionBuilder,
        motion: LinearMotion,
        first: Sequence[Polynomial],
        names: Sequence[Symbol],
        *,
        loaded: bool,
    ) -> None:
        """Take the initial rates and the names of the free coordinates, and write the equations of motion.

        If `loaded`, they include constant forces; otherwise the coordinates count from equilibrium. Raise
        UnsolvedError if the equilibrium is unstable.
        """
        self.book, self.motion, self.first, self.names = book, motion, list(first), list(names)
        self.size, self.loaded = len(motion.free), loaded
        self.shown_modes: frozenset[int] = frozenset()  # indices of the modes that the solution shows
        self.mass, self.stiffness = motion.matrix("mass"), motion.matrix("stiffness")
        half = np.linalg.inv(np.linalg.cholesky(self.mass))  # makes M one, so that K stays symmetric
        decomposition = np.linalg.eigh(half @ self.stiffness @ half.T)
        self.squares: Array = np.asarray(decomposition[0], dtype=np.float64)
        self.shapes: Array = half.T @ np.asarray(decomposition[1], dtype=np.float64)
        if self.squares[0] < -ZERO_MODE_RTOL * self.squares[-1]:
            raise UnsolvedError("something is driven away")
        self.load: Array = np.array([motion.load(i).value(motion.givens) for i in motion.free])
        self.initial_rates: Array = np.array([rate.value(motion.givens) for rate in first])
        self._tell_equations(loaded=loaded)

    @property
    def zeros(self) -> int:
        """Return the number of modes without a restoring force, whose λ is zero."""
        return int((self.squares < ZERO_MODE_RTOL * self.squares[-1]).sum())

    # ---- frequencies

    def entry(self, i: int, j: int) -> tuple[Polynomial, Polynomial]:
        """Return the entries of the stiffness matrix K and the mass matrix M for the free coordinates i and j."""
        free = self.motion.free
        return self.motion.stiffness(free[i], free[j]), self.motion.mass(free[i], free[j])

    def _tell_equations(self, *, loaded: bool) -> None:
        equations: list[str] = []
        for i, number in enumerate(self.motion.free):
            entries = [(*self.entry(i, j), name) for j, name in enumerate(self.names)]
            inertia = total(mass * Polynomial.from_expression(dotted(name)) for _, mass, name in entries)
            pull = total(stiff * Polynomial.from_expression(name) for stiff, _, name in entries)
            forces = (self.motion.load(number) if loaded else NIL) - pull
            equations.append(f"${inertia.expression().latex()} = {forces.expression().latex()}$")
        step = self.book.begin_step("equations of motion")
        subject = "equations of motion are" if len(equations) > 1 else "equation of motion is"
        step.add_text(f"The {subject} {join_words(equations)}.")
        step.close()

    @cached_property
    def powers(self) -> list[Polynomial]:
        """Return the coefficients of det(K − λM) by the power of λ."""
        coefficients = [NIL] * (self.size + 1)
        for sign, order in signed_permutations(self.size):
            product = [Polynomial.from_expression(sign)]
            for i, j in enumerate(order):
                stiff, mass = self.entry(i, j)
                longer = [NIL] * (len(product) + 1)
                for power, part in enumerate(product):
                    longer[power] = longer[power] + part * stiff
                    longer[power + 1] = longer[power + 1] - part * mass
                product = longer
            coefficients = [a + b for a, b in zip(coefficients, product, strict=True)]
        return coefficients

    @cached_property
    def modes(self) -> list[Mode]:
        """Return all modes, that of lowest frequency first, and write their λ = ω²."""
        powers = self.powers[self.zeros :]
        if any(self.powers[: self.zeros]):
            raise UnsolvedError("a mode that only these numbers leave free")
        free = [Mode(n, ZERO) for n in range(self.zeros)]
        if len(powers) == 2:
            return [*free, self._only(powers)]
        if len(powers) == 3:
            return [*free, *self._two(powers)]
        return [*free, *self._several(powers)]

    def _only(self, powers: Sequence[Polynomial]) -> Mode:
        """Write the root of a linear characteristic equation and return its mode."""
        mode = self._named(self.zeros)
        self._root(mode, powers, reduced_quotient(powers[0].scale(-1.0), powers[1]))
        return mode

    def _two(self, powers: Sequence[Polynomial]) -> list[Mode]:
        """Write the roots of a quadratic characteristic equation and return their modes."""
        c, b, a = (coefficient.expression() for coefficient in powers)
        modes: list[Mode] = []
        for n, sign in ((0, 1.0), (1, -1.0)):  # the coefficient of λ² and that of λ have opposite signs
            mode = self._named(self.zeros + n)
            turned = sign if self.book.value(a) > 0.0 else -sign
            formula = (-b - Number(turned) * Root(Power(b, 2) - 4.0 * a * c)) / (2.0 * a)
            implicit = not self.loaded and self.book.is_hidden(formula) and not self.book.in_symbols
            self._root(mode, powers, self._implicit(mode, powers) if implicit else self.book.defer_to_number(formula))
            modes.append(mode)
        return modes

    def _implicit(self, mode: Mode, powers: Sequence[Polynomial]) -> Expression:
        """Return λ as an implicit root of its quadratic equation, which is easier to solve for the unknown."""
        assert isinstance(mode.square, Symbol)
        return QuadraticRoot(self._vanishing(powers, mode.square), mode.square.name, float(self.squares[mode.number]))

    def _several(self, powers: Sequence[Polynomial]) -> list[Mode]:
        """Write the numerical roots of a characteristic equation of higher degree and return their modes."""
        modes: list[Mode] = []
        for n in range(len(powers) - 1):
            mode = self._named(self.zeros + n)
            assert isinstance(mode.square, Symbol)
            self._root(mode, powers, None)
            modes.append(mode)
        return modes

    def _vanishing(self, powers: Sequence[Polynomial], square: Symbol) -> Expression:
        """Return the characteristic polynomial, in numbers if its coefficients are long and known."""
        characteristic: Expression = ZERO
        long = sum(len(part.expression().latex()) for part in powers) > MAX_COEFFICIENT_LENGTH
        for power, part in reversed([*enumerate(powers)]):
            size = part.expression()
            value = self.book.value(size)
            if long and not self.book.is_hidden(size):
                size = NumericFormula(size if value > 0.0 else part.scale(-1.0).expression(), abs(value))
            elif value < 0.0:
                size = part.scale(-1.0).expression()
            term = size if power == 0 else size * (square if power == 1 else Power(square, power))
            characteristic = characteristic + term if value > 0.0 else characteristic - term
        return characteristic

    def _named(self, number: int) -> Mode:
        """Write the laws that determine λ and the shape of the mode with an index, and return the mode."""
        numbers = self.shapes[:, number]
        first = int(np.argmax(np.abs(numbers)))
        mark = str(number + 1) if self.size - self.zeros > 1 else ""
        mode = Mode(number, self.book.fresh(r"\lambda", mark), first=first)
        self.write_laws(mode)
        return mode

    def write_laws(self, mode: Mode) -> None:
        """Write Newton's law along each free coordinate for one mode; if λ is zero, without the redundant law."""
        numbers = self.shapes[:, mode.number] / self.shapes[mode.first, mode.number]
        unknown = [i for i in range(self.size) if i != mode.first]
        names = {i: self.book.fresh("r", self._mark(i, mode)) for i in unknown}
        mode.shape = [names.get(i, ONE) for i in range(self.size)]
        self.book.observed |= {names[i].name: float(numbers[i]) for i in unknown}
        driven = mode.square != ZERO
        if isinstance(mode.square, Symbol):
            self.book.observed[mode.square.name] = float(self.squares[mode.number])
        step = self.book.begin_step("mode laws")
        step.label(f"mode {mode.number}")
        rate = f"$-{mode.square.latex()}$"
        if names:
            accelerations = f"each acceleration is {rate} times the deviation"
            clause = accelerations if driven else "the forces of the springs do not change"
            step.add_text(f"In normal mode {mode.number + 1} {self._shares(mode)}, and {clause}:")
        else:
            acceleration = f"{rate} times the displacement from equilibrium" if driven else "zero"
            step.add_text(f"The acceleration is {acceleration}:")
        laws: list[str] = []
        for i in range(self.size) if driven else unknown:
            pulls, inertia = self.row(mode, i)
            laws.append(step.law(pulls.expression(), inertia.expression()))
        step.add_text(f"{join_words(laws)}.")
        step.close()

    def row(self, mode: Mode, i: int) -> tuple[Polynomial, Polynomial]:
        """Return both sides of Newton's law of a mode along one free coordinate: stiffness and inertia."""
        square = Polynomial.from_expression(mode.square) if mode.square != ZERO else NIL
        row = [(self.entry(i, j), Polynomial.from_expression(a if a != ONE else 1.0)) for j, a in enumerate(mode.shape)]
        return total(stiff * a for (stiff, _), a in row), total(square * mass * a for (_, mass), a in row)

    def _root(self, mode: Mode, powers: Sequence[Polynomial], formula: Expression | None) -> None:
        assert isinstance(mode.square, Symbol)
        step, again = self.book.begin_step("modes"), self._repeats(mode)
        step.rest_on(f"mode {mode.number}")
        if len(powers) == 2 and formula is not None:
            step.add_text(f"Together they give {step.result(mode.square, formula, PER_SECOND_SQUARED)}.")
            step.close()
            return
        characteristic = self._vanishing(powers, mode.square)
        if not again:
            text = "They hold only if the determinant of the coefficients of the displacements is zero"
            text += "; apart from the root 0," if self.zeros else ","
            step.add_text(f"{text} {step.derived(characteristic, ZERO)}.")
        count, of = len(powers) - 1, " of the same equation" if again else ""
        which = f"{self._order(mode.number - self.zeros, count)} root{of}"
        if formula is not None:
            equation = step.result(mode.square, formula, PER_SECOND_SQUARED)
            implicit = isinstance(formula, QuadraticRoot)
            step.add_text(
                f"Here ${mode.square.latex()}$ is the {which}." if implicit else f"The {which} is {equation}."
            )
        else:
            near = float(self.squares[mode.number])
            text = f"By numerical solution, the {which} is"
            step.add_text(root_sentence(self.book, step, mode.square, characteristic, near, PER_SECOND_SQUARED, text))
        step.close()

    @staticmethod
    def _order(place: int, count: int) -> str:
        """Return the rank of a root among `count` in ascending order, in words, such as *second smallest*."""
        if count == TWO_COORDINATES:
            return ("smaller", "greater")[place]
        return "greatest" if place == count - 1 else ("smallest", "second smallest", "third smallest")[place]

    def _repeats(self, mode: Mode) -> bool:
        """Return whether the text of an earlier mode already contains the characteristic equation."""
        return mode.number in self.shown_modes and any(self.zeros <= n < mode.number for n in self.shown_modes)

    def _mark(self, i: int, mode: Mode) -> str:
        """Return the subscript of a component of a mode shape: the mode, after the body if there are several."""
        if self.size == TWO_COORDINATES:
            return str(mode.number + 1)
        own = self.names[i].name.partition("_")[2]
        own = own[1:-1] if own.startswith("{") else own
        return f"{own or i + 1},{mode.number + 1}"

    def _shares(self, mode: Mode) -> str:
        """Return the mode shape as a ratio of displacements, in words."""
        ratio = " : ".join(part.latex() for part in mode.shape)
        who = join_words([f"${name.latex()}$" for name in self.names])
        what = f"the deviations of {who} from equilibrium" if mode.square != ZERO else f"the displacements {who}"
        return f"{what} are in the ratio ${ratio}$"


def dotted(name: Symbol, dots: int = 2) -> Symbol:
    """Return the symbol of the first or second time derivative of a coordinate."""
    base, line, mark = name.name.partition("_")
    return Symbol(rf"\{'d' * dots}ot{{{base}}}{line}{mark}")
