"""Formulas: equal to the reference in value, wherever the symbols are set.

A response is evaluated at bindings that it cannot foresee: those of the item, and ones where each symbol in turn is
moved, or, without an item, ones drawn from a hash of the reference. Any equivalent form passes, no number does.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from hashlib import blake2b
from itertools import islice
from typing import Final

from sim2reason.dsl.units import Unit
from sim2reason.grading import arithmetic
from sim2reason.grading.arithmetic import Node
from sim2reason.grading.extract import boxed
from sim2reason.grading.number import number
from sim2reason.grading.parser import parse
from sim2reason.grading.score import Outcome, Refused, Score
from sim2reason.grading.statement import last_side, unit_of
from sim2reason.grading.tokens import Token, canonical

__all__ = ["FormulaError", "formula"]

POINTS: Final = 8
TRIES: Final = 256
LOWEST, HIGHEST = 0.2, 1.5  # where symbols are drawn: positive, as physical quantities are, and angles acute
NEGLIGIBLE: Final = 1e-9  # a reference this small beside its others has lost its digits

Bindings = Mapping[str, float]
_Frozen = tuple[tuple[str, float], ...]


class FormulaError(ValueError):
    """A reference, or bindings for it, that nothing could be graded against."""


def formula(
    response: str,
    reference: str,
    bindings: Bindings | Sequence[Bindings] | None = None,
    *,
    symbols: Collection[str] | None = None,
    tolerance: float = 1e-6,
) -> Score:
    r"""Grade a boxed formula against `reference` by value.

    Args:
        response: the whole text, with its thinking.
        reference: LaTeX or plain text; one without symbols is graded as a number.
        bindings: values for all symbols, one mapping or several; drawn from a hash of the reference if None.
        symbols: the item's table, in any spelling (``\mu_k``, ``mu_k``); by default the names that the bindings
            have, or else those in the reference. ``e`` is Euler's number unless it is in the table.
        tolerance: relative, at each of the bindings.

    Raises:
        FormulaError: for a reference that cannot be read or has no value, bindings that leave symbols out, or a
            tolerance outside [0, 1).
    """
    if not 0 <= tolerance < 1:
        raise FormulaError("the tolerance must be in [0, 1)")
    if bindings is None:
        given: tuple[_Frozen, ...] = ()
    else:
        each = [bindings] if isinstance(bindings, Mapping) else bindings
        given = tuple(tuple(sorted(binding.items())) for binding in each)
    truth = _truth(reference, given, None if symbols is None else frozenset(symbols))
    if not truth.table:
        return number(response, truth.values[0])
    try:
        return _judge(boxed(response), truth, tolerance)
    except Refused as refused:
        return refused.score


@dataclass(frozen=True, slots=True)
class _Truth:
    """A reference: its table of symbols, and its values at the points where responses are tried."""

    table: frozenset[str]
    points: tuple[Bindings, ...]
    values: tuple[float, ...]


@lru_cache(maxsize=512)
def _truth(reference: str, given: tuple[_Frozen, ...], symbols: frozenset[str] | None) -> _Truth:
    try:
        bindings: list[Bindings] = [{canonical(name): value for name, value in binding} for binding in given]
        named = frozenset(canonical(name) for name in symbols) if symbols is not None else None
        table = frozenset(bindings[0]) if named is None and bindings else named
        tokens = last_side(reference, table)
        node = _value_of(reference, tokens)
    except (Refused, ValueError) as error:
        raise FormulaError(f"the reference {reference!r}: {error}") from error
    used = frozenset(token.text for token in tokens if token.kind == "symbol")
    if not used:
        return _kept(reference, used, [({}, value)] if (value := arithmetic.value(node, {})) is not None else [])
    table = used if table is None else table
    if any(table - binding.keys() for binding in bindings):
        raise FormulaError(f"the bindings for {reference!r} leave out a symbol")
    points = _around(bindings, reference, node) if bindings else _drawn(table, reference)
    valued = ((point, value) for point in points if (value := arithmetic.value(node, point)) is not None)
    values = list(valued if bindings else islice(valued, POINTS))
    if [point for point, _ in values[: len(bindings)]] != bindings:
        raise FormulaError(f"the reference {reference!r} has no value at its bindings")
    return _kept(reference, table, values)


def _kept(reference: str, table: frozenset[str], values: list[tuple[Bindings, float]]) -> _Truth:
    """The points where the reference has digits to compare: a difference that cancels has none."""
    scale = max((abs(value) for _, value in values), default=0.0)
    sound = [(point, value) for point, value in values if abs(value) > NEGLIGIBLE * scale or not table]
    if not sound:
        raise FormulaError(f"the reference {reference!r} has no value where it was tried")
    return _Truth(table, tuple(point for point, _ in sound), tuple(value for _, value in sound))


def _share(*seed: object) -> float:
    """A number in [0, 1) that depends on nothing but `seed`."""
    digest = blake2b("\0".join(map(str, seed)).encode(errors="replace"), digest_size=8).digest()
    return int.from_bytes(digest) / 2**64


def _drawn(table: frozenset[str], reference: str) -> Iterator[Bindings]:
    """Points over the whole range; more than are needed, since a reference may not have a value at each."""
    for attempt in range(TRIES):
        yield {name: LOWEST + (HIGHEST - LOWEST) * _share(reference, attempt, name) for name in sorted(table)}


def _around(bindings: Sequence[Bindings], reference: str, node: Node) -> Iterator[Bindings]:
    """The given points, and the first with each symbol in turn moved by 1 to 5 %: the answer must move alike.

    Where a move leaves the domain of the reference, the other direction is taken, or a tenth of the way.
    """
    yield from bindings
    first = bindings[0]
    for name in sorted(first):
        step = 0.01 + 0.04 * _share(reference, name)
        moves = (first[name] * (1 + move) if first[name] else move for move in (step, -step, step / 10, -step / 10))
        points = ({**first, name: moved} for moved in moves)
        yield from islice((point for point in points if arithmetic.value(node, point) is not None), 1)


def _value_of(content: str, tokens: Sequence[Token]) -> Node:
    """The value that `tokens` spell; only a unit in upright text may follow it, and is ignored."""
    node, taken, refusal = parse(tokens, unit_follows=False)
    if taken < len(tokens):
        _ignored_unit(content, tokens[taken:], refusal)
    return node


def _ignored_unit(content: str, rest: Sequence[Token], refusal: Refused | None) -> Unit:
    words = [token for token in rest if token.kind == "word"]
    names = any(token.kind in {"symbol", "constant", "percent", "degree"} for token in rest)
    if names or not words or not all(word.upright for word in words):
        shown = words[0].text if words else rest[0].text
        raise refusal or Refused(Outcome.UNREADABLE, f"{shown!r} is not among the symbols of the problem")
    return unit_of(content, rest, refusal)


def _judge(content: str, truth: _Truth, tolerance: float) -> Score:
    node = _value_of(content, last_side(content, truth.table))
    said = content.strip()
    for point, expected in zip(truth.points, truth.values, strict=True):
        found = arithmetic.value(node, point)
        if found is None or not abs(found - expected) <= tolerance * abs(expected):
            where = ", ".join(f"{name} = {value:.4g}" for name, value in sorted(point.items()))
            shown = "has no finite value" if found is None else f"is {found:.6g}"
            return Score.of(Outcome.WRONG, said, f"at {where} it {shown}; expected {expected:.6g}")
    return Score.of(Outcome.CORRECT, said, f"it equals the reference at all {len(truth.points)} points tried")
