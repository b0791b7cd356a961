"""Execution on a Ray cluster: batches are tasks, which Ray restarts when workers die.

Workers return items and access no files of this machine. Each machine of the cluster needs the same package versions,
since these determine the bytes.
"""

import faulthandler
import os
import socket
from collections.abc import Generator
from contextlib import contextmanager
from functools import cache, partial
from typing import Any, Final

from sim2reason.base.optional import optional
from sim2reason.datasets.places import PLACES, Reply, Run, Source, WorkerPool
from sim2reason.datasets.worker import Attempt, Batch, outcome, tune_garbage_collection
from sim2reason.errors import DatasetError
from sim2reason.generation.request import Maker, load_maker, versions

MAX_RETRIES: Final = 3  # of a batch whose worker or machine dies; then `WorkQueue` tries its positions one by one
BATCHES_PER_CORE: Final = 2  # batches per core, so that no core waits for the next one
CONNECT_TIMEOUT: Final = 5.0  # s


@PLACES.register("ray")
@contextmanager
def on_ray(crew: WorkerPool) -> Generator[Run, None, None]:
    """Connect to the cluster at HOST:PORT, else to this machine's cluster, else start a local one.

    DatasetError if there is no cluster at the address, MissingExtraError without Ray.
    """
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")  # else Ray reports to its makers
    ray = optional("ray", "ray")
    where = f"ray://{crew.address}" if crew.address else None
    try:
        if where:  # nobody may be there: Ray itself would wait for half a minute
            host, _, port = crew.address.rpartition(":")
            socket.create_connection((host, int(port)), timeout=CONNECT_TIMEOUT).close()
        ray.init(address=where, log_to_driver=False, logging_level="ERROR")
    except (OSError, ImportError, RuntimeError, ValueError, OverflowError) as error:
        remedy = "start one: ray start --head --ray-client-server-port=PORT, and say --on ray://HOST:PORT"
        raise DatasetError(f"--on {where or 'ray'}: no cluster answers ({_line(error)}); {remedy}") from error
    try:
        yield partial(_replies, ray, crew)
    finally:
        ray.shutdown()


def _replies(ray: Any, crew: WorkerPool, source: Source) -> Generator[tuple[Batch, Reply], None, None]:  # noqa: ANN401 - a module
    task, pending = ray.remote(num_cpus=1, max_retries=MAX_RETRIES)(attempts), dict[Any, Batch]()
    try:
        while True:
            most = crew.workers or BATCHES_PER_CORE * int(ray.cluster_resources().get("CPU", 1))  # a cluster may grow
            while len(pending) < most and (batch := source()) is not None:
                pending[task.remote(batch, crew.maker, crew.patience, versions())] = batch
            if not pending:
                return
            for done in ray.wait(list(pending))[0]:
                yield pending.pop(done), _reply(ray, done)
    finally:
        for begun in pending:
            ray.cancel(begun, force=True)


def _reply(ray: Any, done: Any) -> Reply:  # noqa: ANN401 - a module and what it gives
    lost = ray.exceptions
    try:
        return ray.get(done)
    except (lost.WorkerCrashedError, lost.NodeDiedError, lost.OutOfMemoryError, lost.ObjectLostError):
        return "crashed its worker"
    except (lost.RayError, ConnectionError) as error:
        cause = getattr(error, "cause", error)
        raise cause if isinstance(cause, DatasetError) else DatasetError(f"--on ray: {_line(cause)}") from error


def attempts(batch: Batch, maker: str, patience: float, expected: dict[str, str]) -> list[Attempt]:
    """Make the items of a batch in a worker, which exits after a timeout (s); DatasetError for other versions."""
    if other := [f"{name} {mine} ≠ {expected[name]}" for name, mine in versions().items() if mine != expected[name]]:
        raise DatasetError(f"{socket.gethostname()}: {', '.join(other)}; all machines of a cluster need the same")
    faulthandler.dump_traceback_later(patience, exit=True)
    try:
        make = _prepared(maker)
        return [outcome(make, position, request) for position, request in batch]
    finally:
        faulthandler.cancel_dump_traceback_later()


@cache
def _prepared(maker: str) -> Maker:
    make = load_maker(maker)
    tune_garbage_collection()
    return make


def _line(error: BaseException) -> str:
    return " ".join(str(error).split())[:300] or type(error).__name__
