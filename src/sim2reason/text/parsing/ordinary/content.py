"""Words and numbers that a sentence states, and the library's own sentences for comparison."""

import re
from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import cache, lru_cache

import numpy as np
from pydantic import ValidationError

from sim2reason.errors import SceneError, UnsupportedError
from sim2reason.scenes.dsl.choices import chances, choices, close_ports, contained_classes, specials
from sim2reason.scenes.dsl.entity import ENTITIES, Entity, Named
from sim2reason.scenes.dsl.model import Choice, Count, draw, field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.units import UnitError, to_coherent_unit
from sim2reason.text.parsing.ordinary.lexicon import FILLERS, ORDERED, PHRASES, SURFACES, SYNONYMS, TEXTURES
from sim2reason.text.prose.phrases import Names, letters
from sim2reason.text.prose.voices import symbolic_but_zero
from sim2reason.text.prose.writer import Writer

MINUS, TIMES = "\N{MINUS SIGN}", "\N{MULTIPLICATION SIGN}"
_NUMBER = re.compile(
    rf"(?<![\w.])([-{MINUS}]?\d{{1,30}}(?:\.\d{{1,30}})?"
    rf"(?:e[+-]?\d{{1,3}}|\s?[{TIMES}x*]\s?10\^?[-{MINUS}]?\d{{1,3}})?)"
    r"(?:[ \-]?(°|%|[A-Za-zµμΩ][A-Za-zµμΩ0-9²³⁻¹·*/^]{0,20}))?"
)
_SYMBOL = re.compile(r"\$([^$\n]{1,40})\$")
_WORD = re.compile(r"#\d+#|\$\d+\$|[A-Za-z][A-Za-z-]*")
_MEANS = {other: word for word, others in SYNONYMS.items() for other in others.split()}


@dataclass(frozen=True, slots=True)
class WrittenNumber:
    """A number as written, with its unit (empty for a pure number) and that unit without SI prefixes."""

    digits: str
    unit: str
    is_bare: str

    def in_unit(self, unit: str) -> str:
        """Return the digits of this number in another unit of the same kind, without rounding."""
        mine, other = to_coherent_unit(self.unit)[1], to_coherent_unit(unit)[1]
        if mine == other:
            return self.digits
        plain = re.sub(rf"\s?[{TIMES}x*]\s?10\^?", "e", self.digits).replace(MINUS, "-")
        return f"{(Decimal(plain) * mine / other).normalize():f}".replace("-", MINUS)


@dataclass(frozen=True, slots=True)
class Content:
    """The significant words of a sentence in order, with `#0#` in place of its first number, and the numbers."""

    words: tuple[str, ...]
    numbers: tuple[WrittenNumber, ...]

    @property
    def facts(self) -> frozenset[str]:
        """Return the words of the sentence as a set, without numbers and without letters that name bodies."""
        return frozenset(word for word in self.words if len(word) > 1 and word[0] != "#")

    @property
    def order(self) -> tuple[str, ...]:
        """Return the words whose order matters, such as nouns, in sentence order, without immediate repetitions."""
        several = sum(word in SURFACES for word in self.words) > 1
        matters: frozenset[str] = ORDERED.union(TEXTURES, SURFACES) if several else ORDERED
        words = [word for word in self.words if word in matters]
        return tuple(word for index, word in enumerate(words) if index == 0 or words[index - 1] != word)

    @property
    def letters(self) -> tuple[str, ...]:
        """Return the letters that name bodies, in the order of the sentence."""
        return tuple(word for word in self.words if len(word) == 1)

    def words_beside(self, index: int) -> frozenset[str]:
        """Return the words directly before and after a number, given by its index."""
        at = self.words.index(f"#{index}#")
        near = (*self.words[max(at - 1, 0) : at], *self.words[at + 1 : at + 2])
        return frozenset(word for word in near if word[0] != "#")


@lru_cache(maxsize=1024)
def content(sentence: str) -> Content:
    """Return the significant words and numbers of a sentence; numbers count from 0 in order of occurrence."""
    numbers: list[WrittenNumber] = []

    def numbered(found: re.Match[str]) -> str:
        unit, bare, rest = _unit(found[2] or "")
        numbers.append(WrittenNumber(found[1], unit, bare))
        return f" #{len(numbers) - 1}# {rest}"

    return Content(tuple(_words(_NUMBER.sub(numbered, sentence))), tuple(numbers))


