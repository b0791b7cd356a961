"""Checks of stated and hidden numbers, and of declared ranges."""

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import cast

import numpy as np
from pydantic import ValidationError

from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.questions import SimulatedScene
from sim2reason.questions.unknown import find_limits
from sim2reason.scenes.dsl.choices import chances
from sim2reason.scenes.dsl.entity import Entity
from sim2reason.scenes.dsl.mechanism import CollisionPair, Mechanism, RigidBody, SurfaceContact
from sim2reason.scenes.dsl.model import Model, Parameter, draw, field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import ENGINES
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import (
    ENTITY_NAME,
    Specimen,
    Specimens,
    change_numbers,
    differences,
    specimen,
    stated_by_word,
    stated_numbers,
    studied,
)

SHIFT_FACTOR = 1.01
WORDING_COUNT = 3


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
        wordings = [set(stated_numbers(found.scene, seed)) for seed in range(found.seed, found.seed + WORDING_COUNT)]
        for parameter in found.scene.parameters:
            path, value = parameter.path, parameter.value
            if (
                parameter.hidden
                or not value
                or all(path in stated_paths for stated_paths in wordings)
                or stated_by_word(found.scene, path)
            ):
                continue
            other = studied(change_numbers(found.scene, {path: value * SHIFT_FACTOR}), found.scene.horizon)
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
    facts = {f"the mass of {body.name}": body.mass for body in mechanism.bodies}
    facts |= {f"the friction under {face.subject}": face.friction for face in mechanism.faces}
    facts |= {f"the restitution of {' and '.join(hit.names)}": hit.restitution for hit in mechanism.meetings}
    return {name: value for name, value in facts.items() if value not in (0.0, 1.0) and np.isfinite(value)}


def _decided(found: Specimen) -> set[str]:
    """Return which masses and coefficients of the mechanism change with some stated number."""
    before, decided = _facts(found.study.mechanism), set[str]()
    for path, parameter in stated_numbers(found.scene).items():
        other = change_numbers(found.scene, {path: (parameter.value or 0.0) * SHIFT_FACTOR})
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
    xx, yy, zz, xy, xz, yz = (SHIFT_FACTOR * part for part in body.inertia)
    return replace(body, mass=SHIFT_FACTOR * body.mass, inertia=(xx, yy, zz, xy, xz, yz))


def _rougher(face: SurfaceContact) -> SurfaceContact:
    return replace(face, friction=SHIFT_FACTOR * face.friction)


def _livelier(hit: CollisionPair) -> CollisionPair:
    return replace(hit, restitution=hit.restitution / SHIFT_FACTOR)


def _moved(found: Specimen, mechanism: Mechanism) -> SimulatedScene | None:
    try:
        return SimulatedScene(found.scene, ENGINES[RECORDED](mechanism, np.array([0.0, found.scene.horizon])))
    except (SimulationError, UnsupportedError):
        return None


HIDDEN_DRAWS = 3


@check
class HiddenNumbersCheck(Check):
    """Check that numbers marked `Hidden` change no answer."""

    name = "hidden numbers"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Draw all hidden numbers again, and compare all answers with the original ones."""
        for found in specimens.moving:
            rng = np.random.default_rng([found.seed, 7])
            hidden = [p for p in found.scene.parameters if p.hidden and p.value is not None]
            for _ in range(HIDDEN_DRAWS if hidden else 0):
                numbers = {parameter.path: _redrawn(found.scene, parameter, rng) for parameter in hidden}
                other = studied(change_numbers(found.scene, numbers), found.scene.horizon)
                difference = next(differences(found, other), None) if other is not None else None
                if difference is not None:
                    assignments = ", ".join(f"{path} = {value:g}" for path, value in numbers.items())
                    yield found.finding(
                        self.name,
                        "the same answers whatever the hidden numbers are",
                        f"with {assignments}, {difference.text}",
                        "say the number, or build so that nothing depends on it",
                    )
                    break


def _redrawn(scene: Scene, parameter: Parameter, rng: np.random.Generator) -> float:
    """Return another value from the field's declared range, or up to twice the value without a range."""
    owner, _, name = parameter.path.rpartition(".")
    field_type = field_types(type(cast("Model", scene.value(owner))))[name]
    value = parameter.value or 1.0
    low, high = (field_type.drawn.low, field_type.drawn.high) if field_type.drawn is not None else (value, 2.0 * value)
    return float(rng.uniform(low, high))


RANGE_DRAWS, MANY_DRAWS = 60, 300  # seeds of draws, and their number where a value seems to be constant
MIN_DRAWS = 12  # draws after which an unchanged value counts as constant
FRESH, MOST = 1000, 150  # first seed and number of extra scenes for a number that seems irrelevant
MIN_SCENES = 12  # scenes with a number after which it counts as irrelevant
SHIFT_FACTORS = (1.01, 0.99)


