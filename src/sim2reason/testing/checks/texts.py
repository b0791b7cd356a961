"""Checks of texts and files: wordings, symbols, true statements, and the round trip from a scene and back."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import get_args

from sim2reason.errors import SceneError, TextError
from sim2reason.scenes.dsl.choices import contained_classes
from sim2reason.scenes.dsl.entity import Part
from sim2reason.scenes.dsl.fields import Resistance
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.structure import is_gravity_relevant
from sim2reason.scenes.dsl.template import PartLines, Topic, variants
from sim2reason.scenes.files import load
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens, change_numbers, stated_by_word, stated_numbers
from sim2reason.text.parsing import ParsedScene, parse_scene
from sim2reason.text.parsing.equivalence import Signature, signature
from sim2reason.text.parsing.ordinary.textbook import AIRLESS
from sim2reason.text.parsing.sentences import split_pieces
from sim2reason.text.prose.description import Description, describe
from sim2reason.text.prose.voices import symbolic, symbolic_at

WORDING_COUNT = 3


@check
class RoundTripCheck(Check):
    """Check that files and texts, in several wordings, parse back to the same scene."""

    name = "round trip"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Write and parse all scenes, each in several wordings."""
        for specimen in specimens.members:
            yield from self._file(specimen)
            wordings = range(specimen.seed, specimen.seed + WORDING_COUNT)
            yield from (lost for seed in wordings for lost in self._text(specimen, describe(specimen.scene, seed)))

    def _file(self, found: Specimen) -> Iterator[Finding]:
        expected, remedy = "the file of a scene loads as that scene", "declare all that build uses as fields"
        try:
            if load(found.file) != found.scene:
                yield found.finding(self.name, expected, "it loads as another one", remedy)
        except SceneError as error:
            yield found.finding(self.name, expected, f"it is refused: {error}", remedy)

    def _text(self, found: Specimen, description: Description) -> Iterator[Finding]:
        expected = "the text is read back as the scene that it tells"
        remedy = "let lines differ in their words where they differ in meaning, and say all that build uses"
        try:
            parsed = parse_scene(description.text)
        except SceneError as error:
            yield found.finding(self.name, expected, f"{error}\n  text: {description.text}", remedy)
            return
        if text_signature(parsed) != meaning(description) or numbers(parsed.scene) != numbers(description.scene):
            other = "it is read as another scene"
            yield found.finding(self.name, expected, f"{other}\n  text: {description.text}", remedy)


def meaning(description: Description) -> Signature:
    """Return the equivalence signature of a described scene, by the names in its text."""
    scene = description.scene
    return signature(scene, {address: description.mention(address) for address in scene.bodies})


def text_signature(parsed: ParsedScene) -> Signature:
    """Return the equivalence signature of a parsed text."""
    return signature(parsed.scene, parsed.mentions)


def numbers(scene: Scene) -> list[tuple[str, float]]:
    """Return all stated numbers; a massless pulley may belong to an entity or to a string."""
    stated = [(p.measure.name, p.value) for p in scene.parameters if not p.hidden and p.value is not None]
    return sorted(number for number in stated if number != ("pulley mass", 0.0))


MIN_WORDINGS = 3


@check
class WordingsCheck(Check):
    """Check that every sentence of the class and its parts has at least three wordings."""

    name = "wordings"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Yield the sentences that have fewer than three wordings."""
        for model in contained_classes(specimens.cls):
            lines = model.says if issubclass(model, Part) else ()
            for saying in (line for line in lines if not isinstance(line, PartLines)):
                for ways in variants(saying):
                    if len(set(ways)) < MIN_WORDINGS:
                        expected = f"each line of {model.__name__} has at least {MIN_WORDINGS} wordings"
                        remedy = "say it in another construction, not only in other words"
                        yield Finding(self.name, expected, f"{len(set(ways))}: {ways[0]!r}", remedy)


@check
class SymbolsCheck(Check):
    """Check that every stated number has its own symbol in the symbolic text."""

    name = "symbols"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Yield pairs of numbers with one symbol, and symbols missing in the text."""
        for specimen in specimens.members:
            yield from self._shared(specimen)

    def _shared(self, found: Specimen) -> Iterator[Finding]:
        description = describe(found.scene, found.seed, symbolic)
        owner: dict[str, str] = {}
        for path, parameter in stated_numbers(found.scene, found.seed).items():
            symbol = description.symbols.get(path, parameter.measure.symbol)
            remedy = "give the fields different symbols: in their Measure, or in `symbols` of their body"
            if symbol in owner:
                expected = "no two givens share a symbol"
                yield found.finding(self.name, expected, f"{path} and {owner[symbol]} are both ${symbol}$", remedy)
            elif f"${symbol}$" not in description.text:
                expected = f"the symbol of {path}, ${symbol}$, stands in the text"
                yield found.finding(self.name, expected, f"it does not: {description.text}", remedy)
            owner.setdefault(symbol, path)


SCENE_COUNT = 3
SHIFT_FACTOR = 1.5


