"""Tests of the formula reader in the benchmark of symbolic problems."""

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

from sim2reason.generation.item import Binding, FormulaRecord

FILE = Path(__file__).parent.parent / "benchmarks" / "symbolic.py"


@pytest.fixture(scope="module")
def benchmark() -> ModuleType:
    spec = importlib.util.spec_from_file_location("symbolic_benchmark", FILE)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_no_symbol_is_found_in_what_stands_for_another(benchmark: ModuleType) -> None:
    """Symbols are replaced by names with the letter s, which may be a symbol itself."""
    point = {"m_A": 3.6, "m_B": 1.6, "k": 65.0, "d": 0.22, "s": 0.19}
    wanted = (5.2 * 65.0 * 0.19 - 3.6 * 0.22 * 65.0) / (3.6 * 1.6)
    found = benchmark.value(r"\frac{m_A k s + m_B k s - m_A d k}{m_A m_B}", point)
    assert found == pytest.approx(wanted, rel=1e-12)


def test_a_coordinate_may_be_negative(benchmark: ModuleType) -> None:
    """√(x²) isn't rewritten as x."""
    bindings = tuple(Binding(numbers=(x,), answer=3.0 * abs(x)) for x in (-2.0, -1.5, 0.7))
    formula = FormulaRecord(latex=r"3 \sqrt{x^{2}}", symbols=("x",), units=("m",), unit="m", bindings=bindings)
    assert len(list(benchmark.rewritings(formula))) >= 3
    for text in list(benchmark.rewritings(formula))[2:]:
        assert benchmark.value(text, {"x": -2.0}) == pytest.approx(6.0), text
