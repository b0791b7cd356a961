"""Parallel execution in several processes on this machine, connected as by torchrun."""

# torch is an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

import os
import signal
import socket
import sys
import time
from collections.abc import Callable
from contextlib import closing
from multiprocessing.connection import wait
from typing import TypeAlias, TypeVar

from sim2reason.datasets.processes import SPAWN_CONTEXT, end_with_parent
from sim2reason.errors import Sim2ReasonError, TrainingError
from sim2reason.training.extras import External, library

__all__ = ["AdvanceCallback", "BeginCallback", "is_launched", "run_in_processes"]

MAX_ERROR_LINES = 2.0  # seconds for the first process to report an error after another has ended
T = TypeVar("T")
BeginCallback: TypeAlias = Callable[[str, int], object]
AdvanceCallback: TypeAlias = Callable[[int], object]
Work: TypeAlias = Callable[[T, BeginCallback, AdvanceCallback], object]
ProcessReport: TypeAlias = tuple[str, int] | int | Sim2ReasonError
"""What the first process says: that a phase begins, how many steps more are done, or what went wrong."""


def is_launched() -> bool:
    """Return whether this is already one of several processes, started by torchrun or similar."""
    return "WORLD_SIZE" in os.environ


def run_in_processes(count: int, work: Work[T], given: T, begun: BeginCallback, advance: AdvanceCallback) -> None:
    """Run `work(given, begun, advance)` in `count` processes; all arguments must be importable.

    Raises:
        Sim2ReasonError: what it raises in the first process.
        TrainingError: a process ended before its work was done.
    """
    library("torch.multiprocessing")  # it teaches pickles of processes about tensors
    ours, theirs = SPAWN_CONTEXT.Pipe(duplex=False)
    port = _free_port()
    ranks = [
        SPAWN_CONTEXT.Process(target=_rank, args=(rank, count, port, theirs if rank == 0 else None, work, given))
        for rank in range(count)
    ]
    with closing(ours):
        try:
            for process in ranks:
                process.start()
            theirs.close()
            fault = _followed(ours, ranks, begun, advance)
            codes = [process.exitcode for process in ranks if process.exitcode]
        finally:
            for process in ranks:
                if process.is_alive():
                    process.terminate()
                process.join()
    if fault is not None:
        raise fault
    if codes:
        raise TrainingError(f"a process of the run ended with code {codes[0]}; give the same command again to go on")


def _followed(
    pipe: External, ranks: list[External], begun: BeginCallback, advance: AdvanceCallback
) -> Sim2ReasonError | None:
    """Forward the first process's reports until all end or one fails; return its error, if any."""
    fault, silent = None, False
    while fault is None:
        codes = [process.exitcode for process in ranks]  # one look: who ends after it wakes us by its sentinel
        alive = [process.sentinel for process, code in zip(ranks, codes, strict=True) if code is None]
        if any(codes) or (not alive and (silent or not pipe.poll())):
            break
        if silent or pipe not in wait([pipe, *alive]):
            wait(alive)
            continue
        fault, silent = _forward_report(pipe, begun, advance)
    end = time.monotonic() + MAX_ERROR_LINES
    while fault is None and not silent and pipe.poll(max(0.0, end - time.monotonic())):
        fault, silent = _forward_report(pipe, begun, advance)
    return fault


def _forward_report(
    pipe: External, begun: BeginCallback, advance: AdvanceCallback
) -> tuple[Sim2ReasonError | None, bool]:
    """Forward one report; return an error if it is one, and whether the pipe is closed."""
    try:
        report: ProcessReport = pipe.recv()
    except EOFError:
        return None, True
    match report:
        case Sim2ReasonError():
            return report, False
        case int():
            advance(report)
        case phase, steps:
            begun(phase, steps)
    return None, False


def _free_port() -> int:
    with socket.socket() as sock:
        sock.bind(("127.0.0.1", 0))
        return int(sock.getsockname()[1])


def _rank(rank: int, count: int, port: int, pipe: External, work: Work[T], given: T) -> None:
    """Execute the work as the process of one rank, and report progress and errors to `pipe`."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent is interrupted, and ends this
    end_with_parent()
    names = {"RANK": rank, "LOCAL_RANK": rank, "WORLD_SIZE": count, "LOCAL_WORLD_SIZE": count, "MASTER_PORT": port}
    os.environ.update({name: str(value) for name, value in names.items()} | {"MASTER_ADDR": "127.0.0.1"})
    torch = library("torch")
    if not torch.accelerator.is_available():
        os.environ.setdefault("ACCELERATE_USE_CPU", "true")
        torch.set_num_threads(1)  # threads of several processes wait for each other
    try:
        work(given, lambda phase, steps: _send_report(pipe, (phase, steps)), lambda steps: _send_report(pipe, steps))
    except Sim2ReasonError as error:
        _send_report(pipe, error)
        sys.exit(2)


def _send_report(pipe: External, report: ProcessReport) -> None:
    if pipe is not None:
        pipe.send(report)
