"""Translation of whole scene descriptions from textbook language into the library's sentences."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.text.parsing.ordinary.amounts import Amount, extract_amounts
from sim2reason.text.parsing.ordinary.textbook_scenes import TEXTBOOK_SCENES, Facts, TextbookScene, compiled

MOST_SENTENCES = 12  # longest text in which a superfluous sentence is searched for
MAX_TEXT_LENGTH = 1500  # characters of a text that is translated
RESERVED = re.compile(r"[#|]")  # characters that stand for numbers and for matched words below
_AIR = (
    r"(?:air resistance|air drag|drag|air friction|(?:the )?(?:resistance|drag|friction) of the (?:air|medium)"
    r"|effects? of (?:the )?air)"
)
AIRLESS = (
    rf"(?:neglect|ignore|neglecting|ignoring|disregard|disregarding) (?:all |any )?(?:the )?{_AIR}",
    rf"(?:the )?{_AIR} (?:is|are|can be|may be|may safely be) (?:negligible|neglected|ignored|absent)",
    rf"(?:the )?{_AIR} plays no (?:role|part)",
    r"(?:there is )?(?:without|no|negligible) (?:air resistance|air drag)",
)
"""Patterns of sentences that deny the resistance of the air."""
GENERAL = (
    r"(?:(?:take|use|let|assume|with|where|here) )?g (?:= |is |as |to be )?<g:accel>",
    r"(?:(?:take|use|assume) )?(?:the )?acceleration (?:due to|of) gravity (?:is |as |to be )?(?:g = )?<g:accel>",
    *AIRLESS,
)
"""Patterns that any text may contain: the acceleration of free fall, and that there is no air."""
FILLERS = frozenset(
    [
        "a",
        "an",
        "the",
        "it",
        "its",
        "they",
        "is",
        "are",
        "was",
        "be",
        "and",
        "then",
        "of",
        "on",
        "at",
        "to",
        "in",
        "with",
        "by",
        "which",
        "that",
        "from",
        "as",
        "where",
        "has",
        "have",
        "having",
        "there",
        "this",
        "so",
        ".",
        "initially",
        "when",
        "while",
    ]
)
ARTICLES = r"(?:an?|another|second|one|two|three)"
GENERIC = frozenset({"body", "object", "mass", "particle"})
PLACES = frozenset({"surface", "plane", "slope", "incline", "inclined plane"})


@dataclass(frozen=True, slots=True)
class LibraryText:
    """A scene in the library's sentences, and the names of required facts missing from the original text."""

    text: str
    missing: tuple[str, ...]


def library_texts(text: str) -> list[LibraryText]:
    """Return the translations of a text, one for each kind of scene whose patterns match all of its words."""
    if len(text) > MAX_TEXT_LENGTH or RESERVED.search(text):
        return []
    words, amounts = normalised(text)
    found = (_translated(scene, words, amounts) for scene in TEXTBOOK_SCENES.values())
    return [each for each in found if each is not None]


def superfluous(sentences: Sequence[str]) -> int | None:
    """Return the index of the one sentence without which a text can be translated; None unless it is unique."""
    if len(sentences) > MOST_SENTENCES:
        return None
    others = (" ".join((*sentences[:index], *sentences[index + 1 :])) for index in range(len(sentences)))
    found = (index for index, text in enumerate(others) if any(not each.missing for each in library_texts(text)))
    return next(found, None)


def normalised(text: str) -> tuple[str, tuple[Amount, ...]]:
    """Return a text in lower case with placeholders for numbers and separate full stops, and its numbers."""
    apart, amounts = extract_amounts(" ".join(text.split()))
    plain = re.sub(r"[,;:()]", " ", apart.lower())
    plain = re.sub(r"\.(?=\s|$)", " . ", plain.replace("=", " = "))
    return f" {' '.join(plain.split())} ", amounts


def _translated(scene: TextbookScene, words: str, amounts: tuple[Amount, ...]) -> LibraryText | None:
    """Translate a text as one kind of scene; None if it is of another kind, or a word remains unmatched."""
    begins = all(compiled(pattern).search(words) for pattern in scene.opening)
    if not begins or (scene.never and compiled(scene.never).search(words)):
        return None
    given: dict[str, str | Amount] = {}
    left = words
    for pattern in (*scene.phrases, *GENERAL):
        left = _taken(pattern, left, amounts, given) if left else ""
    if not left or not _one(scene.place, words, PLACES) or not _one(scene.bodies, left, GENERIC):
        return None
    left = compiled(scene.bodies).sub("|", left) if scene.bodies else left
    if any(word.strip("|") and word not in FILLERS for word in left.split()):
        return None
    facts = Facts(given, words)
    text = scene.write(facts)
    return LibraryText(text, tuple(dict.fromkeys(facts.missing))) if facts.missing or facts.whole else None


def _taken(pattern: str, words: str, amounts: tuple[Amount, ...], given: dict[str, str | Amount]) -> str:
    """Remove the matches of a pattern and store their facts in `given`; return an empty text on contradictions."""
    expression = compiled(pattern)
    for found in expression.finditer(words):
        for group, said in found.groupdict().items():
            name = group.removeprefix("keep").removeprefix("_")
            if said is None or not name:
                continue
            index = re.search(r"\d+", said) if said[0] == "#" else None
            value = amounts[int(index[0])] if index is not None else name
            if given.setdefault(name, value) != value:
                return ""
    return expression.sub(_kept, words)


def _kept(found: re.Match[str]) -> str:
    """Return the part of a matched phrase that stays in the text: its group `keep`, or else the mark `|`."""
    kept = (said for name, said in found.groupdict().items() if name.startswith("keep") and said is not None)
    return next(kept, "|")


def _one(nouns: str, words: str, generic: frozenset[str]) -> bool:
    """Return whether a text uses at most one specific noun for a body and introduces the body at most once."""
    if not nouns:
        return True
    used = {found[0].strip() for found in compiled(nouns).finditer(words)}
    introduced = compiled(rf"{ARTICLES} (?:[\w#|-]{{1,20}} ){{0,3}}?(?:{nouns})").findall(words)
    return len(used - generic) <= 1 and len(introduced) <= 1
