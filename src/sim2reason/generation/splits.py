"""Assignment of items to splits by fingerprints of their problems, which ignore numbers."""

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from hashlib import blake2b
from itertools import accumulate, permutations
from math import log, pi
from typing import NamedTuple

from sim2reason.generation.item import Item, QueryRecord
from sim2reason.grading.formula import CompiledFormula, compile_formula
from sim2reason.scenes.dsl.units import Dimension, parse_unit

SAMPLE_POINTS = 6  # at which formulas are evaluated; some have no value at most points because of square roots
PAIR_POINTS = 3  # of them at which pairs of symbols are also changed
VALUE_RANGE = 0.2, 5.0  # of values in coherent units
ANGLES = 0.1 * pi, 0.45 * pi  # rad
PAIR_FACTORS = 1.3717, 1.7331  # factors on the first and the second symbol of a pair
VALUE_DIGITS = 6  # of a value relative to the largest, far coarser than rounding errors
MIN_NONZERO_VALUES = 4  # nonzero values from which a formula's fingerprint is distinctive

Values = Mapping[tuple[int, ...], float | None]
"""The values at one point, by the places of the symbols that are moved; None where there is none."""


class _Rounded(NamedTuple):
    """The formula's values at one sample point as integers relative to the largest, and the largest's logarithm."""

    multiples: Mapping[tuple[int, ...], int | None]
    size: float


@lru_cache(maxsize=2048)
def fingerprint(latex: str, symbols: tuple[str, ...], units: tuple[str, ...]) -> str:
    """Return a fingerprint of a formula, independent of the names of its symbols and of arrangement.

    The text of the formula itself if it has too few values to be distinctive, or cannot be parsed.
    """
    try:
        formula = compile_formula(latex, symbols)
    except ValueError:
        return latex
    unit_of = dict(zip(symbols, units, strict=True))
    roles = [parse_unit(unit_of[name]).dimension for name in formula.symbols]
    samples = [_rounded(_values(formula, roles, point)) for point in range(SAMPLE_POINTS)]
    if sum(bool(value) for each in samples if each for value in each.multiples.values()) < MIN_NONZERO_VALUES:
        return latex
    signed = (json.dumps(_form(samples, roles, sign)) for sign in (1, -1))
    return blake2b(min(signed).encode(), digest_size=16, person=b"formula").hexdigest()


def _values(formula: CompiledFormula, roles: Sequence[Dimension], point: int) -> Values:
    base = [_number(role, point) for role in roles]
    places = range(len(roles))
    moves = [(), *((index,) for index in places), *(permutations(places, 2) if point < PAIR_POINTS else ())]
    return {moved: formula.value(dict(zip(formula.symbols, _moved(base, moved), strict=True))) for moved in moves}


def _number(role: Dimension, point: int) -> float:
    """Return the value given to all symbols of one dimension when two formulas are compared at a sample point."""
    digest = blake2b(f"{point} {tuple(role)}".encode(), digest_size=8).digest()
    low, high = ANGLES if role == Dimension(angle=1) else VALUE_RANGE
    return low * (high / low) ** (int.from_bytes(digest, "big") / 2.0**64)


def _moved(base: Sequence[float], moved: tuple[int, ...]) -> Iterator[float]:
    factors = dict(zip(moved, PAIR_FACTORS, strict=False))
    return (number * factors.get(index, 1.0) for index, number in enumerate(base))


def _rounded(values: Values) -> _Rounded | None:
    """Return the formula's values at one sample point relative to the largest; None if all are zero."""
    largest = max((abs(value) for value in values.values() if value is not None), default=0.0)
    if not largest:
        return None
    share = 10.0**VALUE_DIGITS / largest
    return _Rounded({at: None if v is None else round(v * share) for at, v in values.items()}, log(largest))


def _form(samples: Sequence[_Rounded | None], roles: Sequence[Dimension], sign: int) -> object:
    """Return a formula's sampled values, with a sign, sorted independently of the names of its symbols."""
    first = next(each.size for each in samples if each)
    sizes = [each and round((each.size - first) * 10**VALUE_DIGITS) for each in samples]

    def at(*moved: int) -> list[int]:
        # what has no value sorts as a number that no value has
        values = (each.multiples.get(moved) if each else None for each in samples)
        return [2 * 10**VALUE_DIGITS if value is None else sign * value for value in values]

    def seen_from(place: int) -> object:
        others = (other for other in range(len(roles)) if other != place)
        pairs = sorted((tuple(roles[other]), at(place, other), at(other, place)) for other in others)
        return tuple(roles[place]), at(place), pairs

    return sizes, at(), sorted(map(seen_from, range(len(roles))), key=json.dumps)


_NUMBER = re.compile(r"(?<![\w.])[-−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.])")


def problem(item: Item) -> str:
    """Return the problem of an item without numbers: equal for all its variants.

    It depends on the scene's entities and connections, and on the queries with their subjects, but not on wording, nor
    on the order of parts. A problem whose answer is a formula is identified by the formula, up to a factor and the
    names of its symbols, whatever the scene.
    """
    formula = item.answer.formula
    if formula is not None and not item.parts:
        return fingerprint(formula.latex, formula.symbols, formula.units)
    questions = sorted(question(part.kind, part.asked) for part in item.parts) or [question(item.kind, item.asked)]
    return "\n".join((item.mode, *questions, mask_numbers(item.scene)))


def question(kind: str, query: QueryRecord) -> str:
    """Return the query of a question as text without numbers."""
    event = mask_numbers(query.event or "")
    left_open = ", ".join(dict.fromkeys(filter(None, (query.unknown, query.limit_of))))
    return f"{kind}\n{query.quantity}\n{query.subject}\n{left_open}\n{event}"


def choose_split(item: Item, shares: Mapping[str, float]) -> str:
    """Return the split of an item; each split gets its share of all problems up to numbers."""
    names = list(shares)
    if len(names) == 1:
        return names[0]
    digest = blake2b(problem(item).encode(), digest_size=8, person=b"split").digest()
    fraction = int.from_bytes(digest, "big") / 2.0**64
    bounds = zip(names, accumulate(shares.values()), strict=True)
    return next((name for name, bound in bounds if fraction < bound), names[-1])


def parse_numbers(text: str) -> list[float]:
    """Return the numbers in a text."""
    return [float(number.replace("−", "-")) for number in _NUMBER.findall(text)]


def mask_numbers(text: str) -> str:
    """Return a text with its numbers replaced by a placeholder."""
    return _NUMBER.sub("#", text)
