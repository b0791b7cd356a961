"""The LaTeX of formulas in relations, as one would write them."""

import re

from sim2reason.solutions.algebra.expressions import Expression
from sim2reason.solutions.algebra.signs import with_plain_signs
from sim2reason.solutions.algebra.storeys import is_reducible, is_storeyed, one_storey

SIGNS = re.compile(r"\\left\(-|-\\frac|-\\left\(|\{-")
"""Matches the LaTeX of formulas whose signs can be simplified."""
SYMBOL = r"(?<![A-Za-z\\])(\\?[A-Za-z]+(?:_\w|_\{[^{}]*\})?)"
REPEATED = re.compile(SYMBOL + r"(?:\^\{\d\})? \1(?![\w'])")
"""Matches the LaTeX of products in which a symbol stands twice."""


def plain_latex(held: Expression) -> str:
    """Return the LaTeX of a formula with signs as one would write them, and its fractions reduced."""
    found = held.latex()
    if SIGNS.search(found):
        found = (held := with_plain_signs(held)).latex()
    fractions = found.count("frac{")
    nested = fractions > 1 and is_storeyed(held)
    if nested or (fractions and is_reducible(held)) or REPEATED.search(found):
        return one_storey(held).latex()
    return found
