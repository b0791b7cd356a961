"""What settings in a file choose problems by: recipes, difficulties and modes, all of them known."""

from collections.abc import Callable
from typing import Annotated

from pydantic import AfterValidator, BaseModel

from sim2reason.base.settings import held_to
from sim2reason.datasets.names import difficulties_named, modes_named, recipes_named
from sim2reason.datasets.plan import ALL

__all__ = ["Chosen"]

Given = str | tuple[str, ...]
"""One name, several, or ``all``."""


def _known(named: Callable[[Given], tuple[str, ...]]) -> AfterValidator:
    """Return a validator: `named` raises for a name that there is not."""

    def check(value: Given) -> Given:
        if not value:
            raise ValueError(f"names none; give one, several, or {ALL}")
        return held_to(named, value)

    return AfterValidator(check)


class Chosen(BaseModel):
    """Settings of problems that are drawn, which classes of settings inherit."""

    recipe: Annotated[Given, _known(recipes_named)] = ALL
    difficulty: Annotated[Given, _known(difficulties_named)] = ALL
    modes: Annotated[Given, _known(modes_named)] = ("numeric",)
