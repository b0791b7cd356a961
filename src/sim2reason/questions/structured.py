"""Questions given in parts instead of a sentence: the quantity to find, its subject and the moment."""

import re
import shlex
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, Self, cast

import numpy as np

from sim2reason.base.registry import similar_names
from sim2reason.errors import TextError
from sim2reason.questions.moments import MOMENTS, Clause, Happening, Moment
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import DIGITS_PATTERN, ORDINALS, Words
from sim2reason.scenes.dsl.units import UnitError, parse_unit
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.trace import Channel, Trace


@dataclass(frozen=True, slots=True)
class JustBefore(Happening):
    """The instant just before another moment whose words name no side; only for structured questions, never drawn."""

    label = "before"

    inner: Moment

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return no moments, since none are ever drawn."""
        del study, words, rng
        return ()

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Return no moments: a sentence about such an instant is read as a structured question."""
        del text, trace, words
        return iter(())

    @property
    def subjects(self) -> tuple[str, ...]:
        """Return the subjects of the inner moment."""
        return self.inner.subjects

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Return the channels of the inner moment."""
        return self.inner.channels

    @property
    def sided(self) -> bool | None:
        """Return False, for just before the event."""
        return False

    def time(self, trace: Trace) -> float | None:
        """Return the time of the inner moment, s; None if the moment does not occur."""
        return self.inner.time(trace)

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return phrases such as *just before the block comes to rest*."""
        clauses = (phrase for phrase in self.inner.phrases(words) if phrase.startswith("when "))
        return tuple(f"just before {phrase.removeprefix('when ')}" for phrase in clauses)

    def clause(self, words: Words) -> Clause | None:
        """Return None: a question about the time asks about the inner moment instead."""
        del words
        return None

    def subject(self, words: Words) -> str:
        """Return the phrase for the inner moment's subject."""
        return self.inner.subject(words)


START = "at start"
EQUILIBRIUM = "equilibrium"  # the name of the equilibrium in place of a moment
REMOVAL = re.compile(r"(?P<what>\S.*?) (?:removed|cut|switched off)(?: (?:(?:at|when|after) )?(?P<when>.+))?$")
"""A change that removes something at some moment of the motion: a string that is cut, a field that is switched off."""
CHANGE = re.compile(r"(?P<number>.+?)(?:\s*(?P<sign>[=×*])\s*|\s+[xX]\s*(?=[\d.]))(?P<value>.+)")
"""A change of a number: another value, or a factor after ×, * or the letter x."""
MAX_PART_LENGTH = 200  # characters of a part
_NUMBER = re.compile(
    rf"([+-]?(?:{DIGITS_PATTERN}\.?(?:{DIGITS_PATTERN})?|\.{DIGITS_PATTERN})(?:[eE][+-]?\d{{1,3}})?)\s*(.*)"
)
_COUNTS = {word: number for number, word in enumerate(ORDINALS, start=1)}
_BEFORE = re.compile(r"\b(?:just )?before\b")
_AFTER = re.compile(r"\b(?:just )?after\b")


@dataclass(frozen=True, slots=True)
class StructuredQuestion:
    """A question in parts: the quantity to find, its subject and the moment, named as in the registries or the scene.

    `find` is a quantity, a functional such as *greatest speed*, *time*, *period*, or the address of a number of the
    scene. `along` names a component. With `given`, such as *velocity = 2 m/s*, the question asks for the value of a
    number of the scene that leads to this result; with *velocity = greatest*, for the value at which the velocity is
    greatest. Where several values of the number do, *velocity = 2 m/s, least* asks for the least of them. With
    `change`, such as *ramp.speed = 5 m/s*, or *ramp.speed × 2, box fixed*, it asks how the answer changes: `compare` is
    the *ratio* of the new value to the original one, which is the default, their *difference*, or the new *value*
    itself. With *tendon_1 removed at 1.5 s*, it asks about the motion that follows when a string, a hand or a field
    ceases to act. A number of the scene that is asked for is compared with the number that the scene has, if `compare`
    says so. With *ramp.angle = greatest* it asks for the answer's greatest value; with *left.block.mass = infinity*, or
    *0*, for the limit that the answer approaches. `of` may name several subjects of an energy or a mass, as *block A +
    block B*, for the sum; `when` may name two moments, as *second bounced minus bounced*, for the value at the first
    less that at the second. With *block A or block B*, of two subjects or moments, it asks which of them it is.
    """

    find: str
    of: str = ""
    when: str = ""
    along: str = ""
    given: str = ""
    change: str = ""
    compare: str = ""

    @classmethod
    def read(cls, parts: Mapping[str, object]) -> Self:
        """Return the question with the given named parts, from a file or a program; TextError for invalid parts."""
        known = [field.name for field in fields(cls)]
        for name, value in parts.items():
            if name not in known:
                raise TextError(f"question.{name}", "there is no such key", _suggestion(name, known))
            if not isinstance(value, str | int | float) or isinstance(value, bool) or len(str(value)) > MAX_PART_LENGTH:
                raise TextError(f"question.{name}", "it is no short text", "give words, such as: moved 0.5 m")
        if not parts.get("find"):
            raise TextError("question", "it does not say what to find", "give find, such as: velocity")
        return cls(**{name: " ".join(str(value).split()) for name, value in parts.items()})

    @property
    def text(self) -> str:
        """Return the parts of the question as one text."""
        return f"({', '.join(f'{name}: {part}' for name, part in self._parts().items())})"

    @property
    def options(self) -> str:
        """Return the parts of the question as options of a command, such as ``--find time --when 'A stopped'``."""
        return " ".join(f"--{name} {shlex.quote(part)}" for name, part in self._parts().items())

    def _parts(self) -> dict[str, str]:
        parts = {"find": self.find, "of": self.of, "when": self.when, "along": self.along, "given": self.given}
        compare = self.compare or ("ratio" if self.change and REMOVAL.search(self.change) is None else "")
        parts |= {"change": self.change, "compare": compare}
        return {name: part for name, part in parts.items() if part}


