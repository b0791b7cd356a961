"""Worker processes that can be killed one by one.

One pipe per worker and no lock between them: a worker that crashes, hangs or is killed takes only its own
batch with it. (`concurrent.futures` loses the whole pool to one crash.)
"""

import time
from collections.abc import Callable, Generator
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess

from sim2reason.datasets.worker import Batch, Outcome, serve
from sim2reason.errors import DatasetError

Reply = list[Outcome] | str
"""The outcomes of a batch, or why there are none: ``crashed …`` or ``hung …``."""
_SPAWN = get_context("forkserver")  # a fork of a process with threads may deadlock


@dataclass
class _Worker:
    process: BaseProcess
    pipe: "Connection[Batch, list[Outcome] | DatasetError]"
    batch: Batch | None = None
    deadline: float = 0.0

    @classmethod
    def start(cls, maker: str) -> "_Worker":
        ours, theirs = _SPAWN.Pipe()
        process = _SPAWN.Process(target=serve, args=(theirs, maker), daemon=True)
        process.start()
        theirs.close()  # now the worker alone holds it: its death closes the pipe
        return cls(process, ours)

    def give(self, batch: Batch, patience: float) -> None:
        self.batch, self.deadline = batch, time.monotonic() + patience
        with suppress(OSError):  # it died while it waited: `take` will say so
            self.pipe.send(batch)

    def take(self) -> Reply:
        """The reply that has come; raise the error that tells that no worker can work."""
        try:
            reply = self.pipe.recv()
        except (EOFError, OSError):
            self.process.join()
            return f"crashed its worker (exit code {self.process.exitcode})"
        if isinstance(reply, DatasetError):
            raise reply
        return reply

    def stop(self) -> None:
        self.pipe.close()
        self.process.kill()
        self.process.join()


def run(
    source: Callable[[], Batch | None], maker: str, workers: int, patience: float
) -> Generator[tuple[Batch, Reply], None, None]:
    """Have `workers` processes work on what `source` gives, and give each batch back with its reply.

    `source` is asked again after every reply, and gives None while there is nothing to do. A batch that
    takes longer than `patience` (s) is hung: its worker is killed. Replies come in any order. DatasetError
    if the maker can't be imported. However the generator ends, no worker stays.
    """
    crew: list[_Worker] = []
    try:
        while True:
            _employ(crew, source, maker, workers, patience)
            busy = [worker for worker in crew if worker.batch is not None]
            if not busy:
                return
            pause = max(0.0, min(worker.deadline for worker in busy) - time.monotonic())
            wait([worker.pipe for worker in busy], pause)
            for worker in busy:
                reply = _reply(worker, patience)
                if reply is None or worker.batch is None:
                    continue
                batch, worker.batch = worker.batch, None
                if isinstance(reply, str):
                    crew.remove(worker)
                    worker.stop()
                yield batch, reply
    finally:
        for worker in crew:
            worker.stop()


def _employ(crew: list[_Worker], source: Callable[[], Batch | None], maker: str, workers: int, patience: float) -> None:
    idle = [worker for worker in crew if worker.batch is None]
    while idle or len(crew) < workers:
        batch = source()
        if batch is None:
            return
        if not idle:
            idle.append(_Worker.start(maker))
            crew.append(idle[0])
        idle.pop().give(batch, patience)


def _reply(worker: _Worker, patience: float) -> Reply | None:
    if worker.pipe.poll():
        return worker.take()
    if time.monotonic() >= worker.deadline:
        return f"hung its worker for {patience:g} s"
    return None
