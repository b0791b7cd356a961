"""Plan of a dataset: the request at each position, as a pure function of the configuration."""

import hashlib
import json
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import product, starmap
from math import isclose, lcm
from numbers import Real
from typing import Annotated, cast

from annotated_types import Ge, Le, MinLen
from pydantic import AfterValidator, BaseModel, Field, field_validator

from sim2reason.base.records import cached_property
from sim2reason.base.settings import validate_with
from sim2reason.datasets.contamination import BenchmarkFile
from sim2reason.errors import DatasetError, DrawError, UnknownNameError
from sim2reason.generation.item import Record
from sim2reason.generation.recipes import RECIPES, all_recipes, find_difficulty
from sim2reason.generation.request import MAX_SEED, SI, Request, Weights
from sim2reason.questions import MODES
from sim2reason.questions.accuracy import TOLERANCE, out_of_range
from sim2reason.questions.difficulty import DIFFICULTIES, NEEDS, Difficulty, Need

__all__ = ["Chosen"]

MAKER = "sim2reason.generation.make:make"
"""The maker of items, by dotted path, so that a worker process can find it."""
DEFAULT_SHARD_ROWS = 500  # rows: a few MB, made in half a minute; the most that a kill can lose
BARREN, TURNS = 100, 2  # positions, and rounds over all cells, without new items after which generation ends
MIN_ATTEMPTS = 20  # positions, with one round, if there is no item at all
MAX_SHARD_ROWS = 100_000  # rows in memory at once, some 300 MB
DATA = "data"
"""The folder of all shards."""
TRAIN = "train"
"""The split that holds everything where none is asked for; so the Hugging Face hub calls it, too."""
DEFAULT_DISTANCE = 0.05
"""How far apart the numbers of two variants of a problem are at least: the relative tolerance of answers.

If no number of one differs by more from that of the other, its answer included, then who knows one answer knows both.
"""
LICENSE = "apache-2.0"
"""Of the data, by the name that the Hugging Face hub has for it: that of the library."""
ALL_NAMES = "all"
Names = str | Sequence[str]
"""One name, several, or ``all``."""
SHARES = "--split train=0.9,test=0.1"
"""What shares of splits look like."""
_SPLIT = re.compile(r"[a-z][a-z0-9_]{0,30}")
_LICENSE = re.compile(r"[a-z0-9][a-z0-9.+-]{0,39}")


def several(what: str, names: object) -> tuple[str, ...]:
    """Return one or more names as a tuple; DatasetError, with `what`, for anything else."""
    many = isinstance(names, Iterable) and not isinstance(names, str)
    for name in (chosen := tuple(cast("Iterable[object]", names if many else (names,)))):
        if not isinstance(name, str):
            raise DatasetError(f"{what}: {name!r} is no name; give one, several, or {ALL_NAMES!r}")
    return cast("tuple[str, ...]", chosen)


def numbers(what: str, pairs: object) -> dict[str, float]:
    """Return numbers by name, such as weights; DatasetError for anything else."""
    if not isinstance(pairs, Mapping):
        raise DatasetError(f"{what}: {pairs!r} is no mapping; give numbers by name, as in {{'period': 2}}")
    for name, size in (by_name := cast("Mapping[object, object]", pairs)).items():
        if not isinstance(name, str) or not isinstance(size, Real):
            raise DatasetError(f"{what}: {name!r}: {size!r} is no number of that name; write as in {{'period': 2}}")
    return cast("dict[str, float]", dict(by_name))


