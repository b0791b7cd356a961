"""Whether the numbers that stand for the symbols of a question decide which way something moves."""

from collections.abc import Collection, Iterator

import numpy as np

from sim2reason.questions.regimes.direction import MovesOneWay
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import Absolute
from sim2reason.solutions.closed_forms.closed_form import defined_by
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.writing.steps import Book

SAMPLES = 40
BAR = r"\left|"
DECADES = 1.0  # by which a number is varied, up and down


def either_way(setting: Setting, book: Book, held: Expression, bodies: Collection[str]) -> bool:
    """Return whether a quantity of some bodies in symbols may be positive or negative, with no direction assumed."""
    if not book.in_symbols or any(isinstance(each, MovesOneWay) and each.name in bodies for each in setting.assumed):
        return False
    return len({*_signs(setting, book, held)}) > 1


def of_motion(setting: Setting, book: Book, begun: Expression, a: Symbol, bodies: Collection[str]) -> Expression:
    """Return the acceleration of bodies over a distance; its magnitude where they may set off from rest either way."""
    return Absolute(a) if begun == ZERO and either_way(setting, book, a, bodies) else a


def is_open(setting: Setting, book: Book, held: Expression, body: str) -> bool:
    """Return whether numbers decide on the sign of a quantity of a body of which an answer in symbols has bars."""
    return setting.formula is not None and BAR in setting.formula.latex and either_way(setting, book, held, [body])


def reason_for_negative(setting: Setting, book: Book, held: Expression, body: str) -> str:
    """Return the words that say that a quantity is negative, if the answer's formula supposes it; else nothing."""
    if not book.in_symbols or setting.formula is None or BAR in setting.formula.latex:
        return ""
    why = " under the assumption made" if either_way(setting, book, held, [body]) else ""
    return f"${held.latex()}$ is negative{why}"


def _signs(setting: Setting, book: Book, held: Expression) -> Iterator[bool]:
    """Yield whether a quantity is positive, for other numbers in place of those that are given."""
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
            yield float(held.value(at).real) > 0.0
        except (KeyError, ValueError, ArithmeticError):  # it is no motion with these numbers
            continue
