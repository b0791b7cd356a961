"""Corpora of arithmetic solutions and of drills."""

from collections import Counter
from collections.abc import Callable, Iterator
from typing import Annotated

import numpy as np
from annotated_types import Ge, Le
from pydantic import Field, field_validator

from sim2reason.generation.certified import worked_solution
from sim2reason.generation.item_search import ItemSearch, generator
from sim2reason.generation.make import item_of
from sim2reason.generation.request import Request
from sim2reason.training.corpora import CORPORA, Corpus, Row
from sim2reason.training.corpora.parts.drawing import drawn_rows
from sim2reason.training.corpora.parts.operations import Definitions, arithmetic, plain_number
from sim2reason.training.corpora.parts.renumbering import SLIPS, renumbered, slipped
from sim2reason.training.sources.fresh import Fresh, fingerprint

__all__ = ["Arithmetic", "Drills"]

Share = Annotated[float, Ge(0.0), Le(1.0)]


@CORPORA.register("arithmetic")
class Arithmetic(Corpus):
    """Arithmetic solutions of problems generated from a seed, optionally with planted errors."""

    problems: Fresh
    """What is drawn, as a source of prompts has it; of another seed than those that are trained or evaluated on."""
    items: Annotated[int, Ge(1), Le(10**7)] = 1000
    """How many problems are drawn."""
    rows_each: Annotated[int, Ge(1), Le(1000)] = 1
    """Rows of each problem: the first with its own numbers, the others with other numbers, and slips of their own.

    Problems with other numbers are no more certified, nor has any filter seen them.
    """
    slips: dict[str, Share] = Field(default_factory=dict[str, Share])
    """How often a solution has each kind of slip, where there is place for it."""
    workers: Annotated[int, Ge(1), Le(1024)] = 1
    """Processes that make the problems; they never change which."""

    @field_validator("slips")
    @classmethod
    def _known(cls, value: dict[str, float]) -> dict[str, float]:
        for name in value:
            if name not in SLIPS:
                raise ValueError(f"no such slip: {name!r}; there are: {', '.join(SLIPS)}")
        return value

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield the rows of the problems in order, without those whose solution is not arithmetic."""
        return drawn_rows(self.problems, self.rows_of, self.items, self.workers, left_out, "no arithmetic")

    def rows_of(self, request: Request) -> list[Row] | None:
        """Return the prompts and arithmetic solutions of one problem and its variants; None if no problem is found."""
        certified = ItemSearch(request).find()
        if certified is None:
            return None
        item = item_of(request, certified)
        solution = worked_solution(request, certified)
        rows = list[Row]()
        for number in range(self.rows_each):
            rng = generator("corpus", request.id, number)
            prompt, held = (number and renumbered(item.prompt, solution, rng)) or (item.prompt, solution)
            right, text = arithmetic(held), arithmetic(held, self._slips(rng))
            if text:
                known = fingerprint(item) if held is solution else ""
                rows.append(Row(prompt, text, _answer(text) == _answer(right), known))
        return rows

    def _slips(self, rng: np.random.Generator) -> Callable[[Definitions], Definitions]:
        return lambda held: slipped(held, self.slips, rng)


def _answer(text: str) -> str:
    """Return the content of the box."""
    return text.rpartition("\n")[2]


PROMPT = "Operations:"
SHARES = {"*": 0.5, "+": 0.1, "-": 0.1, "/": 0.3}


@CORPORA.register("drills")
class Drills(Corpus):
    """Single operations with three-digit results, written as in arithmetic solutions, without a problem."""

    seed: Annotated[int, Ge(0)] = 0
    items: Annotated[int, Ge(1), Le(10**7)] = 10_000
    operations: Annotated[int, Ge(1), Le(100)] = 10
    """In one row."""

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield all drills, each as a prompt with its completion."""
        del left_out
        rng = generator("drills", self.seed)
        for _ in range(self.items):
            yield Row(PROMPT, "; ".join(_operation(rng) for _ in range(self.operations)))


def _operation(rng: np.random.Generator) -> str:
    """Return one random operation on numbers of the magnitudes usual in mechanics in SI units."""
    sign = str(rng.choice(list(SHARES), p=list(SHARES.values())))
    first = float(plain_number(10.0 ** rng.uniform(-0.8, 1.0)))
    second = float(f"{10.0 ** rng.uniform(-1.2, 1.0):.{2 if sign == '*' else 3}g}")
    result = {"*": first * second, "+": first + second, "-": first - second, "/": first / second}[sign]
    return f"{plain_number(first)}{sign}{second:g}={plain_number(result)}"
