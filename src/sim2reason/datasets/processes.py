"""Worker processes: start, termination with the parent, and handling of interrupts."""

import os
import signal
from collections.abc import Generator
from contextlib import contextmanager
from multiprocessing import parent_process, resource_tracker, spawn
from multiprocessing.context import SpawnContext, SpawnProcess
from multiprocessing.process import BaseProcess
from threading import Lock, Thread, get_ident
from typing import Any

__all__ = ["SPAWN_CONTEXT"]


def end_with_parent() -> None:
    """Terminate this process when its parent exits; do nothing in a process without a parent."""
    Thread(target=_wait, daemon=True).start()


def _wait() -> None:
    parent = parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


SIGNALS = signal.SIGINT, signal.SIGTERM


@contextmanager
def children_ignoring_signals() -> Generator[None, None, None]:
    """Make processes started in the block ignore interrupts; those of this process wait for the block's end."""
    resource_tracker.ensure_running()  # it would lift the block while it starts
    before = signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


PROGRAM = "init_main_from_name", "init_main_from_path"
"""What a new process is told about the caller's program."""
_starting = Lock()


class _Process(SpawnProcess):
    @staticmethod
    def _Popen(process_obj: BaseProcess) -> Any:  # noqa: ANN401, N802 - as in multiprocessing, whose types it has not
        with _main_program_hidden():
            return SpawnProcess._Popen(process_obj)  # type: ignore[attr-defined]  # noqa: SLF001 - see above


class _Context(SpawnContext):
    Process = _Process


SPAWN_CONTEXT = _Context()
"""The context for processes of ours; what they run must stand in a module that can be imported."""


@contextmanager
def _main_program_hidden() -> Generator[None, None, None]:
    """Hide the caller's main program from processes that this thread starts within the block."""
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
