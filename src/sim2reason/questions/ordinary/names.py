"""Names of strings, springs, rods and particles in a question, and descriptions of bodies."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from math import isclose
from typing import NamedTuple

from sim2reason.questions.ordinary.vocabulary import GENERIC_NOUNS, NOUNS
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import ConstantTension
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.scenes.dsl.vectors import inner
from sim2reason.simulation.quantities.subjects.bodies import DIRECTION_TOL, Bodies, center_path
from sim2reason.simulation.quantities.subjects.interactions import Springs, Strings, pulleys
from sim2reason.simulation.quantities.subjects.rotating_parts import SwingingLines, load_center, welded_bodies

Ranked = tuple[int, str, str]
"""How specific a pattern is, the phrase of the text, and the pattern of its names."""
_THAT = "(?:(?:that|which) )?(?:(?:is|are|it|runs|goes) )?"
_JOINING = (
    rf"(?:{_THAT}(?:between|joining|joins|connecting|connects|linking|links|from|tying|ties|runs|running"
    rf"|stretched between))"
)
_TIED = (
    "(?:attached|tied|fastened|fixed|connected|joined|made fast|leading|running|hooked|leads|runs|goes|led)"
    " (?:on )?to|ending at|ends at"
)
_CARRYING = (
    "(?:holding|holds|supporting|supports|carrying|carries|bearing|bears|suspending|suspends|lifting|lifts)(?: up)?"
    "|(?:pulling|pulls|dragging|drags|acting|acts|tugging|tugs)(?: on| up| along| at)?"
)
_FROM = (
    "(?:from|by|on) which (?:{end}) (?:hangs|is hanging|is tied|is hung|is suspended|is held)"
    "(?: from (?:the )?(?:axle of )?(?:the )?(?:(?:movable|fixed) )?pulley(?: [A-Z])?)?"
)
_OVER = (
    rf"{_THAT}(?:(?:passing|passes|going|goes|running|runs|led|laid|slung|hung|wound|wrapped) )?(?:over|round"
    rf"|around|across)"
)
_PARTS = "(?:part|section|piece|segment|portion|side)"
_PART = rf"(?:{_PARTS} of (?:the )?)?"
_DIRECTION_COMPONENTS = {"vertical|hanging|upright": 1.0, "horizontal|level": 0.0}
_COUNTED = "first", "second", "third", "fourth"
VERTICAL_TOL = 1e-6


class NamedLine(NamedTuple):
    """A line with its name, phrase, noun, the phrases of its ends, whether each end is an axle, and its pulleys."""

    name: str
    phrase: str
    noun: str
    ends: tuple[str, str]
    axles: tuple[bool, bool]
    over: tuple[str, ...]


def noun_alternatives(noun: str, *others: str) -> str:
    """Return the alternatives of a pattern for a noun: its synonyms and other given nouns."""
    return "|".join(sorted({noun, *others} | group(noun)))


def group(noun: str) -> frozenset[str]:
    """Return all synonyms of a noun."""
    return next((nouns for nouns in NOUNS if noun in nouns), frozenset[str]())


def between(phrase: str, lone: frozenset[str] = frozenset()) -> Iterable[Ranked]:
    """Yield ranked patterns that name a string, spring or rod by the two objects at its ends, in either order.

    A thing whose noun is one of the `lone` ones may be called by the noun without its letter.
    """
    parts = re.fullmatch(r"the (?:part of the )?(\w+) between (.+) and (.+)", phrase)
    if parts is None:
        return
    nouns = noun_alternatives(parts[1])
    ends = [_end_pattern(parts[2], lone), _end_pattern(parts[3], lone)]
    kinds = {noun for noun, _, _ in (end.removeprefix("the ").partition(" ") for end in parts.groups()[1:])}
    if len(kinds) == 1:
        both = rf"(?:the )?(?:two )?(?:{noun_alternatives(*kinds, *GENERIC_NOUNS)})e?s"
        yield 2000, phrase, rf"\b(?:[Tt]he )?{_PART}(?:{nouns}) {_JOINING} {both}\b(?! [A-Z]\b)"
    for one, other in (ends, reversed(ends)):
        pattern = rf"\b(?:[Tt]he )?{_PART}(?:{nouns}) {_JOINING} {one} (?:and|to|with) {other}(?! [A-Z]\b)"
        yield 2000, phrase, pattern


def named_lines(words: Words) -> Iterable[Ranked]:
    """Yield ranked patterns of all unique names of strings and springs."""
    for kind, noun in ((Strings(), "string"), (Springs(), "spring")):
        lines = [_named(name, noun, words) for name in kind.names(words.mechanism)]
        known = words.subject_phrases(kind)
        for unsaid in lines:
            line = unsaid._replace(phrase=known.get(unsaid.name, unsaid.name))
            yield from _by_ends(line, lines)
            yield from _by_pulleys(line, lines)
            yield from _by_places(line, lines, words)


def swinging_lines(words: Words) -> Iterable[Ranked]:
    """Yield ranked patterns that name an arm by a line from its axle to a body on the side of the centre of mass."""
    mechanism = words.mechanism
    for name, phrase in words.subject_phrases(SwingingLines()).items():
        body = mechanism.body.get(name)
        if body is None:
            continue
        heavy = load_center(mechanism, body)
        for part in welded_bodies(mechanism, name):
            if part.name in words.mentions and inner(heavy, part.at) > 0.0:
                to = rf"(?:(?:the )?centre (?:of mass )?of )?{_end_pattern(words.mentions[part.name])}"
                pattern = rf"\b(?:[Tt]he )?(?:line|arm) (?:from|between) (?:the )?axle (?:to|and) {to}(?! [A-Z]\b)"
                yield 2500, phrase, pattern


def _named(name: str, noun: str, words: Words) -> NamedLine:
    mechanism = words.mechanism
    line = mechanism.line[name]
    carriers = {body: words.mentions[address] for body, address in pulleys(mechanism, words.mentions).items()}

    def phrase(site: str) -> str:
        body = mechanism.site[site].body or ""
        owner = words.mentions.get(site.rpartition(".")[0], "")
        return owner if "pulley" in owner else words.mentions.get(body, carriers.get(body, ""))

    ends = line.through[0], line.through[-1]
    pulled = isinstance(line.law, ConstantTension)
    phrases = tuple(phrase(site) or ("the hand" if pulled else "") for site in ends)
    rims = ".left", ".right", ".in", ".out"
    axles = tuple("pulley" in end and not site.endswith(rims) for end, site in zip(phrases, ends, strict=True))
    over = dict.fromkeys(filter(None, (phrase(site) for site in line.through[1:-1])))
    over |= {end: None for end, axle in zip(phrases, axles, strict=True) if "pulley" in end and not axle}
    return NamedLine(name, "", noun, (phrases[0], phrases[1]), (axles[0], axles[1]), tuple(over))


def _by_ends(line: NamedLine, lines: list[NamedLine]) -> Iterable[Ranked]:
    """Yield ranked patterns that name a line by its two ends, or by a single end at which no other line ends."""
    string = rf"\b(?:[Tt]he )?{_PART}(?:{noun_alternatives(line.noun)})"
    one, other = line.ends
    if one and other and [{*each.ends} for each in lines].count({one, other}) == 1:
        first, second = _end_pattern(one), _end_pattern(other)
        pair = rf"(?:{first} (?:and|to|with) {second}|{second} (?:and|to|with) {first})"
        yield 1900, line.phrase, rf"{string} {_JOINING} {pair}(?! [A-Z]\b)"
    everywhere = [end for each in lines for end in each.ends]
    for end, axle in zip(line.ends, line.axles, strict=True):
        if not end or everywhere.count(end) != 1 or ("pulley" in end and not axle):
            continue
        end_pattern = _end_pattern(end)
        if end == "the hand":
            holds = r"(?:(?:that|which) )?(?:(?:the )?hand (?:pulls|holds)(?: on)?|held by (?:the )?hand)"
            yield 1450, line.phrase, rf"{string} {holds}"
            continue
        yield 1450, line.phrase, rf"{string} {_THAT}(?:{_CARRYING}) {end_pattern}(?! [A-Z]\b)"
        yield 1450, line.phrase, rf"{string} {_FROM.format(end=end_pattern)}"
        hung = "(?:hangs|is hanging|is hung) (?:from|on|by)"
        yield 1450, line.phrase, rf"{string} (?:(?:that|which) )?{end_pattern} {hung}\b"
        tied = end_pattern if not axle else rf"(?:the )?axle of {end_pattern}"
        if not axle:
            yield 1350, line.phrase, rf"{string} (?:on|at|above|beside|next to) {end_pattern}(?! [A-Z]\b)"
        yield 1450, line.phrase, rf"{string} {_THAT}(?:{_TIED}) {tied}(?! [A-Z]\b)"
    alone = [each.name for each in lines if "" in each.ends] == [line.name] and len(lines) > 1
    if line.noun == "string" and alone:
        hook = "(?:the )?(?:fixed )?(?:hook|support|ceiling|beam|wall|point)"
        yield 1400, line.phrase, rf"{string} {_THAT}(?:{_TIED}) {hook}"
    if line.noun == "spring" and alone:
        wall = "(?:the )?(?:fixed )?(?:wall|stop|support)"
        yield 1400, line.phrase, rf"{string} (?:{_THAT}(?:{_TIED}|next to|at|touching) {wall}|at {wall})"


def _by_pulleys(line: NamedLine, lines: list[NamedLine]) -> Iterable[Ranked]:
    """Yield ranked patterns that name a line by a pulley over which no other line passes."""
    for pulley in line.over:
        if sum(pulley in each.over for each in lines) == 1:
            pattern = rf"\b(?:[Tt]he )?(?:{noun_alternatives(line.noun)}) {_OVER} {_end_pattern(pulley)}(?! [A-Z]\b)"
            yield 1450, line.phrase, pattern


def _by_places(line: NamedLine, lines: list[NamedLine], words: Words) -> Iterable[Ranked]:
    """Yield ranked patterns that name a string's part by its direction or the body beside it, or a line by number."""
    counted = re.fullmatch(rf"the {line.noun} (\d)|{line.noun} (\d)", line.phrase)
    if counted is not None and 0 < int(counted[1] or counted[2]) <= len(_COUNTED):
        yield 1400, line.phrase, rf"\b(?:[Tt]he )?{_COUNTED[int(counted[1] or counted[2]) - 1]} {line.noun}\b"
    strings = rf"(?:{noun_alternatives(line.noun)})"
    if len(lines) == 1 and line.noun == "string" and "between" not in line.phrase:
        adjectives = "|".join((*_DIRECTION_COMPONENTS, "sloping", "inclined"))
        yield 1400, line.phrase, rf"\b(?:[Tt]he )?(?:{adjectives}) {_PARTS} of (?:the )?{strings}\b"
    if not line.phrase.startswith("the part of"):
        return
    tilts = {each.name: tilt for each in lines if (tilt := _tilt(each, words)) is not None}
    for adjective, component in _DIRECTION_COMPONENTS.items():
        alone = [name for name, tilt in tilts.items() if abs(tilt - component) < VERTICAL_TOL]
        if alone == [line.name]:
            yield 1400, line.phrase, rf"\b(?:[Tt]he )?(?:{adjective}) {_PARTS} of (?:the )?{strings}\b"
    for end in line.ends:
        if end and "pulley" not in end and [e for each in lines for e in each.ends].count(end) == 1:
            beside = r"(?:on (?:the side of )?|beside |next to |above |near |at |towards )"
            place = f"{beside}{_end_pattern(end)}(?:'s side)?"
            yield 1400, line.phrase, rf"\b(?:[Tt]he )?{_PARTS} of (?:the )?{strings} {place}(?! [A-Z]\b)"


