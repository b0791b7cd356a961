"""Shell completion for the options of a structured question, with names from the scene file."""

from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sim2reason.cli import source
from sim2reason.errors import Sim2ReasonError

if TYPE_CHECKING:
    from sim2reason.questions import Words


def findable(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[str]:
    """Return the names of quantities and numbers of the scene that begin with `incomplete`."""
    from sim2reason.questions.posing import findable as names

    del param
    words = _words(ctx)
    return _beginning(incomplete, names(words) if words is not None else ())


def subjects(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[str]:
    """Return the addresses of bodies of the scene that begin with `incomplete`."""
    del param
    words = _words(ctx)
    return _beginning(incomplete, words.mentions if words is not None else ())


def moments(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[str]:
    """Return the names of moments and outcomes that begin with `incomplete`."""
    from sim2reason.questions import MOMENTS
    from sim2reason.questions.outcomes import OUTCOMES

    del ctx, param
    return _beginning(incomplete, (name.replace("_", " ") for name in (*MOMENTS, *OUTCOMES, "equilibrium")))


def _words(ctx: click.Context) -> "Words | None":
    from sim2reason.questions.prompt import words_of
    from sim2reason.text.prose.description import describe

    path = ctx.params.get("scene") or next(iter(ctx.args), None)  # click leaves it there while an option has no value
    with suppress(Sim2ReasonError, OSError):
        return words_of(describe(source.scene(Path(path)))) if path is not None else None
    return None


def _beginning(incomplete: str, names: Iterable[str]) -> list[str]:
    return [name for name in names if name.startswith(incomplete)]
