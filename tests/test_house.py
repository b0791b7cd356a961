"""Rules of the house that no linter knows."""

import ast
import subprocess
import sys
from graphlib import TopologicalSorter
from pathlib import Path
from statistics import median

import grimp
import pytest

import sim2reason

ROOT = Path(__file__).parents[1]
MODULES = sorted((ROOT / "src").rglob("*.py"))
HEAVY = {"mujoco", "torch", "matplotlib", "trl", "vllm", "transformers", "sympy", "scipy"}


Documented = ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef


def docstring_lines(node: Documented) -> int:
    if ast.get_docstring(node, clean=False) is None:
        return 0
    return (node.body[0].end_lineno or 0) - node.body[0].lineno + 1


def lines(node: ast.FunctionDef | ast.AsyncFunctionDef) -> int:
    """Count the lines of a function without its docstring, which may be as long as its readers need."""
    return (node.end_lineno or node.lineno) - node.lineno + 1 - docstring_lines(node)


def functions(path: Path) -> list[ast.FunctionDef]:
    return [node for node in ast.walk(ast.parse(path.read_text("utf-8"))) if isinstance(node, ast.FunctionDef)]


def test_the_public_surface_is_sorted_and_small() -> None:
    names = list(getattr(sim2reason, "__all__", ()))
    assert names == sorted(names)
    assert len(names) <= 37
    assert all(hasattr(sim2reason, name) for name in names)


def test_import_loads_nothing_heavy() -> None:
    code = "import sim2reason, sys; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not HEAVY & set(loaded)


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(ROOT / "src/sim2reason")))
def test_modules_and_functions_are_short(path: Path) -> None:
    text = path.read_text("utf-8")
    nodes = [node for node in ast.walk(ast.parse(text)) if isinstance(node, Documented)]
    assert len(text.splitlines()) <= 400
    assert len(text.splitlines()) - sum(map(docstring_lines, nodes)) <= 300
    assert not [f"{f.name}: {lines(f)}" for f in functions(path) if lines(f) > 40]


def test_no_modules_import_each_other_in_a_circle_not_even_for_types() -> None:
    graph = grimp.build_graph("sim2reason", cache_dir=None)
    imports = {name: graph.find_modules_directly_imported_by(name) for name in graph.modules}
    assert len(imports) > 100
    TopologicalSorter(imports).prepare()  # it raises CycleError, which names them


def test_the_usual_function_is_a_few_lines() -> None:
    assert median(lines(f) for path in MODULES for f in functions(path)) <= 10
    assert median(len(path.read_text("utf-8").splitlines()) for path in MODULES) <= 150


def test_what_questions_are_made_of_has_one_name_each() -> None:
    places: dict[str, list[Path]] = {}
    for path in MODULES:
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                places.setdefault(node.name, []).append(path.relative_to(ROOT / "src/sim2reason"))
    within = "questions/", "simulation/quantities/", "generation/filters/"
    beside = {Path("generation"), Path("datasets")}
    ours = {p for found in places.values() for p in found if f"{p}".startswith(within) or p.parent in beside}
    twice = {name: found for name, found in places.items() if len(found) > 1}
    assert not {name: found for name, found in twice.items() if ours & {*found}}


def test_every_ignored_rule_is_justified() -> None:
    text = (ROOT / "pyproject.toml").read_text("utf-8")
    block = text[text.index("[tool.ruff.lint]") : text.index("[tool.ruff.lint.pydocstyle]")]
    rules = [line for line in block.splitlines() if line.startswith('    "')]
    assert rules
    assert all(" # " in line for line in rules)


EXAMPLES = sorted((ROOT / "examples").glob("*.py"))


@pytest.mark.slow
@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.name)
def test_examples_are_short_and_run(path: Path, tmp_path: Path) -> None:
    text = path.read_text("utf-8")
    assert len(text.splitlines()) <= 40
    if "import trl" in text or "from trl" in text:
        pytest.skip("make test-exports runs it, where TRL is installed")
    result = subprocess.run([sys.executable, str(path)], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
