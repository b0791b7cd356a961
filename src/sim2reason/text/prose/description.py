"""Descriptions: the text of a scene with its names and symbols, and the quantities behind the symbols."""

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from decimal import Decimal
from functools import cache

import numpy as np

from sim2reason.base.records import abridge
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.body import BODIES, Body
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.scenes.dsl.model import field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import Role, Topic
from sim2reason.scenes.dsl.unit_text import factors
from sim2reason.scenes.dsl.units import SYSTEMS, parse_unit, to_coherent_unit
from sim2reason.scenes.files import SceneLike, as_scene
from sim2reason.text.prose.phrases import Names, letters, paragraphs
from sim2reason.text.prose.voices import Voice, VoiceName, numeric, voice_of
from sim2reason.text.prose.writer import Writer


@dataclass(frozen=True)
class Description:
    """The text of a scene with the names and symbols in it.

    Attributes:
        scene: The scene.
        sentences: Sentences in order.
        names: Names of bodies.
        symbols: Symbols of numbers in LaTeX, by address.
        roles: Roles of those sentences that are not mere facts.
        told: Addresses of the stated numbers, in order.
        seed: Seed of the wording.
        voice: Function that writes a number, as a number or as its symbol.
        without: Topics that were left out.
        topics: Topics that the text covers.
        dry: The writer of the first pass, if it is known.
        text: The sentences as one paragraph; a table has lines of its own.
        symbolic: Addresses of the numbers that appear only as symbols, in order.
    """

    scene: Scene
    sentences: tuple[str, ...]
    names: Names
    symbols: dict[str, str]
    roles: Mapping[str, Role] = field(default_factory=dict[str, Role])  # of sentences that are no mere facts
    told: tuple[str, ...] = ()  # the addresses of all numbers that are told, in the order of telling
    seed: int = 0
    voice: Voice = numeric
    without: frozenset[Topic] = frozenset()  # topics on which it says nothing
    topics: frozenset[Topic] = frozenset()  # those on which it says something
    dry: Writer | None = field(default=None, compare=False, repr=False)  # of the first pass, if it is known

    @property
    def text(self) -> str:
        """Return the sentences as one paragraph; a table has lines of its own."""
        return paragraphs(self.sentences)

    @property
    def symbolic(self) -> tuple[str, ...]:
        """Return the addresses of the numbers that appear only as symbols, in order."""
        own = {p.path: p for p in self.scene.parameters}
        stated = [(own[path], self.symbols[path]) for path in self.told if path in own and path in self.symbols]
        return tuple(p.path for p, symbol in stated if self.voice(p, symbol) != numeric(p, symbol))

    def __repr__(self) -> str:
        """Return the name of the scene and the beginning of the text."""
        return f"<Description of {self.scene.name!r}: {abridge(self.text)!r}>"

    def __str__(self) -> str:
        """Return the text of the description."""
        return self.text

    def role(self, sentence: str) -> Role:
        """Return the role of one of the sentences, such as *fact* or *start*."""
        return self.roles.get(sentence, "fact")

    def voiced(self, voice: Voice) -> "Description":
        """Return the description with the same sentences in another voice (numbers or symbols)."""
        return self._written(voice, self.without)

    def leaving_out(self, topics: Collection[Topic]) -> "Description":
        """Return the description without the sentences on the given topics."""
        return self._written(self.voice, topics) if topics else self

    def _written(self, voice: Voice, without: Collection[Topic]) -> "Description":
        """Render the text again in another voice; names and wordings depend only on the scene and the seed."""
        dry = self.dry if self.dry is not None else write_draft(self.scene, self.seed)[1]
        return write_description(dry, self.seed, voice, without)

    def mention(self, address: str) -> str:
        """Return the name of a body in the text; SceneError if the text does not mention it."""
        if address not in self.scene.bodies:
            raise SceneError(address, "the text mentions no such body", "ask about one that it mentions")
        return self.names.mention(address, self.scene.bodies[address])


def describe(
    scene: SceneLike,
    seed: int = 0,
    voice: Voice | VoiceName = numeric,
    without: Collection[Topic] = (),
    *,
    hide: Collection[str] = (),
) -> Description:
    r"""Describe a scene in words.

    The seed alone selects the wording, so that all voices use the same sentences.

    Args:
        scene: A scene, the path of its file, its YAML text, an item about it, or the result of `parse_scene`.
        seed: Seed of the wording and of the nouns for bodies.
        voice: ``numeric``, ``symbolic``, or a function that takes a parameter and its symbol and returns its text.
        without: Topics to leave out: ``axes``, ``slack`` or ``start``.
        hide: Addresses of numbers to replace by their symbols, such as ``ramp.block.mass``.

    Returns:
        The description; `str` gives its text.

    Raises:
        TypeError: `scene` is of another type.
        SceneError: `hide` has an address at which the text states no number.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> print(sim2reason.describe(scene))
        A block ... inclined at 30° to the horizontal. ...
        >>> print(sim2reason.describe(scene, hide=["e1.plane.angle"]))
        A block ... inclined at $\theta$ to the horizontal. ...
    """
    scene = as_scene(scene, "describe")
    return write_description(write_draft(scene, seed)[1], seed, voice_of(scene.parameters, voice, hide), without)