def resolve_name(field_name: str, text: str, candidates: Mapping[str, str]) -> str:
    """Return the name of the candidate, among names with their phrases, that a text denotes; TextError if not unique.

    `text` may be the name, the phrase with or without an article, or a part that only one candidate has. If `text` is
    empty, the only candidate is meant. TextError, at `field_name`, if no candidate matches, or several do.
    """
    if not text and len(candidates) == 1:
        return next(iter(candidates))
    ranks = {name: rank for name, phrase in candidates.items() if (rank := _rank(text, name, phrase)) is not None}
    matches = [name for name, rank in ranks.items() if rank == min(ranks.values())] if text else []
    if len(matches) == 1:
        return matches[0]
    if not candidates:
        raise TextError(field_name, "this scene has nothing of that kind", "ask about something else")
    problem = f"there is no {text!r} here" if text else "it does not say what it is about"
    raise TextError(field_name, problem, _suggestion(text, [*candidates, *candidates.values()], candidates))


def _rank(text: str, name: str, phrase: str) -> int | None:
    """Return the rank of the match between `text` and a candidate, 0 being the best; None if there is no match."""
    bare_text, bare = _bare(text), _bare(phrase)
    tests = (
        text == name,
        bare_text == bare,
        bare_text == bare.rpartition(" ")[2],
        f".{name}".endswith(f".{text}"),
        bare_text in (bare.partition(" ")[0], *re.split(r"[._]", name)),
    )
    return next((rank for rank, holds in enumerate(tests) if holds), None)


def _bare(text: str) -> str:
    return text.lower().removeprefix("the ").strip()


def _suggestion(text: str, names: Iterable[str], shown: Iterable[str] | None = None) -> str:
    near = similar_names(text, list(dict.fromkeys(names)))
    return f"did you mean: {', '.join(near)}" if near else f"there are: {', '.join(shown or names)}"


def one_of(field_name: str, text: str, names: Iterable[str]) -> str:
    """Return `text` if it is one of `names`; TextError, at `field_name`, with the nearest names, otherwise."""
    known = list(dict.fromkeys(names))
    if text not in known:
        raise TextError(field_name, f"there is no {text!r}", _suggestion(text, known))
    return text


def parse_amount(field_name: str, text: str, unit: str) -> float:
    """Return the value, in `unit`, of a number with a unit, by default `unit`; TextError if there is no number."""
    match = _NUMBER.fullmatch(text.strip())
    if match is None:
        raise TextError(field_name, f"{text!r} is no number", f"give one, such as: 2.5 {unit}".rstrip())
    try:
        factor = parse_unit(match[2] or unit).factor_to(parse_unit(unit))
    except UnitError as error:
        raise TextError(field_name, str(error), f"give it in {unit}") from None
    if factor is None:
        raise TextError(field_name, f"{text!r} is not measured in {unit}", f"give it in {unit}")
    return float(f"{float(match[1]) * factor:.15g}")


def sense_named(field_name: str, text: str, senses: Iterable[Sense]) -> Sense:
    """Return the direction with a given name: the name of its axis, or of its positive sense."""
    by_name = {name: sense for sense in senses for name in (sense.positive, sense.axis) if name}
    return by_name[resolve_name(field_name, text, {name: name for name in by_name})]


