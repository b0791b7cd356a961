"""The native core gives what Python gives, in every bit, and refuses what would not fit its memory."""

import gc
import json
import math
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.generation.recipes import RECIPES
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Y
from sim2reason.scenes.dsl.vectors import Number
from sim2reason.simulation.engines.exact import motion
from sim2reason.simulation.engines.exact.dop853_table import DENSE, ERROR_3, ERROR_5, NODES, STAGES
from sim2reason.simulation.engines.exact.flow import Flow
from sim2reason.simulation.engines.exact.linear import (
    Problem,
    RoughContact,
    eliminated,
    eliminated_symbols,
    gradient,
)
from sim2reason.simulation.engines.exact.native import CORE_API_VERSION, core
from sim2reason.simulation.engines.exact.tape import PlainTape, Tape, float_value
from traced import RANDOM

SUPPORT = Path(__file__).parents[3] / "support"
FAMILIES = [*RECIPES, *RANDOM]
COUNT = 3
compiled = pytest.mark.skipif(core is None, reason="installed without a compiler, or switched off")


def digests(switch: str) -> "subprocess.Popen[str]":
    command = [sys.executable, str(SUPPORT / "traced.py"), *FAMILIES, "--count", str(COUNT)]
    return subprocess.Popen(command, env=os.environ | {"SIM2REASON_NATIVE": switch}, stdout=subprocess.PIPE, text=True)


@pytest.fixture(scope="module")
def both() -> list[dict[str, object]]:
    """Digests of motions by the native core and by Python, in processes of their own."""
    return [json.loads(process.communicate()[0]) for process in [digests("1"), digests("0")]]


@compiled
def test_one_switch_chooses(both: list[dict[str, object]]) -> None:
    assert [found["native"] for found in both] == [True, False]


@compiled
@pytest.mark.parametrize("family", FAMILIES)
def test_motions_are_the_same_in_every_bit(family: str, both: list[dict[str, object]]) -> None:
    native, plain = ({k: v for k, v in found.items() if k.startswith(f"{family} ")} for found in both)
    assert len(native) == 2 * COUNT
    assert native == plain


def test_motions_and_errors_are_among_what_is_compared(both: list[dict[str, object]]) -> None:
    failed = ["Error" in str(value) for value in both[0].values()]
    assert sum(failed) >= 3
    assert failed.count(False) > 150


def test_without_the_extension_python_is_used() -> None:
    code = "import sys; sys.modules['sim2reason.simulation.engines.exact.core._core'] = None\n"
    code += "from sim2reason.simulation.engines.exact.native import uses_native_core; print(uses_native_core())"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


@compiled
def test_an_extension_of_another_version_is_not_used() -> None:
    assert core is not None
    with pytest.raises(ImportError, match="another version"):
        core.set_up(0, NODES, STAGES, ERROR_5, ERROR_3, DENSE)
    core.set_up(CORE_API_VERSION, NODES, STAGES, ERROR_5, ERROR_3, DENSE)


# ---- parts

NUMBERS = st.one_of(
    st.floats(-3.0, 3.0), st.sampled_from([0.0, -0.0, 1.0, -1.0, 2.0, 1e-300, 1e300, -1e300, math.inf, -math.inf])
)
OPERATIONS = st.lists(
    st.tuples(st.sampled_from("+-*/nqsc"), st.integers(0, 60), st.integers(0, 60)), min_size=1, max_size=40
)


def recorded(tape: Tape, operations: list[tuple[str, int, int]], constants: list[float]) -> list[Number]:
    """Numbers of which each is computed from earlier ones."""
    known: list[Number] = [*tape.inputs.values(), *constants]
    for name, i, j in operations:
        a, b = known[i % len(known)], known[j % len(known)]
        known.append(
            a + b
            if name == "+"
            else a - b
            if name == "-"
            else a * b
            if name == "*"
            else a / b
            if name == "/"
            else -a
            if name == "n"
            else tape.sqrt(a)
            if name == "q"
            else tape.sin(a)
            if name == "s"
            else tape.cos(a)
        )
    return known