def _tilt(line: NamedLine, words: Words) -> float | None:
    """Return the vertical component of the direction in which the body at a part's end moves; None if unknown."""
    by_phrase: Mapping[str, str] = {
        phrase: name for name, phrase in words.mentions.items() if name in words.mechanism.body
    }
    bodies = [by_phrase[end] for end in line.ends if end in by_phrase and "pulley" not in end]
    path = center_path(words.mechanism, bodies[0]) if len(bodies) == 1 else None
    return abs(path.ways[0][2]) if path is not None and path.straight else None


def _end_pattern(phrase: str, lone: frozenset[str] = frozenset()) -> str:
    """Return a pattern for an end of a line: a letter with or without a noun, a pulley with or without its axle.

    A `lone` noun may stand without its letter.
    """
    bare = phrase.removeprefix("the ").removeprefix("axle of ")
    noun, _, letter = bare.partition(" ")
    if len(letter) == 1:
        alone = f"|{noun}(?! {letter})" if noun in lone else ""
        nouns = noun_alternatives(noun, *GENERIC_NOUNS)
        return rf"(?:the )?(?:axle of )?(?:the )?(?:(?:(?:{nouns})(?:e?s)? )?{letter}{alone})"
    return rf"(?:the )?(?:axle of )?(?:the )?(?:(?:movable|fixed) )?{re.escape(bare)}"


