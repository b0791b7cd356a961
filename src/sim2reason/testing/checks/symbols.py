"""Symbols."""

from collections.abc import Iterator

from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens
from sim2reason.testing.variants import spoken
from sim2reason.text.prose.description import describe
from sim2reason.text.prose.voices import symbolic


@check
class SymbolsCheck(Check):
    """In the symbolic voice every given has a symbol of its own, and it stands in the text."""

    name = "symbols"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Two givens with one symbol, and symbols that the text lacks."""
        for found in specimens.members:
            yield from self._shared(found)

    def _shared(self, found: Specimen) -> Iterator[Finding]:
        description = describe(found.scene, found.seed, symbolic)
        owner: dict[str, str] = {}
        for path, parameter in spoken(found.scene, found.seed).items():
            symbol = description.symbols.get(path, parameter.measure.symbol)
            remedy = "give the fields different symbols: in their Measure, or in `symbols` of their body"
            if symbol in owner:
                expected = "no two givens share a symbol"
                yield found.finding(self.name, expected, f"{path} and {owner[symbol]} are both ${symbol}$", remedy)
            elif f"${symbol}$" not in description.text:
                expected = f"the symbol of {path}, ${symbol}$, stands in the text"
                yield found.finding(self.name, expected, f"it does not: {description.text}", remedy)
            owner.setdefault(symbol, path)