def content_of_form(form: str) -> Content:
    """Return the content of a sentence with symbols in dollars; each counts as a number without a unit."""
    symbols: list[WrittenNumber] = []

    def numbered(found: re.Match[str]) -> str:
        symbols.append(WrittenNumber(found[1], "", ""))
        return f" #{len(symbols) - 1}# "

    return Content(tuple(_words(_SYMBOL.sub(numbered, form))), tuple(symbols))


def _unit(text: str) -> tuple[str, str, str]:
    """Return the unit at the start of a string, the unit without prefixes, and the remainder of the string."""
    word = text.rstrip(".")
    try:
        return (word, to_coherent_unit(word)[0], "") if word else ("", "", "")
    except (UnitError, ArithmeticError):
        return "", "", text


def _words(text: str) -> Iterator[str]:
    text = _letters(text)
    for pattern, plain in _phrases():
        text = pattern.sub(f" {plain} ", text)
        text = " ".join(text.split())
    words: list[str] = _WORD.findall(text)
    for word in words:
        if word.isupper() or word[0] == "#":
            yield word
        elif word not in FILLERS:
            meaning = _MEANS.get(word, word)
            singular = (
                meaning[:-1] if meaning.endswith("s") and len(meaning) > 3 and not meaning.endswith("ss") else meaning
            )
            yield _MEANS.get(singular, singular)


def _letters(text: str) -> str:
    """Return the text in lower case except for the letters of bodies; a capital A at the start is an article."""
    text = re.sub(r"^\W*A\s+(?=[a-z#])", "a ", text)
    return re.sub(r"\b(?![A-Z]\b)\w+", lambda word: word[0].lower(), text)


@cache
def _phrases() -> tuple[tuple[re.Pattern[str], str], ...]:
    return tuple((re.compile(pattern), plain) for pattern, plain in PHRASES.items())


MAX_SINGLE_WORDS = 4  # words that fix a number, such as *smooth*, each of which gets a scene of its own
MAX_PART_CLASSES = 4  # classes of parts tried for the same field, such as bodies that roll
RANDOM_SCENES = 1  # random scenes of each entity
WORDINGS_PER_SCENE = 2  # of each scene
IT = "it"
GRAVITY, _GRAVITY_OF_SYMBOL = "Take g = $g$.", "The acceleration of free fall is $g$."  # as with a number, and without


@dataclass(frozen=True, slots=True)
class Form:
    """A library sentence with symbols in dollars for its numbers; `position` is its relative position in a text."""

    text: str
    units: tuple[str, ...]
    position: float
    content: Content


class _FixedChoiceWriter(Writer):
    """A writer that uses the same index for all wordings, and always the first noun."""

    wording = 0

    def choose(self, options: tuple[str, ...]) -> str:
        """Return the wording of this writer's index, modulo the number of wordings."""
        return options[self.wording % len(options)]


@cache
def forms() -> tuple[Form, ...]:
    """Return all sentence forms of the library, without repetitions."""
    forms_by_text: dict[str, Form] = {}
    for cls in ENTITIES.values():
        for number, chosen in enumerate(_choices(cls)):
            for form in _forms_of(cls, number, chosen, forms_by_text):
                forms_by_text[form.text] = form
    return tuple(forms_by_text.values())


def _choices(cls: type[Entity]) -> Iterator[dict[str, Choice]]:
    """Yield settings for random scenes of an entity that together use each special word, such as *smooth*."""
    fields = [
        (model, name, field_type) for model in contained_classes(cls) for name, field_type in field_types(model).items()
    ]
    special_values = {
        f"{model.__name__}.{name}": specials(model, name) for model, name, _ in fields if specials(model, name)
    }
    few = {
        f"{model.__name__}.{name}": Count(field_type.count.low, field_type.count.low)
        for model, name, field_type in fields
        if field_type.count
    }
    words: list[dict[str, float]] = [
        {},
        *({path: values[end] for path, values in special_values.items()} for end in (0, -1)),
    ]
    for present in (0.0, 1.0):
        plain: dict[str, Choice] = {**few, **dict.fromkeys(chances(cls), present)}
        yield from ({**plain, **special} for special in words)
        yield from (
            {**plain, path: special_values[path][0]}
            for path in list(special_values)[:MAX_SINGLE_WORDS]
            if len(special_values) > 1
        )
    for model, name, field_type in fields:
        kinds = [kind.__name__ for kind in field_type.models if len(field_type.models) > 1]
        yield from ({**chances(cls), f"{model.__name__}.{name}": (kind,)} for kind in kinds[:MAX_PART_CLASSES])
    yield from (choices(cls, np.random.default_rng(seed)) for seed in range(RANDOM_SCENES))


