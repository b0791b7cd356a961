"""Wordings."""

from collections.abc import Iterator

from sim2reason.scenes.dsl.choices import reachable
from sim2reason.scenes.dsl.entity import Part
from sim2reason.scenes.dsl.template import PartLines, variants
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimens

LEAST = 3


@check
class WordingsCheck(Check):
    """Every line of the class and of its parts can be said in at least three ways."""

    name = "wordings"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Lines with fewer."""
        for model in reachable(specimens.cls):
            lines = model.says if issubclass(model, Part) else ()
            for saying in (line for line in lines if not isinstance(line, PartLines)):
                for ways in variants(saying):
                    if len(set(ways)) < LEAST:
                        expected = f"each line of {model.__name__} has at least {LEAST} wordings"
                        remedy = "say it in another construction, not only in other words"
                        yield Finding(self.name, expected, f"{len(set(ways))}: {ways[0]!r}", remedy)
