"""Texts that tell a whole scene in the words of textbooks: the library's text of the story that they tell."""

import re
from dataclasses import dataclass

from sim2reason.parsing.ordinary.amounts import Amount, set_apart
from sim2reason.parsing.ordinary.stories import STORIES, Story, Told, compiled

LONGEST = 1500  # characters of a text that may be a story
RESERVED = re.compile(r"[#|]")  # which stand for numbers and for what has been read
GENERAL = (
    r"(?:(?:take|use|let|assume|with|where|here) )?g (?:= |is |as |to be )?<g:accel>",
    r"(?:(?:take|use|assume) )?(?:the )?acceleration (?:due to|of) gravity (?:is |as |to be )?(?:g = )?<g:accel>",
    (
        r"(?:neglect|ignore|neglecting|ignoring|disregard) (?:all |any )?(?:the )?"
        r"(?:air resistance|air drag|drag|air friction|resistance of the air|effects? of (?:the )?air)"
    ),
    r"(?:the )?air resistance (?:is|can be|may be) (?:negligible|neglected|ignored)",
    r"(?:without|no|negligible) (?:air resistance|air drag)",
)
"""What any story may say: how strong gravity is, and that there is no air."""
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
class Retold:
    """The library's text of a story, and what it needs that the original text does not give."""

    text: str
    missing: tuple[str, ...]


def retold(text: str) -> list[Retold]:
    """Return the library's text of each story that a text tells, with nothing left over."""
    if len(text) > LONGEST or RESERVED.search(text):
        return []
    words, amounts = normalised(text)
    found = (_told(story, words, amounts) for story in STORIES.values())
    return [each for each in found if each is not None]


def normalised(text: str) -> tuple[str, tuple[Amount, ...]]:
    """Return a text in lower case with numbers set apart and each full stop a word of its own, and its numbers."""
    apart, amounts = set_apart(" ".join(text.split()))
    plain = re.sub(r"[,;:()]", " ", apart.lower())
    plain = re.sub(r"\.(?=\s|$)", " . ", plain.replace("=", " = "))
    return f" {' '.join(plain.split())} ", amounts


def _told(story: Story, words: str, amounts: tuple[Amount, ...]) -> Retold | None:
    """Return a story as the library tells it; None if the text tells another, or anything more."""
    begins = all(compiled(pattern).search(words) for pattern in story.opening)
    if not begins or (story.never and compiled(story.never).search(words)):
        return None
    given: dict[str, str | Amount] = {}
    left = words
    for pattern in (*story.phrases, *GENERAL):
        left = _taken(pattern, left, amounts, given) if left else ""
    if not left or not _one(story.place, words, PLACES) or not _one(story.bodies, left, GENERIC):
        return None
    left = compiled(story.bodies).sub("|", left) if story.bodies else left
    if any(word.strip("|") and word not in FILLERS for word in left.split()):
        return None
    told = Told(given, words)
    text = story.tell(told)
    return Retold(text, tuple(dict.fromkeys(told.missing))) if told.missing or told.whole else None


def _taken(pattern: str, words: str, amounts: tuple[Amount, ...], given: dict[str, str | Amount]) -> str:
    """Return what a pattern leaves of a text, noting the facts that it finds; empty if they contradict others."""
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
    """Return what stays of what a pattern has taken."""
    kept = (said for name, said in found.groupdict().items() if name.startswith("keep") and said is not None)
    return next(kept, "|")


def _one(nouns: str, words: str, generic: frozenset[str]) -> bool:
    """Return whether a text speaks of one thing: it uses one noun beside generic ones, and introduces it once."""
    if not nouns:
        return True
    used = {found[0].strip() for found in compiled(nouns).finditer(words)}
    introduced = compiled(rf"{ARTICLES} (?:[\w#|-]{{1,20}} ){{0,3}}?(?:{nouns})").findall(words)
    return len(used - generic) <= 1 and len(introduced) <= 1
