"""Output of the commands: tables, JSON, problems as readable text, progress, and errors in one line."""

import json
import sys
import time
from collections.abc import Generator, Iterable, Sequence
from contextlib import AbstractContextManager, contextmanager
from math import isfinite
from pathlib import Path
from textwrap import fill, indent
from threading import Event, Thread
from typing import TYPE_CHECKING, Any, Protocol, Self

import click

from sim2reason.cli import process
from sim2reason.errors import Sim2ReasonError

if TYPE_CHECKING:
    from sim2reason.generation.item import Item

RESULT = click.Path(path_type=Path, dir_okay=False, allow_dash=True)
"""The file that a command writes; it may be there already, but not as a folder. A dash is standard output."""


SELDOM, OFTEN = 15.0, 1.0  # s between lines about work where there is no terminal; the second with --verbose
VERBOSE = "sim2reason.verbose"
"""Where a context keeps whether all is to be told."""
LINE_WIDTH = 88  # characters of a line of a problem
LONGEST_TIMER = 1e6  # s, some days: timers of systems go no further


class Seconds(click.FloatRange):
    """A duration within bounds; unlike click's own range it rejects NaN."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:  # noqa: ANN401 - click's own signature
        """Return the given number; click.BadParameter if it is invalid or out of bounds."""
        number = float(super().convert(value, param, ctx))
        if not isfinite(number):
            self.fail(f"{number} is not a finite number of seconds.", param, ctx)
        return number


class Progress(Protocol):
    """The callback of a long task for its progress."""

    def __call__(self, steps: int = 1) -> None:
        """Advance the bar by `steps`."""
        ...


def explain(line: str | None) -> None:
    """Print one line to stderr."""
    click.echo(line, err=True)


def explained(error: BaseException) -> str | None:
    """Return one line for an error that users can act on; None for a defect, which needs its traceback."""
    notes = "".join(f"; {note}" for note in getattr(error, "__notes__", ()))
    match error:
        case KeyboardInterrupt() | click.Abort():
            line = "sim2reason: interrupted"
        case click.UsageError():
            path = error.ctx.command_path if error.ctx else "sim2reason"
            line = f"{path}: {error.format_message()} See: {path} --help"
        case click.ClickException():
            line = f"sim2reason: {error.format_message()}"
        case Sim2ReasonError():
            line = f"sim2reason: {error}"
        case OSError():
            where = f"{process.file_of(error)}: ".removeprefix(": ")
            reason = error.strerror or error
            checked = "the path" if isinstance(error, FileNotFoundError) else "its permissions and the free space"
            line = f"sim2reason: {where}{reason}; check {checked}"
        case _:
            return None
    return " ".join((line + notes).split())


def as_json(value: object) -> None:
    """Print `value` as JSON."""
    click.echo(json.dumps(value, indent=2, ensure_ascii=False))


def as_json_list(values: Iterable[object]) -> None:
    """Print values one after the other as a JSON list, as `as_json` prints a list."""
    count = 0
    for count, value in enumerate(values, start=1):
        click.echo(",\n" if count > 1 else "[\n", nl=False)
        text = json.dumps(value, indent=2, ensure_ascii=False)
        click.echo("  " + text.replace("\n", "\n  "), nl=False)
    click.echo("\n]" if count else "[]")


def table(head: Sequence[str], rows: Sequence[Sequence[object]], *, err: bool = False) -> None:
    """Print rows in aligned columns under `head`, to stdout or stderr; numbers are right-aligned."""
    cells = [[str(cell) for cell in row] for row in rows]
    widths = [max(len(line[i]) for line in [list(head), *cells]) for i in range(len(head))]
    right = [bool(rows) and all(isinstance(row[i], int | float) for row in rows) for i in range(len(head))]
    for line in [list(head), ["-" * width for width in widths], *cells]:
        padded = (c.rjust(w) if r else c.ljust(w) for c, w, r in zip(line, widths, right, strict=True))
        click.echo("  ".join(padded).rstrip(), err=err)


def tell_problem(item: "Item", *, scene: bool = False, solution: bool = False) -> None:
    """Print a problem and its answer, optionally with its scene and solution."""
    click.secho(item.id, bold=True)
    for line in item.prompt.splitlines():
        click.echo(fill(line, LINE_WIDTH, break_long_words=False, break_on_hyphens=False))
    click.echo(f"\nAnswer: {item.answer.shown}")
    click.echo(f"Needs: {item.needs}\n")
    if solution:
        told = item.solution.text if item.solution is not None else item.unsolved
        click.echo(f"{told or 'No solution was asked for: sim2reason generate OUT --solutions'}\n")
    if scene:
        click.echo(indent(item.scene, "    "))


def comma_separated(option: str) -> tuple[str, ...]:
    """Return the comma-separated words of an option, without repetitions."""
    names = tuple(dict.fromkeys(word.strip() for word in option.split(",") if word.strip()))
    if not names:
        raise click.UsageError(f"{option!r} names nothing; give names separated by commas, or all.")
    return names


@contextmanager
def progress(what: str, total: int) -> Generator[Progress, None, None]:
    """Show progress on stderr while the block runs: a bar on a terminal, else or with --verbose periodic lines.

    Yields the function that advances the progress.
    """
    if not sys.stderr.isatty() or verbose():
        with Lines(what, total) as lines:
            yield lines.advance
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn()
    with Progress(*columns, console=Console(stderr=True)) as bars:
        task = bars.add_task(what, total=total)
        yield lambda steps=1: bars.advance(task, steps)


def verbose() -> bool:
    """Return whether the running command was given the option --verbose."""
    context = click.get_current_context(silent=True)
    return context is not None and bool(context.meta.get(VERBOSE))


class Lines:
    """Lines on stderr that report progress at regular intervals, however long a single step takes."""

    def __init__(self, what: str, total: int) -> None:
        """Prepare to report on `total` steps, under the label `what`."""
        self._what, self._total, self._done = what, total, 0
        self._ended = Event()
        self._begun = time.monotonic()
        self._thread = Thread(target=self._print_progress, args=(OFTEN if verbose() else SELDOM,), daemon=True)

    def __enter__(self) -> Self:
        """Start to report progress; the first line appears after one interval."""
        self._thread.start()
        return self

    def __exit__(self, *error: object) -> None:
        """Stop the reports."""
        self._ended.set()
        self._thread.join()

    def advance(self, steps: int = 1) -> None:
        """Advance the progress count by `steps`."""
        self._done += steps

    def _print_progress(self, every: float) -> None:
        while not self._ended.wait(every):
            explain(f"{self._what}: {self._done} of {self._total}, {time.monotonic() - self._begun:.0f} s")


@contextmanager
def resumable(remedy: str) -> Generator[None, None, None]:
    """Print how to continue if the user interrupts the block."""
    try:
        yield
    except KeyboardInterrupt as error:
        error.add_note(remedy)
        raise


class Bar:
    """A progress bar that appears once the amount of work is known."""

    def __init__(self, what: str) -> None:
        """Store the label of the bar."""
        self._what = what
        self._shown: AbstractContextManager[Progress] | None = None
        self._move: Progress = _ignore

    def __enter__(self) -> Self:
        """Return the bar, still hidden."""
        return self

    def __exit__(self, *error: object) -> None:
        """Remove the bar."""
        if self._shown is not None:
            self._shown.__exit__(None, None, None)

    def begin(self, total: int) -> None:
        """Show the bar for `total` steps."""
        self._shown = progress(self._what, total)
        self._move = self._shown.__enter__()

    def advance(self, steps: int) -> None:
        """Advance the bar by `steps`."""
        self._move(steps)


class Phases:
    """A sequence of progress bars, one for each phase of some work."""

    def __init__(self) -> None:
        """Start without a bar, until the first phase begins."""
        self._bar = Bar("")

    def __enter__(self) -> Self:
        """Return the sequence of bars."""
        return self

    def __exit__(self, *error: object) -> None:
        """Remove the last bar."""
        self._bar.__exit__(*error)

    def begin(self, phase: str, total: int) -> None:
        """Show the bar of the next phase in place of the last."""
        self._bar.__exit__()
        self._bar = Bar(phase)
        self._bar.begin(total)

    def advance(self, steps: int) -> None:
        """Advance the current bar by `steps`."""
        self._bar.advance(steps)


def _ignore(steps: int = 1) -> None:
    del steps
