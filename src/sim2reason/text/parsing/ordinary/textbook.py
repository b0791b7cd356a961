"""Scenes in textbook language: patterns of their words, and translation into the library's sentences."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from sim2reason.base.registry import Registry
from sim2reason.scenes.dsl.mechanism import GRAVITY
from sim2reason.text.parsing.ordinary.lexicon import Amount, extract_amounts, format_amount


@dataclass
class Facts:
    """The facts that patterns found in a text, by name, with records of the facts requested and missing."""

    given: Mapping[str, str | Amount]
    words: str = ""
    missing: list[str] = field(default_factory=list[str])
    asked: set[str] = field(default_factory=set[str])

    def has(self, name: str) -> bool:
        """Return whether the text states a fact."""
        self.asked.add(name)
        return name in self.given

    def nouns(self, pattern: str) -> list[str]:
        """Return the distinct nouns of the text that match a pattern, in the singular."""
        return list(dict.fromkeys(compiled(rf"(?P<noun>{pattern})s?").findall(self.words)))

    def amount(self, name: str, called: str) -> Amount | None:
        """Return a required number; if it is missing, record it under the name `called` and return None."""
        self.asked.add(name)
        fact = self.given.get(name)
        if isinstance(fact, Amount):
            return fact
        if called:  # else it was recorded before
            self.missing.append(called)
        return None

    def number(self, name: str, called: str) -> str:
        """Return a required number with its unit; a question mark if it is missing."""
        amount = self.amount(name, called)
        return amount.text if amount is not None else "?"

    def value(self, name: str, called: str, unit: str = "") -> float:
        """Return the value of a required number, in SI units or in `unit`; 1 if it is missing."""
        amount = self.amount(name, called)
        return amount.value_in(unit) if amount is not None else 1.0

    def or_symbol(self, name: str, symbol: str) -> str:
        """Return an optional number with its unit, or `symbol` in dollars if the text does not give it."""
        self.asked.add(name)
        fact = self.given.get(name)
        return fact.text if isinstance(fact, Amount) else f"${symbol}$"

    def one_of(self, called: str, *names: str) -> str:
        """Return which of several exclusive facts the text states; record `called` as missing unless exactly one is."""
        stated = [name for name in names if self.has(name)]
        if len(stated) != 1:
            self.missing.append(called if not stated else f"{called} unambiguously")
        return stated[0] if stated else ""

    @property
    def g(self) -> float:
        """Return the acceleration of free fall that the text gives, m/s²; the default where it gives none."""
        return self.value("g", "") if self.has("g") else GRAVITY

    @property
    def gravity(self) -> str:
        """Return the library's sentence that states the acceleration of free fall."""
        return f"Take g = {format_amount(self.g)} m/s²."

    @property
    def whole(self) -> bool:
        """Return whether every fact of the text was requested."""
        return self.asked.issuperset(self.given)


@dataclass(frozen=True)
class TextbookScene:
    """A kind of scene that is recognised by patterns in a text and written in the library's own sentences.

    Data:
        summary: what happens, in a few words.
        opening: patterns that all occur in a text about such a scene.
        phrases: patterns of all that may be said, tried in order; `<name:kind>` is a number of a kind, and a named
            group a fact that is said or not; what a group called `keep` or `keep_fact` holds stays for later patterns.
            Each place of a text is taken by the first pattern that fits.
        bodies: a pattern of the nouns for the body; a text may use one of them only. Empty where phrases name them.
        place: a pattern of the nouns for the surface that it moves on, of which a text may name one only, too.
        never: a pattern that excludes the scene, such as a slope that moves.
        write: returns the library's text for the facts of a text.
    """

    summary: str
    opening: tuple[str, ...]
    phrases: tuple[str, ...]
    write: Callable[[Facts], str]
    bodies: str = ""
    place: str = ""
    never: str = ""

    def __post_init__(self) -> None:
        """Compile all patterns, so that an invalid pattern fails where it is declared."""
        for pattern in (*self.opening, *self.phrases, self.bodies, self.place, self.never):
            compiled(pattern)


