"""Changes of a scene that a question supposes: other values of numbers, bodies held fixed, and things removed."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from sim2reason.errors import TextError
from sim2reason.questions.derived_numbers import derived_numbers, number_at, with_numbers
from sim2reason.questions.removal import after_removal, removable
from sim2reason.questions.structured import CHANGE, REMOVAL, measured, resolved
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.scene import Scene

MOST = 6  # changes in one question
FIXED = "fixed"  # what a body is made, which then no longer moves
REMOVED = "removed"  # what ceases to act at some moment of the motion: a string that is cut, a field switched off
_PARTED = re.compile(r",\s+")
_FIXED = re.compile(rf"(?P<body>.+?) {FIXED}")
_TIME = re.compile(r"(?:t = )?[\d.]\S* \S+|(?:t = )?[\d.]\S*")


@dataclass(frozen=True, slots=True)
class SceneChange:
    """Other values of some numbers of a scene, by address, and the addresses of bodies that are held fixed.

    Lines, hands and fields that are `removed`, by name, cease to act at the time `after`, s; the changed scene is then
    that from this time on.
    """

    values: tuple[tuple[str, float], ...] = ()
    fixed: tuple[str, ...] = ()
    removed: tuple[str, ...] = ()
    after: float = 0.0

    def applied(self, scene: Scene) -> Scene:
        """Return a scene with these changes; SceneError or ValueError if there is no such scene."""
        other = with_numbers(scene, dict(self.values)) if self.values else scene
        other = other.gluing(*self.fixed) if self.fixed else other
        return after_removal(other, self.removed, self.after) if self.removed else other

    @property
    def told(self) -> str:
        """Return the changes as text, such as *ramp.angle = 30, box fixed*, for a structured question."""
        numbers = (f"{path} = {value:.15g}" for path, value in self.values)
        removed = (f"{name} {REMOVED} at {self.after:.15g} s" for name in self.removed)
        return ", ".join((*numbers, *(f"{body} {FIXED}" for body in self.fixed), *removed))


def variation(said: str, scene: Scene, words: Words, time_of: Callable[[str, SceneChange], float]) -> SceneChange:
    """Return the changes that a structured question names, as in *ramp.angle = 30°, left.mass × 2, box fixed*.

    As in *tendon_1 removed at 1.5 s*, something may be removed in the course of the motion, at a time or at a moment,
    whose time in the otherwise changed scene, s, `time_of` returns.

    TextError if a change names no number or body of the scene, or has no value; or if there are two times.
    """
    parts = _PARTED.split(said.strip())
    if len(parts) > MOST:
        raise TextError("change", f"there are {len(parts)} changes", f"give at most {MOST}")
    values, fixed, units, removed = dict[str, float](), list[str](), units_of(scene), dict[str, str]()
    for part in parts:
        gone = REMOVAL.fullmatch(part)
        if gone is not None and CHANGE.fullmatch(gone["what"]) is None:
            removed[resolved("change", gone["what"], removable(words))] = gone["when"] or ""
            continue
        found, held = CHANGE.fullmatch(part), _FIXED.fullmatch(part)
        if held is not None and found is None:
            fixed.append(_body(held["body"], scene, words))
            continue
        if found is None:
            raise TextError("change", f"{part!r} changes nothing", "say how, such as: ramp.speed = 5 m/s")
        path = resolved("change", found["number"], {path: words.named.get(path, path) for path in units})
        value = measured("change", found["value"], units[path] if found["sign"] == "=" else "")
        values[path] = value if found["sign"] == "=" else value * number_at(scene, path)
    change = SceneChange(tuple(values.items()), tuple(fixed))
    return _removing(removed, change, words, time_of) if removed else change


def _removing(
    removed: Mapping[str, str], change: SceneChange, words: Words, time_of: Callable[[str, SceneChange], float]
) -> SceneChange:
    """Return a change with the removal of what is named, all at one moment, by default the start."""
    if len(whens := set(removed.values())) > 1:
        raise TextError("change", "there are several moments at which something is removed", "give one moment")
    when = whens.pop()
    if not when or when in ("start", "at start"):
        after = 0.0
    elif _TIME.fullmatch(when):
        after = measured("change", when.removeprefix("t = "), words.units.spell("s"))
    else:
        after = time_of(when, change)
    return replace(change, removed=tuple(removed), after=after)


def is_removal(said: str) -> bool:
    """Return whether one of the changes that a structured question names is the removal of something."""
    return any(map(REMOVAL.fullmatch, _PARTED.split(said)))


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
