"""Normal modes: their frequencies and shapes, and their excitation by the initial state."""

from collections.abc import Sequence
from dataclasses import replace
from math import inf

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.phrasing import SPEEDS, PeriodQuery
from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.elimination import solve_linear
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Symbol
from sim2reason.solutions.algebra.fractions import cramer
from sim2reason.solutions.algebra.functions import Power, Root
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.oscillations.mode_laws import TWO_COORDINATES, Mode, ModeLaws, dotted, place
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.writing.notation import (
    ACCELERATION,
    ANGULAR_SPEED,
    KILOGRAMS,
    METRES,
    PER_SECOND_SQUARED,
    SPEED,
)
from sim2reason.solutions.writing.steps import StepBuilder, UnsolvedError, record_inequality

SMALLER = {"slower": "smaller", "faster": "greater", "slowest": "smallest", "fastest": "greatest"}


def natural_frequency(laws: ModeLaws, query: PeriodQuery) -> Symbol:
    """Write the angular frequency that a question asks about; UnsolvedError if the motion has no period."""
    if not query.small and laws.size - laws.zeros > 1:
        raise UnsolvedError("the motion as a whole has no period")
    mode = laws.modes[laws.zeros + (query.rank if query.small else 0)]
    text = "The angular frequency is"
    if query.small and query.modes > 1:
        which = SPEEDS[query.modes][query.rank > 0]
        text = f"As each root is the square of an angular frequency, the {which} mode has the {SMALLER[which]} one:"
        if laws.size - laws.zeros == TWO_COORDINATES and laws.book.is_hidden(mode.square) and not laws.book.in_symbols:
            laws.book.afterwards.append(lambda: _tell_other_root(laws, mode, query))
    name = laws.book.fresh(r"\omega")
    return laws.book.add_step("rate", text, name, Root(mode.square), ANGULAR_SPEED)


def _tell_other_root(laws: ModeLaws, mode: Mode, query: PeriodQuery) -> None:
    """Write the λ of the other mode from the product of both, once all numbers are known."""
    book, slower, square = laws.book, query.rank == 0, mode.square
    rest, _, leading = laws.powers[laws.zeros :]
    formula = rest.expression() / (leading.expression() * square)
    step, name = book.begin_step("verify"), book.fresh(r"\lambda", r"\text{other}")
    record_inequality(book, step, *((formula, square) if slower else (square, formula)))
    product = (
        f"The product of both roots is the constant term divided by the coefficient of ${Power(square, 2).latex()}$"
    )
    step.add_text(f"{product}, so the other root is {step.verified(name, formula, PER_SECOND_SQUARED)}.")
    size, which = ("greater", "slower") if slower else ("smaller", "faster")
    step.add_text(f"It is {size}, so the given {query.measure} is that of the {which} mode.")
    step.close()


EXCITATION_RTOL = 1e-10  # relative to the largest part: below it the start does not excite a mode
ACCELERATION_ORDER = 2  # order of the time derivative that is an acceleration
Form = tuple[Array, int]
"""A linear combination of displacements: a weight per free coordinate, (n,), and the order of a time derivative."""

COMMON_MODE_AT_REST = (
    "The total momentum is zero, and no external force changes it, so the centre of mass stays at rest and this mode "
    "is not excited."
)
MAX_FORMULA_LENGTH = 160  # maximum length of the LaTeX of a formula that is not replaced by its number