def moment_named(question: StructuredQuestion, words: Words) -> Moment:
    """Return the moment that a structured question names, with the numbers and the side given beside the name.

    As in *moved 0.5 m*, *block A stopped*, *second collided before*, *t = 2 s*. The moment's subject stands before the
    name; by default it is the subject of the question. TextError if there is no such moment.
    """
    text = question.when or START
    name, before, after = _split(text)
    cls = MOMENTS[name]
    rest = " ".join(part for part in (before, after) if part)
    field_types = {field.name: field.type for field in fields(cast("Any", cls))}
    values: dict[str, object] = {}
    sided, side = field_types.get("after") is bool, _BEFORE.search(rest) is None
    if sided or (not side and issubclass(cls, Happening)):
        values |= {"after": side} if sided else {}
        before, after = (_AFTER.sub("", _BEFORE.sub("", part)).strip() for part in (before, after))
    for field, unit in _measures(cls, words).items():
        if after or field_types[field] is float:
            values[field] = cast("type[float]", field_types[field])(parse_amount("when", after, unit))
    if "number" in field_types:
        before, values["number"] = _counted(before)
    if "name" in field_types:
        candidates = cast("Any", cls).candidates(words)
        values["name"] = resolve_name("when", before or _same(question.of, candidates), candidates)
    moment = cls(**values)
    return moment if sided or side or not isinstance(moment, Happening) else JustBefore(moment)


def moment_told(moment: Moment, words: Words) -> str:
    """Return a moment in the form that `moment_named` reads: ordinal, subject's address, name, numbers and side."""
    if isinstance(moment, JustBefore):
        return f"{moment_told(moment.inner, words)} before"
    name = next(name for name, cls in MOMENTS.items() if cls is type(moment)).replace("_", " ")
    field_values: dict[str, Any] = {field.name: getattr(moment, field.name) for field in fields(cast("Any", moment))}
    values = [f"{field_values[field]:.15g} {unit}" for field, unit in _measures(type(moment), words).items()]
    number = int(field_values.get("number", 1))
    count = ORDINALS[number - 1] if number > 1 else ""
    side = "before" if field_values.get("after") is False else ""
    return " ".join(filter(None, (count, str(field_values.get("name", "")), name, *values, side)))


def _measures(cls: type[Moment], words: Words) -> dict[str, str]:
    """Return the scene's unit for each field of a class of moments that holds a number with a unit."""
    units = {float: words.units.spell(getattr(cls, "unit", "s"))}
    field_units = {field.name: units.get(cast("Any", field.type)) for field in fields(cast("Any", cls))}
    field_units |= {"degrees": "deg"} if "degrees" in field_units else {}
    return {name: unit for name, unit in field_units.items() if unit is not None}


def _same(of: str, candidates: Mapping[str, str]) -> str:
    """Return the candidate that denotes the question's subject; empty if there is none."""
    try:
        return resolve_name("when", of, candidates) if of else ""
    except TextError:
        return ""


def _split(text: str) -> tuple[str, str, str]:
    """Return a moment's name, and the text before and after the name; TextError if the text names no moment."""
    plain = text.replace("_", " ")
    for name in sorted(MOMENTS, key=len, reverse=True):
        spelled = name.replace("_", " ")
        match = re.search(rf"(?:^|(?<=\s)){re.escape(spelled)}(?=\s|$)", plain)
        if match is not None:
            return name, text[: match.start()].strip(), text[match.end() :].strip()
    time = re.fullmatch(r"(?:at\s+)?(?:t\s*=\s*)?([\d.].*)", plain)
    if time is not None:
        return "at_time", "", time[1]
    if plain in ("start", "release", "at release"):
        return "at_start", "", ""
    words = plain.split(" ")
    spans = [" ".join(words[a:b]) for a in range(len(words)) for b in range(a + 1, min(a + 4, len(words)) + 1)]
    names = [name.replace("_", " ") for name in MOMENTS]
    near = [match for span in spans for match in similar_names(span, names, 1)]
    remedy = f"did you mean: {', '.join(dict.fromkeys(near))}" if near else "see: sim2reason list moments"
    raise TextError("when", f"{text!r} names no moment", remedy)


def _counted(before: str) -> tuple[str, int]:
    """Return the text before a moment's name without its ordinal, and the ordinal's number, by default 1."""
    for word, number in _COUNTS.items():
        match = re.search(rf"\b{word}\b", before)
        if match is not None:
            return " ".join((before[: match.start()] + before[match.end() :]).split()), number
    return before, 1