def _forms_of(cls: type[Entity], number: int, chosen: dict[str, Choice], known: Container[str]) -> Iterator[Form]:
    """Yield the new sentence forms of one random scene of an entity; none if the scene is invalid."""
    rng = np.random.default_rng([number])
    try:
        scene = close_ports(Named(name=IT, entity=draw(cls, rng, chosen)), rng)
        first = _FixedChoiceWriter(scene, Names(), rng, symbolic_but_zero)
        first.sentences()
        for wording in range(WORDINGS_PER_SCENE):
            yield from _new_forms(scene, first, number * WORDINGS_PER_SCENE + wording, known)
    except (SceneError, UnsupportedError, ValidationError):
        return


def _new_forms(scene: Scene, first: Writer, wording: int, known: Container[str]) -> Iterator[Form]:
    names = Names(letters(first.introduced, scene.bodies))
    teller = _FixedChoiceWriter(scene, names, np.random.default_rng(0), symbolic_but_zero, tuple(first.told))
    teller.wording = wording
    sentences = [GRAVITY if sentence == _GRAVITY_OF_SYMBOL else sentence for sentence in teller.sentences()]
    units = {teller.symbols[p.path]: p.measure.unit for p in scene.parameters if p.path in teller.symbols}
    for index, sentence in enumerate(sentences):
        if "|" in sentence or sentence in known:
            continue
        form_content = content_of_form(sentence)
        symbols = [number.digits for number in form_content.numbers]
        if all(symbol in units for symbol in symbols):
            yield Form(sentence, tuple(units[symbol] for symbol in symbols), index / len(sentences), form_content)


_MASS = r"(?:of (?:mass(?:es)? )?)?(\d[\d.]*(?: ?[x×] ?10\^?-?\d+)?)[ -]?(k?g|kilograms?)"
_STRING = r"(?:a |the )?(?:(?:single|light|massless|inextensible|ideal)(?:,? and|,)? )*(?:string|rope|cord)"
_PULLEY = r"(?:a |an )?(?:(?:light|massless|frictionless|smooth|fixed|ideal)(?:,? and|,)? )*pulley"
_LEADS = r"(?:(?:that|which) )?(?:passes |passing |runs |running |goes |going |hung |is hung |slung )?over"
_TIED = r"(?:connected|attached|joined|tied)"
_BODY = r"(?:blocks|masses|weights|bodies|objects)"

PULLEY_REWORDINGS: Mapping[str, str] = {
    rf"Two {_BODY},? {_MASS} and {_MASS},? (?:hang|are hung|are suspended|are {_TIED})"
    rf"(?: vertically)?(?: (?:together|from|to|at|on|the|both|two|opposite|ends?|of))*"
    rf"(?: by)? {_STRING} {_LEADS} {_PULLEY}\.": (
        r"A light string is tied to block A of mass \1 \2; it runs straight up, passes over a light fixed pulley"
        r" and runs straight down to block B of mass \3 \4."
    ),
    rf"(?:It|The block|Block A) is {_TIED} by {_STRING} {_LEADS} {_PULLEY} at (?:the|its) edge(?: of the \w+)?"
    rf" to (?:a |another |a second )?(?:hanging )?(?:block|mass|weight)(?: B)? {_MASS}"
    r"(?:,? (?:that|which) hangs (?:freely|vertically))?\.": (
        r"A light string tied to block A runs to the right along the plane, passes over a light fixed pulley"
        r" and runs straight down to block B (\1 \2)."
    ),
}
"""By a pattern of a whole sentence, the library's sentence that says the same; the first body mentioned is A."""


def reword_textbook_sentence(sentence: str) -> str | None:
    """Return the library's sentence that says the same as one of a textbook on a usual arrangement; None if unknown."""
    for pattern, replacement in PULLEY_REWORDINGS.items():
        match = re.fullmatch(pattern, sentence)
        if match is not None:
            return match.expand(replacement)
    return None
