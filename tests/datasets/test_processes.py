"""Tests that this library's processes never run the main program, while those of others do as usual."""

import ast
import sys
from multiprocessing import spawn
from pathlib import Path

import sim2reason
from sim2reason.datasets.processes import PROGRAM, SPAWN_CONTEXT

SOURCE = Path(sim2reason.__file__).parent


def test_what_a_process_is_told_about_the_program_is_what_is_left_out() -> None:
    """A later version of the standard library might use other keys for the main program."""
    assert [name for name in spawn.get_preparation_data("any") if name.startswith("init_main")] in (
        [],
        *[[name] for name in PROGRAM],
    )


def test_a_process_starts_and_leaves_everything_as_it_was() -> None:
    before = spawn.get_preparation_data
    process = SPAWN_CONTEXT.Process(target=sys.exit, args=(7,))
    process.start()
    process.join()
    assert process.exitcode == 7
    assert spawn.get_preparation_data is before


def test_no_module_starts_processes_in_another_way() -> None:
    """Otherwise a script without a `__name__` guard would run again in each process."""
    others = {"get_context", "Pool", "Process", "set_start_method"}
    for path in SOURCE.rglob("*.py"):
        if path.name == "processes.py" and path.parent.name == "datasets":
            continue
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for node in ast.walk(tree):
            if isinstance(node, ast.Call):
                called = ast.unparse(node.func)
                assert called.split(".")[-1] not in others or called.startswith("SPAWN_CONTEXT."), f"{path}: {called}"
                if called.endswith("ProcessPoolExecutor"):
                    assert "mp_context=SPAWN_CONTEXT" in ast.unparse(node), path