@check
class RangesCheck(Check):
    """Check that every declared number and choice varies between draws, and affects an answer in some scene."""

    name = "ranges"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Draw many entities, then change each number in turn."""
        for name in _constant(specimens.cls):
            yield Finding(
                self.name, f"{name} varies", f"it is the same in {MANY_DRAWS} draws", "widen its Range, or leave it out"
            )
        looked = _Looked()
        for member in specimens.moving:
            looked.at(member)
        for seed in range(FRESH, FRESH + MOST):
            if not looked.undecided_numbers:
                break
            looked.test_again(specimen(specimens.cls, seed))
        for name in looked.dead:
            others = f"nor of {looked.again_with[name]} others with this number"
            yield looked.seen[name].finding(
                self.name,
                f"in some scene an answer changes with {name}",
                f"none of {len(specimens.moving)} scenes has one, {others}",
                "leave out what does not matter, or mark it Hidden and do not say it",
            )


@dataclass
class _Looked:
    """The numbers of an entity tested so far: a scene that contains each, and which of them affect an answer."""

    seen: dict[str, Specimen] = field(default_factory=dict[str, Specimen])
    alive: set[str] = field(default_factory=set[str])
    again_with: Counter[str] = field(default_factory=Counter[str])  # in how many further scenes each was changed

    @property
    def dead(self) -> list[str]:
        """Return the tested numbers that have affected no answer so far."""
        return sorted(self.seen.keys() - self.alive)

    @property
    def undecided_numbers(self) -> list[str]:
        """Return the numbers that have affected no answer, but in too few scenes to be called irrelevant."""
        return [name for name in self.dead if self.again_with[name] < MIN_SCENES]

    def at(self, found: Specimen, only: Collection[str] | None = None) -> None:
        """Change each number of a scene that is not yet known to affect an answer, and record the result."""
        for path in stated_numbers(found.scene, found.seed):
            name = _field(path)
            if path.startswith(f"{ENTITY_NAME}.") and name not in self.alive and (only is None or name in only):
                self.seen.setdefault(name, found)
                if _matters(found, path):
                    self.alive.add(name)

    def test_again(self, found: Specimen) -> None:
        """Change the numbers that seem irrelevant in one more scene, to find an answer that they affect."""
        if found.moves:
            dead = self.undecided_numbers
            self.again_with.update(
                {_field(path) for path in stated_numbers(found.scene, found.seed)}.intersection(dead)
            )
            self.at(found, dead)


def _field(path: str) -> str:
    """Return the address of a number with ``*`` in place of list indices, as in ``blocks.*.mass``."""
    return ".".join("*" if step.isdigit() else step for step in path.split("."))


def _matters(member: Specimen, path: str) -> bool:
    """Return whether changing a number changes an answer."""
    value = next(p.value for p in member.scene.parameters if p.path == path) or 0.0
    candidates = [value * shift if value else shift - 1.0 for shift in SHIFT_FACTORS]
    owner, _, name = path.rpartition(".")
    kind = cast("type[Model]", type(member.scene.value(owner)))
    if field_types(kind)[name].above:  # a limit, which matters where it lies beyond another
        candidates += find_limits(member.scene, path)
    for other in candidates:
        scene = change_numbers(member.scene, {path: other})
        if scene is not None:
            again = studied(scene, member.scene.horizon)
            if again is None or next(differences(member, again), None) is not None:
                return True
    return False


def _constant(cls: type[Entity]) -> list[str]:
    """Return the declared ranges and choices that never vary."""
    values: dict[str, list[object]] = {}
    for seed in range(MANY_DRAWS):
        if seed >= RANGE_DRAWS and not _constant_names(values):
            break
        try:
            entity = draw(cls, np.random.default_rng([seed, 3]), chances(cls))
        except (SceneError, ValidationError):
            continue
        for name, value in _varying(entity):
            values.setdefault(name, []).append(value)
    return _constant_names(values)


def _constant_names(values: Mapping[str, list[object]]) -> list[str]:
    """Return the names with many drawn values that are all equal."""
    return sorted(name for name, draws in values.items() if len(draws) >= MIN_DRAWS and len(set(draws)) == 1)


def _varying(value: Model) -> Iterator[tuple[str, object]]:
    """Yield all randomly drawn values of an object and its parts: numbers, choices, and counts of members."""
    for name, kind in field_types(type(value)).items():
        field_value, called = getattr(value, name), f"{type(value).__name__}.{name}"
        if kind.optional:
            yield f"whether there is {called}", field_value is not None
        if field_value is not None and (kind.drawn is not None or kind.words):
            yield called, field_value
        if isinstance(field_value, tuple) and kind.count is not None and kind.count.low < kind.count.high:
            yield f"the number of {called}", len(field_value)  # type: ignore[reportUnknownArgumentType]
        for member in field_value if isinstance(field_value, tuple) else (field_value,):  # type: ignore[reportUnknownVariableType]
            if isinstance(member, Model):
                yield from _varying(member)