def write_description(
    dry: Writer, seed: int = 0, voice: Voice = numeric, without: Collection[Topic] = ()
) -> Description:
    """Render the text of a scene; the first pass `dry` has found which bodies need letters, and number order."""
    scene = dry.scene
    names = Names(letters(dry.introduced, scene.bodies), dry.names.nouns)
    final = Writer(scene, names, np.random.default_rng([seed, 2]), voice, tuple(dry.told), without)
    sentences, order, left_out = tuple(final.sentences()), tuple(final.told), frozenset(without)
    topics = frozenset(final.topics)
    return Description(scene, sentences, names, final.symbols, final.roles, order, seed, voice, left_out, topics, dry)


def write_draft(scene: Scene, seed: int = 0) -> tuple[list[str], Writer]:
    """Render a text once to find the bodies and numbers in it; return its sentences and its writer."""
    nouns = _nouns(scene, np.random.default_rng([seed, 1]))
    writer = Writer(scene, Names(nouns=nouns), np.random.default_rng([seed, 2]), numeric)
    return writer.sentences(), writer


def _nouns(scene: Scene, rng: np.random.Generator) -> dict[type[Body], str]:
    """Draw a noun for each class of bodies; the first noun has twice the weight of any other."""
    classes = sorted({type(body) for body in scene.bodies.values()}, key=lambda cls: cls.__name__)
    drawn = {cls: cls.nouns[max(0, int(rng.integers(-1, len(cls.nouns))))] for cls in classes}
    bodies = scene.bodies
    misnamed = {type(body) for body in bodies.values() if not body.suits(drawn[type(body)], bodies)}
    return {cls: cls.nouns[0] if cls in misnamed else noun for cls, noun in drawn.items()}


SIGNIFICANT_DIGITS = 12  # significant digits of a converted number
MINUS = "\N{MINUS SIGN}"
DEGREES, RADIANS = "deg", "rad"


@cache
def formula_unit_factor(unit: str) -> float:
    """Return the factor from a stated unit to the unit in formulas: 1 except for degrees and kilometres.

    Units of other coherent systems, such as those of astronomy, are unchanged.
    """
    own = frozenset[str]().union(*(system.own for system in SYSTEMS))
    return 1.0 if own & {word for word, _ in factors(unit)} else parse_unit(unit).factor


@cache
def formula_unit(unit: str) -> str:
    """Return the unit that formulas use for a stated unit: ``rad`` for ``deg``, ``m/s`` for ``km/s``."""
    if formula_unit_factor(unit) == 1.0:
        return unit
    words = ((RADIANS if word == DEGREES else word, power) for word, power in factors(unit))
    return to_coherent_unit(" ".join(f"{word}^{power}" for word, power in words))[0]


def stated_value(number: float, unit: str) -> str:
    """Return the text of a number from a formula in its stated unit: 30° for 0.5236 rad, 2.5 kg."""
    if unit == RADIANS:
        number, unit = number / formula_unit_factor(DEGREES), DEGREES
    plain = format(Decimal(f"{number:.{SIGNIFICANT_DIGITS}g}"), "f")  # no text has exponents
    return join_unit(plain.replace("-", MINUS), unit)


NOUNS = (
    (r"\b(?:in a direction|points) ", "deg", "at an angle ", ""),
    (r"\bat ", "deg", "an angle ", ""),
    (r"(?<!of )", "m", "a height ", r" above\b"),
    (r"(?<!of )", "m", "a distance ", r" (?:from|beyond)\b"),
)
"""What stands before a symbol, of which unit, the noun that is put in between, and what stands after the symbol."""


def with_names(marked: Description) -> Description:
    """Return a symbolic text in which each bare symbol follows the name of its quantity."""
    parameters = {parameter.path: parameter for parameter in marked.scene.parameters}
    units = {marked.symbols[path]: p.measure.unit for path, p in parameters.items() if path in marked.symbols}
    names = {
        f"(${symbol}$)": f"({parameters[path].measure.name} ${symbol}$)"
        for path in marked.told
        if (symbol := marked.symbols.get(path)) and path in parameters
        if path.rpartition(".")[0] in marked.scene.bodies
    }

    def named(sentence: str) -> str:
        for alone, replacement in names.items():
            sentence = sentence.replace(alone, replacement)
        return sentence if sentence.lstrip().startswith("|") else _with_nouns(sentence, units)

    roles = {named(sentence): role for sentence, role in marked.roles.items()}
    return replace(marked, sentences=tuple(map(named, marked.sentences)), roles=roles)


def without_names(text: str) -> str:
    """Return a text as it was before `with_names`."""
    for before, _, noun, after in NOUNS:
        text = re.sub(rf"({before}){noun}(?=\$[^$]+\${after})", r"\1", text)
    return _named().sub(r"(\1)", text)


def _with_nouns(sentence: str, units: Mapping[str, str]) -> str:
    for before, unit, noun, after in NOUNS:
        for symbol, of in units.items():
            if parse_unit(of).dimension == parse_unit(unit).dimension:
                sentence = re.sub(
                    rf"({before})(?=\${re.escape(symbol)}\${after})", lambda match, n=noun: f"{match[1]}{n}", sentence
                )
    return sentence


@cache
def _named() -> re.Pattern[str]:
    """Return the pattern of a symbol in brackets after the name of a quantity."""
    kinds = (kind for body in BODIES.values() for kind in field_types(body).values())
    names = {kind.measure.name for kind in kinds if kind.measure is not None}
    return re.compile(rf"\((?:{'|'.join(map(re.escape, sorted(names)))}) (\$[^$]+\$)\)")
