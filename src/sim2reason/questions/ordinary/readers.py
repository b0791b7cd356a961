"""Meanings of main clauses, and the simple readers that several tables of main clauses share."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from sim2reason.questions.ordinary.hearing import ALL, TokenizedSentence
from sim2reason.questions.ordinary.whens import When

GAIN, LOSS, JUMP, CHANGE = CHANGES = "gain", "loss", "loss in an impact", "change"
"""What a clause beside a main clause ends: a quantity's change since the start, or over what happens then."""
FREE, STRETCH, MOMENT, CLAUSED, LANDING = "free", "stretch", "moment", "claused", "landing"
"""What a clause beside a main clause tells, for which see `Main`."""


@dataclass(frozen=True, slots=True)
class Main:
    """A meaning of a main clause: quantity, subject, axis, presumed directions and implied moment.

    `needs` says whether the clause asks for a value at a moment, which is steady where no moment is named; for a
    quantity over a stretch of the motion, up to a moment or the whole motion; for a quantity *free* of moments; or for
    a value only beside a clause, or only beside the clause of a landing, or for one of the `CHANGES`. A meaning of a
    higher `rank` counts only where the scene has none of a lower rank.
    """

    find: str
    of: str = ""
    along: str = ""
    needs: str = MOMENT
    ways: tuple[tuple[str, str], ...] = ()
    when: When | None = None
    rank: int = 0


Reader = Callable[[re.Match[str], TokenizedSentence], Iterator[Main]]


def each(heard: TokenizedSentence, token: str | None) -> tuple[str, ...]:
    """Return the subjects of a token: a single subject, or all members of a joint phrase."""
    said = heard.subject(token)
    return tuple(said.removeprefix(f"{ALL} ").split(" & ")) if said.startswith(f"{ALL} ") else (said,)


def of_one(*finds: str, needs: str = MOMENT) -> Reader:
    """Return a reader for one or several quantities of the subject that a main clause names."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        for of in each(heard, found.groupdict().get("s")):
            yield from (Main(find, of, needs=needs) for find in finds)

    return read


def of_none(*finds: str, needs: str = MOMENT) -> Reader:
    """Return a reader for quantities of the only subject in the scene that has them, whatever subject is named."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        del found, heard
        yield from (Main(find, needs=needs) for find in finds)

    return read


def of_pair(*finds: str, needs: str = MOMENT) -> Reader:
    """Return a reader for quantities of the pair that a main clause names or, if it names none, of the only pair."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        groups = found.groupdict()
        named = [said for key in "st" if groups.get(key) for said in each(heard, groups[key])]
        if len(named) == 2 and named[0] == named[1]:
            return
        pair = " & ".join(named) if len(named) == 2 else ""
        yield from (
            Main(find, of, needs=needs, rank=rank)
            for rank, of in enumerate(dict.fromkeys((pair, "")))
            for find in finds
        )

    return read


def implied(find: str, *whens: str, needs: str = FREE) -> Reader:
    """Return a reader for a quantity that implies its moment, as the time in the air implies the landing."""

    def read(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
        who = heard.subject(found.groupdict().get("s"))
        for rank, when in enumerate(whens):
            told = When(when.format(s=who).strip())
            yield Main(find, "" if find == "time" else who, needs=needs, when=told, rank=rank)

    return read
