"""An interrupt, by a person or a batch system, goes to every process of a command; one decides what it means."""

import signal
from collections.abc import Generator
from contextlib import contextmanager
from multiprocessing import resource_tracker

SIGNALS = signal.SIGINT, signal.SIGTERM


@contextmanager
def deaf_children() -> Generator[None, None, None]:
    """Processes that start in the block hear none of `SIGNALS`, from their first moment on; ours waits for its end."""
    resource_tracker.ensure_running()  # it would lift the block while it starts
    before = signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
