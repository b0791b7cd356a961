"""Arguments that exclude the other roots of an equation."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from math import inf, pi

from sim2reason.solutions.algebra.evaluated import Chain
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Absolute, Call, Root
from sim2reason.solutions.algebra.root_finding import is_explicit, range_text, substitute, values_with
from sim2reason.solutions.algebra.standard_equations import beyond_right_angle
from sim2reason.solutions.solution import ANSWER_RTOL, with_unit
from sim2reason.solutions.writing.notation import DEGREES, SECONDS
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, UnsolvedError, record_inequality

Sides = tuple[Expression, Expression]
"""The left and right sides of an equation."""
OTHER_ROOT_LEAD = "With the other root for {}, {}"
MAX_COMPARISON_LENGTH = 6000  # maximum length of the LaTeX of a comparison after substitution
UNDEFINED = (UnsolvedError, ValueError, ArithmeticError, KeyError, TypeError)


class OtherRoots:
    """The writer of the reasons that exclude other roots in a reverse question, verified where possible."""

    def __init__(self, book: SolutionBuilder, unknown: str, chain: Callable[[str], Chain]) -> None:
        """Take the symbol of the unknown and a function that returns the chain of formulas on which a name depends."""
        self.book, self.unknown, self._chain = book, unknown, chain

    def write_exclusions(
        self, step: StepBuilder, name: str, found: Expression, others: Sequence[float], written: Sequence[Sides]
    ) -> None:
        """Write why the other roots of the equation for a name are excluded.

        `others` are the other roots; the first of the `written` equations is the one that the text shows.
        """
        book = self.book
        if book.in_symbols:
            return
        if name == self.unknown:
            self.schedule_exclusion(others)
        if len(others) == 1:
            self.drop(step, name, others)
            self._too_late(step, name, others)
            self._breaks_assumption(step, name, others[0])
        elif not others and len(written) > 1:
            self._from_squaring(step, name, *written)
        if book.units[name] == DEGREES:
            step.add_text(beyond_right_angle(others, book.values[name]) or self._obtuse(step, name, found))

    def drop(self, step: StepBuilder, name: str, others: Sequence[float]) -> None:
        """Write why the only other root is excluded: a negative root, or one that follows from a negative unknown."""
        book = self.book
        if len(others) != 1 or book.values[self.unknown] <= 0.0 or (name == self.unknown and others[0] >= 0.0):
            return
        if name == self.unknown:
            self._say_negative(step, others[0])
        elif self._would_be_negative(name, others[0]):
            step.add_text(f"The other root, {self._number(name, others[0])}, would take a negative ${self.unknown}$.")
        else:
            self._say_never(step, name, others[0])

    def _say_negative(self, step: StepBuilder, value: float) -> None:
        number = self._number(self.unknown, value)
        step.add_text(f"The other root, {number}, is negative, but ${self.unknown}$ is positive.")

    def _number(self, name: str, value: float) -> str:
        return f"${with_unit(value, self.book.units[name])}$"

    def schedule_exclusion(self, others: Sequence[float], lead: str = OTHER_ROOT_LEAD, *, must: bool = False) -> None:
        """Schedule a final step that excludes other values of the unknown, by an assumed inequality that they violate.

        It is written when all assumed comparisons are. The sentence begins with `lead`. With `must`, UnsolvedError is
        raised if no comparison fails, as then nothing determines the root.
        """
        right_angle = self.book.units[self.unknown] == DEGREES
        for value in others:
            if value > 0.0 and self.book.passage and self.book.units[self.unknown] == SECONDS:
                self.book.checks.setdefault((self, value), partial(self._tell_passage, value))
            elif 0.0 < value < (0.5 * pi if right_angle else inf):  # of a greater angle the text says that it is one
                self.book.checks.setdefault((self, value), partial(self._write_exclusion, value, lead, must=must))

    def _tell_passage(self, value: float) -> None:
        """Write why a first or second time excludes the other root: that root is later, or earlier."""
        name, ordinal = Symbol(self.unknown), ("first", "second")[self.book.passage - 1]
        earlier = self.book.passage > 1 and value < self.book.values[self.unknown]
        step = self.book.begin_step("verify")
        record_inequality(self.book, step, *((name, Number(value)) if earlier else (Number(value), name)))
        other = f"The other root, {self._number(name.name, value)},"
        step.add_text(f"{other} is {'earlier' if earlier else 'later'}: ${name.name}$ is the {ordinal} time.")
        step.close()

    def _write_exclusion(self, value: float, lead: str, *, must: bool) -> None:
        formulas = {name: formula for name, formula in self.book.formulas.items() if name not in self.book.stated}
        relations = [relation for step in self.book.steps for relation in step.relations]
        for relation in relations:
            if relation.role == "verified" and isinstance(relation.left, Symbol):
                formulas.setdefault(relation.left.name, relation.right)
        for relation in relations:
            if relation.role != "exceeds" or isinstance(relation.left, Number):
                continue
            try:
                left, right = (self._with(side, formulas, value) for side in (relation.left, relation.right))
                broken = self.book.value(right) > self.book.value(left)
            except UNDEFINED:
                continue
            if broken:
                step = self.book.begin_step("verify")
                record_inequality(self.book, step, right, left)
                positive = "positive" if relation.right == ZERO else f"greater than ${relation.right.latex()}$"
                number = self._number(self.unknown, value)
                step.add_text(f"{lead.format(f'${self.unknown}$', number)}, ${relation.left.latex()}$ would not be")
                step.add_text(f"{positive}.")
                step.close()
                return
        if must:
            raise UnsolvedError(f"nothing that it states excludes the other root, {value:.5g}")

    def _with(self, side: Expression, held: dict[str, Expression], value: float) -> Expression:
        """Return a formula in terms of the unknown alone, with a value substituted for the unknown.

        Raises:
            UnsolvedError: the formula becomes too long.
        """
        for name in reversed(held):
            side = substitute(side, name, held[name])
            if len(side.latex()) > MAX_COMPARISON_LENGTH:
                raise UnsolvedError("it becomes too long")
        return substitute(side, self.unknown, Number(value))

    def _too_late(self, step: StepBuilder, name: str, others: Sequence[float]) -> None:
        """Write that another root is later than a stated instant that ends the stage."""
        book = self.book
        stated = [instant for instant in book.stated if book.units[instant] == book.units[name] == SECONDS]
        late = [instant for instant in stated if book.values[name] < book.values[instant] < others[0]]
        if late:
            step.add_text(f"The other root, {self._number(name, others[0])}, is later than ${late[0]}$.")

    def _say_never(self, step: StepBuilder, name: str, value: float) -> None:
        """Write that no value of the unknown leads to another root, or schedule the exclusion of the values that do."""
        if name == self.unknown:
            return
        chain = self._chain(name)
        values = values_with(chain, value, self.unknown, self.book) if is_explicit(chain) else None
        if values:
            self.schedule_exclusion(values, must=True)
        elif values is not None:
            what = range_text(self.unknown, self.book)
            step.add_text(f"No {what} gives the other root, {self._number(name, value)}.")

    def _would_be_negative(self, name: str, value: float) -> bool:
        """Return whether a quantity that is linear in the unknown has a given value only for a negative unknown."""
        at, known, chain = self.book.values, self.book.values[self.unknown], self._chain(name)
        try:
            one, two, three = (float(chain.value({**at, self.unknown: n * known}).real) for n in (1.0, 2.0, 3.0))
        except (ValueError, ArithmeticError):  # it has no value for twice the number
            return False
        straight = two != one and abs(three - 2.0 * two + one) <= 1e-9 * max(abs(one), abs(two))
        return straight and (value - one) / (two - one) < -1.0

    def _breaks_assumption(self, step: StepBuilder, name: str, value: float) -> None:
        """Write an inequality that the equations assume and that another root of a quantity violates."""
        for left, right in self._assumed(name):
            try:
                more, less = substitute(right, name, Number(value)), substitute(left, name, Number(value))
                broken = self.book.value(more) > self.book.value(less)
            except UNDEFINED:
                continue
            if broken:
                record_inequality(self.book, step, more, less)
                step.add_text(
                    f"With the other root, {self._number(name, value)}, ${left.latex()}$ would not be greater than "
                    f"${right.latex()}$."
                )
                return

    def _assumed(self, name: str) -> Iterator[Sides]:
        """Yield both sides of each inequality in the steps that contains a name and otherwise only known names."""
        for relation in (relation for step in self.book.steps for relation in step.relations):
            names = relation.names
            if relation.role == "exceeds" and name in names and self.book.hidden.isdisjoint(names - {name}):
                yield relation.left, relation.right

    def _from_squaring(self, step: StepBuilder, name: str, shown: Sides, plain: Sides) -> None:
        """Write that the other root of the displayed quadratic is negative or fails the original equation."""
        other, known = self._other_of_quadratic(name, shown), self.book.values[name]
        if other is None:
            return
        number = self._number(name, other)
        if other < 0.0 < known and name == self.unknown:
            self._say_negative(step, other)
        elif any(isinstance(part, Root) and name in part.names for side in plain for part in _parts(side)):
            size = ANSWER_RTOL * max(abs(self.book.value(plain[0])), abs(self.book.value(plain[1])))
            try:
                gap = Absolute(substitute(plain[0], name, Number(other)) - substitute(plain[1], name, Number(other)))
                misses = self.book.value(gap) > size
            except UNDEFINED:
                return
            if misses:
                record_inequality(self.book, step, gap, ZERO)
                step.add_text(f"The other root, {number}, does not satisfy the equation before it is squared.")
        elif name == self.unknown:
            self.schedule_exclusion([other], must=True)
        else:
            self._say_never(step, name, other)

    def _other_of_quadratic(self, name: str, shown: Sides) -> float | None:
        """Return the second root of an equation that is quadratic in a name; None for any other equation."""
        known = self.book.values[name]

        def excess(size: float) -> float:
            at = {**self.book.values, name: size * known}
            return float((shown[0].value(at) - shown[1].value(at)).real)

        try:
            less, one, two, three = (excess(size) for size in (-1.0, 1.0, 2.0, 3.0))
        except UNDEFINED:
            return None
        slope, middle = (one - less) / 2.0, (one + less) / 2.0  # of α x² + β x + γ: β and α + γ
        bend = (two - middle - 2.0 * slope) / 3.0
        rest, scale = middle - bend, abs(less) + abs(two) + abs(three)
        fits = abs(9.0 * bend + 3.0 * slope + rest - three) <= ANSWER_RTOL * scale and abs(one) <= ANSWER_RTOL * scale
        root = rest / bend if abs(bend) > ANSWER_RTOL * scale else 1.0
        return root * known if fits and abs(root - 1.0) > ANSWER_RTOL else None

    def _obtuse(self, step: StepBuilder, name: str, found: Expression) -> str:
        """Return a sentence that the other angle with the same sine exceeds 90°; empty unless an arcsine was taken."""
        inverse = -found if found.negative else found
        known = self.book.values[name]
        if not isinstance(inverse, Call) or inverse.function != "arcsin" or not 0.0 < known < 0.5 * pi:
            return ""
        record_inequality(self.book, step, PI - Symbol(name), Number(0.5) * PI)
        return f"The other angle with this sine, {self._number(name, pi - known)}, is more than $90^\\circ$."


def _parts(formula: Expression) -> Iterator[Expression]:
    yield formula
    for part in formula.parts:
        yield from _parts(part)
