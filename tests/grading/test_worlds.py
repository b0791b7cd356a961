"""Tests that the verdict is the same in any environment, and that no answer can attack the grader."""

import ast
import asyncio
import json
import multiprocessing
import os
import subprocess
import sys
import tracemalloc
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path

import pytest

import hostile
import sim2reason.grading
import sim2reason.scenes.dsl.units
from grader_cases import CASES, verdict
from sim2reason.grading import formula, number

SUPPORT = Path(hostile.__file__).parent
SOURCES = [
    *Path(sim2reason.grading.__file__).parent.glob("*.py"),
    *Path(sim2reason.scenes.dsl.units.__file__).parent.glob("unit*.py"),
]


@pytest.fixture(scope="module")
def here() -> list[str]:
    return [verdict(case) for case in CASES]


def test_eight_threads_agree(here: list[str]) -> None:
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(verdict, CASES * 8)) == here * 8


def test_a_spawned_process_agrees(here: list[str]) -> None:
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        assert list(pool.map(verdict, CASES, chunksize=64)) == here


def test_asyncio_agrees(here: list[str]) -> None:
    async def grade(case: dict[str, str]) -> str:
        await asyncio.sleep(0)
        return verdict(case)

    async def all_of_them() -> list[str]:
        return await asyncio.gather(*map(grade, CASES), *(asyncio.to_thread(verdict, case) for case in CASES))

    assert asyncio.run(all_of_them()) == here * 2


def test_a_deep_stack_does_not_change_the_verdict(here: list[str]) -> None:
    def dive(depth: int) -> list[str]:
        return dive(depth - 1) if depth else [verdict(case) for case in CASES]

    assert dive(300) == here


@pytest.mark.parametrize("seed", ["0", "1"])
def test_the_hash_seed_does_not_change_the_verdict(seed: str, here: list[str]) -> None:
    script = "from grader_cases import CASES, verdict; print([verdict(case) for case in CASES])"
    done = subprocess.run(
        [sys.executable, "-c", script],
        cwd=SUPPORT,
        env={**os.environ, "PYTHONHASHSEED": seed},
        capture_output=True,
        text=True,
        check=True,
    )
    assert ast.literal_eval(done.stdout) == here


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: path.name)
def test_the_source_runs_nothing_that_it_reads(path: Path) -> None:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    names |= {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    names |= {
        alias.name for node in ast.walk(tree) if isinstance(node, ast.ImportFrom | ast.Import) for alias in node.names
    }
    modules = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    banned = {
        "eval",
        "exec",
        "compile",
        "__import__",
        "parse_expr",
        "sympify",
        "parse_latex",
        "sympy",
        "getattr",
        "open",
        "print",
    }
    banned |= {"signal", "threading", "random", "subprocess", "os", "literal_eval", "import_module"}
    assert not (names - {"compile"} | modules) & banned
    compiled = [node for node in ast.walk(tree) if isinstance(node, ast.Attribute) and node.attr == "compile"]
    assert all(isinstance(node.value, ast.Name) and node.value.id == "re" for node in compiled)
    own = {module for module in modules if module and module.startswith("sim2reason")}
    assert all(module.startswith(("sim2reason.grading", "sim2reason.scenes.dsl.unit")) for module in own)


def test_importing_the_grader_loads_nothing_heavy() -> None:
    script = "import sys, sim2reason.grading; print(*{name.split('.')[0] for name in sys.modules})"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert not set(done.stdout.split()) & {"numpy", "pydantic", "mujoco", "torch", "sympy", "pyarrow", "click", "rich"}


@pytest.mark.parametrize("count", [10_000, pytest.param(100_000, marks=pytest.mark.slow)])
def test_hostile_texts_touch_nothing_and_earn_nothing(tmp_path: Path, count: int) -> None:
    command = [sys.executable, "-W", "error", str(SUPPORT / "fuzz_grader.py"), str(count), "20240229"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    assert report["events"] == [], "something was run, imported or opened"
    assert report["accepted"] == []
    assert report["slow"] == []
    assert report["peak"] < 64 * 2**20
    assert report["graded"] >= count
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", hostile.giants())
def test_giants_earn_nothing(name: str) -> None:
    text = hostile.giants()[name]
    assert not number(text, 73219.456, "m/s^2").reward
    assert not formula(text, r"\sqrt{2gh}").reward


def test_what_long_runs_of_letters_mean_is_not_kept() -> None:
    tracemalloc.start()
    for count in range(300):
        formula(rf"\boxed{{{f'{count:b}'.replace('0', 'm').replace('1', 'g') * 90}}}", "mg")
    size, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert size < 2 * 2**20
