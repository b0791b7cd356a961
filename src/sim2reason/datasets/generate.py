"""Generation of a dataset: the function behind the command `generate`."""

import re
from collections.abc import Callable, Mapping, Sequence
from inspect import Parameter, signature
from pathlib import Path
from typing import Annotated, Any, TypedDict, TypeVar, Unpack, cast, get_args, get_type_hints

from pydantic import ValidationError

from sim2reason.base.registry import similar_names
from sim2reason.base.settings import read_settings
from sim2reason.datasets.build import build, ignore_progress
from sim2reason.datasets.contamination import Benchmarks, benchmark_file_record
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.places import HERE
from sim2reason.datasets.plan import (
    ALL_NAMES,
    DEFAULT_DISTANCE,
    DEFAULT_SHARD_ROWS,
    LICENSE,
    MAKER,
    Config,
    Names,
    difficulties_named,
    find_modes,
    find_needs,
    find_recipes,
    numbers,
)
from sim2reason.errors import DatasetError, DrawError, EvaluationError
from sim2reason.generation.request import SI, nonnegative_integer
from sim2reason.questions.accuracy import TOLERANCE
from sim2reason.questions.spoken_units import system_named

DEFAULT_ITEMS = 1000
AS_GIVEN = "seed", "shard", "maker", "solutions", "unfiltered", "weights", "split", "distance", "license", "tolerance"
NUMBERS = "items", "seed", "shard"
ORDER = re.compile(r"^( *)order: the options of `Order`\.$", re.MULTILINE)
"""The line of a docstring that stands for all options; its indentation depends on the version of Python."""
F = TypeVar("F", bound=Callable[..., object])


class Order(TypedDict, total=False):
    """Options of a dataset to generate, each with its meaning; `DEFAULTS` has the value of an omitted option."""

    items: Annotated[int, "Number of problems."]
    recipe: Annotated[Names, "Kinds of scenes: one name, several, or ``all``."]
    difficulty: Annotated[Names, "``easy``, ``medium``, ``hard``, several, or ``all``."]
    mode: Annotated[Names, "Modes of questions: one name, several, or ``all``."]
    seed: Annotated[int, "Seed of the problems, 0 or greater."]
    weights: Annotated[
        Mapping[str, float] | None,
        'Relative frequencies of kinds of question, as in ``{"period": 2, "reverse.count": 0}``.',
    ]
    units: Annotated[str, "System of units of the texts: ``SI``, ``cgs`` or ``mixed``."]
    tolerance: Annotated[
        float, "Relative error that an answer may have, from 0.005 to 0.05; the filters apply it, too."
    ]
    needs: Annotated[
        Names, 'Mathematics that solutions may need, as in ``("arithmetic", "quadratic")``, or ``all``; see `item`.'
    ]
    solutions: Annotated[bool, "Whether items have worked solutions."]
    unfiltered: Annotated[bool, "Whether to keep every question with an answer, even if a filter rejects it."]
    split: Annotated[Mapping[str, float] | None, 'Shares of the splits, as in ``{"train": 0.9, "test": 0.1}``.']
    distance: Annotated[float, "Least relative difference of some number between two variants of a problem."]
    decontaminate: Annotated[
        Path | str | Sequence[Path | str], "Files of benchmarks with which no problem may share a run of words."
    ]
    license: Annotated[str, "License of the data, by its name on the Hugging Face Hub."]
    shard: Annotated[int, "Number of problems in one file."]
    maker: Annotated[
        str, "Function that makes items, as a dotted path; it may accept names that the library does not have."
    ]


DEFAULTS: Order = {
    "items": DEFAULT_ITEMS,
    "recipe": ALL_NAMES,
    "difficulty": ALL_NAMES,
    "mode": "numeric",
    "seed": 0,
    "weights": None,
    "units": SI,
    "tolerance": TOLERANCE,
    "needs": (),
    "solutions": False,
    "unfiltered": False,
    "split": None,
    "distance": DEFAULT_DISTANCE,
    "decontaminate": (),
    "license": LICENSE,
    "shard": DEFAULT_SHARD_ROWS,
    "maker": MAKER,
}


def _ordered(function: F) -> F:
    """Add the options of `Order` to the signature and docstring of a function that takes them as keyword arguments."""
    taken, hints = signature(function), get_type_hints(Order, include_extras=True)
    own = [each for each in taken.parameters.values() if each.kind is not Parameter.VAR_KEYWORD]
    options = [
        Parameter(name, Parameter.KEYWORD_ONLY, default=DEFAULTS.get(name), annotation=get_args(kind)[0])
        for name, kind in hints.items()
    ]
    function.__signature__ = taken.replace(parameters=own[:1] + options + own[1:])  # type: ignore[attr-defined]
    lines = [f"{name}: {get_args(kind)[1]}" for name, kind in hints.items()]
    function.__doc__ = ORDER.sub(lambda match: "\n".join(match[1] + line for line in lines), function.__doc__ or "")
    return function