@check
class MaskingCheck(Check):
    """Check that a hidden number appears nowhere else, and that every sentence is necessary."""

    name = "masking"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Hide each number, and remove each sentence and table row."""
        for specimen in specimens.some(SCENE_COUNT):
            yield from self._numbers(specimen)
            yield from self._sentences(specimen)

    def _numbers(self, found: Specimen) -> Iterator[Finding]:
        """Yield findings for hidden numbers that the text still reveals, or that its parse does not report."""
        for path, parameter in stated_numbers(found.scene, found.seed).items():
            other = change_numbers(found.scene, {path: (parameter.value or 1.0) * SHIFT_FACTOR})
            text = describe(found.scene, found.seed, symbolic_at(path)).text
            expected = f"with {path} hidden, nothing in the text depends on it"
            if other is not None and not stated_by_word(other, path):
                its = describe(other, found.seed, symbolic_at(path)).text
                if its != text:
                    remedy = "say each number through its own slot, so that it can be hidden"
                    yield found.finding(self.name, expected, f"it reads: {text}\n  or: {its}", remedy)
                    continue
            if not _lacks(text, path):
                remedy = "name the number in the line, and let no other line tell it"
                yield found.finding(self.name, expected, f"the text is read back all the same: {text}", remedy)

    def _sentences(self, found: Specimen) -> Iterator[Finding]:
        """Yield findings for sentences and table rows whose removal does not change the meaning."""
        description = found.description
        spared = optional_sentences(description)
        for cut, text in without_one(list(split_pieces(description.text))):
            if cut not in spared and _understood(text) == meaning(description):
                yield found.finding(
                    self.name,
                    "every sentence is needed",
                    f"without {cut!r} the text is read as the same scene: {text}",
                    "leave out the line, or tell in it what nothing else tells",
                )


def _lacks(text: str, path: str) -> bool:
    """Return whether a text is refused, or parsed with the number at an address unknown."""
    try:
        return path.rpartition(".")[2] in {where.rpartition(".")[2] for where in parse_scene(text).unknown}
    except TextError:
        return True


def _understood(text: str) -> object:
    """Return the parsed meaning of a text; None if it is refused."""
    try:
        return text_signature(parse_scene(text))
    except TextError:
        return None


def optional_sentences(description: Description) -> set[str]:
    """Return the sentences that matter only for some questions, so that they may be omitted.

    Sentences on the initial state are excluded: a text without a question needs them.
    """
    topics = [topic for topic in get_args(Topic) if topic != "start"]
    return set(description.sentences).difference(description.leaving_out(topics).sentences)


def without_one(parts: list[str]) -> Iterator[tuple[str, str]]:
    """Yield each removed sentence or table row, with the remaining text."""
    for index, part in enumerate(parts):
        yield part, join_sentences([*parts[:index], *parts[index + 1 :]]) or " "
        rows = part.split("\n")
        for number, row in enumerate(rows) if len(rows) > 1 else ():
            shorter = "\n".join(rows[:number] + rows[number + 1 :])
            yield row, join_sentences([*parts[:index], shorter, *parts[index + 1 :]])


def join_sentences(parts: list[str]) -> str:
    """Return sentences and tables joined to one text."""
    return "".join(f"\n\n{part}\n\n" if part.startswith("|") else f" {part}" for part in parts).strip()


@dataclass(frozen=True, slots=True)
class Claim:
    """A claim that something is absent, in the words of texts, and the scenes that it is false of."""

    absent: str
    pattern: re.Pattern[str]
    is_false: Callable[[Scene], bool]


def _has_drag(scene: Scene) -> bool:
    return any(isinstance(force.law, Resistance) for force in scene.mechanism.forces)


def _has_friction(scene: Scene) -> bool:
    return any(face.friction > 0.0 for face in scene.mechanism.faces)


def _has_motion_at_the_start(scene: Scene) -> bool:
    return not scene.starts_from_rest


def _has_weight(scene: Scene) -> bool:
    return is_gravity_relevant(scene.mechanism)


_NEGLIGIBLE = r"(?:is|are|can be|may be) (?:negligible|neglected|ignored|absent)"
CLAIMS = (
    Claim(
        "resistance of a medium",
        re.compile("|".join((*AIRLESS, r"in (?:a )?vacuum")), re.IGNORECASE),
        _has_drag,
    ),
    Claim(
        "friction",
        re.compile(
            rf"friction {_NEGLIGIBLE}|(?:neglect|ignore) (?:all )?friction"
            r"|there is no friction(?! (?:at|in|between|on))|(?:all|the) surfaces are (?:smooth|frictionless)",
            re.IGNORECASE,
        ),
        _has_friction,
    ),
    Claim(
        "initial motion",
        re.compile(
            r"(?:everything|the system|the motion|the bodies|all bodies) (?:is|are|starts?|begins?) "
            r"(?:released from rest|from rest|held at rest)",
            re.IGNORECASE,
        ),
        _has_motion_at_the_start,
    ),
    Claim(
        "gravity",
        re.compile(
            rf"gravity {_NEGLIGIBLE}|(?:neglect|ignore) gravity|(?:no|without) gravity|weightless", re.IGNORECASE
        ),
        _has_weight,
    ),
)
"""Claims about a whole scene; a claim about one body, as *a smooth plane*, is a word of that body."""


@check
class ClaimsCheck(Check):
    """Check that no sentence says that something is absent which the scene has, such as the resistance of the air."""

    name = "claims"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Yield each sentence that denies what its scene has."""
        for specimen in specimens.members:
            yield from self._false_claims(specimen)

    def _false_claims(self, found: Specimen) -> Iterator[Finding]:
        for sentence in found.description.sentences:
            for claim in CLAIMS:
                if claim.pattern.search(sentence) and claim.is_false(found.scene):
                    expected = f"no sentence denies the {claim.absent} of the scene"
                    remedy = "say that sentence only where it is true, or leave out what it denies"
                    yield found.finding(self.name, expected, f"{sentence!r}", remedy)
