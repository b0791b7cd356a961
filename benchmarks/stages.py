"""Shares of the CPU time of an item by stage, and calls of each stage for each kept item.

    python benchmarks/stages.py [items of each cell] [mode ...]

A timer interrupts every millisecond of CPU time, and the innermost stage whose code runs is charged, with the library
code that it calls. A second pass over fewer items counts the calls of the function that stands for each stage.
"""

import argparse
import signal
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from time import process_time
from types import CodeType, FrameType
from typing import NamedTuple

from sim2reason.datasets.worker import tune_garbage_collection
from sim2reason.generation.make import make
from sim2reason.generation.recipes import RECIPES
from sim2reason.generation.request import Request
from sim2reason.questions.difficulty import DIFFICULTIES

SEED = 5
PERIOD = 1e-3  # s of CPU time between samples
SOURCE = str(Path(sys.modules["sim2reason"].__file__ or "").parent)
MODES = "numeric", "reverse", "symbolic"


class Stage(NamedTuple):
    """A part of the work on an item."""

    name: str
    places: tuple[str, ...]
    """The beginnings of the paths of its modules."""
    counted: str = ""
    """The function whose calls are counted: its path and qualified name."""


STAGES = (
    Stage("draw the recipe", ("generation/recipes/",), "generation/recipes/__init__.py:Recipe.__call__"),
    Stage(
        "filters: sensitivity", ("generation/filters/sensitivity.py",), "generation/filters/sensitivity.py:elasticities"
    ),
    Stage("filters: misconceptions", ("generation/filters/misconceptions.py", "questions/simplifications/")),
    Stage("filters: other", ("generation/filters/",), "generation/filters/__init__.py:apply_filters"),
    Stage("completion of formulas", ("generation/modes/", "questions/regimes/")),
    Stage("solutions", ("solutions/",), "solutions/solve.py:_written"),
    Stage(
        "witness", ("simulation/engines/mujoco/", "simulation/certify.py"), "simulation/engines/mujoco/engine.py:run"
    ),
    Stage(
        "exact: integrate and locate events",
        ("simulation/engines/exact/native_flow.py", "simulation/engines/exact/flow.py"),
    ),
    Stage("exact: set-up and forces", ("simulation/engines/exact/",), "simulation/engines/exact/engine.py:simulate"),
    Stage("read the motion", ("simulation/", "questions/moments/", "questions/functionals/")),
    Stage(
        "uniqueness and dependence", ("questions/dependence.py", "questions/conditions.py", "questions/inversion.py")
    ),
    Stage(
        "ask questions",
        ("questions/", "generation/question_search.py"),
        "generation/question_search.py:QuestionSearch._suits",
    ),
    Stage("build mechanisms", ("scenes/",), "scenes/dsl/scene.py:Scene.builder"),
    Stage("prose", ("text/",), "text/prose/writer.py:Writer.sentences"),
    Stage("other", ("",)),
)


def items(count: int, mode: str) -> Iterator[bool]:
    """Make items of each recipe and difficulty; yield whether each was kept."""
    for recipe in RECIPES:
        for difficulty in DIFFICULTIES:
            for index in range(count):
                yield make(Request(recipe, difficulty, mode, SEED, index)).item is not None


def stage_of(path: str) -> str:
    """Return the name of the stage of a module, by its path in the package."""
    return next(stage.name for stage in STAGES if path.startswith(stage.places))


def sampled(count: int, mode: str) -> tuple[Counter[str], int, float]:
    """Return the samples of each stage, the number of kept items, and the CPU time, s."""
    samples, stages = Counter[str](), dict[CodeType, str | None]()

    def charge(number: int, frame: FrameType | None) -> None:
        del number
        while frame is not None:
            code = frame.f_code
            if code not in stages:
                inside = code.co_filename.startswith(SOURCE)
                path = code.co_filename[len(SOURCE) + 1 :]
                stages[code] = stage_of(path) if inside and not path.startswith("base/") else None
            stage = stages[code]
            if stage is not None:
                samples[stage] += 1
                return
            frame = frame.f_back

    signal.signal(signal.SIGPROF, charge)
    start = process_time()
    signal.setitimer(signal.ITIMER_PROF, PERIOD, PERIOD)
    try:
        kept = sum(items(count, mode))
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
    return samples, kept, process_time() - start


def counted(count: int, mode: str) -> tuple[Counter[str], int]:
    """Return the calls of each stage's function, and the number of kept items."""
    calls, wanted = Counter[str](), {stage.counted: stage.name for stage in STAGES if stage.counted}
    names = dict[CodeType, str | None]()

    def note(frame: FrameType, event: str, argument: object) -> None:
        del argument
        if event == "call":
            code = frame.f_code
            if code not in names:
                names[code] = wanted.get(f"{code.co_filename[len(SOURCE) + 1 :]}:{code.co_qualname}")
            name = names[code]
            if name is not None:
                calls[name] += 1

    profile: Callable[[FrameType, str, object], None] = note
    sys.setprofile(profile)
    try:
        kept = sum(items(count, mode))
    finally:
        sys.setprofile(None)
    return calls, kept


def main() -> None:
    """Print a table for each mode."""
    options = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    options.add_argument(
        "count", type=int, nargs="?", default=4, help="items of each recipe and difficulty (default: 4)"
    )
    options.add_argument("modes", nargs="*", default=MODES, help="modes (default: all)")
    given = options.parse_args()
    tune_garbage_collection()
    for mode in given.modes:
        make(Request("pulley", "easy", mode, SEED + 1, 0))
        import_module("sympy.polys.fields")  # half a second, when the first formula is shortened
        samples, kept, seconds = sampled(given.count, mode)
        calls, made = counted(max(1, given.count // 4), mode)
        print(f"\n{mode}: {kept} items, {kept / seconds:.1f} a CPU-second\n{'stage':36} share, %  calls")
        for stage in STAGES:
            number = f"{calls[stage.name] / made:7.1f}" if stage.counted else "      –"
            print(f"{stage.name:36} {100 * samples[stage.name] / samples.total():8.1f} {number}")


if __name__ == "__main__":
    main()
