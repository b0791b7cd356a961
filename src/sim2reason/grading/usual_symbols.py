"""What single letters usually stand for, so that their product is not taken for another quantity: *xy* is no length.

Only what textbooks agree on is here; a letter with several meanings has them all, and one that is not here may be any.
"""

from collections.abc import Sequence
from itertools import product
from typing import Final

from sim2reason.dsl.units import Dimension, Unit, parse_unit
from sim2reason.grading import labels
from sim2reason.grading.tokens import Token

__all__ = ["may_be"]

_USUAL: Final[dict[str, tuple[Dimension, ...]]] = {
    letter: tuple(parse_unit(unit).dimension for unit in units.split())
    for units, letters in (
        ("kg", "m M"),
        ("m", "x y z h H d D r R l L"),
        ("m s", "s"),
        ("s", "t"),
        ("m/s", "v u"),
        ("m/s^2", "g"),
        ("m/s^2 m", "a"),
        ("N", "F"),
        ("kg*m/s Pa", "p"),
        ("J", "E K"),
    )
    for letter in letters.split()
}
_MOST: Final = 4  # letters of a product
_KINDS: Final = frozenset({"word", "symbol", "mark", "times"})


def may_be(side: Sequence[Token], unit: Unit) -> bool:
    """Whether a side may be a quantity in `unit`: all but products of usual letters that have another dimension."""
    factors = [letter for letter, _ in labels.names(side)]
    if not 1 < len(factors) <= _MOST or any(token.kind not in _KINDS for token in side):
        return True
    if any(letter not in _USUAL for letter in factors):
        return True
    return any(
        tuple(map(sum, zip(*meant, strict=True)))[:7] == unit.dimension.base
        for meant in product(*(_USUAL[letter] for letter in factors))
    )