PARTICLE_MASS_RTOL = 0.01  # relative: largest difference from a particle's mass, as texts round masses
MASSES: Mapping[str, float] = {"electron": 9.1094e-31, "proton": 1.6726e-27}
"""The masses of particles, kg."""


def with_particles(text: str, words: Words) -> str:
    """Return a text in which the name of a particle, if unique, is replaced by the scene's phrase for the body."""
    factor = parse_unit(words.units.spell("kg")).factor_to(parse_unit("kg")) or 1.0
    for particle, mass in MASSES.items():
        fits = [
            phrase
            for name, phrase in words.subject_phrases(Bodies()).items()
            if isclose(words.mechanism.body[name].mass * factor, mass, rel_tol=PARTICLE_MASS_RTOL)
        ]
        if len(fits) == 1:
            text = re.sub(rf"\b(?:[Tt]he )?{particle}\b", fits[0], text)
    return text


EQUAL_MASS_RTOL = 1e-9  # relative: masses that differ by less are equal
PAIR_SIZE = 2
BodyChoice = Callable[[list[str], Words], list[str]]


def with_letters(text: str, words: Words) -> str:
    """Return a text with the phrase of the scene's text in place of each description that fits one body alone.

    A description distinguishes bodies that share a noun, such as block A and block B; another one is left as it is.
    """
    for noun, phrases in _lettered(words).items():
        nouns = "|".join(sorted(group(noun) | GENERIC_NOUNS | {noun, "mass", "one"}))
        for template, chosen in _DESCRIPTIONS.items():
            fitting = chosen(list(phrases), words)
            if len(fitting) == 1:
                pattern = rf"\b(?:[Tt]he )(?:{template.format(nouns=f'(?:{nouns})')})\b(?! [A-Z]\b)"
                text = re.sub(pattern, phrases[fitting[0]], text)
    return text


