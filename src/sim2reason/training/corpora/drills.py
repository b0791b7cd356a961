"""Drills: sums, products and quotients of random numbers, for a model that has never seen any arithmetic."""

from collections import Counter
from collections.abc import Iterator
from typing import Annotated

import numpy as np
from annotated_types import Ge, Le

from sim2reason.generation.random_scenes import generator
from sim2reason.training.corpora import CORPORA, Corpus, Row
from sim2reason.training.corpora.parts.operations import plain_number

__all__ = ["Drills"]

PROMPT = "Operations:"
SHARES = {"*": 0.5, "+": 0.1, "-": 0.1, "/": 0.3}


@CORPORA.register("drills")
class Drills(Corpus):
    """Operations with three-digit results, as solutions written as arithmetic have them; no problem comes before."""

    seed: Annotated[int, Ge(0)] = 0
    items: Annotated[int, Ge(1), Le(10**7)] = 10_000
    operations: Annotated[int, Ge(1), Le(100)] = 10
    """In one row."""

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield all of them."""
        del left_out
        rng = generator("drills", self.seed)
        for _ in range(self.items):
            yield Row(PROMPT, "; ".join(_operation(rng) for _ in range(self.operations)))


def _operation(rng: np.random.Generator) -> str:
    """Return one operation on numbers about one, as mechanics in the units of the SI has them."""
    sign = str(rng.choice(list(SHARES), p=list(SHARES.values())))
    first = float(plain_number(10.0 ** rng.uniform(-0.8, 1.0)))
    second = float(f"{10.0 ** rng.uniform(-1.2, 1.0):.{2 if sign == '*' else 3}g}")
    result = {"*": first * second, "+": first + second, "-": first - second, "/": first / second}[sign]
    return f"{plain_number(first)}{sign}{second:g}={plain_number(result)}"
