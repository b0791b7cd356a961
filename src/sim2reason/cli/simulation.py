"""The command that simulates a scene, in a separate process that can be killed."""

from collections.abc import Callable
from contextlib import nullcontext
from math import isfinite
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar
from warnings import catch_warnings, simplefilter

import click

from sim2reason.cli import console, files, options
from sim2reason.datasets.processes import SPAWN_CONTEXT, children_ignoring_signals, end_with_parent
from sim2reason.errors import MotionEndsWarning, Sim2ReasonError, SimulationError

if TYPE_CHECKING:  # numpy is loaded where it is needed: in the worker
    from sim2reason.simulation.trace import Trace


P = ParamSpec("P")
R = TypeVar("R")


def run_in_sandbox(patience: float, function: Callable[P, R], *args: P.args, **kwargs: P.kwargs) -> R:
    """Run `function(*args)` in a separate process for at most `patience` seconds, and return its result.

    Raises:
        SimulationError: it took longer, or crashed its process.
        Sim2ReasonError, OSError: what the function raises.
    """
    ours, theirs = SPAWN_CONTEXT.Pipe(duplex=False)
    process = SPAWN_CONTEXT.Process(target=_serve, args=(theirs, function, args, kwargs), daemon=True)
    with children_ignoring_signals():
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


EXAMPLE = """\b
Example:
    sim2reason simulate scene.yaml
    sim2reason simulate scene.yaml --engine both --duration 1.5 -o trace.parquet

Exit code 0: simulated; 1: the engines disagree (--engine both); 2: a scene that can't be simulated.
"""
WORKER_TIMEOUT = 20.0  # s; a safety net: budgets are counted in steps
SHOWN = ("displacement", "velocity", "acceleration", "tension", "normal force", "friction force")
STUCK = {
    "indeterminate": "give it a mass or hang something on it",
    "lift": "pull on it with less force",
    "crowd": "move what meets apart",
    "reach": "leave more string between them",
    "limit": "let it start elsewhere",
}
"""What helps where a motion ends at its start, by what ended it."""

Summary = dict[str, Any]
"""What a run found, as plain JSON values."""


@click.command("simulate", epilog=EXAMPLE)
@options.scene()
@click.option("--engine", default="exact", show_default=True, help="One of: sim2reason list engines; or both.")
@click.option(
    "--duration",
    type=console.Seconds(1e-9, 1e12),
    default=None,
    help="How long, in the scene's unit of time (s, or yr among planets); by default as long as the scene is worth.",
)
@click.option("--samples", type=click.IntRange(2, 100_001), default=101, show_default=True, help="Rows of a trace.")
@click.option("--truncate", is_flag=True, help="Cut where a sample stands out by 5σ, events included.")
@options.out("Write the trace to this .parquet file.")
@options.to_json()
@click.option("--patience", type=console.Seconds(0.01, console.LONGEST_TIMER), default=WORKER_TIMEOUT, hidden=True)
def simulate_command(
    scene: Path,
    engine: str,
    duration: float | None,
    samples: int,
    truncate: bool,
    out: Path | None,
    to_json: bool,
    patience: float,
) -> int:
    """Simulate the scene in the file SCENE, or on standard input if it is -."""
    from sim2reason.simulation import trace_files

    if out is not None:
        trace_files.check(out)
    content = files.text(scene)
    files.scene(scene, content)  # what is wrong with the file is said here, with its name
    with files.written(out) if out is not None else nullcontext() as part:
        found = run_in_sandbox(patience, run, content, engine, duration, samples, part, truncate)
    if to_json:
        console.as_json(found)
    else:
        _tell(found)
    return 1 if found["cut"] == "certificate" else 0


