"""Check of scenes with parts removed or bodies held fixed."""

from collections.abc import Callable, Iterator

from pydantic import ValidationError

from sim2reason.errors import SceneError, Sim2ReasonError
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.scenes import simulate
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import IT, Specimen, Specimens
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose.description import describe

SCENES = 4


@check
class AblationsCheck(Check):
    """Check that scenes stay valid, or are refused with a reason, if a part is removed or a body is held fixed."""

    name = "ablations"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Remove every optional part, and fix every movable body."""
        for found in specimens.some(SCENES):
            for address in removable(found.scene):
                yield from self._without(found, address)
            for body in found.scene.mechanism.bodies:
                if body.coordinates and body.name.startswith(f"{IT}."):
                    yield from self._glued(found, body.name)

    def _without(self, found: Specimen, address: str) -> Iterator[Finding]:
        """Yield a finding unless the rest of the scene is described and simulated, or refused with an error."""
        remedy = "let a validator refuse what can not be without it, and build what is there"
        try:
            scene = _made(lambda: found.scene.without(address))
            if scene is not None:
                describe(scene, found.seed)
                simulate(scene)
        except Sim2ReasonError:
            return
        except Exception as error:  # noqa: BLE001 - whatever a stranger's class raises is a finding
            what = f"{type(error).__name__}: {error}"
            yield found.finding(self.name, f"without {address} it is a scene, or refused in words", what, remedy)
            return
        if scene is None:
            return
        text = describe(scene, found.seed).text
        try:
            parse_scene(text)
        except SceneError as error:
            expected = f"without {address} its text is read back"
            yield found.finding(self.name, expected, f"{error}\n  text: {text}", remedy)

    def _glued(self, found: Specimen, body: str) -> Iterator[Finding]:
        """Yield a finding if a body that is held fixed can still move, or the rest of the scene cannot be simulated."""
        expected, remedy = f"{body} can be glued to what carries it", "let build say all of a body through the frame"
        try:
            scene = _made(lambda: found.scene.gluing(body))
            if scene is not None and scene.mechanism.body[body].coordinates:
                yield found.finding(self.name, expected, "it still moves", remedy)
            if scene is not None:
                simulate(scene)
        except Sim2ReasonError:
            return
        except Exception as error:  # noqa: BLE001 - the same
            yield found.finding(self.name, expected, f"{type(error).__name__}: {error}", remedy)


def _made(make: Callable[[], Scene]) -> Scene | None:
    """Return a changed scene if it is valid; None if it is refused."""
    try:
        scene = make()
        scene.check()
    except (SceneError, ValidationError):
        return None
    return scene


def removable(scene: Scene) -> Iterator[str]:
    """Yield the addresses of removable parts: optional fields with a value, and members of lists."""
    yield from _removable(scene.entity(IT), IT)


def _removable(value: Model, address: str) -> Iterator[str]:
    for name, kind in field_types(type(value)).items():
        held, where = getattr(value, name), f"{address}.{name}"
        if kind.optional and held is not None:
            yield where
        if isinstance(held, tuple):
            for index, member in enumerate(held):  # type: ignore[reportUnknownVariableType]
                yield f"{where}.{index}"
                if isinstance(member, Model):
                    yield from _removable(member, f"{where}.{index}")
        elif isinstance(held, Model):
            yield from _removable(held, where)
