"""Simulations that may use too much time or memory, and their outcomes."""

import resource
import signal
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from time import process_time

import numpy as np

from curved_mechanisms import FAMILIES
from random_mechanisms import pulleys, rough, table, wedges
from scene_files import drawn
from scene_files import spoiled as spoiled_file
from sim2reason.errors import Sim2ReasonError
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import load
from sim2reason.simulation.certify import certify_trace
from sim2reason.simulation.trace import ENGINES
from spoiled_mechanisms import collapse, spoiled

TIMES = np.linspace(0.0, 2.0, 101)
LONGEST = 5.0  # s of CPU for both engines
LARGEST = 1.0  # GB
GIVEN_UP = 20  # s of CPU, after which a simulation is stopped


@cache
def _scenes() -> list[Scene]:
    return list(drawn(60, seed=7))


KINDS: dict[str, Callable[[int], Mechanism]] = {
    **FAMILIES,
    **{made.__name__: lambda seed, made=made: made(seed).finish() for made in (pulleys, wedges, table, rough)},
    "recipes": lambda seed: next(drawn(1, seed=seed)).mechanism,
}
SPOILED: dict[str, Callable[[int], Mechanism]] = {
    "files": lambda seed: load(spoiled_file(seed, _scenes())).mechanism,
    "spoiled": spoiled,
    "collapse": collapse,
}


@dataclass(frozen=True)
class Try:
    """Outcome of the simulation of one mechanism."""

    kind: str
    seed: int
    outcome: str
    exact: float = 0.0  # CPU seconds
    witness: float = 0.0
    memory: float = 0.0  # GB, by which the most that the process ever had grew

    @property
    def bad(self) -> bool:
        """Return whether the simulation failed or used too much time or memory."""
        return self.outcome.startswith("failed") or self.exact + self.witness > LONGEST or self.memory > LARGEST


def attempt(job: tuple[str, int]) -> Try:
    """Simulate one mechanism by both engines and return the outcome."""
    kind, seed = job
    signal.signal(signal.SIGVTALRM, _give_up)
    signal.setitimer(signal.ITIMER_VIRTUAL, GIVEN_UP)
    marks, before = [process_time()], _peak()
    try:
        mechanism = (KINDS | SPOILED)[kind](seed)
        marks = [process_time()]
        trace = ENGINES["exact"](mechanism, TIMES)
        marks.append(process_time())
        _, certificate = certify_trace(trace)
        outcome = "no witness" if certificate.reason.startswith("no witness") else "simulated"
    except Sim2ReasonError as error:
        outcome = type(error).__name__
    except Exception as error:  # noqa: BLE001 - this is what is looked for
        outcome = f"failed by {type(error).__name__}: {error}"
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
    marks = [*marks, process_time()] if len(marks) == 2 else [*marks, process_time(), process_time()]
    return Try(kind, seed, outcome, marks[1] - marks[0], marks[2] - marks[1], _peak() - before)


def _peak() -> float:
    """Return the peak memory of the process in GB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20


def _give_up(*_: object) -> None:
    raise TimeoutError(f"over {GIVEN_UP} s")
