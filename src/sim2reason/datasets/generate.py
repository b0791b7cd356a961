"""Generate a dataset from Python, as the command of this name does."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TypedDict, Unpack

from pydantic import ValidationError

from sim2reason.datasets.benchmark_files import described
from sim2reason.datasets.build import build
from sim2reason.datasets.contamination import Benchmarks
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.names import difficulties_named, modes_named, needs_named, recipes_named
from sim2reason.datasets.places import HERE
from sim2reason.datasets.plan import ALL, MAKER, Config, Names, numbers
from sim2reason.datasets.request import SI, whole
from sim2reason.errors import DatasetError, DrawError
from sim2reason.questions.spoken_units import system_named

ITEMS = 1000
AS_GIVEN = "seed", "shard", "maker", "solutions", "unfiltered", "weights", "split", "distance", "license", "tolerance"
NUMBERS = "items", "seed", "shard"


class Order(TypedDict, total=False):
    """What a dataset shall hold; whatever is left out is as the command line has it."""

    items: int
    recipe: Names
    difficulty: Names
    mode: Names
    seed: int
    weights: Mapping[str, float]
    """How often kinds of question are asked: ``{"period": 2, "reverse.count": 0}``."""
    units: str
    """The system in which texts speak: ``SI``, ``cgs`` or ``mixed``."""
    tolerance: float
    """The relative error that an answer may have, and by which filters judge: from 0.005 to 0.05."""
    needs: Names
    """What solutions may need: ``("arithmetic", "quadratic")``, or ``all``; by default few need a computer."""
    solutions: bool
    """Whether items come with worked solutions."""
    unfiltered: bool
    """A control: any question that has an answer is kept, whatever the filters say of it."""
    split: Mapping[str, float]
    """The shares of the splits: ``{"train": 0.9, "test": 0.1}``."""
    distance: float
    """How far apart, relatively, some number of two variants of a problem is at least."""
    decontaminate: Path | str | Sequence[Path | str]
    """Files of benchmarks with which no problem may share a run of words."""
    license: str
    """Of the data, as the Hugging Face hub calls it."""
    shard: int
    """How many problems stand in one file."""
    maker: str
    """The maker of items by its dotted path: one of one's own may know names that the library doesn't."""


def generate(
    out: Path | str,
    *,
    workers: int | None = None,
    advance: Callable[[int], object] = lambda _: None,
    on: str = HERE,
    **order: Unpack[Order],
) -> Dataset:
    """Fill the folder `out` with problems, or go on with what stands there, and open it.

    The same order gives the same bytes, whatever the number of `workers` (default: one per core) and wherever they work
    (`on`: ``here``, ``ray`` or ``ray://HOST:PORT``); with more `items` a dataset grows. `advance` is called with the
    number of positions that are done.

    Raises:
        UnknownNameError: no such recipe, difficulty, mode, units or place.
        DatasetError: an order that makes no sense, a folder that holds anything else, or a place where nobody works.
        TypeError: an order of what there is not.
        MissingExtraError: the place needs a package that is not installed.
    """
    benchmarks = Benchmarks(files_to_avoid(order))
    build(out, configured(**order), workers=workers, advance=advance, on=on, benchmarks=benchmarks)
    return Dataset(out)


def configured(**order: Unpack[Order]) -> Config:
    """The configuration that an order means; it raises what `generate` does."""
    unknown = [name for name in order if name not in Order.__annotations__]
    if unknown:  # as Python says of all other functions
        known = ", ".join(sorted(Order.__annotations__))
        raise TypeError(f"generate() got an unexpected keyword argument {unknown[0]!r}; an order has {known}")
    ours = order.get("maker", MAKER) == MAKER  # another may know names that the library doesn't
    pairs = {name: numbers(name, order.get(name, {})) for name in ("weights", "split")}
    given = pairs | {name: value for name, value in order.items() if name in AS_GIVEN and name not in pairs}
    fields = {
        "items": order.get("items", ITEMS),
        "recipes": recipes_named(order.get("recipe", ALL), check=ours),
        "difficulties": difficulties_named(order.get("difficulty", ALL)),
        "modes": modes_named(order.get("mode", "numeric"), check=ours),
        "units": system_named(order.get("units", SI)).name,
        "needs": needs_named(order.get("needs", ())),
        "decontaminate": tuple(described(path) for path in files_to_avoid(order)),
        **{name: value for name, value in given.items() if value != {}},
    }
    try:
        fields |= {name: whole(name, fields[name]) for name in NUMBERS if name in fields}
        return Config.model_validate(fields, strict=True)
    except DrawError as error:
        raise DatasetError(str(error)) from None
    except ValidationError as error:
        fault = error.errors()[0]
        problem = fault["msg"].removeprefix("Value error, ")
        raise DatasetError(f"{'.'.join(map(str, fault['loc']))}: {problem}") from None


def files_to_avoid(order: Order) -> tuple[Path, ...]:
    """The files of benchmarks in an order: one, or several; DatasetError for what is no file."""
    given = order.get("decontaminate", ())
    try:
        return tuple(map(Path, (given,) if isinstance(given, str | Path) else given))
    except TypeError:
        raise DatasetError(f"decontaminate: {given!r} names no files; give a path, or several in a list") from None
