"""Grading of formulas: a response is correct if its values equal those of the reference.

Response and reference are evaluated at unpredictable values of all symbols: at the item's bindings and, if these are
few, at points drawn by `points` from a hash of the reference. Every equivalent form is accepted, numbers and
approximations are not.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from sim2reason.grading import arithmetic, remarks
from sim2reason.grading.arithmetic import (
    TEST_POINTS,
    Bindings,
    Node,
    Ranges,
    draw_points,
    opposite_sign_points,
    well_conditioned_points,
)
from sim2reason.grading.extract import boxed
from sim2reason.grading.number import number
from sim2reason.grading.parser import parse
from sim2reason.grading.remarks import Direction
from sim2reason.grading.score import Outcome, Refused, Score
from sim2reason.grading.sides import Statement, flatten, is_signed, statement, two_values, unwrap
from sim2reason.grading.spelling import normalize_spelling, strip_unmatched_braces, vectors_as_components
from sim2reason.grading.tokens import Token, canonical, tokenize
from sim2reason.grading.units import parse_answer_unit
from sim2reason.scenes.dsl.units import UnitError

__all__ = ["CompiledFormula", "FormulaError", "compile_formula", "formula"]


@dataclass(frozen=True, slots=True)
class CompiledFormula:
    """A parsed formula, for repeated evaluation."""

    symbols: tuple[str, ...]
    """Those of its table that stand in it, as the table spells them."""
    _names: Mapping[str, str]
    _node: Node

    def value(self, point: Mapping[str, float]) -> float | None:
        """Return the value at `point`, which binds all `symbols`; None if it is not a finite real number."""
        return arithmetic.value(self._node, {self._names[name]: point[name] for name in self.symbols})


def compile_formula(latex: str, symbols: Collection[str]) -> CompiledFormula:
    r"""Parse a formula in the given `symbols`, in any spelling (``\mu_k``, ``mu_k``).

    Raises:
        ValueError: it is no formula in these symbols.
    """
    names = {name: canonical(name) for name in symbols}
    try:
        tokens = statement(flatten(tokenize(normalize_spelling(latex.strip()), frozenset(names.values())))).value
        node, taken, _ = parse(tokens, unit_follows=False)
    except Refused as refused:
        raise ValueError(f"{latex!r}: {refused}") from refused
    if taken != len(tokens):
        raise ValueError(f"{latex!r}: only its first {taken} of {len(tokens)} tokens are a formula")
    used = {token.text for token in tokens if token.kind == "symbol"}
    return CompiledFormula(tuple(name for name in names if names[name] in used), names, node)


APPROXIMATION_RTOL: Final = 0.02  # relative tolerance between a formula and the approximations of it in the same answer

_Frozen = tuple[tuple[str, float], ...]
_Ranged = tuple[tuple[str, tuple[float, float]], ...]


class FormulaError(ValueError):
    """An error for a reference or bindings with which no response can be graded."""


def formula(
    response: object,
    reference: str,
    bindings: Bindings | Sequence[Bindings] | None = None,
    *,
    symbols: Collection[str] | None = None,
    ranges: Ranges | None = None,
    positive: str = "",
    tolerance: float = 1e-6,
) -> Score:
    r"""Grade the formula in the box of a response by its values.

    Args:
        response: The whole text with its thinking, or a list of messages, of which the last counts. Any other object
            has no answer.
        reference: The right formula, in LaTeX or plain text; one without symbols is graded as a number.
        bindings: Values of all symbols, one mapping or several. Further values are drawn around them from a hash of the
            reference; beside eight or more, a response need not have a value there. None: drawn over `ranges`.
        symbols: Symbols of the problem, in any spelling (``\mu_k``, ``mu_k``); by default those of the bindings, or
            else those in the reference. ``e`` is Euler's number unless it is among them.
        ranges: Least and greatest value of symbols; others are drawn over a few decades.
        positive: Direction that counts as positive, in the words of the question; empty for a magnitude.
        tolerance: Relative difference that is allowed at each of the bindings.

    Returns:
        The score, with the text of the formula that was read.

    Raises:
        FormulaError: The reference cannot be read or has no value, a binding lacks a symbol, or the tolerance is
            outside [0, 1).

    Examples:
        >>> from sim2reason.grading import formula
        >>> formula(r"\boxed{\frac{1}{2} g t^2}", r"g t^2 / 2", {"g": 9.8, "t": 2.0}).reward
        1.0
        >>> formula(r"\boxed{g t^2}", r"g t^2 / 2", {"g": 9.8, "t": 2.0}).reward
        0.0
    """
    if not 0 <= tolerance < 1:
        raise FormulaError("the tolerance must be in [0, 1)")
    each = [] if bindings is None else [bindings] if isinstance(bindings, Mapping) else bindings
    given = tuple(tuple(sorted(binding.items())) for binding in each)
    named = None if symbols is None else frozenset(symbols)
    truth = _truth(reference, given, named, tuple(sorted((ranges or {}).items())), signed=bool(positive))
    if not truth.table:
        return number(response, truth.values[0], positive=positive)
    try:
        return _judge(boxed(response), truth, tolerance, positive)
    except Refused as refused:
        return refused.score


@dataclass(frozen=True, slots=True)
class _Truth:
    """The correct formula with its symbols, and its values at the points where responses are tested.

    A response must be defined at the first `firm` of them.
    """

    table: frozenset[str]
    points: tuple[Bindings, ...]
    values: tuple[float, ...]
    firm: int


@lru_cache(maxsize=512)
def _truth(
    reference: str, given: tuple[_Frozen, ...], symbols: frozenset[str] | None, ranged: _Ranged, *, signed: bool
) -> _Truth:
    try:
        bindings: list[Bindings] = [{canonical(name): value for name, value in binding} for binding in given]
        ranges = {canonical(name): ends for name, ends in ranged}
        named = frozenset(canonical(name) for name in symbols) if symbols is not None else None
        table = frozenset(bindings[0]) if named is None and bindings else named
        content = normalize_spelling(reference.strip())
        tokens = statement(flatten(tokenize(content, table))).value
        node, directions = _parse_value(content, tokens)
    except (Refused, ValueError) as error:
        raise FormulaError(f"the reference {reference!r}: {error}") from error
    used = frozenset(token.text for token in tokens if token.kind == "symbol")
    if directions:
        raise FormulaError(f"the reference {reference!r} has a direction")
    if not used:
        value = arithmetic.value(node, {})
        return _freeze_truth(reference, used, [] if value is None else [({}, value)])
    table = used if table is None else table
    if any(table - binding.keys() for binding in bindings):
        raise FormulaError(f"the bindings for {reference!r} leave out a symbol")
    if any(arithmetic.value(node, binding) is None for binding in bindings):
        raise FormulaError(f"the reference {reference!r} has no value at its bindings")
    given_points = well_conditioned_points(node, bindings)
    fresh = well_conditioned_points(node, list(draw_points(node, table, bindings, ranges, reference)))
    signs = {value > 0 for _, value in (*given_points, *fresh)}
    if bindings and len(signs) == 1 and (signed or len(bindings) < TEST_POINTS):
        fresh += well_conditioned_points(
            node, opposite_sign_points(node, table, bindings, 1.0 if True in signs else -1.0, reference)
        )
    if len(bindings) < TEST_POINTS:
        return _freeze_truth(reference, table, [*given_points, *fresh])
    if not signed:  # where a magnitude comes out negative, its formula does not hold
        fresh = [(point, value) for point, value in fresh if value * given_points[0][1] > 0] if given_points else []
    return _freeze_truth(reference, table, [*given_points, *fresh], firm=len(given_points))


def _freeze_truth(
    reference: str, table: frozenset[str], values: list[tuple[Bindings, float]], firm: int | None = None
) -> _Truth:
    if not values:
        raise FormulaError(f"the reference {reference!r} has no value where it was tried")
    points, expected = zip(*values, strict=True)
    return _Truth(table, points, expected, len(values) if firm is None else firm)


def _parse_value(content: str, tokens: Sequence[Token]) -> tuple[Node, tuple[Direction, ...]]:
    """Return the expression that the tokens spell, and the directions after it; an upright unit is ignored."""
    node, taken, refusal = parse(tokens, unit_follows=False)
    if taken == len(tokens):
        return node, ()
    rest = tokens[taken:]
    name, remark_text = remarks.cut(strip_unmatched_braces(content[rest[0].begin : rest[-1].finish]))
    remark = remarks.read(remark_text) if remark_text else None
    if remark is not None and remark.again:
        raise Refused(Outcome.UNREADABLE, f"{remark.again[0]!r} stands behind the formula")
    if not remarks.is_blank(name):
        _refuse_all_but_units(name, [token for token in rest if token.begin < rest[0].begin + len(name)], refusal)
    return node, remark.directions if remark is not None else ()


def _refuse_all_but_units(name: str, rest: Sequence[Token], refusal: Refused | None) -> None:
    words = [token for token in rest if token.kind == "word"]
    names = any(token.kind in {"symbol", "constant", "percent", "degree"} for token in rest)
    if names or not words or not all(word.upright for word in words):
        shown = words[0].text if words else rest[0].text
        raise refusal or Refused(Outcome.UNREADABLE, f"{shown!r} is not among the symbols of the problem")
    try:
        parse_answer_unit(name, None)
    except UnitError as error:
        raise refusal or Refused(Outcome.UNREADABLE, f"{name!r} after the value: {error}") from error


def _judge(content: str, truth: _Truth, tolerance: float, positive: str) -> Score:
    parsed = content.strip()
    content = vectors_as_components(normalize_spelling(content.rstrip(" \t\n.")))
    stated = statement(flatten(tokenize(content, truth.table)))
    node, directions = _parse_value(content, stated.value)
    exact = _checked(content, stated, node, truth, tolerance)
    if stated.rounded and exact is not None:
        node = exact
    if remarks.sign_for(directions, positive, written=is_signed(stated.value)) < 0:
        node = arithmetic.negated(node)
    for count, (point, expected) in enumerate(zip(truth.points, truth.values, strict=True)):
        actual = arithmetic.value(node, point)
        if actual is None and count >= truth.firm:
            continue
        if actual is None or not abs(actual - expected) <= tolerance * abs(expected):
            where = ", ".join(f"{name} = {value:.4g}" for name, value in sorted(point.items()))
            shown = "has no finite value" if actual is None else f"is {actual:.6g}"
            return Score.of(Outcome.WRONG, parsed, f"at {where} it {shown}; expected {expected:.6g}")
    return Score.of(Outcome.CORRECT, parsed, f"it equals the reference at all {len(truth.points)} points tried")


def _pairs(
    truth: _Truth, node: Node, wanted: Sequence[float | None]
) -> Iterator[tuple[Bindings, float | None, float | None]]:
    """Yield the test points, each with two values to compare: of the response's formula, and the wanted one."""
    for count, (point, other) in enumerate(zip(truth.points, wanted, strict=True)):
        actual = arithmetic.value(node, point)
        if count < truth.firm or (actual is not None and other is not None):
            yield point, actual, other


