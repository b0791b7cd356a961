"""Kinds of scenes in textbook language: patterns of their words, and a function that writes the library's text."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from sim2reason.base.registry import Registry
from sim2reason.scenes.dsl.mechanism import GRAVITY
from sim2reason.text.parsing.ordinary.amounts import Amount, format_amount


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
        found = self.given.get(name)
        if isinstance(found, Amount):
            return found
        if called:  # else it was recorded before
            self.missing.append(called)
        return None

    def number(self, name: str, called: str) -> str:
        """Return a required number with its unit; a question mark if it is missing."""
        found = self.amount(name, called)
        return found.text if found is not None else "?"

    def value(self, name: str, called: str, unit: str = "") -> float:
        """Return the value of a required number, in SI units or in `unit`; 1 if it is missing."""
        found = self.amount(name, called)
        return found.value_in(unit) if found is not None else 1.0

    def or_symbol(self, name: str, symbol: str) -> str:
        """Return an optional number with its unit, or `symbol` in dollars if the text does not give it."""
        self.asked.add(name)
        found = self.given.get(name)
        return found.text if isinstance(found, Amount) else f"${symbol}$"

    def one_of(self, called: str, *names: str) -> str:
        """Return which of several exclusive facts the text states; record `called` as missing unless exactly one is."""
        said = [name for name in names if self.has(name)]
        if len(said) != 1:
            self.missing.append(called if not said else f"{called} unambiguously")
        return said[0] if said else ""

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
    "parsing.ordinary.textbook_scenes", package="sim2reason.text.parsing.ordinary.textbook_scenes"
)
