"""A process for calls that may hang or crash: it is killed after a while, and another one takes its place."""

from collections.abc import Callable
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from threading import Lock
from typing import Generic, TypeVar

from sim2reason.datasets.processes import ALONE

__all__ = ["Killable"]

R = TypeVar("R")
STARTING = 120.0  # s: imports may take so long on a busy machine, and are not counted


class Killable(Generic[R]):
    """`function`, importable and of texts, in a process of its own, with at most `patience` seconds for a call."""

    def __init__(self, function: Callable[..., R], patience: float) -> None:
        """Start nothing yet."""
        self._function, self._patience = function, patience
        self._process: BaseProcess | None = None
        self._pipe: Connection[tuple[str, ...], R | None] | None = None
        self._lock = Lock()

    def __call__(self, *texts: str) -> R | None:
        """Return what the function gives; None if it raised, took too long or crashed."""
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
            self._pipe, theirs = ALONE.Pipe()
            self._process = ALONE.Process(target=_serve, args=(theirs, self._function), daemon=True)
            self._process.start()
            theirs.close()  # now the process alone holds it: its death closes the pipe
            try:
                ready = self._pipe.poll(STARTING) and self._pipe.recv() is None
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