def run(
    content: str, engine: str, duration: float | None, samples: int, out: Path | None, truncate: bool = False
) -> Summary:
    """Simulate the scene of a text, in a worker process; write the trace to `out`."""
    from sim2reason.scenes.files import loads
    from sim2reason.simulation import scenes, trace_files
    from sim2reason.simulation.scenes import truncate_trace
    from sim2reason.simulation.trace import ending

    scene, certificate = loads(content), None
    with catch_warnings():
        simplefilter("ignore", MotionEndsWarning)  # it is told below
        if engine == scenes.BOTH:
            trace, certificate = scenes.certify(scene, duration, samples)
            trace = truncate_trace(trace) if truncate else trace
            trace = trace.until(trace.stable_until)
        else:
            trace = scenes.simulate(scene, duration, engine, samples, truncate=truncate)
    if trace.stable_until == 0.0 and trace.cut in STUCK:
        raise _stuck(trace)
    if out is not None:
        trace_files.write_trace(trace, out)
    return {
        "engine": engine,
        "duration": scene.horizon if duration is None else duration,
        "time_unit": scene.units.time,
        "stable_until": trace.stable_until,
        "cut": trace.cut,
        "why": ending(trace),
        "events": [{"time": e.time, "kind": e.kind, "subjects": list(e.subjects)} for e in trace.events],
        "final": _final(trace),
        "certificate": certificate.document() if certificate else None,
    }


def _stuck(trace: "Trace") -> SimulationError:
    from sim2reason.simulation.trace import ENDINGS

    what = ", ".join(trace.events[-1].subjects)
    return SimulationError(
        f"{what}: there is no motion to follow: {ENDINGS[trace.cut]} at the start; {STUCK[trace.cut]}"
    )


def _final(trace: "Trace") -> list[Summary]:
    """Return every channel at the last valid time; null where a value is not determined."""
    import numpy as np

    from sim2reason.simulation.trace import channels

    state = trace.sample(np.array([trace.stable_until]))
    entries: list[Summary] = []
    for channel, quantity in channels(trace.mechanism):
        value = quantity.evaluate(state, channel.subject)[0].tolist()
        plain = [_finite_or_none(part) for part in value] if quantity.vector else _finite_or_none(value)
        entries.append(
            {
                "subject": channel.subject,
                "quantity": quantity.name,
                "unit": trace.mechanism.units.spell(quantity.unit),
                "value": plain,
            }
        )
    return entries


def _finite_or_none(value: float) -> float | None:
    return value + 0.0 if isfinite(value) else None


def _tell(summary: Summary) -> None:
    until, unit = summary["stable_until"], summary["time_unit"]
    rows = [row for row in summary["final"] if row["quantity"] in SHOWN]
    rows.sort(key=lambda row: SHOWN.index(row["quantity"]))
    head = ["subject", "quantity", f"at {until:.6g} {unit}", "unit"]
    console.table(head, [_row(r) for r in rows])
    for event in summary["events"]:
        click.echo(f"{event['time']:.6g} {unit}: {event['kind']} of {', '.join(event['subjects'])}")
    if summary["cut"]:
        click.echo(
            f"The motion is followed until {until:.6g} {unit}, not {summary['duration']:g} {unit}: {summary['why']}"
        )
    if summary["certificate"] is not None:
        _tell_certificate(summary["certificate"])


def _row(entry: Summary) -> list[str]:
    from sim2reason.scenes.dsl.measures import show_unit

    return [entry["subject"], entry["quantity"], _number(entry["value"]), show_unit(entry["unit"])]


def _number(value: Any) -> str:  # noqa: ANN401 - a number, a vector, or None
    if isinstance(value, list):
        return "(" + ", ".join(_number(part) for part in value) + ")"  # type: ignore[reportUnknownVariableType]
    return "not determined" if value is None else f"{value:.6g}"


def _tell_certificate(certificate: Summary) -> None:
    engines, until = " and ".join(certificate["engines"]), certificate["stable_until"]
    worst = max((difference for _, _, difference, _ in certificate["channels"]), default=0.0)
    why = f" ({certificate['reason']})" if certificate["reason"] else ""
    click.echo(f"{engines} agree until {until:.6g} s{why}; they differ by at most {worst:.1e} of the largest values")