def outcome(
    kind: type[Tape], operations: list[tuple[str, int, int]], constants: list[float], point: list[float]
) -> str:
    """All that a kind of tape makes of arithmetic, as text: the record, values at a point, and results or the error."""
    tape = kind(["t", "a", "b"])
    try:
        numbers = recorded(tape, operations, constants)
        tape.stand([0.3, 0.7, -1.1])
        told: list[object] = [tape.nodes, tape.constants]
        told += [number.value if hasattr(number, "value") else number for number in numbers]
        guards = [(number, 1e-3) for number in numbers if hasattr(number, "value")][3:5]
        code = tape.code(numbers, guards)(math)
        told += [tape.written, code(point[0], point[1:])]
    except (ArithmeticError, ValueError) as error:
        return type(error).__name__
    return repr(told).replace("-nan", "nan")


@compiled
@given(
    operations=OPERATIONS,
    constants=st.lists(NUMBERS, min_size=2, max_size=5),
    point=st.lists(NUMBERS, min_size=3, max_size=3),
)
def test_tapes_agree_on_all_arithmetic(
    operations: list[tuple[str, int, int]], constants: list[float], point: list[float]
) -> None:
    assert outcome(Tape, operations, constants, point) == outcome(PlainTape, operations, constants, point)


ENTRIES = st.one_of(st.just(0.0), st.sampled_from([1.0, -1.0, 1e-12, 1e9]), st.floats(-2.0, 2.0))


@compiled
@given(data=st.data(), count=st.integers(0, 6), size=st.integers(1, 6))
def test_elimination_is_the_same_also_for_singular_systems(data: st.DataObject, count: int, size: int) -> None:
    assert core is not None
    rows = [data.draw(st.lists(ENTRIES, min_size=size + 1, max_size=size + 1)) for _ in range(count)]
    if count > 1 and data.draw(st.booleans()):
        rows[-1] = [2.0 * entry for entry in rows[0]]
    plain = eliminated([list(row) for row in rows])
    assert repr(core.solve(rows)) == repr((plain.x, plain.nulls, plain.consistent))


def eliminated_on(kind: type[Tape], matrix: list[list[float]]) -> str:
    """Elimination on the symbols of a kind of tape, as text: the record with all values."""
    tape = kind(["t"])
    tape.stand([0.7])
    t = tape.inputs["t"]
    equations = [[entry * t if 0.1 < abs(entry) < 1.0 else entry for entry in row] for row in matrix]
    solve = core.solve_symbols if kind is Tape and core is not None else eliminated_symbols
    found, free, pivots = solve(equations)
    told = [[getattr(n, "id", n), float_value(n)] for n in [*found, *(n for _, f in free for n in f), *pivots]]
    return repr([tape.nodes, tape.constants, told, [column for column, _ in free]])


@compiled
@given(data=st.data(), count=st.integers(1, 5), size=st.integers(1, 5))
def test_elimination_on_symbols_records_the_same(data: st.DataObject, count: int, size: int) -> None:
    matrix = [data.draw(st.lists(ENTRIES, min_size=size + 1, max_size=size + 1)) for _ in range(count)]
    assert eliminated_on(Tape, matrix) == eliminated_on(PlainTape, matrix)


@compiled
def test_equations_are_checked() -> None:
    assert core is not None
    for wrong in ([], [[]], [[1.0, 2.0], [1.0]]):
        with pytest.raises(ValueError, match="equations"):
            core.solve_symbols(wrong)
    with pytest.raises(TypeError):
        core.solve_symbols([["x", 1.0]])


def spinning() -> Mechanism:
    builder = Builder()
    builder.room().body("rod").hinge(Y).body("bob", 1.0, at=(1.0, 0.0, 0.0))
    return builder.finish()


def flow_of(mechanism: Mechanism) -> Flow:
    flow = motion(mechanism, 1.0).segments[0].flow
    assert flow is not None
    return flow


@compiled
def test_sizes_are_checked() -> None:
    assert core is not None
    flow = flow_of(spinning())
    formulas, run = flow.formulas, flow.steps
    rate, margins, closing, held = formulas.rate, formulas.code, formulas.closing, formulas.held
    integration = core.Integration
    with pytest.raises(ValueError, match="2 numbers are expected, not 1"):
        rate(0.0, (1.0,))
    with pytest.raises(ValueError, match="differ"):
        integration(margins, margins, closing, held, (), 0.0, (0.0, 0.0))
    with pytest.raises(ValueError, match="2 numbers"):
        integration(rate, margins, closing, held, (), 0.0, (0.0,))
    with pytest.raises(IndexError, match="no such margin"):
        integration(rate, margins, closing, held, (7,), 0.0, (0.0, 0.0))
    with pytest.raises(ValueError, match="not begun"):
        integration(rate, margins, closing, held, (), 0.0, (0.0, 0.0)).advance(1.0, 1.0, 10)
    with pytest.raises(ValueError, match="no steps"):
        integration(rate, margins, closing, held, (), 0.0, (0.0, 0.0)).sample(np.zeros(3), np.zeros((3, 2)))
    with pytest.raises(IndexError, match="no such step"):
        _ = run[len(run)]
    assert run[-1].time == run[len(run) - 1].time


