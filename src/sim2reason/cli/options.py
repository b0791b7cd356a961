"""Options shared by several commands."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

from sim2reason.cli.console import RESULT, VERBOSE, comma_separated

ALL = "all"
MAX_SEED = 2**63 - 1  # as of a seed of a dataset, whose module would load too much for --help
STRICTEST, TOLERANCE = 0.005, 0.05  # as of an item's answer, likewise
Names = str | tuple[str, ...]
"""One name, several, or all."""
F = TypeVar("F", bound=Callable[..., Any])


class Printing(click.Option):
    """An option that only affects what a command prints, and has no counterpart in the Python function."""


def names(ctx: click.Context, param: click.Parameter, value: str) -> Names:
    """Return the comma-separated names of an option, or all."""
    del ctx, param
    return value if value == ALL else comma_separated(value)


def names_or_none(ctx: click.Context, param: click.Parameter, value: str | None) -> Names:
    """Return the comma-separated names of an optional option; an empty tuple if the option is not given."""
    return () if value is None else names(ctx, param, value)


def pairs(ctx: click.Context, param: click.Parameter, value: str | None) -> dict[str, float]:
    """Return the pairs of name and number of an option; empty if it is not given."""
    del ctx
    numbers: dict[str, float] = {}
    for pair in value.split(",") if value is not None else ():
        name, equals, number = (part.strip() for part in pair.partition("="))
        if name in numbers:
            raise click.UsageError(f"--{param.name}: {name} is given twice; give it once.")
        try:
            numbers[name] = float(number)
        except ValueError:
            quoted = repr(pair.strip())
            raise click.UsageError(f"--{param.name}: {quoted} is no pair; write NAME{equals or '='}NUMBER.") from None
    return numbers


def scene() -> Callable[[F], F]:
    """Return a decorator that adds the argument for a scene file, or a dash for standard input."""
    return click.argument("scene", metavar="SCENE", type=click.Path(path_type=Path, allow_dash=True))


def dataset() -> Callable[[F], F]:
    """Return a decorator that adds the argument for a dataset folder."""
    return click.argument("dataset", metavar="DATASET", type=click.Path(path_type=Path))


def identity(text: str, *, required: bool = False) -> Callable[[F], F]:
    """Return a decorator that adds the option for the id of a problem."""
    return click.option("--id", "id", required=required, help=text)


def several(option: str, text: str, default: str = ALL) -> Callable[[F], F]:
    """Return a decorator that adds an option for one name, several, or all."""
    return click.option(option, callback=names, default=default, show_default=True, help=text)


def recipe() -> Callable[[F], F]:
    """Return a decorator that adds the option for recipes."""
    return several("--recipe", "Recipes, separated by commas, or all.")


def difficulty() -> Callable[[F], F]:
    """Return a decorator that adds the option for difficulties."""
    return several("--difficulty", "easy, medium, hard, several separated by commas, or all.")


def mode(default: str = "numeric") -> Callable[[F], F]:
    """Return a decorator that adds the option for modes."""
    return several("--mode", "Modes of questions, as in numeric,reverse; or all. See: sim2reason list modes.", default)


def split() -> Callable[[F], F]:
    """Return a decorator that adds the option for splits of a dataset."""
    return several("--split", "Splits of the dataset, separated by commas, or all.")


def one_recipe() -> Callable[[F], F]:
    """Return a decorator that adds the option for the recipe of one problem."""
    text = "Which kind of scene; see: sim2reason list recipes."
    return click.option("--recipe", default="pulley", show_default=True, help=text)


def one_difficulty() -> Callable[[F], F]:
    """Return a decorator that adds the option for the difficulty of one problem."""
    return click.option("--difficulty", default="medium", show_default=True, help="easy, medium or hard.")


def one_mode() -> Callable[[F], F]:
    """Return a decorator that adds the option for the mode of one problem."""
    return click.option(
        "--mode", default="numeric", show_default=True, help="Which mode of questions; see: sim2reason list modes."
    )


def seed(text: str) -> Callable[[F], F]:
    """Return a decorator that adds the option for a random seed."""
    return click.option("--seed", type=click.IntRange(0, MAX_SEED), default=0, show_default=True, help=text)


def wording() -> Callable[[F], F]:
    """Return a decorator that adds --seed for a text whose wording a scene file may state."""
    text = "Of the wording, as in describe; by default that which the file states, or 0."
    return click.option("--seed", type=click.IntRange(0, MAX_SEED), default=None, help=text)


def index(text: str) -> Callable[[F], F]:
    """Return a decorator that adds the option for the index of a problem in its series."""
    return click.option("--index", type=click.IntRange(0, MAX_SEED), default=0, show_default=True, help=text)


def items(default: int, minimum: int, most: int | None, text: str = "How many problems.") -> Callable[[F], F]:
    """Return a decorator that adds the option for the number of problems."""
    bounds = click.IntRange(minimum, most)
    return click.option("-n", "--items", type=bounds, default=default, show_default=True, help=text)


def weights() -> Callable[[F], F]:
    """Return a decorator that adds the option for weights of question kinds."""
    text = (
        "How often kinds of question are asked, as in period=2,reverse.count=0,springs.numeric.sum=0.5. [default: as "
        "the kinds and recipes declare]"
    )
    return click.option("--weights", callback=pairs, help=text)


def units() -> Callable[[F], F]:
    """Return a decorator that adds the option for the units of texts."""
    text = "In which texts speak: SI, cgs, or mixed (cm, g and km/h, else SI)."
    return click.option("--units", default="SI", show_default=True, help=text)


def tolerance() -> Callable[[F], F]:
    """Return a decorator that adds the option for the relative tolerance of answers."""
    text = "The relative error that an answer may have, and by which filters judge; from 0.005 on."
    kind = click.FloatRange(STRICTEST, TOLERANCE)
    return click.option("--tolerance", type=kind, default=TOLERANCE, show_default=True, help=text)


def needs() -> Callable[[F], F]:
    """Return a decorator that adds the option for the mathematics that solutions may need."""
    text = (
        "What solutions may need: arithmetic, quadratic, inverse-function, root, special-function or integration, "
        "several separated by commas, or all. [default: the first three, and more for at most one problem in ten]"
    )
    return click.option("--needs", callback=names_or_none, help=text)


def out(text: str, *, required: bool = False, printing: bool = True) -> Callable[[F], F]:
    """Return a decorator that adds the option for the output file."""
    kind = Printing if printing else click.Option
    return click.option("-o", "--out", "out", type=RESULT, required=required, cls=kind, help=text)


def to_json(text: str = "For a program to read.") -> Callable[[F], F]:
    """Return a decorator that adds the option for JSON output."""
    return click.option("--json", "to_json", is_flag=True, cls=Printing, help=text)


def verbose() -> Callable[[F], F]:
    """Return a decorator that adds --verbose, with which a long command reports more on stderr."""

    def kept(ctx: click.Context, param: click.Parameter, value: bool) -> None:
        del param
        ctx.meta[VERBOSE] = value

    text = "Tell more on stderr as it goes on, in lines."
    return click.option("-v", "--verbose", is_flag=True, cls=Printing, callback=kept, expose_value=False, help=text)


def figure(*, printing: bool = False) -> Callable[[F], F]:
    """Return a decorator that adds the option for the file of a drawing."""
    kind = Printing if printing else click.Option
    return click.option("--figure", type=RESULT, cls=kind, help="Draw the scene, too: a .svg, .png or .pdf file.")
