"""SIGINT: heard from the start to the end, and heard again where a library swallows what it raises."""

import signal
from collections.abc import Generator
from contextlib import contextmanager
from threading import current_thread, main_thread
from types import FrameType

PATIENCE = 2.0  # s, after which whoever was interrupted and goes on is interrupted again


@contextmanager
def heard() -> Generator[None, None, None]:
    """Raise KeyboardInterrupt in the block at each SIGINT, and again until the block ends.

    Modules in C drop what is raised at some moments, and a run of hours would go on. Where SIGINT is ignored, as in a
    job in the background, nothing changes.
    """
    before = signal.getsignal(signal.SIGINT)
    if not callable(before) or current_thread() is not main_thread():
        yield
        return
    alarm = signal.signal(signal.SIGALRM, _interrupt)
    signal.signal(signal.SIGINT, _interrupt)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, alarm)
        signal.signal(signal.SIGINT, before)


def _interrupt(number: int, frame: FrameType | None) -> None:
    del number, frame
    signal.setitimer(signal.ITIMER_REAL, PATIENCE)
    raise KeyboardInterrupt
