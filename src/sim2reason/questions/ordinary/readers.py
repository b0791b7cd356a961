"""What several tables of main clauses share: what they give, and the simplest of their readers."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from sim2reason.questions.ordinary.hearing import ALL, Heard
from sim2reason.questions.ordinary.whens import When

FREE, STRETCH, MOMENT, CLAUSED, LANDING = "free", "stretch", "moment", "claused", "landing"
"""What a clause beside a main clause tells, for which see `Main`."""


@dataclass(frozen=True, slots=True)
class Main:
    """What is found, of what, along which axis; what is taken for granted of ways; and the moment that it implies.

    `needs` says whether it asks for a value at a moment, which is steady where none is named; for something over a
    stretch of the motion, up to a moment or the whole of it; for something *free* of moments; or for a value only
    beside a clause, that of a landing at most. Those of a higher `rank` are meant only where the scene has none of a
    lower one.
    """

    find: str
    of: str = ""
    along: str = ""
    needs: str = MOMENT
    ways: tuple[tuple[str, str], ...] = ()
    when: When | None = None
    rank: int = 0


Reader = Callable[[re.Match[str], Heard], Iterator[Main]]


def each(heard: Heard, token: str | None) -> tuple[str, ...]:
    """The subjects that a token stands for: one, or all that share a noun."""
    said = heard.subject(token)
    return tuple(said.removeprefix(f"{ALL} ").split(" & ")) if said.startswith(f"{ALL} ") else (said,)


def of_one(*finds: str, needs: str = MOMENT) -> Reader:
    """Something of one subject, by any of several names."""

    def read(found: re.Match[str], heard: Heard) -> Iterator[Main]:
        for of in each(heard, found.groupdict().get("s")):
            yield from (Main(find, of, needs=needs) for find in finds)

    return read


def of_none(*finds: str, needs: str = MOMENT) -> Reader:
    """Something of the only subject that it can be of, whatever is named."""

    def read(found: re.Match[str], heard: Heard) -> Iterator[Main]:
        del found, heard
        yield from (Main(find, needs=needs) for find in finds)

    return read


def implied(find: str, *whens: str, needs: str = FREE) -> Reader:
    """What implies its moment, as the time in the air does."""

    def read(found: re.Match[str], heard: Heard) -> Iterator[Main]:
        who = heard.subject(found.groupdict().get("s"))
        for rank, when in enumerate(whens):
            told = When(when.format(s=who).strip())
            yield Main(find, "" if find == "time" else who, needs=needs, when=told, rank=rank)

    return read
