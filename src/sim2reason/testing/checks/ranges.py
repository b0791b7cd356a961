"""Check of declared ranges."""

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from typing import cast

import numpy as np
from pydantic import ValidationError

from sim2reason.errors import SceneError
from sim2reason.questions.unknown import limits_of
from sim2reason.scenes.dsl.choices import chances
from sim2reason.scenes.dsl.entity import Entity
from sim2reason.scenes.dsl.model import Model, draw, field_types
from sim2reason.testing.answers import differences
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import IT, Specimen, Specimens, changed, specimen, stated_numbers, studied

DRAWS, MANY = 60, 300  # seeds of draws, and their number where a value seems to be constant
OFTEN = 12  # draws after which an unchanged value counts as constant
FRESH, MOST = 1000, 150  # first seed and number of extra scenes for a number that seems irrelevant
MORE = 12  # scenes with a number after which it counts as irrelevant
SHIFTS = (1.01, 0.99)


@check
class RangesCheck(Check):
    """Check that every declared number and choice varies between draws, and affects an answer in some scene."""

    name = "ranges"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Draw many entities, then change each number in turn."""
        for name in _constant(specimens.cls):
            yield Finding(
                self.name, f"{name} varies", f"it is the same in {MANY} draws", "widen its Range, or leave it out"
            )
        looked = _Looked()
        for found in specimens.moving:
            looked.at(found)
        for seed in range(FRESH, FRESH + MOST):
            if not looked.open:
                break
            looked.again(specimen(specimens.cls, seed))
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
    def open(self) -> list[str]:
        """Return the numbers that have affected no answer, but in too few scenes to be called irrelevant."""
        return [name for name in self.dead if self.again_with[name] < MORE]

    def at(self, found: Specimen, only: Collection[str] | None = None) -> None:
        """Change each number of a scene that is not yet known to affect an answer, and record the result."""
        for path in stated_numbers(found.scene, found.seed):
            name = _field(path)
            if path.startswith(f"{IT}.") and name not in self.alive and (only is None or name in only):
                self.seen.setdefault(name, found)
                if _matters(found, path):
                    self.alive.add(name)

    def again(self, found: Specimen) -> None:
        """Change the numbers that seem irrelevant in one more scene, to find an answer that they affect."""
        if found.moves:
            dead = self.open
            self.again_with.update(
                {_field(path) for path in stated_numbers(found.scene, found.seed)}.intersection(dead)
            )
            self.at(found, dead)


def _field(path: str) -> str:
    """Return the address of a number with ``*`` in place of list indices, as in ``blocks.*.mass``."""
    return ".".join("*" if step.isdigit() else step for step in path.split("."))


def _matters(found: Specimen, path: str) -> bool:
    """Return whether changing a number changes an answer."""
    value = next(p.value for p in found.scene.parameters if p.path == path) or 0.0
    tried = [value * shift if value else shift - 1.0 for shift in SHIFTS]
    owner, _, name = path.rpartition(".")
    kind = cast("type[Model]", type(found.scene.value(owner)))
    if field_types(kind)[name].above:  # a limit, which matters where it lies beyond another
        tried += limits_of(found.scene, path)
    for other in tried:
        scene = changed(found.scene, {path: other})
        if scene is not None:
            again = studied(scene, found.scene.horizon)
            if again is None or next(differences(found, again), None) is not None:
                return True
    return False


def _constant(cls: type[Entity]) -> list[str]:
    """Return the declared ranges and choices that never vary."""
    values: dict[str, list[object]] = {}
    for seed in range(MANY):
        if seed >= DRAWS and not _alike(values):
            break
        try:
            entity = draw(cls, np.random.default_rng([seed, 3]), chances(cls))
        except (SceneError, ValidationError):
            continue
        for name, value in _varying(entity):
            values.setdefault(name, []).append(value)
    return _alike(values)


def _alike(values: Mapping[str, list[object]]) -> list[str]:
    """Return the names with many drawn values that are all equal."""
    return sorted(name for name, held in values.items() if len(held) >= OFTEN and len(set(held)) == 1)


def _varying(value: Model) -> Iterator[tuple[str, object]]:
    """Yield all randomly drawn values of an object and its parts: numbers, choices, and counts of members."""
    for name, kind in field_types(type(value)).items():
        held, called = getattr(value, name), f"{type(value).__name__}.{name}"
        if kind.optional:
            yield f"whether there is {called}", held is not None
        if held is not None and (kind.drawn is not None or kind.words):
            yield called, held
        if isinstance(held, tuple) and kind.count is not None and kind.count.low < kind.count.high:
            yield f"the number of {called}", len(held)  # type: ignore[reportUnknownArgumentType]
        for member in held if isinstance(held, tuple) else (held,):  # type: ignore[reportUnknownVariableType]
            if isinstance(member, Model):
                yield from _varying(member)
