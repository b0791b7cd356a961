"""Usual meanings of single letters, to detect expressions of another dimension than the requested one.

For example, *xy* is not a length, and *a/g* not an acceleration. The table contains only meanings common to textbooks;
a letter with several meanings has all of them, and other letters may mean anything.
"""

from collections.abc import Sequence
from itertools import product
from typing import Final

from sim2reason.grading import arithmetic, labels
from sim2reason.grading.arithmetic import Node
from sim2reason.grading.parser import parse
from sim2reason.grading.score import Refused
from sim2reason.grading.tokens import Token
from sim2reason.scenes.dsl.units import Dimension, Unit, parse_unit

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
_MAX_LETTERS: Final = 6  # letters of an expression
_SCALES: Final = (1.9, 2.3, 3.1)  # factors by which the units of length, mass and time are enlarged
_SCALING_RTOL: Final = 1e-9


def may_be(side: Sequence[Token], unit: Unit) -> bool:
    """Return whether an expression may be a quantity in `unit`; False if its letters have another dimension."""
    found = labels.names(side)
    letters = list(dict.fromkeys(letter for letter, _ in found))
    if len(found) <= 1 or len(letters) > _MAX_LETTERS or any(letter not in _USUAL for letter in letters):
        return True
    node = _expression(side)
    if node is None:
        return True
    meanings = [dict(zip(letters, meant, strict=True)) for meant in product(*(_USUAL[letter] for letter in letters))]
    return any(_has_dimension(node, meant, unit.dimension) for meant in meanings)


def _expression(side: Sequence[Token]) -> Node | None:
    """Parse a side as an expression of letters and numbers; None if it is not one."""
    tokens = list[Token]()
    for token in side:
        letters = labels.names([token])
        if token.kind in {"word", "symbol"} and not letters:
            return None
        if token.kind == "mark":
            continue
        named = (token._replace(kind="symbol", text=letter) for letter, _ in letters)
        tokens += named if letters else [token]
    try:
        node, taken, _ = parse(tokens, unit_follows=False)
    except Refused:
        return None
    return node if taken == len(tokens) else None


def _has_dimension(node: Node, meant: dict[str, Dimension], wanted: Dimension) -> bool:
    """Return whether an expression has a dimension, by its scaling with the units of length, mass and time."""
    here = arithmetic.value(node, {letter: 1.0 + 0.3 * place for place, letter in enumerate(meant)})
    if not here:
        return True
    for axis, scale in enumerate(_SCALES):
        larger = {letter: (1.0 + 0.3 * n) * scale ** meant[letter][axis] for n, letter in enumerate(meant)}
        there = arithmetic.value(node, larger)
        if there is not None and abs(there - here * scale ** wanted[axis]) > _SCALING_RTOL * abs(there):
            return False
    return True
