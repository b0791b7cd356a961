"""Conventions that no linter checks."""

import ast
import subprocess
import sys
from dataclasses import dataclass
from functools import cache
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


@dataclass(frozen=True)
class Module:
    """Measurements of a module; lines are counted with and without docstrings."""

    path: Path
    lines: int
    without_docstrings: int
    functions: list[tuple[str, int]]
    classes: list[str]


@cache
def modules() -> list[Module]:
    """Parse each module once, for all conventions."""
    found = list[Module]()
    for path in MODULES:
        text = path.read_text("utf-8")
        nodes = [node for node in ast.walk(ast.parse(text)) if isinstance(node, Documented)]
        count = len(text.splitlines())
        functions = [(node.name, lines(node)) for node in nodes if isinstance(node, ast.FunctionDef)]
        classes = [node.name for node in nodes if isinstance(node, ast.ClassDef)]
        without = count - sum(map(docstring_lines, nodes))
        found.append(Module(path.relative_to(ROOT / "src/sim2reason"), count, without, functions, classes))
    return found


def test_the_public_surface_is_sorted_and_small() -> None:
    names = list(getattr(sim2reason, "__all__", ()))
    assert names == sorted(names)
    assert len(names) <= 37
    assert all(hasattr(sim2reason, name) for name in names)


def test_import_loads_nothing_heavy() -> None:
    code = "import sim2reason, sys; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not HEAVY & set(loaded)


def test_modules_and_functions_are_short() -> None:
    assert len(modules()) > 100
    assert not [
        f"{module.path}: {module.lines} lines, {module.without_docstrings} without docstrings"
        for module in modules()
        if module.lines > 400 or module.without_docstrings > 300
    ]
    assert not [
        f"{module.path}: {name}: {count} lines"
        for module in modules()
        for name, count in module.functions
        if count > 40
    ]


def test_no_modules_import_each_other_in_a_circle_not_even_for_types() -> None:
    graph = grimp.build_graph("sim2reason", cache_dir=None)
    imports = {name: graph.find_modules_directly_imported_by(name) for name in graph.modules}
    assert len(imports) > 100
    TopologicalSorter(imports).prepare()  # it raises CycleError, which names them


def test_the_usual_function_is_a_few_lines() -> None:
    assert median(count for module in modules() for _, count in module.functions) <= 10
    assert median(module.lines for module in modules()) <= 250


def test_what_questions_are_made_of_has_one_name_each() -> None:
    places: dict[str, list[Path]] = {}
    for module in modules():
        for name in module.classes:
            if not name.startswith("_"):
                places.setdefault(name, []).append(module.path)
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
RUN = [
    pytest.param(path, id=path.name, marks=[] if path.stem == "own_scene" else [pytest.mark.slow]) for path in EXAMPLES
]


def test_examples_are_short() -> None:
    assert EXAMPLES
    assert not [path.name for path in EXAMPLES if len(path.read_text("utf-8").splitlines()) > 40]


@pytest.mark.parametrize("path", RUN)
def test_examples_run(path: Path, tmp_path: Path) -> None:
    text = path.read_text("utf-8")
    if "import trl" in text or "from trl" in text:
        pytest.skip("make test-exports runs it, where TRL is installed")
    result = subprocess.run([sys.executable, str(path)], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
