"""Quantities in symbols whose sign depends on the numbers for which the symbols stand."""

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


def has_either_sign(setting: Setting, book: Book, held: Expression, bodies: Collection[str]) -> bool:
    """Return whether a quantity in symbols may be positive or negative, for bodies with no assumed direction."""
    if not book.in_symbols or any(isinstance(each, MovesOneWay) and each.name in bodies for each in setting.assumed):
        return False
    return len({*_signs(setting, book, held)}) > 1


def acceleration_over_distance(
    setting: Setting, book: Book, begun: Expression, a: Symbol, bodies: Collection[str]
) -> Expression:
    """Return an acceleration for d = ½ a t²: its magnitude if the bodies may start from rest in either direction."""
    return Absolute(a) if begun == ZERO and has_either_sign(setting, book, a, bodies) else a


def needs_modulus(setting: Setting, book: Book, held: Expression, body: str) -> bool:
    """Return whether a quantity may have either sign, and the answer in symbols is written as a modulus."""
    return setting.formula is not None and BAR in setting.formula.latex and has_either_sign(setting, book, held, [body])


def reason_for_negative(setting: Setting, book: Book, held: Expression, body: str) -> str:
    """Return a clause that a quantity is negative; empty for an answer in numbers or one written as a modulus."""
    if not book.in_symbols or setting.formula is None or BAR in setting.formula.latex:
        return ""
    why = " under the assumption made" if has_either_sign(setting, book, held, [body]) else ""
    return f"${held.latex()}$ is negative{why}"


def _signs(setting: Setting, book: Book, held: Expression) -> Iterator[bool]:
    """Yield whether a quantity is positive, for random numbers in place of the given numbers."""
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
