"""Checks of stated and hidden numbers."""

from collections.abc import Iterator
from dataclasses import replace
from typing import cast

import numpy as np

from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.questions import SimulatedScene
from sim2reason.scenes.dsl.mechanism import CollisionPair, Mechanism, RigidBody, SurfaceContact
from sim2reason.scenes.dsl.model import Model, Parameter, field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import ENGINES
from sim2reason.testing.answers import differences
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens, changed, stated_by_word, stated_numbers, studied

SHIFT = 1.01
WORDINGS = 3


@check
class GivensCheck(Check):
    """Check that every number on which an answer depends is stated, in every wording, and no other."""

    name = "givens"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Change each number that the text does not state, and compare all answers with the original ones."""
        for found in specimens.moving:
            yield from self._declared(found)
            yield from self._undeclared(found)

    def _declared(self, found: Specimen) -> Iterator[Finding]:
        """Yield findings for numbers of the scene that matter but are missing in some wording."""
        heard = [set(stated_numbers(found.scene, seed)) for seed in range(found.seed, found.seed + WORDINGS)]
        for parameter in found.scene.parameters:
            path, value = parameter.path, parameter.value
            if (
                parameter.hidden
                or not value
                or all(path in said for said in heard)
                or stated_by_word(found.scene, path)
            ):
                continue
            other = studied(changed(found.scene, {path: value * SHIFT}), found.scene.horizon)
            difference = next(differences(found, other), None) if other is not None else None
            if difference is not None:
                yield found.finding(
                    self.name,
                    f"the text says {path}, on which answers depend",
                    f"it does not, and with {path} 1 % larger {difference.text}",
                    "say it in every wording of a line",
                )

    def _undeclared(self, found: Specimen) -> Iterator[Finding]:
        """Yield findings for masses, friction and restitution that affect answers but follow from no stated number."""
        mechanism = found.study.mechanism
        for name, other in _shifted(mechanism):
            if name in _decided(found):
                continue
            difference = next(differences(found, study), None) if (study := _moved(found, other)) else None
            if difference is not None:
                yield found.finding(
                    self.name,
                    f"{name} follows from what the text says",
                    f"it does not, and with it 1 % larger {difference.text}",
                    "declare it as a field with a Measure, and say it",
                )


def _facts(mechanism: Mechanism) -> dict[str, float]:
    """Return the masses and the friction and restitution coefficients of a mechanism, by description."""
    found = {f"the mass of {body.name}": body.mass for body in mechanism.bodies}
    found |= {f"the friction under {face.subject}": face.friction for face in mechanism.faces}
    found |= {f"the restitution of {' and '.join(hit.names)}": hit.restitution for hit in mechanism.meetings}
    return {name: value for name, value in found.items() if value not in (0.0, 1.0) and np.isfinite(value)}


def _decided(found: Specimen) -> set[str]:
    """Return which masses and coefficients of the mechanism change with some stated number."""
    before, decided = _facts(found.study.mechanism), set[str]()
    for path, parameter in stated_numbers(found.scene).items():
        other = changed(found.scene, {path: (parameter.value or 0.0) * SHIFT})
        if other is not None and parameter.value:
            after = _facts(other.mechanism)
            decided |= {name for name, value in before.items() if after.get(name) != value}
    return decided


def _shifted(mechanism: Mechanism) -> Iterator[tuple[str, Mechanism]]:
    """Yield the mechanism with one mass or coefficient changed at a time, with its description."""
    for name in _facts(mechanism):
        bodies = tuple(_heavier(body) if name == f"the mass of {body.name}" else body for body in mechanism.bodies)
        faces = tuple(
            _rougher(face) if name == f"the friction under {face.subject}" else face for face in mechanism.faces
        )
        hits = tuple(
            _livelier(hit) if name == f"the restitution of {' and '.join(hit.names)}" else hit
            for hit in mechanism.meetings
        )
        yield name, replace(mechanism, bodies=bodies, faces=faces, meetings=hits)


def _heavier(body: RigidBody) -> RigidBody:
    xx, yy, zz, xy, xz, yz = (SHIFT * part for part in body.inertia)
    return replace(body, mass=SHIFT * body.mass, inertia=(xx, yy, zz, xy, xz, yz))


def _rougher(face: SurfaceContact) -> SurfaceContact:
    return replace(face, friction=SHIFT * face.friction)


def _livelier(hit: CollisionPair) -> CollisionPair:
    return replace(hit, restitution=hit.restitution / SHIFT)


def _moved(found: Specimen, mechanism: Mechanism) -> SimulatedScene | None:
    try:
        return SimulatedScene(found.scene, ENGINES[RECORDED](mechanism, np.array([0.0, found.scene.horizon])))
    except (SimulationError, UnsupportedError):
        return None


DRAWS = 3


@check
class HiddenNumbersCheck(Check):
    """Check that numbers marked `Hidden` change no answer."""

    name = "hidden numbers"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Draw all hidden numbers again, and compare all answers with the original ones."""
        for found in specimens.moving:
            rng = np.random.default_rng([found.seed, 7])
            hidden = [p for p in found.scene.parameters if p.hidden and p.value is not None]
            for _ in range(DRAWS if hidden else 0):
                numbers = {parameter.path: _redrawn(found.scene, parameter, rng) for parameter in hidden}
                other = studied(changed(found.scene, numbers), found.scene.horizon)
                difference = next(differences(found, other), None) if other is not None else None
                if difference is not None:
                    said = ", ".join(f"{path} = {value:g}" for path, value in numbers.items())
                    yield found.finding(
                        self.name,
                        "the same answers whatever the hidden numbers are",
                        f"with {said}, {difference.text}",
                        "say the number, or build so that nothing depends on it",
                    )
                    break


def _redrawn(scene: Scene, parameter: Parameter, rng: np.random.Generator) -> float:
    """Return another value from the field's declared range, or up to twice the value without a range."""
    owner, _, name = parameter.path.rpartition(".")
    held = field_types(type(cast("Model", scene.value(owner))))[name]
    value = parameter.value or 1.0
    low, high = (held.drawn.low, held.drawn.high) if held.drawn is not None else (value, 2.0 * value)
    return float(rng.uniform(low, high))
