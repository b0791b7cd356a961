"""Changes of a scene that a question supposes: other values of numbers, and bodies held fixed."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace

from sim2reason.dsl.scene import Scene
from sim2reason.errors import TextError
from sim2reason.questions.derived_numbers import derived_numbers, number_at, with_numbers
from sim2reason.questions.structured import measured, resolved
from sim2reason.questions.words import Words

MOST = 6  # changes in one question
FIXED = "fixed"  # what a body is made, which then no longer moves
_PARTED = re.compile(r",\s+")
_CHANGE = re.compile(r"(?P<number>.+?)\s*(?P<sign>[=×*])\s*(?P<value>.+)")
_FIXED = re.compile(rf"(?P<body>.+?) {FIXED}")


@dataclass(frozen=True, slots=True)
class SceneChange:
    """Other values of some numbers of a scene, by address, and the addresses of bodies that are held fixed."""

    values: tuple[tuple[str, float], ...] = ()
    fixed: tuple[str, ...] = ()

    def applied(self, scene: Scene) -> Scene:
        """Return a scene with these changes; SceneError or ValueError if there is no such scene."""
        other = with_numbers(scene, dict(self.values)) if self.values else scene
        return other.gluing(*self.fixed) if self.fixed else other

    @property
    def told(self) -> str:
        """Return the changes as text, such as *ramp.angle = 30, box fixed*, for a structured question."""
        numbers = (f"{path} = {value:.15g}" for path, value in self.values)
        return ", ".join((*numbers, *(f"{body} {FIXED}" for body in self.fixed)))


def variation(said: str, scene: Scene, words: Words) -> SceneChange:
    """Return the changes that a structured question names, as in *ramp.angle = 30°, left.mass × 2, box fixed*.

    TextError if a change names no number or body of the scene, or has no value.
    """
    parts = _PARTED.split(said.strip())
    if len(parts) > MOST:
        raise TextError("change", f"there are {len(parts)} changes", f"give at most {MOST}")
    values, fixed, units = dict[str, float](), list[str](), units_of(scene)
    for part in parts:
        found, held = _CHANGE.fullmatch(part), _FIXED.fullmatch(part)
        if held is not None and found is None:
            fixed.append(_body(held["body"], scene, words))
            continue
        if found is None:
            raise TextError("change", f"{part!r} changes nothing", "say how, such as: ramp.speed = 5 m/s")
        path = resolved("change", found["number"], {path: words.named.get(path, path) for path in units})
        value = measured("change", found["value"], units[path] if found["sign"] == "=" else "")
        values[path] = value if found["sign"] == "=" else value * number_at(scene, path)
    return SceneChange(tuple(values.items()), tuple(fixed))


def _body(said: str, scene: Scene, words: Words) -> str:
    held = {name: words.mentions.get(name, name) for name in scene.builder.bodies}
    return resolved("change", said, held)


def units_of(scene: Scene) -> Mapping[str, str]:
    """Return the units of all numbers that the text of a scene states, derived ones included, by address."""
    said = {p.path: p.measure.unit for p in scene.parameters if p.value is not None and not p.hidden}
    return said | {path: number.unit for path, number in derived_numbers(scene).items()}


def words_in(scene: Scene, words: Words) -> Words:
    """Return the words for a changed scene, given those for the scene before the change."""
    said = units_of(scene)
    symbols = {path: symbol for path, symbol in words.symbols.items() if path in said}
    found = Words.of(scene, words.mentions, symbols, symbols)
    return replace(found, unknowns=[unknown for unknown in words.unknowns if unknown.path in said])
