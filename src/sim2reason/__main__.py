"""``python -m sim2reason``, like the command ``sim2reason``, is the command line."""

import atexit
import gc
import os
import signal

INTERRUPTED = b"sim2reason: interrupted\n"
GC_THRESHOLD = 100_000  # new objects after which the garbage collector runs: imports make many, and no garbage


def main() -> None:
    """Run it; an interrupt while it loads, or after its end, is one line, too."""
    for number in (signal.SIGINT, signal.SIGTERM):
        if signal.getsignal(number) is not signal.SIG_IGN:  # as SIGINT is in the background
            signal.signal(number, _leave)
    gc.set_threshold(GC_THRESHOLD)
    atexit.register(gc.freeze)  # the interpreter would collect all objects three times before it ends
    from sim2reason.cli import main as commands  # noqa: PLC0415 - it takes a tenth of a second

    commands(prog_name="sim2reason")


def _leave(number: int, frame: object) -> None:
    del number, frame
    os.write(2, INTERRUPTED)
    os._exit(130)


if __name__ == "__main__":
    main()
