"""Processing of untrusted input in a separate process that can be killed."""

from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import ParamSpec, TypeVar

from sim2reason.datasets.processes import ALONE, deaf_children, end_with_parent
from sim2reason.errors import Sim2ReasonError, SimulationError

P = ParamSpec("P")
R = TypeVar("R")


def sandboxed(patience: float, function: Callable[P, R], *args: P.args, **kwargs: P.kwargs) -> R:
    """Run `function(*args)` in a separate process for at most `patience` seconds, and return its result.

    Raises:
        SimulationError: it took longer, or crashed its process.
        Sim2ReasonError, OSError: what the function raises.
    """
    ours, theirs = ALONE.Pipe(duplex=False)
    process = ALONE.Process(target=_serve, args=(theirs, function, args, kwargs), daemon=True)
    with deaf_children():
        process.start()
    theirs.close()  # now the worker alone holds it: its death closes the pipe
    try:
        if not ours.poll(patience):
            raise SimulationError(f"the simulation takes longer than {patience:g} s; simulate a shorter time")
        good, value = ours.recv()
    except EOFError:
        process.join()
        code = process.exitcode
        raise SimulationError(f"the simulation crashed its process (exit code {code}); try another engine") from None
    finally:
        process.kill()
        process.join()
        ours.close()
    if good:
        return value
    raise value


def _serve(
    pipe: "Connection[object, object]",
    function: Callable[..., object],
    args: tuple[object, ...],
    kwargs: dict[str, object],
) -> None:
    end_with_parent()
    try:
        answer = True, function(*args, **kwargs)
    except (Sim2ReasonError, OSError) as error:
        answer = False, error
    pipe.send(answer)