class NormalModes(ModeLaws):
    """All normal modes of a linear motion, written as they are needed."""

    # ---- shapes

    def _counts(self, n: int, forms: Sequence[Form]) -> bool:
        """Return whether mode n contributes to any of `forms`: weighted sums of displacements or their derivatives."""
        shape = self.shapes[:, n] / np.abs(self.shapes[:, n]).max()
        last = self._last(n)
        relevant = (parts for parts, order in forms if order <= last)
        return any(abs(float(parts @ shape)) > EXCITATION_RTOL * float(np.abs(parts).max()) for parts in relevant)

    def _last(self, n: int) -> float:
        """Return the order of the highest time derivative of the displacements that is not zero in mode n.

        A mode without a restoring force has a constant velocity or a constant acceleration.
        """
        if n >= self.zeros:
            return inf
        return ACCELERATION_ORDER if self._pushed(n) else ACCELERATION_ORDER - 1

    def _pushed(self, n: int) -> bool:
        """Return whether the net forces at the initial positions excite mode n."""
        shape = self.shapes[:, n]
        return abs(float(shape @ self.load)) > EXCITATION_RTOL * float(np.abs(shape * self.load).max())

    def contributing_modes(self, forms: Sequence[Form]) -> list[int]:
        """Return the indices of excited modes that contribute to `forms`, without writing anything."""
        return [n for n in self._moving if self._counts(n, forms)]

    @cached_property
    def _moving(self) -> list[int]:
        """Return the indices of the modes that the initial state excites."""
        sizes: list[float] = []
        for n in range(self.size):
            shape = self.shapes[:, n]
            heavy = float(shape @ self.mass @ shape)
            rise, swing = float(shape @ self.load) / heavy, float(shape @ self.mass @ self.initial_rates) / heavy
            square = self.squares[n] if n >= self.zeros else 1.0
            sizes.append(max(abs(rise) / square, abs(swing) / square**0.5) * float(np.abs(shape).max()))
        return [n for n in range(self.size) if sizes[n] > EXCITATION_RTOL * max(sizes)]

    def excited(self, forms: Sequence[Form]) -> list[Mode]:
        """Write the modes that the initial state excites, with their shapes and amplitudes, and return them.

        `forms` are the linear combinations that the question needs; modes that contribute to none are left out.
        """
        shown = self.contributing_modes(forms)
        self.shown_modes = frozenset(shown)
        modes = [mode for mode in self.modes if mode.number in shown]
        if any(mode.square == ZERO for mode in self.modes) and all(mode.square != ZERO for mode in modes):
            step = self.book.begin_step("modes")
            step.add_text(f"Mode 1 is the common motion of all bodies. {self._omitted_mode_reason}")
            step.close()
        for mode in modes:
            self._shaped(mode)
        self._tell_projection(modes)
        for mode in modes:
            self._started(mode, alone=len(modes) == 1)
        return modes

    @property
    def _omitted_mode_reason(self) -> str:
        """Return a sentence that says why the common motion is left out: not excited, or irrelevant here."""
        shape = self.shapes[:, 0]
        terms = (shape * self.load, shape * (self.mass @ self.initial_rates))
        driven, moves = (abs(float(part.sum())) > EXCITATION_RTOL * float(np.abs(part).max()) for part in terms)
        if not driven and not moves:
            return COMMON_MODE_AT_REST
        kept = "the distances between them" if driven else "distances between them or, as it is uniform, accelerations"
        return f"It does not change {kept}; in what follows, displacements are those apart from it."

    def _tell_projection(self, found: Sequence[Mode]) -> None:
        """Write displacements as sums over modes, and why each mode has its own equation of motion."""
        if self.size == 1 or not found:
            return
        for mode in found:
            mode.name = self.book.fresh("q", str(mode.number + 1))
        step = self.book.begin_step("projection")
        names = [f"${mode.name.latex()}$ {'' if n else 'be '}" for n, mode in enumerate(found)]
        first, *others = [f"the coordinate of mode {mode.number + 1}" for mode in found]
        others = [other.replace("the coordinate", "that") for other in others]
        definitions = join_words([f"{name}{of}" for name, of in zip(names, [first, *others], strict=True)])
        step.add_text(f"Let {definitions}{self._sums(found)}.")
        rest = "Normal modes are orthogonal"
        if len(found) == self.size == TWO_COORDINATES:
            rest = f"{rest}, {step.derived(self._product(*found), ZERO)}"
        step.add_text(
            f"{rest}, so the equations of motion, each multiplied by the share of its displacement in one mode, add up "
            "to an equation for the coordinate of this mode alone.",
        )
        step.close()

    @property
    def common(self) -> bool:
        """Return whether the initial state excites the common motion of all bodies, but the text leaves it out."""
        return any(n < self.zeros for n in self._moving if n not in self.shown_modes)

    def _sums(self, found: Sequence[Mode]) -> str:
        """Return a clause with the displacements to which only the given modes contribute, as sums over modes."""
        others = [n for n in self._moving if n not in self.shown_modes]
        hidden = np.abs(self.shapes[:, [n for n in others if n >= self.zeros]]).max(axis=1, initial=0.0)
        equations: list[str] = []
        for i, name in enumerate(self.names):
            if hidden[i] <= EXCITATION_RTOL * float(hidden.max()):
                combination: Expression = ZERO
                for mode in found:
                    combination = combination + mode.shape[i] * mode.name
                equations.append(f"${name.latex()} = {combination.latex()}$")
        if not equations:
            return ""
        qualifier = " apart from the common motion" if self.common else " from the start"
        what = f"the displacements{qualifier} are" if len(equations) > 1 else f"the displacement{qualifier} is"
        return f", so that {what} {join_words(equations)}"

    def _product(self, one: Mode, other: Mode) -> Expression:
        """Return the product aᵀM b of two mode shapes a and b with the mass matrix M."""
        product: Expression = ZERO
        for i, a in enumerate(one.shape):
            for j, b in enumerate(other.shape):
                mass = self.entry(i, j)[1]
                product = product + mass.expression() * (a * b) if mass else product
        return product

    def _shaped(self, mode: Mode) -> None:
        """Write the mode shape: the amplitudes of the free coordinates, of which the greatest is 1."""
        if mode.square == ZERO:
            mode.first = int(np.argmax(np.abs(self.shapes[:, mode.number])))
            self.write_laws(mode)
        names = [part.name for part in mode.shape if isinstance(part, Symbol)]
        if not names:
            return
        rows = [self.row(mode, i) for i in range(self.size) if i != mode.first]
        step = self.book.begin_step("shape")
        step.rest_on(f"mode {mode.number}")
        equations = self._solve(step, [pulls - inertia for pulls, inertia in rows], names)
        of = f"With ${mode.square.latex()}$," if mode.square != ZERO else "So"
        step.add_text(f"{of} {join_words(equations)}.")
        step.close()

    def _solve(self, step: StepBuilder, rows: list[Polynomial], names: list[str]) -> list[str]:
        """Record the solution of linear equations for some names and return each in LaTeX."""
        left, equations = [*names], list[str]()
        waiting = [*rows]
        while left:
            row = next((r for r in waiting if len(r.names() & {*left}) == 1), None)
            if row is None:
                return equations + self._together(step, waiting, left)
            waiting.remove(row)
            (name,) = row.names() & {*left}
            equations.append(step.result(Symbol(name), solve_linear(row, name), ""))
            left.remove(name)
        return equations

    def _together(self, step: StepBuilder, rows: list[Polynomial], left: list[str]) -> list[str]:
        """Record the simultaneous solution of linear equations by Cramer's rule and return each in LaTeX."""
        equations: list[str] = []
        coefficients = [[row.coefficient(name) for name in left] for row in rows[: len(left)]]
        rest = [row.terms_without(left).scale(-1.0) for row in rows[: len(left)]]
        for name, formula in zip(left, cramer(coefficients, rest), strict=True):
            written = formula if len(formula.latex()) <= MAX_FORMULA_LENGTH else self.book.defer_to_number(formula)
            equations.append(step.result(Symbol(name), written, ""))
        return equations

    # ---- what is excited

    def _along(self, mode: Mode, of: Sequence[Polynomial]) -> Expression:
        """Return the scalar product of a mode shape with a quantity that has one value per free coordinate."""
        product: Expression = ZERO
        for part, component in zip(mode.shape, of, strict=True):
            product = product + part * component.expression() if component else product
        return product

    def _started(self, mode: Mode, *, alone: bool) -> None:
        """Write the effective mass, the angular frequency and the course of a mode."""
        free, n = self.motion.free, mode.number + 1
        pushes = [self.motion.load(i) for i in free]
        carried = [total(self.motion.mass(i, j) * self.first[b] for b, j in enumerate(free)) for i in free]
        push, momentum = self._along(mode, pushes), self._along(mode, carried)
        own = self._own_mass(mode, named=not alone)
        if mode.square != ZERO:
            mode.rate = self.book.fresh(r"\omega", str(n))
            text = "Its angular frequency is" if alone else f"The angular frequency of mode {n} is"
            self.book.add_step("rate", text, mode.rate, Root(mode.square), ANGULAR_SPEED)
        shape = self.shapes[:, mode.number]
        carry = shape * (self.mass @ self.initial_rates)
        moves = momentum != ZERO and abs(float(carry.sum())) > EXCITATION_RTOL * float(np.abs(carry).max())
        self._tell_course(mode, own, push if self._pushed(mode.number) else ZERO, momentum if moves else ZERO)

    def _tell_course(self, mode: Mode, own: Expression, push: Expression, momentum: Expression) -> None:
        """Write the coordinate of a mode as a function of time, with its coefficients."""
        if push == ZERO and momentum == ZERO:
            return
        step, mark, equations = self.book.begin_step("start"), str(mode.number + 1), list[str]()
        driven = mode.square != ZERO
        if push != ZERO:
            mode.rise = self.book.fresh("b", mark)
            below = own * mode.square if driven else own
            result = step.result(mode.rise, push / below, METRES if driven else ACCELERATION, law=True)
            equations.append(f"{result} (the {'equilibrium value' if driven else 'acceleration'})")
        if momentum != ZERO:
            mode.swing = self.book.fresh("c", mark)
            below = own * mode.rate if mode.rate is not None else own
            result = step.result(mode.swing, momentum / below, METRES if driven else SPEED, law=True)
            equations.append(f"{result} (from the initial velocities)")
        step.add_text(self._motion(mode, own, push, momentum), f"Here {join_words(equations)}.")
        step.close()

    def _motion(self, mode: Mode, own: Expression, push: Expression, momentum: Expression) -> str:
        """Return a sentence with the equation of motion of a mode and its solution."""
        name = mode.name if self.size > 1 else self.names[0]
        right = push - own * mode.square * name if mode.square != ZERO else push
        start = f"${name.latex()} = 0$ and ${dotted(name, 1).latex()} = {(momentum / own).latex()}$"
        course = place([replace(mode, shape=[ONE])], 0, Symbol("t")).latex()
        return (
            f"The equation of motion of mode {mode.number + 1} is ${(own * dotted(name)).latex()} = {right.latex()}$, "
            f"and its solution with {start} at $t = 0$ is ${name.latex()} = {course}$."
        )

    def _own_mass(self, mode: Mode, *, named: bool) -> Expression:
        """Return the effective mass aᵀM a of a mode, written with a symbol if `named`."""
        effective_mass: Expression = ZERO
        for i, one in enumerate(mode.shape):
            for j, other in enumerate(mode.shape):
                mass = self.entry(i, j)[1]
                if mass and j >= i:
                    pair = Power(one, 2) if i == j and one != ONE else one * other
                    effective_mass = effective_mass + (mass.scale(1.0 if i == j else 2.0)).expression() * pair
        if not named:
            return effective_mass
        name = self.book.fresh(r"\mu", str(mode.number + 1))
        return self.book.add_step(
            "modal mass", f"The effective mass of mode {mode.number + 1} is", name, effective_mass, KILOGRAMS
        )
