"""Executors that make items, on this machine or elsewhere; each is one module, found by its name.

An executor makes items and returns them; it never accesses the output folder, so nothing is shared.
"""

from collections.abc import Callable, Generator
from contextlib import AbstractContextManager
from dataclasses import dataclass

from sim2reason.base.registry import Registry
from sim2reason.datasets.worker import Attempt, Batch

__all__ = ["DEFAULT_TIMEOUT", "HERE", "PLACES", "Place", "Reply", "Run", "Source", "WorkerPool", "opened"]

HERE = "here"
"""The place where work is done unless another is named."""
DEFAULT_TIMEOUT = 120.0
"""Seconds after which a batch counts as hung: a safety net, far above what any item needs."""


@dataclass(frozen=True, slots=True)
class WorkerPool:
    """The settings of workers: the function that makes items, the number of workers, and the timeout of a batch."""

    maker: str
    workers: int | None = None
    """How many processes; None: one for each core of the place."""
    patience: float = DEFAULT_TIMEOUT
    address: str = ""
    """What stands behind ``://`` in the name of the place."""


Reply = list[Attempt] | str
"""The outcomes of a batch, or why there are none: ``crashed …`` or ``hung …``."""
Source = Callable[[], Batch | None]
"""Gives the next batch; None while there is nothing to do. It is asked again after every reply."""
Run = Callable[[Source], Generator[tuple[Batch, Reply], None, None]]
"""Have a crew work on what a source gives: each batch comes back once, with its reply, in any order."""
Place = Callable[[WorkerPool], AbstractContextManager[Run]]
"""Gather a crew; whatever way the block ends, no worker of it stays.

On entering it raises `DatasetError` if nobody can work there, and `MissingExtraError` if a package lacks.
"""
PLACES: Registry[Place] = Registry("datasets.places")


def opened(name: str, crew: Callable[[str], WorkerPool]) -> AbstractContextManager[Run]:
    """Return the executor called ``NAME`` or ``NAME://ADDRESS``; UnknownNameError if there is none."""
    scheme, _, address = name.partition("://")
    return PLACES[scheme](crew(address))