def _checked(content: str, stated: Statement, node: Node, truth: _Truth, tolerance: float) -> Node | None:
    """Return the expression before the last equals sign, if it is a value; Refused if it has other values."""
    last: Node | None = None
    if not stated.before and not stated.others:
        return None
    wanted = [arithmetic.value(node, point) for point in truth.points]
    for side in map(unwrap, stated.before):
        last = _parse_complete(side)
        if last is None:
            stated.refuse_unsolved(side)
            continue
        if _differ(last, wanted, truth, tolerance):
            shown = content[side[0].begin : side[-1].finish]
            raise Refused(Outcome.WRONG, f"{shown!r} does not agree with the formula behind it")
    for side in stated.others:
        if (other := _parse_complete(side)) is not None and _differ(other, wanted, truth, tolerance):
            raise two_values()
    return last


def _differ(node: Node, wanted: Sequence[float | None], truth: _Truth, tolerance: float) -> bool:
    """Return whether two formulas differ at some test point by more than rounding errors."""
    return any(
        mine is None
        or yours is None
        or abs(mine - yours) > max(APPROXIMATION_RTOL, tolerance) * max(abs(mine), abs(yours))
        for _, mine, yours in _pairs(truth, node, wanted)
    )


def _parse_complete(side: Sequence[Token]) -> Node | None:
    """Return a side of an equation as an expression; None if it does not parse completely."""
    try:
        node, taken, _ = parse(side, unit_follows=False)
    except Refused:
        return None
    return node if taken == len(side) else None
