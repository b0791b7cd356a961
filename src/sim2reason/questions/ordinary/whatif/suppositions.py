"""The reading of suppositions, such as *if g were 5 m/s²*, as changes of a scene's numbers."""

import re
from collections.abc import Mapping
from functools import cache
from typing import NamedTuple

from sim2reason.questions.ordinary.hearing import Heard
from sim2reason.questions.ordinary.whatif.numbers import NUMBER, NamedNumber, named_number, number_pattern
from sim2reason.questions.ordinary.whatif.supposed_rows import (
    ADJUNCTS,
    CLAUSES,
    DONE,
    MULTIPLES,
    SWAPPED,
    TIMES,
)

Rows = tuple[tuple[str, str, str], ...]
_JOINED = re.compile(r" (?:,? ?and|,) (?:if )?")


class Supposition(NamedTuple):
    """A change of a number or a body that a sentence supposes.

    `how` is one of the changes of `supposed_rows`. The number changes to a `value`, with the unit of the sentence, by a
    `factor`, or by the value with a `sign`. A speed may be told with the `way`, *up* or *down*.
    """

    how: str
    number: NamedNumber
    value: str = ""
    factor: float = 1.0
    sign: int = 0
    way: str = ""


def suppositions(text: str, heard: Heard) -> tuple[Supposition, ...]:
    """Return the changes that a clause such as *A were twice as heavy and g were 5 m/s²* supposes, joined by *and*.

    There are none if a part of the clause is not understood.
    """
    alone = _first(text, heard, CLAUSES)
    if alone:
        return alone
    for found in _JOINED.finditer(text):
        # The first part is one change, not several: else each *and* would double the work.
        one = _first(text[: found.start()], heard, CLAUSES)
        if other := suppositions(text[found.end() :], heard) if one else ():
            return (*one, *other)
    return ()


def adjunct(text: str, heard: Heard) -> tuple[Supposition, ...]:
    """Return the change that a phrase such as *without friction* supposes; none if it is not understood."""
    return _first(text, heard, ADJUNCTS)


def _first(text: str, heard: Heard, rows: Rows) -> tuple[Supposition, ...]:
    """Return the change of the first row that a text matches; none if it matches no row."""
    subject = {f"@{index}@": said for index, said in enumerate(heard.subjects)}
    said = re.sub(r"\b(?:just|instead only|only)\b ?", "", text).strip(" ,")
    for told, kind, how in rows:
        found = _compiled(told).fullmatch(said)
        if found is None:
            continue
        groups = found.groupdict()
        number = named_number(found, subject) if NUMBER in told else NamedNumber(kind or f"{groups.get('e')} field")
        owners = tuple(subject[groups[key]] for key in ("s", "t") if groups.get(key))
        if owners and not number.owners and how != SWAPPED:
            number = number._replace(owners=owners[:1])
        elif how == SWAPPED:
            number = number._replace(owners=owners)
        return (_changed(how, number, groups, heard),)
    return ()


MEANT = {"level": "0", "ground": "0 m", "flat": "0", "upright": "90", "elastic": "1", "plastic": "0"}
"""By the group of a row that matches, the value that its words mean."""


def _changed(how: str, number: NamedNumber, groups: Mapping[str, str | None], heard: Heard) -> Supposition:
    token = groups.get("n")
    value = heard.number(token) if token else ""
    value = next((told for name, told in MEANT.items() if groups.get(name)), value)
    sign = 1 if groups.get("grow") else -1 if groups.get("shrink") else 0
    if groups.get("pct") or (sign and value.endswith(("%", "percent"))):
        return Supposition(TIMES, number, factor=1.0 + sign * float(value.partition(" ")[0].rstrip("%")) / 100.0)
    return Supposition(how, number, value, _factor(groups, heard), sign, groups.get("way") or "")


def _factor(groups: Mapping[str, str | None], heard: Heard) -> float:
    done, multiple = groups.get("done"), groups.get("mult")
    if done:
        return DONE[done]
    if multiple and multiple.startswith("#"):
        return float(heard.number(multiple.partition(" ")[0]).partition(" ")[0])
    return next((value for told, value in MULTIPLES.items() if multiple and re.fullmatch(told, multiple)), 1.0)


@cache
def _compiled(told: str) -> re.Pattern[str]:
    return re.compile(told.replace(NUMBER, number_pattern()))
