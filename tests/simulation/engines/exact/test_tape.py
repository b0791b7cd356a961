"""Tests that recorded arithmetic has the same results as direct arithmetic."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.scenes.dsl.vectors import Maths, Number
from sim2reason.simulation.engines.exact import tape as module
from sim2reason.simulation.engines.exact.tape import PlainSymbol, PlainTape, Symbol, Tape, float_value

Formula = Callable[[list[Number], Maths], Number]
TAPES = pytest.mark.parametrize("kind", [Tape, PlainTape])  # the native one, where it is compiled, and Python's
VALUES = st.floats(-3.0, 3.0)
LEAF: st.SearchStrategy[Formula] = st.one_of(
    st.integers(0, 2).map(lambda i: lambda x, _: x[i]),
    st.sampled_from([0.0, 1.0, -1.0, 2.0, 0.5, 3.7]).map(lambda c: lambda _x, _m: c),
)


def _more(parts: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    pair = st.tuples(parts, parts)
    return st.one_of(
        pair.map(lambda p: lambda x, m: p[0](x, m) + p[1](x, m)),
        pair.map(lambda p: lambda x, m: p[0](x, m) - p[1](x, m)),
        pair.map(lambda p: lambda x, m: p[0](x, m) * p[1](x, m)),
        pair.map(lambda p: lambda x, m: p[0](x, m) / (p[1](x, m) * p[1](x, m) + 1.5)),
        parts.map(lambda p: lambda x, m: m.sin(p(x, m)) - m.cos(p(x, m))),
        parts.map(lambda p: lambda x, m: m.sqrt(p(x, m) * p(x, m) + 0.25)),
    )


FORMULAS = st.recursive(LEAF, _more, max_leaves=30)


def recorded(formulas: list[Formula], kind: type[Tape] = Tape) -> tuple[Tape, list[Number]]:
    tape = kind(["t", "a", "b"])
    inputs: list[Any] = list(tape.inputs.values())
    return tape, [formula(inputs, tape) for formula in formulas]


@TAPES
@given(formulas=st.lists(FORMULAS, min_size=1, max_size=4), point=st.tuples(VALUES, VALUES, VALUES))
def test_code_values_and_plain_arithmetic_are_one(
    kind: type[Tape], formulas: list[Formula], point: tuple[float, float, float]
) -> None:
    tape, outputs = recorded(formulas, kind)
    wanted = [formula(list(point), math) for formula in formulas]
    assert tape.code(outputs)(math)(point[0], point[1:]) == pytest.approx(wanted, rel=1e-12, abs=1e-12)
    tape.stand(point)
    assert [float_value(out) for out in outputs] == pytest.approx(wanted, rel=1e-12, abs=1e-12)
    arrays = tape.code(outputs)(np)(np.full(2, point[0]), [np.full(2, part) for part in point[1:]])
    for found, value in zip(arrays, wanted, strict=True):
        assert np.broadcast_to(found, 2) == pytest.approx(value, rel=1e-12, abs=1e-12)


@TAPES
def test_what_is_computed_twice_is_kept_once(kind: type[Tape]) -> None:
    tape = kind(["t", "a"])
    t, a = tape.inputs.values()
    before = len(tape.nodes)
    assert ((t + a) * tape.sin(t + a)).id == (tape.sin(a + t) * (a + t)).id
    assert len(tape.nodes) == before + 3


@TAPES
def test_zero_and_one_leave_no_trace(kind: type[Tape]) -> None:
    tape = kind(["t"])
    t = tape.inputs["t"]
    assert t + 0.0 is t
    assert t * 1.0 is t
    assert t / 1.0 is t
    assert t * 0.0 == 0.0
    assert 0.0 / t == 0.0
    assert len(tape.nodes) == 1


def test_numbers_are_no_part_of_the_code(monkeypatch: pytest.MonkeyPatch) -> None:
    """Mechanisms of the same structure share compiled code."""
    texts: list[tuple[str, ...]] = []
    compiled = module.compiled
    monkeypatch.setattr(module, "compiled", lambda *a: texts.append(tuple(map(str, a))) or compiled(*a))
    for number in (3.7, 4.1):
        tape, outputs = recorded(
            [lambda x, m, c=number: m.sin(m.cos(c * x[1])) + 2.0 * x[0], lambda *_, c=number: c + 1.0],
            PlainTape,
        )
        found = tape.code(outputs)(math)(0.5, (0.3, 0.0))
        assert found == pytest.approx((math.sin(math.cos(number * 0.3)) + 1.0, number + 1.0))
    assert len(texts) == 1


@TAPES
def test_equal_numbers_are_another_shape(kind: type[Tape]) -> None:
    for scale, bound in ((3.7, 4.1), (3.7, 3.7), (1.0, 3.7), (3.7, 1.0)):
        tape = kind(["t"])
        t = tape.inputs["t"]
        code = tape.code([scale * t, bound], [(t, bound)])(math)
        assert code(5.0, ()) == (scale * 5.0, bound)
        with pytest.raises(ArithmeticError, match="a pivot is lost"):
            code(0.9 * bound, ())


@TAPES
def test_a_pivot_that_shrinks_is_lost(kind: type[Tape]) -> None:
    tape = kind(["t"])
    t = tape.inputs["t"]
    code = tape.code([1.0 / t], [(t, 0.1)])(math)
    assert code(0.2, ()) == (5.0,)
    with pytest.raises(ArithmeticError, match="a pivot is lost"):
        code(0.05, ())


@TAPES
def test_what_has_no_value_at_a_point_is_nan_there(kind: type[Tape]) -> None:
    tape = kind(["t"])
    t = tape.inputs["t"]
    outputs = [1.0 / t, tape.sqrt(t - 1.0)]
    tape.stand([0.0])
    assert all(isinstance(out, (Symbol, PlainSymbol)) and math.isnan(out.value) for out in outputs)


@TAPES
def test_deep_brackets_become_lines(kind: type[Tape]) -> None:
    """The Python parser fails at a hundred levels of brackets."""
    tape = kind(["t"])
    total: Number = tape.inputs["t"]
    for number in range(300):
        total = tape.sin(total) + 0.01 * number
    expected = 0.3
    for number in range(300):
        expected = math.sin(expected) + 0.01 * number
    assert tape.code([total])(math)(0.3, ())[0] == pytest.approx(expected, rel=1e-12)
    assert tape.written > 600
