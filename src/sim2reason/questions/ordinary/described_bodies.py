"""Bodies that a question describes instead of using their letters, such as *the hanging block* or *the upper board*."""

import re
from collections.abc import Callable, Iterator, Mapping

from sim2reason.questions.ordinary.named_lines import group
from sim2reason.questions.ordinary.vocabulary import ANYTHING
from sim2reason.questions.words import Words
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.simulation.quantities.subjects.paths import DIRECTION_TOL, center_path

ALIKE = 1e-9  # relative: masses that differ by less are equal
PAIR = 2

Chosen = Callable[[list[str], Words], list[str]]


def with_letters(text: str, words: Words) -> str:
    """Return a text with the phrase of the scene's text in place of each description that fits one body alone.

    A description distinguishes bodies that share a noun, such as block A and block B; another one is left as it is.
    """
    for noun, phrases in _lettered(words).items():
        nouns = "|".join(sorted(group(noun) | ANYTHING | {noun, "mass", "one"}))
        for told, chosen in _DESCRIPTIONS.items():
            fitting = chosen(list(phrases), words)
            if len(fitting) == 1:
                pattern = rf"\b(?:[Tt]he )(?:{told.format(nouns=f'(?:{nouns})')})\b(?! [A-Z]\b)"
                text = re.sub(pattern, phrases[fitting[0]], text)
    return text


def _lettered(words: Words) -> Mapping[str, Mapping[str, str]]:
    """Return the phrases of bodies that have a letter, by their noun and the name of the body."""
    found: dict[str, dict[str, str]] = {}
    for name, phrase in words.called(Bodies()).items():
        said = re.fullmatch(r"(?:the )?(\w+) [A-Z]", phrase)
        if said is not None:
            found.setdefault(said[1], {})[name] = phrase
    return {noun: phrases for noun, phrases in found.items() if len(phrases) >= PAIR}


def _hanging(names: list[str], words: Words) -> list[str]:
    """Return those of `names` whose bodies move straight up and down and lie on nothing."""
    free = (name for name in names if name not in words.mechanism.contacts)
    return [name for name in free if all(abs(way[2]) > 1.0 - DIRECTION_TOL for way in _ways(name, words))]


def _ways(name: str, words: Words) -> Iterator[tuple[float, float, float]]:
    path = center_path(words.mechanism, name)
    yield from path.ways if path.straight else ((1.0, 0.0, 0.0),)


def _on_fixed_face(names: list[str], words: Words) -> list[str]:
    """Return those of `names` whose bodies lie on a face fixed in the room."""
    return [name for name in names if name in words.mechanism.contacts and words.mechanism.body[name].parent is None]


def _by_mass(*, heaviest: bool) -> Chosen:
    """Return a choice of the heavier of two bodies, or of the lighter one."""

    def chosen(names: list[str], words: Words) -> list[str]:
        if len(names) != PAIR or not {f"{name}.mass" for name in names} <= words.said:
            return []
        mass = {name: words.mechanism.body[name].mass for name in names}
        light, heavy = sorted(names, key=lambda name: mass[name])
        return [heavy if heaviest else light] if mass[heavy] > mass[light] * (1.0 + ALIKE) else []

    return chosen


def _in_pile(position: int, count: int = 0) -> Chosen:
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
        whole = len(pile) == len(names) and count in (0, len(pile))
        return [pile[position]] if whole else []

    return chosen


_DESCRIPTIONS: Mapping[str, Chosen] = {
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
