"""The worker process: it makes items, batch after batch, and exits with its parent."""

import gc
import os
import signal
import time
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from importlib import import_module
from multiprocessing.connection import Connection

from sim2reason.datasets.processes import SIGNALS, end_with_parent
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item
from sim2reason.generation.request import Made, Maker, Request, load_maker

GC_THRESHOLD = 20_000  # new objects after which the garbage collector runs

Batch = Sequence[tuple[int, Request]]
"""Positions and their requests."""


@dataclass(frozen=True, slots=True)
class Attempt:
    """The outcome of one request at a position: the item or None, rejections, and an exception as `failure`."""

    position: int
    item: Item | None
    rejected: dict[str, int]
    failure: str = ""
    wanted: str = ""
    seconds: float = field(default=0.0, compare=False)
    """How long it took."""


Message = list[Attempt] | DatasetError | None
"""What a worker sends: first None, for "I begin", or an error that no other worker would escape; then outcomes."""


def serve(pipe: "Connection[Message, Batch]", maker: str, modules: Sequence[str] = ()) -> None:
    """Process the batches from `pipe` until its other end is closed.

    `modules` outside the library, which register members for the maker, are imported first.
    """
    for number in SIGNALS:
        signal.signal(number, signal.SIG_IGN)  # the parent is interrupted, and decides
    end_with_parent()
    for library in ("OMP", "OPENBLAS", "MKL"):  # before the maker imports numpy: N workers use N cores, not N²
        os.environ[f"{library}_NUM_THREADS"] = "1"
    try:
        for module in modules:
            _import(module)
        make = load_maker(maker)
    except DatasetError as error:
        pipe.send(error)
        return
    tune_garbage_collection()
    with suppress(EOFError, OSError):  # the parent is gone
        pipe.send(None)
        while True:
            pipe.send([outcome(make, position, request) for position, request in pipe.recv()])


def _import(module: str) -> None:
    try:
        import_module(module)
    except ImportError as error:
        raise DatasetError(
            f"{module}: a worker process can't import this module, of which you use members ({error}); put it where "
            "Python finds it, or give workers=1"
        ) from error


def tune_garbage_collection() -> None:
    """Exclude loaded objects from garbage collection, and collect new ones less often.

    Collection took a twelfth of the time of an item.
    """
    gc.collect()
    gc.freeze()
    gc.set_threshold(GC_THRESHOLD)


def outcome(make: Maker, position: int, request: Request) -> Attempt:
    """Make one item; an exception becomes a recorded failure, so that a long run continues."""
    begun = time.perf_counter()
    return replace(_attempt(make, position, request), seconds=time.perf_counter() - begun)


def _attempt(make: Maker, position: int, request: Request) -> Attempt:
    try:
        made: Made = make(request)
    except Exception as error:  # noqa: BLE001 - whatever it is, the manifest tells it with the seed that repeats it
        text = " ".join(str(error).split())
        return Attempt(position, None, {}, f"raised {type(error).__name__}: {text}")
    if made.item is not None and made.item.id != request.id:
        return Attempt(position, None, {}, f"made an item of another id: {made.item.id}")
    return Attempt(position, made.item, dict(made.rejected), wanted=made.wanted)
