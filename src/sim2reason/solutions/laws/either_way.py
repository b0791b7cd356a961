"""Signs of quantities in symbols, which depend on the values of the symbols."""

from collections.abc import Collection, Iterator, Mapping, Sequence

import numpy as np

from sim2reason.grading.formula import compiled
from sim2reason.questions.regimes.directions import MovesOneWay
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import Absolute
from sim2reason.solutions.closed_forms.closed_form import defined_by
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.writing.steps import SolutionBuilder

SAMPLES = 40
BAR = r"\left|"
DECADES = 1.0  # random factors range over this many decades up and down


def has_either_sign(setting: ProblemContext, book: SolutionBuilder, held: Expression, bodies: Collection[str]) -> bool:
    """Return whether the numbers decide the sign of a symbolic quantity, for bodies without an assumed direction."""
    if not book.in_symbols or any(isinstance(each, MovesOneWay) and each.name in bodies for each in setting.assumed):
        return False
    return len({positive for positive, _ in _signs(setting, book, held)}) > 1


def acceleration_over_distance(
    setting: ProblemContext, book: SolutionBuilder, begun: Expression, a: Symbol, bodies: Sequence[str]
) -> tuple[Expression, str]:
    """Return the acceleration for d = ½ a t², or its magnitude for motion either way, and a clause with the reason.

    The magnitude is returned for bodies that may start in either direction, unless an assumption excludes one.
    """
    if begun != ZERO or not has_either_sign(setting, book, a, bodies):
        return a, ""
    if book.value(a) > 0.0 and _is_assumed_positive(setting, book, a):
        return a, f", as ${a.latex()} > 0$ under the assumption made"
    return Absolute(a), f", whichever way {setting.display_name(bodies[0])} moves"


def needs_modulus(setting: ProblemContext, book: SolutionBuilder, held: Expression, body: str) -> bool:
    """Return whether the symbolic answer for a quantity of either sign is written as an absolute value."""
    return setting.formula is not None and BAR in setting.formula.latex and has_either_sign(setting, book, held, [body])


def reason_for_negative(setting: ProblemContext, book: SolutionBuilder, held: Expression, body: str) -> str:
    """Return a clause that a quantity is negative; empty for a numerical answer or an absolute value."""
    if not book.in_symbols or setting.formula is None or BAR in setting.formula.latex:
        return ""
    why = " under the assumption made" if has_either_sign(setting, book, held, [body]) else ""
    return f"${held.latex()}$ is negative{why}"


def _is_assumed_positive(setting: ProblemContext, book: SolutionBuilder, held: Expression) -> bool:
    """Return whether the answer is negative or undefined for all sampled numbers for which a quantity is negative.

    An answer that holds under an assumption is positive, so this quantity is positive under that assumption.
    """
    if not setting.assumed or setting.formula is None:
        return False
    try:
        answer = compiled(setting.formula.latex, setting.formula.symbols)
        values = [answer.value(at) for positive, at in _signs(setting, book, held) if not positive]
    except (KeyError, ValueError):  # contains a number defined later
        return False
    return all(value is None or value < 0.0 for value in values)


def _signs(
    setting: ProblemContext, book: SolutionBuilder, held: Expression
) -> Iterator[tuple[bool, Mapping[str, float]]]:
    """Yield whether a quantity is positive for one random set of the given numbers, with these numbers by symbol."""
    formulas = defined_by(book.steps)
    angles = {given.symbol for given in setting.lexicon.givens.values() if given.angle}
    random = np.random.default_rng(0)
    for _ in range(SAMPLES):
        at = {
            name: random.uniform(0.1, 1.5) if name in angles else value * 10.0 ** random.uniform(-DECADES, DECADES)
            for name, value in book.values.items()
            if name not in formulas
        }
        try:
            for name, formula in formulas.items():
                at[name] = float(formula.value(at).real)
            yield float(held.value(at).real) > 0.0, at
        except (KeyError, ValueError, ArithmeticError):  # no motion with these numbers
            continue