class Config(Record):
    """The configuration of a dataset: with the versions it decides every byte.

    Positions from 0 on cycle through recipes, difficulties and modes. A dataset consists of the first `items` positions
    whose items are not made redundant by earlier ones.
    """

    items: Annotated[int, Ge(0), Le(MAX_SEED)]
    recipes: Annotated[tuple[str, ...], MinLen(1)]
    difficulties: Annotated[tuple[str, ...], MinLen(1)] = DIFFICULTIES
    modes: Annotated[tuple[str, ...], MinLen(1)] = ("numeric",)
    seed: Annotated[int, Ge(0), Le(MAX_SEED)] = 0
    shard: Annotated[int, Ge(1), Le(MAX_SHARD_ROWS)] = DEFAULT_SHARD_ROWS
    maker: str = MAKER
    weights: dict[str, float] = Field(default_factory=dict[str, float])
    """How often kinds of question are asked, by name: ``period``, ``reverse.period``, ``springs.reverse.period``."""
    units: str = SI
    tolerance: float = TOLERANCE
    """The relative error that an answer may have."""
    needs: tuple[str, ...] = ()
    """What solutions may need, by label; none: elementary means, and for few items more."""
    solutions: bool = False
    """Whether items come with worked solutions."""
    unfiltered: bool = False
    """A control: any question that has an answer is kept, whatever the filters say of it."""
    split: dict[str, float] = Field(default_factory=lambda: {TRAIN: 1.0})
    """The shares of the splits, by name; together 1."""

    distance: Annotated[float, Ge(0.0), Le(1.0)] = DEFAULT_DISTANCE
    """By how much some number of two variants of a problem differs at least, relatively; 0 keeps all that differ."""
    decontaminate: tuple[BenchmarkFile, ...] = ()
    """Files of benchmarks with which no problem shares a run of words."""
    license: str = LICENSE
    """The licence of the data, as the card gives it."""

    @field_validator("split")
    @classmethod
    def _check_split(cls, value: dict[str, float]) -> dict[str, float]:
        """Validate the shares of splits and sort them by name."""
        for name, share in value.items():
            if not _SPLIT.fullmatch(name):
                raise ValueError(f"{name!r} is no name of a split; write small letters and digits, as in {SHARES}")
            if name == ALL_NAMES:
                raise ValueError(
                    f"{ALL_NAMES!r} stands for all splits, here and in the library datasets; give another name"
                )
            if not 0.0 < share <= 1.0:
                raise ValueError(f"{name}={share:g} is no share; give a number above 0 and at most 1, as in {SHARES}")
        total = sum(value.values())
        if not isclose(total, 1.0, abs_tol=1e-9):
            raise ValueError(f"the shares add up to {total:.12g}; give all of them, which add up to 1, as in {SHARES}")
        return dict(sorted(value.items()))

    @field_validator("tolerance")
    @classmethod
    def _of_use(cls, value: float) -> float:
        """Validate the tolerance of answers."""
        if fault := out_of_range(value):
            raise ValueError(fault)
        return value

    @field_validator("license")
    @classmethod
    def _of_the_hub(cls, value: str) -> str:
        """Validate the name of a licence on the Hugging Face Hub."""
        if not _LICENSE.fullmatch(value):
            raise ValueError(
                f"{value!r} is no licence on the Hugging Face hub; give its name there, as in --license mit"
            )
        return value

    @cached_property
    def _cells(self) -> tuple[tuple[str, str, str], ...]:
        """Return all combinations of recipe, difficulty and mode, in an order that mixes them evenly.

        Pairs of difficulty and mode form blocks, in which both change from each pair to the next, and all difficulties
        and modes are equally frequent. Each round covers all recipes. A recipe takes the next pair of its block in each
        round, and is one pair ahead of the previous recipe.
        """
        levels, modes = len(self.difficulties), len(self.modes)
        block = lcm(levels, modes)

        def cell(turn: int, place: int) -> tuple[str, str, str]:
            step, shift = (turn + place) % block, turn // block + place // block
            return self.recipes[place], self.difficulties[step % levels], self.modes[(step + shift) % modes]

        return tuple(starmap(cell, product(range(levels * modes), range(len(self.recipes)))))

    def barren_from(self, behind_last: int) -> int:
        """Return the position at which generation gives up; `behind_last` is the position after the last item."""
        tries, turns = (BARREN, TURNS) if behind_last else (MIN_ATTEMPTS, 1)
        return behind_last + max(tries, turns * len(self._cells))

    def request(self, position: int) -> Request:
        """Return the request at a position; positions cycle through all recipes, difficulties and modes."""
        turn, slot = divmod(position, len(self._cells))
        cell = self._cells[slot]
        index = turn * self._cells.count(cell) + self._cells[:slot].count(cell)
        how = self._weights, self.units, self.solutions, self.unfiltered
        return Request(*cell, self.seed, index, *how, tolerance=self.tolerance, needs=self.needs)

    def named(self, name: str) -> Request:
        """Return the request of an id; DrawError if the id does not match this configuration."""
        return Request.named(name, self._weights, self.tolerance, self.needs)

    @cached_property
    def _weights(self) -> Weights:
        return tuple(sorted(self.weights.items()))

    def shards(self, positions: int) -> int:
        """Return the number of shards for a number of positions."""
        return -(-positions // self.shard)

    def positions(self, number: int, end: int) -> range:
        """Return the range of positions of a shard, up to `end`."""
        return range(number * self.shard, min((number + 1) * self.shard, end))

    def position(self, request: Request) -> int:
        """Return the position of a request; DrawError if this configuration has none."""
        cell = request.recipe, request.difficulty, request.mode
        times = self._cells.count(cell)
        if times:
            turn, among = divmod(request.index, times)
            slot = [n for n, candidate in enumerate(self._cells) if candidate == cell][among]
            position = turn * len(self._cells) + slot
            if self.request(position).id == request.id:
                return position
        raise DrawError(f"{request.id}: no item of this dataset")

    def digest(self, versions: dict[str, str]) -> str:
        """Return a hash of the configuration and the package versions."""
        text = json.dumps([self.model_dump(mode="json"), versions], sort_keys=True)
        return hashlib.sha256(text.encode()).hexdigest()


def file_name(number: int, total: int, split: str = TRAIN) -> str:
    """Return the file name of a shard and split, in the style of the Hugging Face Hub."""
    return f"{DATA}/{split}-{number:05}-of-{total:05}.parquet"


def find_recipes(names: Names, *, check: bool = True) -> tuple[str, ...]:
    """Return recipes by name; with `check`, UnknownNameError suggests similar names for an unknown one."""
    recipes = all_recipes() if names == ALL_NAMES else several("recipe", names)
    for name in recipes if check else ():
        RECIPES[name]
    return recipes


def find_modes(names: Names, *, check: bool = True) -> tuple[str, ...]:
    """Return modes by name; with `check`, UnknownNameError suggests similar names for an unknown one."""
    modes = tuple(MODES) if names == ALL_NAMES else several("mode", names)
    for name in modes if check else ():
        MODES[name]
    return modes


def difficulties_named(names: Names) -> tuple[Difficulty, ...]:
    """Return difficulties by name; UnknownNameError for an unknown one."""
    difficulties = DIFFICULTIES if names == ALL_NAMES else several("difficulty", names)
    return tuple(find_difficulty(name) for name in difficulties)


def find_needs(names: Names) -> tuple[str, ...]:
    """Return needs by their labels, without repetitions in ascending order; UnknownNameError for others.

    A hyphen may replace a space. Without names the default quota applies.
    """
    needs = {_need(name) for name in (tuple(NEEDS) if names == ALL_NAMES else several("needs", names))}
    return tuple(need.label for need in sorted(needs))


def _need(name: str) -> Need:
    need = NEEDS.get(name.replace("-", " "))
    if need is None:
        raise UnknownNameError(f"no such need: {name!r}; there are: {', '.join(NEEDS)}, or {ALL_NAMES}")
    return need


Given = str | tuple[str, ...]
"""One name, several, or ``all``."""


def _known(named: Callable[[Given], tuple[str, ...]]) -> AfterValidator:
    """Return a pydantic validator of a setting that rejects empty values, and names that `named` does not know."""

    def check(value: Given) -> Given:
        if not value:
            raise ValueError(f"names none; give one, several, or {ALL_NAMES}")
        return validate_with(named, value)

    return AfterValidator(check)


class Chosen(BaseModel):
    """Settings that select problems (recipes, modes and so on), as a base class of other settings."""

    recipe: Annotated[Given, _known(find_recipes)] = ALL_NAMES
    difficulty: Annotated[Given, _known(difficulties_named)] = ALL_NAMES
    modes: Annotated[Given, _known(find_modes)] = ("numeric",)
