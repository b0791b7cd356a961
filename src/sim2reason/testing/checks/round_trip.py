"""Check of the round trip from a scene to its file and text, and back."""

from collections.abc import Iterator

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import load
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens
from sim2reason.text.parsing import ParsedScene, parse_scene
from sim2reason.text.parsing.equivalence import Signature, signature
from sim2reason.text.prose.description import Description, describe

WORDINGS = 3


@check
class RoundTripCheck(Check):
    """Check that files and texts, in several wordings, parse back to the same scene."""

    name = "round trip"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Write and parse all scenes, each in several wordings."""
        for found in specimens.members:
            yield from self._file(found)
            wordings = range(found.seed, found.seed + WORDINGS)
            yield from (lost for seed in wordings for lost in self._text(found, describe(found.scene, seed)))

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
        if meant(parsed) != meaning(description) or numbers(parsed.scene) != numbers(description.scene):
            other = "it is read as another scene"
            yield found.finding(self.name, expected, f"{other}\n  text: {description.text}", remedy)


def meaning(description: Description) -> Signature:
    """Return the equivalence signature of a described scene, by the names in its text."""
    scene = description.scene
    return signature(scene, {address: description.mention(address) for address in scene.bodies})


def meant(parsed: ParsedScene) -> Signature:
    """Return the equivalence signature of a parsed text."""
    return signature(parsed.scene, parsed.mentions)


def numbers(scene: Scene) -> list[tuple[str, float]]:
    """Return all stated numbers; a massless pulley may belong to an entity or to a string."""
    said = [(p.measure.name, p.value) for p in scene.parameters if not p.hidden and p.value is not None]
    return sorted(number for number in said if number != ("pulley mass", 0.0))
