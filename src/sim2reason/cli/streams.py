"""Standard streams as a shell may leave them: closed, full, without a reader, or with names that are no text."""

import errno
import os
import sys
from contextlib import suppress
from io import TextIOWrapper, UnsupportedOperation

STDOUT = "standard output"
FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}


def prepare() -> None:
    """Open what the shell has closed, so that no file of ours takes its place and what is said there is dropped.

    Names of files need not be UTF-8; standard output says their bytes as they are.
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
        found = os.open(os.devnull, os.O_RDWR)
        if found != number:
            os.dup2(found, number)
            os.close(found)


def hush() -> None:
    """Point stdout at nothing, so that Python does not complain at exit about what it could not say there."""
    with suppress(UnsupportedOperation):  # a test's has no number
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def name(error: OSError) -> str:
    """Where an error was: the file, or standard output, since whoever writes a file names it."""
    return str(error.filename or (STDOUT if error.errno in FULL else ""))
