"""Stories of textbooks, one kind of scene a declaration: how people say it, and how the library does."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from sim2reason.parsing.ordinary.amounts import Amount
from sim2reason.registry import Registry

USUAL_G = "9.8 m/s²"


@dataclass
class Told:
    """What a text tells of a story, by name; it notes what the story asks for and the text does not give."""

    given: Mapping[str, str | Amount]
    words: str = ""
    missing: list[str] = field(default_factory=list[str])
    asked: set[str] = field(default_factory=set[str])

    def has(self, name: str) -> bool:
        """Return whether the text says something."""
        self.asked.add(name)
        return name in self.given

    def nouns(self, pattern: str) -> list[str]:
        """Return the nouns of a pattern that the text uses, each once, those in the plural without their *s*."""
        return list(dict.fromkeys(compiled(rf"(?P<noun>{pattern})s?").findall(self.words)))

    def amount(self, name: str, called: str) -> Amount | None:
        """Return a number that the story can not do without, which messages call `called`; None if it is missing."""
        self.asked.add(name)
        found = self.given.get(name)
        if isinstance(found, Amount):
            return found
        self.missing.append(called)
        return None

    def number(self, name: str, called: str) -> str:
        """Return the text of such a number, with its unit."""
        found = self.amount(name, called)
        return found.text if found is not None else "?"

    def value(self, name: str, called: str) -> float:
        """Return such a number, in the unit of its kind; 1 if it is missing."""
        found = self.amount(name, called)
        return found.value if found is not None else 1.0

    def or_symbol(self, name: str, symbol: str) -> str:
        """Return the text of a number that may be left open, with its unit, or a symbol for it."""
        self.asked.add(name)
        found = self.given.get(name)
        return found.text if isinstance(found, Amount) else f"${symbol}$"

    def one_of(self, called: str, *names: str) -> str:
        """Return which of some facts the text says; it has to say one of them, and one only."""
        said = [name for name in names if self.has(name)]
        if len(said) != 1:
            self.missing.append(called if not said else f"{called} without contradiction")
        return said[0] if said else ""

    @property
    def gravity(self) -> str:
        """Return the closing sentence with the acceleration of free fall, the usual one if the text gives none."""
        return f"Take g = {self.or_symbol('g', '') if self.has('g') else USUAL_G}."

    @property
    def whole(self) -> bool:
        """Return whether the story has used everything that the text says."""
        return self.asked.issuperset(self.given)


@dataclass(frozen=True)
class Story:
    """A kind of scene as textbooks tell it.

    Data:
        summary: what happens, in a few words.
        opening: patterns each of which occurs in a text that tells this story.
        phrases: patterns of all that may be said, tried in order; `<name:kind>` is a number of a kind, and a named
            group a fact that is said or not; what a group called `keep` or `keep_fact` holds stays for later patterns.
            Each place of a text is taken by the first pattern that fits.
        bodies: a pattern of the nouns for the body; a text may use one of them only. Empty where phrases name them.
        place: a pattern of the nouns for the surface that it moves on, of which a text may name one only, too.
        never: a pattern of what tells another scene in the words of this one, as a slope that moves.
        tell: the library's text with what the text tells.
    """

    summary: str
    opening: tuple[str, ...]
    phrases: tuple[str, ...]
    tell: Callable[[Told], str]
    bodies: str = ""
    place: str = ""
    never: str = ""

    def __post_init__(self) -> None:
        """Refuse patterns that are no regular expressions when they are declared."""
        for pattern in (*self.opening, *self.phrases, self.bodies, self.place, self.never):
            compiled(pattern)


def compiled(pattern: str) -> re.Pattern[str]:
    """Return the regular expression of a pattern, which begins and ends where words do."""
    told = re.sub(r"<(\w+):(\w+)>", r"(?P<\1>#\2\\d{1,3}#)", pattern)
    return re.compile(rf"(?<![\w#-])(?:{told})(?![\w#-])")


def mass_of(nouns: str) -> tuple[str, ...]:
    """Return the patterns by which a text gives the mass of its body, and not that of something else."""
    others = "|".join(noun for noun in nouns.split("|") if noun != "mass")
    return (
        r"a (?P<keep>mass) of <mass:mass>(?= (?:is|hangs|lies|rests|on|slides))",
        rf"<mass:mass>(?= (?:(?:small|solid|uniform|thin|wooden|pendulum) )?(?:{nouns}))",
        rf"(?P<keep>{others}) (?:(?:of|with|has|having) )?(?:an? )?(?:mass )?(?:of )?(?:m = )?<mass:mass>",
        rf"(?:the )?mass of (?:the )?(?:{nouns}) is <mass:mass>",
        rf"(?:the )?(?:{nouns}) (?:has a mass of|has mass) <mass:mass>",
    )


STORIES: Registry[Story] = Registry("parsing.ordinary.stories")