def _lettered(words: Words) -> Mapping[str, Mapping[str, str]]:
    """Return the phrases of bodies that have a letter, by their noun and the name of the body."""
    lettered: dict[str, dict[str, str]] = {}
    for name, phrase in words.subject_phrases(Bodies()).items():
        match = re.fullmatch(r"(?:the )?(\w+) [A-Z]", phrase)
        if match is not None:
            lettered.setdefault(match[1], {})[name] = phrase
    return {noun: phrases for noun, phrases in lettered.items() if len(phrases) >= PAIR_SIZE}


def _hanging(names: list[str], words: Words) -> list[str]:
    """Return those of `names` whose bodies move straight up and down and lie on nothing."""
    free = (name for name in names if name not in words.mechanism.contacts)
    return [name for name in free if all(abs(direction[2]) > 1.0 - DIRECTION_TOL for direction in _ways(name, words))]


def _ways(name: str, words: Words) -> Iterator[tuple[float, float, float]]:
    path = center_path(words.mechanism, name)
    yield from path.ways if path.straight else ((1.0, 0.0, 0.0),)


def _on_fixed_face(names: list[str], words: Words) -> list[str]:
    """Return those of `names` whose bodies lie on a face fixed in the room."""
    return [name for name in names if name in words.mechanism.contacts and words.mechanism.body[name].parent is None]


def _by_mass(*, heaviest: bool) -> BodyChoice:
    """Return a choice of the heavier of two bodies, or of the lighter one."""

    def chosen(names: list[str], words: Words) -> list[str]:
        if len(names) != PAIR_SIZE or not {f"{name}.mass" for name in names} <= words.stated_paths:
            return []
        mass = {name: words.mechanism.body[name].mass for name in names}
        light, heavy = sorted(names, key=lambda name: mass[name])
        return [heavy if heaviest else light] if mass[heavy] > mass[light] * (1.0 + EQUAL_MASS_RTOL) else []

    return chosen


def _in_pile(position: int, count: int = 0) -> BodyChoice:
    """Return a choice by the position in a pile of bodies each of which carries the next one, from 0 at its foot.

    With a `count`, the pile must have so many.
    """

    def chosen(names: list[str], words: Words) -> list[str]:
        parents = {name: words.mechanism.body[name].parent for name in names}
        above = [name for name in names if parents[name] is None]
        pile: list[str] = []
        while len(above) == 1:
            pile += above
            above = [name for name in names if parents[name] == pile[-1]]
        complete = len(pile) == len(names) and count in (0, len(pile))
        return [pile[position]] if complete else []

    return chosen


_DESCRIPTIONS: Mapping[str, BodyChoice] = {
    "(?:hanging|suspended) {nouns}": _hanging,
    "{nouns} (?:that hangs|hanging) from the (?:string|rope|cord)": _hanging,
    "{nouns} on the (?:table|plane|slope|incline|ramp|floor|track)": _on_fixed_face,
    "heavier(?: of the two)? {nouns}(?:e?s)?": _by_mass(heaviest=True),
    "lighter(?: of the two)? {nouns}(?:e?s)?": _by_mass(heaviest=False),
    "(?:upper|top|uppermost) {nouns}": _in_pile(-1),
    "(?:lower|bottom|lowest) {nouns}": _in_pile(0),
    "middle {nouns}": _in_pile(1, 3),
}
"""By the words of a description, with its noun: the choice of the bodies that the description fits."""
