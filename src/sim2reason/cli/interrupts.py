"""Handling of SIGINT and SIGTERM, repeated where a library swallows the exception."""

import signal
from collections.abc import Generator
from contextlib import contextmanager
from threading import current_thread, main_thread
from types import FrameType
from warnings import catch_warnings, simplefilter

from sim2reason.datasets.processes import SIGNALS

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
