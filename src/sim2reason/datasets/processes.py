"""Processes that load the library, and never run the program that started them.

The contexts of the standard library have a new process read the caller's program first. Where that has no guard by
``__name__``, its lines run once more in every process.
"""

from collections.abc import Generator
from contextlib import contextmanager
from multiprocessing import spawn
from multiprocessing.context import SpawnContext, SpawnProcess
from multiprocessing.process import BaseProcess
from threading import Lock, get_ident
from typing import Any

__all__ = ["ALONE"]

PROGRAM = "init_main_from_name", "init_main_from_path"
"""What a new process is told about the caller's program."""
_starting = Lock()


class _Process(SpawnProcess):
    @staticmethod
    def _Popen(process_obj: BaseProcess) -> Any:  # noqa: ANN401, N802 - as in multiprocessing, whose types it has not
        with _program_untold():
            return SpawnProcess._Popen(process_obj)  # type: ignore[attr-defined]  # noqa: SLF001 - see above


class _Context(SpawnContext):
    Process = _Process


ALONE = _Context()
"""The context for processes of ours; what they run must stand in a module that can be imported."""


@contextmanager
def _program_untold() -> Generator[None, None, None]:
    """Withhold the caller's program from processes that this thread starts within the block."""
    prepared, thread = spawn.get_preparation_data, get_ident()

    def without_program(name: str) -> dict[str, Any]:
        data = prepared(name)
        return {key: data[key] for key in data if key not in PROGRAM} if get_ident() == thread else data

    with _starting:
        prepared = spawn.get_preparation_data
        spawn.get_preparation_data = without_program
        try:
            yield
        finally:
            spawn.get_preparation_data = prepared
