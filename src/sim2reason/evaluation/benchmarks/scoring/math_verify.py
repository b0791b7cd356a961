"""Comparison of formulas by math-verify, in a process that is killed on a timeout and restarted after a crash.

This module is all that the process imports.
"""

import logging
from collections.abc import Callable
from importlib import import_module
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from threading import Lock
from typing import Any, Generic, TypeVar

from sim2reason.datasets.processes import SPAWN_CONTEXT

__all__ = ["Killable", "verified"]

R = TypeVar("R")
MAX_START_TIME = 120.0  # s, longest start of the process, in addition to the timeout of a call


class Killable(Generic[R]):
    """A function on texts, run in a separate process with at most `patience` seconds per call."""

    def __init__(self, function: Callable[..., R], patience: float) -> None:
        """Store the function; the process starts with the first call."""
        self._function, self._patience = function, patience
        self._process: BaseProcess | None = None
        self._pipe: Connection[tuple[str, ...], R | None] | None = None
        self._lock = Lock()

    def __call__(self, *texts: str) -> R | None:
        """Return the function's result; None if it raised, timed out or crashed."""
        with self._lock:
            pipe = self._started()
            if pipe is None:
                return None
            try:
                pipe.send(texts)
                if pipe.poll(self._patience):
                    return pipe.recv()
            except (EOFError, OSError):
                pass
            self.stop()
            return None

    def _started(self) -> "Connection[tuple[str, ...], R | None] | None":
        if self._pipe is None:
            self._pipe, theirs = SPAWN_CONTEXT.Pipe()
            self._process = SPAWN_CONTEXT.Process(target=_serve, args=(theirs, self._function), daemon=True)
            self._process.start()
            theirs.close()  # now the process alone holds it: its death closes the pipe
            try:
                ready = self._pipe.poll(MAX_START_TIME) and self._pipe.recv() is None
            except (EOFError, OSError):
                ready = False
            if not ready:
                self.stop()
        return self._pipe

    def stop(self) -> None:
        """End the process."""
        if self._process is not None and self._pipe is not None:
            self._process.kill()
            self._process.join()
            self._pipe.close()
        self._process = self._pipe = None


def _serve(pipe: "Connection[object, tuple[str, ...]]", function: Callable[..., object]) -> None:
    pipe.send(None)
    while True:
        try:
            texts = pipe.recv()
        except (EOFError, OSError):
            return
        try:
            answer = function(*texts)
        except Exception:  # noqa: BLE001 - a foreign library on foreign text: whatever it raises is no answer
            answer = None
        pipe.send(answer)


def verified(answer: str, submitted: str) -> tuple[bool, bool, str]:
    """Return whether `submitted` parses, whether it equals `answer`, and its parsed form; both contain a box."""
    library: Any = import_module("math_verify")
    logging.getLogger("math_verify").setLevel(logging.ERROR)  # it warns of the missing limits at each call
    limit = {"parsing_timeout": None}  # its own limits use signals; this process is killed instead
    right, parsed = library.parse(answer, **limit), library.parse(submitted, **limit)
    return bool(parsed), bool(parsed and library.verify(right, parsed, timeout_seconds=None)), str(parsed[:1])[:200]