@compiled
@pytest.mark.parametrize(
    ("times", "into"),
    [
        (np.zeros(3), np.zeros((2, 2))),
        (np.zeros(3), np.zeros((3, 2), dtype=np.float32)),
        (np.zeros(3), np.zeros((6, 2))[::2]),
        (np.zeros(3, dtype=np.int64), np.zeros((3, 2))),
    ],
)
def test_arrays_are_checked(times: np.ndarray, into: np.ndarray) -> None:
    run = flow_of(spinning()).steps
    with pytest.raises((ValueError, BufferError)):
        run.sample(times, into)


@compiled
def test_symbols_of_another_tape_are_refused() -> None:
    one, other = Tape(["t"]), Tape(["t", "a"])
    for use in (
        lambda: one.inputs["t"] + other.inputs["a"],
        lambda: one.sin(other.inputs["t"]),
        lambda: one.code([other.inputs["a"]])(math),
        lambda: one.code([1.0], [(other.inputs["a"], 1.0)])(math),
    ):
        with pytest.raises(ValueError, match="another tape"):
            use()
    with pytest.raises(ValueError, match="at least one input"):
        Tape([])


@compiled
def test_segments_are_checked() -> None:
    assert core is not None
    builder = Builder()
    builder.room().body("block", 1.0).slide(X, 2.0)
    found = motion(builder.finish(), 1.0)
    assert found.state(np.empty(0)).q.shape == (0, 1)
    times, q = np.zeros(2), np.zeros((2, 1))
    with pytest.raises(ValueError, match="integration or None"):
        core.sample_segments(np.zeros(1), np.zeros((1, 3)), (), times, q, q.copy())
    with pytest.raises(ValueError, match="fit"):
        core.sample_segments(np.zeros(1), np.zeros((1, 2)), (None,), times, q, q.copy())
    with pytest.raises(ValueError, match="fit"):
        core.sample_segments(np.zeros(1), np.zeros((1, 9)), (None,), times, np.zeros((3, 1)), np.zeros((3, 1)))


@compiled
def test_problems_are_checked() -> None:
    assert core is not None
    row, grip = gradient([1.0], [0.5]), RoughContact(0, gradient([1.0], [0.0]), 0.3, 0)
    given = ([[2.0]], [[0.1]], [1.0], [3.0], (row,), [0.0], (grip,), (0,), (False,), (-1,), ())
    sound = Problem(*given)
    assert len(core.evaluate_mode(sound, (True,), (0,), 0.0)[0]) == 2
    for wrong, mode in [
        (sound, ((True, True), (0,))),
        (sound, ((True,), ())),
        (replace(sound, mass=[[2.0], [1.0]]), ((True,), (0,))),
        (replace(sound, mass=[[2.0, 1.0]]), ((True,), (0,))),
        (replace(sound, lifted=[]), ((True,), (0,))),
        (replace(sound, rows=(gradient([1.0, 2.0], [0.0]),)), ((True,), (0,))),
        (replace(sound, grips=(replace(grip, contact=1),)), ((True,), (0,))),
        (replace(sound, grips=(replace(grip, coordinate=-2),)), ((True,), (0,))),
    ]:
        with pytest.raises((ValueError, IndexError)):
            core.evaluate_mode(wrong, *mode, 0.0)


@compiled
def test_nothing_is_leaked() -> None:
    mechanism = spinning()

    def repeated() -> int:
        for _ in range(50):
            found = motion(mechanism, 0.5)
            _ = found.state(np.linspace(0.0, 0.5, 5)).a, found.knots
        gc.collect()
        return sys.getallocatedblocks()

    repeated()
    before = repeated()
    assert repeated() - before < 200
