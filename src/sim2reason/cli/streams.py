"""Standard streams that a shell left closed, full, without a reader, or with undecodable file names."""

import errno
import os
import sys
from contextlib import suppress
from io import TextIOWrapper, UnsupportedOperation

STDOUT = "standard output"
FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}


def prepare() -> None:
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
        found = os.open(os.devnull, os.O_RDWR)
        if found != number:
            os.dup2(found, number)
            os.close(found)


def hush() -> None:
    """Redirect stdout to the null device, so that Python reports no error for it at exit."""
    with suppress(UnsupportedOperation):  # a test's has no number
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def name(error: OSError) -> str:
    """Return the file of an error, or *standard output* if the error names none."""
    return str(error.filename or (STDOUT if error.errno in FULL else ""))
