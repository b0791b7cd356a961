"""What a shell completes after an option of a question in parts: names of the scene that stands in the file."""

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
    """What can be found in the scene."""
    from sim2reason.questions.posing import findable as names

    del param
    words = _words(ctx)
    return _beginning(incomplete, names(words) if words is not None else ())


def subjects(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[str]:
    """The bodies of the scene by address."""
    del param
    words = _words(ctx)
    return _beginning(incomplete, words.mentions if words is not None else ())


def moments(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[str]:
    """All moments and outcomes by name."""
    from sim2reason.questions import MOMENTS
    from sim2reason.questions.outcomes import OUTCOMES

    del ctx, param
    return _beginning(incomplete, (name.replace("_", " ") for name in (*MOMENTS, *OUTCOMES, "equilibrium")))


def _words(ctx: click.Context) -> "Words | None":
    from sim2reason.prose.description import describe
    from sim2reason.questions.prompt import words_of

    path = ctx.params.get("scene")
    with suppress(Sim2ReasonError, OSError):
        return words_of(describe(source.scene(Path(path)))) if path is not None else None
    return None


def _beginning(incomplete: str, names: Iterable[str]) -> list[str]:
    return [name for name in names if name.startswith(incomplete)]