def compiled(pattern: str) -> re.Pattern[str]:
    """Compile a pattern into a regular expression that matches whole words."""
    expression = re.sub(r"<(\w+):(\w+)>", r"(?P<\1>#\2\\d{1,3}#)", pattern)
    return re.compile(rf"(?<![\w#-])(?:{expression})(?![\w#-])")


def mass_of(nouns: str) -> tuple[str, ...]:
    """Return patterns for the mass of a body; `nouns` are its alternative nouns, joined by bars."""
    others = "|".join(noun for noun in nouns.split("|") if noun != "mass")
    return (
        r"a (?P<keep>mass) of <mass:mass>(?= (?:is|hangs|lies|rests|on|slides))",
        rf"<mass:mass>(?= (?:(?:small|solid|uniform|thin|wooden|pendulum) )?(?:{nouns}))",
        rf"(?P<keep>{others}) (?:(?:of|with|has|having) )?(?:an? )?(?:mass )?(?:of )?(?:m = )?<mass:mass>",
        rf"(?:the )?mass of (?:the )?(?:{nouns}) is <mass:mass>",
        rf"(?:the )?(?:{nouns}) (?:has a mass of|has mass) <mass:mass>",
    )


TEXTBOOK_SCENES: Registry[TextbookScene] = Registry(
    "parsing.ordinary.textbook_scenes", package="sim2reason.text.parsing.ordinary"
)


MAX_SEARCHED_SENTENCES = 12  # longest text in which a superfluous sentence is searched for
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
PLACE_NOUNS = frozenset({"surface", "plane", "slope", "incline", "inclined plane"})


@dataclass(frozen=True, slots=True)
class LibraryText:
    """A scene in the library's sentences, and the names of required facts missing from the original text."""

    text: str
    missing: tuple[str, ...]


def library_texts(text: str) -> list[LibraryText]:
    """Return the translations of a text, one for each kind of scene whose patterns match all of its words."""
    if len(text) > MAX_TEXT_LENGTH or RESERVED.search(text):
        return []
    words, amounts = normalize_text(text)
    translations = (_translated(scene, words, amounts) for scene in TEXTBOOK_SCENES.values())
    return [each for each in translations if each is not None]


def find_superfluous_sentence(sentences: Sequence[str]) -> int | None:
    """Return the index of the one sentence without which a text can be translated; None unless it is unique."""
    if len(sentences) > MAX_SEARCHED_SENTENCES:
        return None
    others = (" ".join((*sentences[:index], *sentences[index + 1 :])) for index in range(len(sentences)))
    indices = (index for index, text in enumerate(others) if any(not each.missing for each in library_texts(text)))
    return next(indices, None)


def normalize_text(text: str) -> tuple[str, tuple[Amount, ...]]:
    """Return a text in lower case with placeholders for numbers and separate full stops, and its numbers."""
    masked, amounts = extract_amounts(" ".join(text.split()))
    plain = re.sub(r"[,;:()]", " ", masked.lower())
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
    if not left or not _one(scene.place, words, PLACE_NOUNS) or not _one(scene.bodies, left, GENERIC):
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
    for match in expression.finditer(words):
        for group, captured in match.groupdict().items():
            name = group.removeprefix("keep").removeprefix("_")
            if captured is None or not name:
                continue
            index = re.search(r"\d+", captured) if captured[0] == "#" else None
            value = amounts[int(index[0])] if index is not None else name
            if given.setdefault(name, value) != value:
                return ""
    return expression.sub(_kept, words)


def _kept(match: re.Match[str]) -> str:
    """Return the part of a matched phrase that stays in the text: its group `keep`, or else the mark `|`."""
    kept = (
        captured for name, captured in match.groupdict().items() if name.startswith("keep") and captured is not None
    )
    return next(kept, "|")


def _one(nouns: str, words: str, generic: frozenset[str]) -> bool:
    """Return whether a text uses at most one specific noun for a body and introduces the body at most once."""
    if not nouns:
        return True
    used = {match[0].strip() for match in compiled(nouns).finditer(words)}
    introduced = compiled(rf"{ARTICLES} (?:[\w#|-]{{1,20}} ){{0,3}}?(?:{nouns})").findall(words)
    return len(used - generic) <= 1 and len(introduced) <= 1
