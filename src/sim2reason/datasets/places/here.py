"""Worker processes on this machine, each with its own pipe, so that one can be killed without the others.

There is one pipe per worker and no lock between them: a worker that crashes, hangs or is killed loses only its own
batch. (`concurrent.futures` loses the whole pool in a crash.) A single worker is this process itself.
"""

import os
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from multiprocessing import Pipe
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess

from sim2reason.base.registry import further_members
from sim2reason.datasets.places import HERE, PLACES, Reply, Run, Source, WorkerPool
from sim2reason.datasets.processes import SPAWN_CONTEXT, children_ignoring_signals
from sim2reason.datasets.worker import Batch, Message, outcome, serve
from sim2reason.errors import DatasetError
from sim2reason.generation.request import load_maker

PROGRAM = "__main__"
MAX_START_TIME = 60.0  # s, longest start of a worker, whatever the timeout of a batch


@dataclass
class _Worker:
    process: BaseProcess
    pipe: "Connection[Batch, Message]"
    patience: float
    deadline: float
    batch: Batch | None = None
    began: bool = False

    @classmethod
    def start(cls, maker: str, patience: float) -> "_Worker":
        ours, theirs = Pipe()
        process = SPAWN_CONTEXT.Process(target=serve, args=(theirs, maker, tuple(further_members())), daemon=True)
        with children_ignoring_signals():
            process.start()
        theirs.close()  # now the worker alone holds it: its death closes the pipe
        return cls(process, ours, patience, time.monotonic() + max(patience, MAX_START_TIME))

    def give(self, batch: Batch) -> None:
        self.batch = batch
        if self.began:
            self.deadline = time.monotonic() + self.patience
        with suppress(OSError):  # it died while it waited: `take` will say so
            self.pipe.send(batch)

    def reply(self) -> Reply | None:
        """Return the result of the batch; None if it is unfinished. DatasetError if no worker can work."""
        if self.pipe.poll():
            return self._take()
        return self._lost("hung its worker") if time.monotonic() >= self.deadline else None

    def _take(self) -> Reply | None:
        try:
            message = self.pipe.recv()
        except (EOFError, OSError):
            self.process.join()
            return self._lost(f"crashed its worker (exit code {self.process.exitcode})")
        if isinstance(message, DatasetError):
            raise message
        if message is not None:
            return message
        self.began, self.deadline = True, time.monotonic() + self.patience  # to start takes time, and is not counted
        return None

    def _lost(self, why: str) -> str:
        if not self.began:
            raise DatasetError(f"a worker process ended or hung before it began ({why}); try workers=1")
        return why

    def stop(self) -> None:
        self.process.kill()
        self.process.join()
        self.pipe.close()  # not before: a worker that finds nobody at the other end would complain


@PLACES.register(HERE)
@contextmanager
def here(crew: WorkerPool) -> Generator[Run, None, None]:
    """Return a context in which items are made on this machine, in this process or in worker processes."""
    if crew.address:
        raise DatasetError(f"--on {HERE}://{crew.address}: this machine needs no address; say --on {HERE}")
    if _workers(crew) == 1:
        yield partial(run_alone, maker=crew.maker)
    else:
        yield partial(run, maker=crew.maker, workers=crew.workers or cores(), patience=crew.patience)


def _workers(crew: WorkerPool) -> int | None:
    """Return the requested number of worker processes; 1 if the caller's program registers own components."""
    own = further_members().get(PROGRAM, ())
    if own and (crew.workers or 1) > 1:
        raise DatasetError(
            f"workers: {crew.workers} worker processes do not run your program, which defines {', '.join(own)}; "
            "move that to a module and import it, or give workers=1"
        )
    return 1 if own else crew.workers


def run_alone(source: Source, maker: str) -> Generator[tuple[Batch, Reply], None, None]:
    """Yield each batch from `source` with its result, computed in this process without protection from crashes.

    DatasetError if the maker cannot be imported.
    """
    make = load_maker(maker)
    while (batch := source()) is not None:
        yield batch, [outcome(make, position, request) for position, request in batch]


def cores() -> int:
    """Return the number of cores available to this process."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def run(source: Source, maker: str, workers: int, patience: float) -> Generator[tuple[Batch, Reply], None, None]:
    """Yield the batches of `source` with their results, computed by `workers` processes.

    The worker of a batch that takes longer than `patience` (s) is killed. DatasetError if the maker cannot be imported
    or no process starts. No worker outlives the generator.
    """
    crew: list[_Worker] = []
    try:
        while True:
            _employ(crew, source, workers, lambda: _Worker.start(maker, patience))
            busy = [worker for worker in crew if worker.batch is not None]
            if not busy:
                return
            pause = max(0.0, min(worker.deadline for worker in busy) - time.monotonic())
            wait([worker.pipe for worker in busy], pause)
            for worker in busy:
                reply = worker.reply()
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


def _employ(crew: list[_Worker], source: Source, workers: int, start: Callable[[], _Worker]) -> None:
    """Give every idle worker a batch, and start further workers if needed."""
    idle = [worker for worker in crew if worker.batch is None]
    while idle or len(crew) < workers:
        batch = source()
        if batch is None:
            return
        if not idle:
            idle.append(start())
            crew.append(idle[0])
        idle.pop().give(batch)