@_ordered
def generate(
    out: Path | str,
    *,
    workers: int | None = None,
    on: str = HERE,
    advance: Callable[[int], object] = ignore_progress,
    **order: Unpack[Order],
) -> Dataset:
    """Generate problems into a folder and open the dataset.

    A dataset that is already in the folder is continued: after an interruption the same call goes on, and with more
    `items` the dataset grows. The same options give the same bytes, whatever the number of `workers` and wherever they
    run. A program needs no guard by ``__name__``, since worker processes do not run it.

    Args:
        out: The folder.
        order: the options of `Order`.
        workers: Number of processes; by default one for each core. With 1, the calling process does the work.
        on: Where the workers run: ``here``, ``ray`` or ``ray://HOST:PORT``.
        advance: Callback that takes the number of further positions that are finished.

    Returns:
        The finished dataset.

    Raises:
        UnknownNameError: There is no such recipe, difficulty, mode, system of units or place.
        DatasetError: An option is invalid, the folder contains something else, or no worker can be reached.
        TypeError: There is no such option.
        MissingExtraError: The place needs a package that is not installed.

    Examples:
        >>> import sim2reason
        >>> sim2reason.generate("problems", items=2, recipe="pulley", difficulty="easy", workers=1)
        <Dataset 'problems': 2 train>
    """
    benchmarks = Benchmarks(files_to_avoid(order))
    build(out, build_config(**order), workers=workers, advance=advance, on=on, benchmarks=benchmarks)
    return Dataset(out)


def build_config(**order: Unpack[Order]) -> Config:
    """Return the configuration of a dataset for the given options; DatasetError or UnknownNameError if invalid."""
    unknown = [name for name in order if name not in Order.__annotations__]
    if unknown:  # as Python says of all other functions
        known = ", ".join(sorted(Order.__annotations__))
        raise TypeError(f"generate() got an unexpected keyword argument {unknown[0]!r}; an order has {known}")
    options: dict[str, Any] = {**DEFAULTS, **order}
    ours = options["maker"] == MAKER  # another may know names that the library doesn't
    pairs = {name: numbers(name, {} if options[name] is None else options[name]) for name in ("weights", "split")}
    given = pairs | {name: value for name, value in order.items() if name in AS_GIVEN and name not in pairs}
    fields = {
        "items": options["items"],
        "recipes": find_recipes(options["recipe"], check=ours),
        "difficulties": difficulties_named(options["difficulty"]),
        "modes": find_modes(options["mode"], check=ours),
        "units": system_named(options["units"]).name,
        "needs": find_needs(options["needs"]),
        "decontaminate": tuple(benchmark_file_record(path) for path in files_to_avoid(order)),
        **{name: value for name, value in given.items() if value != {}},
    }
    try:
        fields |= {name: nonnegative_integer(name, fields[name]) for name in NUMBERS if name in fields}
        return Config.model_validate(fields, strict=True)
    except DrawError as error:
        raise DatasetError(str(error)) from None
    except ValidationError as error:
        fault = error.errors()[0]
        problem = fault["msg"].removeprefix("Value error, ")
        raise DatasetError(f"{'.'.join(map(str, fault['loc']))}: {problem}") from None


def files_to_avoid(order: Order) -> tuple[Path, ...]:
    """Return the benchmark files in the options; DatasetError for an invalid path."""
    given = order.get("decontaminate", ())
    try:
        return tuple(map(Path, (given,) if isinstance(given, str | Path) else given))
    except TypeError:
        raise DatasetError(f"decontaminate: {given!r} names no files; give a path, or several in a list") from None


def read_order(path: Path) -> Order:
    """Read an order from a YAML file.

    Raises:
        DatasetError: the file is invalid or has an unknown option. ``maker``, which names code, is no option here.
        OSError: the file can't be read.
    """
    try:
        settings = read_settings(path)
    except EvaluationError as error:
        raise DatasetError(str(error)) from None
    options = [name for name in DEFAULTS if name != "maker"]
    for name in settings:
        if name not in options:
            near = similar_names(name, options)
            known = f"did you mean: {near[0]}" if near else f"there are: {', '.join(options)}"
            raise DatasetError(f"{path}: {name}: there is no such option; {known}")
    return cast("Order", settings)
