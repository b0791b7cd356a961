"""The process of a command: its standard streams and its signals.

A shell may leave streams closed, full, without a reader, or with undecodable file names. SIGINT and SIGTERM are
repeated where a library swallows the exception.
"""

import errno
import os
import signal
import sys
from collections.abc import Generator
from contextlib import contextmanager, suppress
from io import TextIOWrapper, UnsupportedOperation
from threading import current_thread, main_thread
from types import FrameType
from warnings import catch_warnings, simplefilter

from sim2reason.datasets.processes import SIGNALS

STDOUT = "standard output"
FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}


def prepare_streams() -> None:
    """Open closed standard streams, so that no other file takes their numbers.

    File names need not be UTF-8; standard output prints their bytes unchanged.
    """
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        if getattr(sys, name) is None:
            _open_null(number)
            mode = "r" if number == 0 else "w"
            setattr(sys, name, open(number, mode, encoding="utf-8"))  # noqa: PTH123, SIM115 - open until the end
    out: object = sys.stdout
    if isinstance(out, TextIOWrapper):
        out.reconfigure(errors="surrogateescape")


def _open_null(number: int) -> None:
    try:
        os.fstat(number)
    except OSError:
        descriptor = os.open(os.devnull, os.O_RDWR)
        if descriptor != number:
            os.dup2(descriptor, number)
            os.close(descriptor)


def silence_stdout() -> None:
    """Redirect stdout to the null device, so that Python reports no error for it at exit."""
    with suppress(UnsupportedOperation):  # a test's has no number
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def file_of(error: OSError) -> str:
    """Return the file of an error, or *standard output* if the error names none."""
    return str(error.filename or (STDOUT if error.errno in FULL else ""))


PATIENCE = 2.0  # s, after which an interrupt without effect is repeated


@contextmanager
def handled_interrupts() -> Generator[None, None, None]:
    """Raise KeyboardInterrupt in the block at each SIGINT and SIGTERM, and again until the block ends.

    C modules drop exceptions at some moments, and a run of hours would continue. After the first signal, warnings are
    suppressed, because libraries warn of interruptions. An ignored signal, such as SIGINT in a background job, stays
    ignored.
    """
    heeded = [number for number in SIGNALS if signal.getsignal(number) not in (signal.SIG_IGN, None)]
    if not heeded or current_thread() is not main_thread():
        yield
        return
    with catch_warnings():
        before = {number: signal.signal(number, _interrupt) for number in (signal.SIGALRM, *heeded)}
        try:
            yield
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
            for number, handler in before.items():
                signal.signal(number, handler)


def _interrupt(number: int, frame: FrameType | None) -> None:
    del number, frame
    signal.setitimer(signal.ITIMER_REAL, PATIENCE)
    simplefilter("ignore")  # pydantic warns of a value that it was interrupted at
    raise KeyboardInterrupt
