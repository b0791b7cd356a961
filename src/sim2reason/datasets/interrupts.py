"""An interrupt from the keyboard goes to every process of a command; one of them decides what it means."""

import signal
from collections.abc import Generator
from contextlib import contextmanager
from multiprocessing import resource_tracker


@contextmanager
def deaf_children() -> Generator[None, None, None]:
    """Processes that start in the block hear no SIGINT, from their first moment on; ours waits for its end."""
    resource_tracker.ensure_running()  # it would lift the block while it starts
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
