"""Checks of texts: wordings, symbols, and indispensable numbers."""

from collections.abc import Iterator
from typing import get_args

from sim2reason.errors import TextError
from sim2reason.scenes.dsl.choices import reachable
from sim2reason.scenes.dsl.entity import Part
from sim2reason.scenes.dsl.template import PartLines, Topic, variants
from sim2reason.testing.checks import Check, check
from sim2reason.testing.checks.round_trip import meaning, meant
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens, changed, stated_by_word, stated_numbers
from sim2reason.text.parsing import parse_scene
from sim2reason.text.parsing.sentences import pieces
from sim2reason.text.prose.description import Description, describe
from sim2reason.text.prose.voices import hiding, symbolic

MIN_WORDINGS = 3


@check
class WordingsCheck(Check):
    """Check that every sentence of the class and its parts has at least three wordings."""

    name = "wordings"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Yield the sentences that have fewer than three wordings."""
        for model in reachable(specimens.cls):
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
        for found in specimens.members:
            yield from self._shared(found)

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


SCENES = 3
SHIFT = 1.5


@check
class MaskingCheck(Check):
    """Check that a hidden number appears nowhere else, and that every sentence is necessary."""

    name = "masking"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Hide each number, and remove each sentence and table row."""
        for found in specimens.some(SCENES):
            yield from self._numbers(found)
            yield from self._sentences(found)

    def _numbers(self, found: Specimen) -> Iterator[Finding]:
        """Yield findings for hidden numbers that the text still reveals, or that its parse does not report."""
        for path, parameter in stated_numbers(found.scene, found.seed).items():
            other = changed(found.scene, {path: (parameter.value or 1.0) * SHIFT})
            text = describe(found.scene, found.seed, hiding(path)).text
            expected = f"with {path} hidden, nothing in the text depends on it"
            if other is not None and not stated_by_word(other, path):
                its = describe(other, found.seed, hiding(path)).text
                if its != text:
                    remedy = "say each number through its own slot, so that it can be hidden"
                    yield found.finding(self.name, expected, f"it reads: {text}\n  or: {its}", remedy)
                    continue
            if not _lacks(text, path):
                remedy = "name the number in the line, and let no other line tell it"
                yield found.finding(self.name, expected, f"the text is read back all the same: {text}", remedy)

    def _sentences(self, found: Specimen) -> Iterator[Finding]:
        """Yield findings for sentences and table rows whose removal does not change the meaning."""
        told = found.description
        spared = spare(told)
        for cut, text in without_one(list(pieces(told.text))):
            if cut not in spared and _understood(text) == meaning(told):
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
        return meant(parse_scene(text))
    except TextError:
        return None


def spare(description: Description) -> set[str]:
    """Return the sentences that matter only for some questions, so that they may be omitted.

    Sentences on the initial state are excluded: a text without a question needs them.
    """
    topics = [topic for topic in get_args(Topic) if topic != "start"]
    return set(description.sentences).difference(description.leaving_out(topics).sentences)


def without_one(parts: list[str]) -> Iterator[tuple[str, str]]:
    """Yield each removed sentence or table row, with the remaining text."""
    for index, part in enumerate(parts):
        yield part, together([*parts[:index], *parts[index + 1 :]]) or " "
        rows = part.split("\n")
        for number, row in enumerate(rows) if len(rows) > 1 else ():
            shorter = "\n".join(rows[:number] + rows[number + 1 :])
            yield row, together([*parts[:index], shorter, *parts[index + 1 :]])


def together(parts: list[str]) -> str:
    """Return sentences and tables joined to one text."""
    return "".join(f"\n\n{part}\n\n" if part.startswith("|") else f" {part}" for part in parts).strip()
