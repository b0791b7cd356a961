"""Changes of a scene that a question supposes: other numbers, fixed bodies, removed objects."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.errors import TextError, UnsupportedError
from sim2reason.questions.structured import CHANGE, REMOVAL, parse_amount, resolve_name
from sim2reason.questions.unknown import derived_numbers, number_at, with_numbers
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Magnetic, Push
from sim2reason.scenes.dsl.mechanism import Force, Inextensible, Mechanism
from sim2reason.scenes.dsl.model import replace_validated
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import displace
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.quantities.subjects.interactions import Hands, Springs, Strings
from sim2reason.simulation.quantities.subjects.rotating_parts import Rods, SwingingLines
from sim2reason.simulation.trace import ENGINES

SAMPLES = 41
FIELDS = {"magnetic": "the magnetic field", "electric": "the electric field"}


class SceneAfterRemoval(Scene):
    """A scene from the time `after`, s, on, without the lines and forces named in `removed`.

    Its motion begins, at t = 0, with the places and velocities that the scene's bodies have at that time.
    """

    removed: tuple[str, ...]
    after: float

    @cached_property
    def mechanism(self) -> Mechanism:
        """Return the mechanism without the removed parts, in its state at the time of removal.

        Raises:
            SimulationError: the motion cannot be solved.
            UnsupportedError: the motion ends before, or its state is more than places and velocities.
        """
        original = self.builder.finish()
        trace = ENGINES[RECORDED](original, np.linspace(0.0, self.after, SAMPLES))
        if trace.stable_until < self.after or float(trace.state.times[-1]) < self.after:
            raise UnsupportedError(f"the motion is not described until {self.after:g} s")
        _refuse_memory(original)
        state = trace.at(self.after)
        there = displace(original, state.q[0].tolist(), state.v[0].tolist())
        return replace(
            _without_lines(there, frozenset(self.removed)),
            forces=tuple(_later(force, self.after) for force in there.forces if force.name not in self.removed),
        )


def _without_lines(mechanism: Mechanism, removed: frozenset[str]) -> Mechanism:
    """Return a mechanism without some lines, and without massless parts that only these lines loaded.

    A light movable pulley whose load is cut off stays behind, with its string without tension.
    """
    gone = [line for line in mechanism.lines if line.whole in removed]
    at = {site.name: site.body for site in mechanism.site.values()}
    light = {body.name for body in mechanism.bodies if not body.mass and body.coordinates}
    light -= {body.parent for body in mechanism.bodies}
    idle, slack = set[str](), set(removed)
    for name in light & {at[site] for line in gone for site in line.through}:
        others = {line.whole for line in mechanism.lines if name in {at[site] for site in line.through}} - removed
        if len(others) == 1:
            idle.add(name)
            slack |= others
    bodies = tuple(replace(body, coordinates=()) if body.name in idle else body for body in mechanism.bodies)
    lines = tuple(line for line in mechanism.lines if line.whole not in slack)
    return replace(mechanism, bodies=bodies, lines=lines)


def _refuse_memory(mechanism: Mechanism) -> None:
    """Raise UnsupportedError for a mechanism whose future depends on more than its positions and velocities."""
    reeled = any(isinstance(line.law, Inextensible) and line.law.reel for line in mechanism.lines)
    sticks = any(meeting.sticks for meeting in mechanism.meetings)
    if reeled or sticks or mechanism.burns or mechanism.feet:
        raise UnsupportedError("nothing can be removed in the course of such a motion")


def _later(force: Force, after: float) -> Force:
    """Return a force with its time origin shifted by `after` seconds."""
    law = force.law
    if not isinstance(law, Push | Magnetic) or law.profile.steady:
        return force
    profile = law.profile
    later = replace(
        profile, value=profile.value + profile.rate * after, phase=profile.phase + profile.frequency * after
    )
    return replace(force, law=replace(law, profile=later))


def find_removable(words: Words) -> Mapping[str, str]:
    """Return the text's phrases for everything that can be removed, by name: lines, hands and fields."""
    mechanism = words.mechanism
    kinds = (Strings(), SwingingLines(), Springs(), Rods(), Hands())
    named = {name: phrase for kind in kinds for name, phrase in words.subject_phrases(kind).items()}
    line_by_part = {line.name: line.whole for line in mechanism.lines}
    phrases = {line_by_part[name]: phrase for name, phrase in named.items() if name in line_by_part}
    forces = {force.name: FIELDS.get(force.name.rpartition(".")[2], "") for force in mechanism.forces}
    return phrases | {name: phrase for name, phrase in forces.items() if phrase}


def after_removal(scene: Scene, removed: tuple[str, ...], after: float) -> Scene:
    """Return a scene from the time `after`, s, on, without some lines and forces, given by name."""
    fields = {name: getattr(scene, name) for name in Scene.model_fields}
    return replace_validated(SceneAfterRemoval(**fields, removed=removed, after=after))


MAX_CHANGES = 6  # greatest number of changes in one question
FIXED_KEYWORD = "fixed"  # the keyword for a body that no longer moves
REMOVED_KEYWORD = "removed"  # the keyword for an object that ceases to act, such as a cut string
_PARTED = re.compile(r",\s+")
_FIXED = re.compile(rf"(?P<body>.+?) {FIXED_KEYWORD}")
_TIME = re.compile(r"(?:t = )?[\d.]\S* \S+|(?:t = )?[\d.]\S*")


@dataclass(frozen=True, slots=True)
class SceneChange:
    """Changed numbers of a scene, by address, and bodies held fixed.

    Lines, hands and fields that are `removed`, by name, cease to act at the time `after`, s; the changed scene is then
    that from this time on.
    """

    values: tuple[tuple[str, float], ...] = ()
    fixed: tuple[str, ...] = ()
    removed: tuple[str, ...] = ()
    after: float = 0.0

    def applied(self, scene: Scene) -> Scene:
        """Return a scene with the changes applied; SceneError or ValueError if it is invalid."""
        other = with_numbers(scene, dict(self.values)) if self.values else scene
        other = other.gluing(*self.fixed) if self.fixed else other
        return after_removal(other, self.removed, self.after) if self.removed else other

    @property
    def text(self) -> str:
        """Return the changes as text, such as *ramp.angle = 30, box fixed*, for a structured question."""
        numbers = (f"{path} = {value:.15g}" for path, value in self.values)
        removed = (f"{name} {REMOVED_KEYWORD} at {self.after:.15g} s" for name in self.removed)
        return ", ".join((*numbers, *(f"{body} {FIXED_KEYWORD}" for body in self.fixed), *removed))


def variation(text: str, scene: Scene, words: Words, time_of: Callable[[str, SceneChange], float]) -> SceneChange:
    """Return the changes that a structured question names, as in *ramp.angle = 30°, left.mass × 2, box fixed*.

    As in *tendon_1 removed at 1.5 s*, something may be removed in the course of the motion, at a time or at a moment,
    whose time in the otherwise changed scene, s, `time_of` returns.

    TextError if a change names no number or body of the scene, or has no value; or if there are two times.
    """
    parts = _PARTED.split(text.strip())
    if len(parts) > MAX_CHANGES:
        raise TextError("change", f"there are {len(parts)} changes", f"give at most {MAX_CHANGES}")
    values, fixed, units, removed = dict[str, float](), list[str](), units_of(scene), dict[str, str]()
    for part in parts:
        gone = REMOVAL.fullmatch(part)
        if gone is not None and CHANGE.fullmatch(gone["what"]) is None:
            removed[resolve_name("change", gone["what"], find_removable(words))] = gone["when"] or ""
            continue
        match, fixed_match = CHANGE.fullmatch(part), _FIXED.fullmatch(part)
        if fixed_match is not None and match is None:
            fixed.append(_body(fixed_match["body"], scene, words))
            continue
        if match is None:
            raise TextError("change", f"{part!r} changes nothing", "say how, such as: ramp.speed = 5 m/s")
        path = resolve_name("change", match["number"], {path: words.named.get(path, path) for path in units})
        value = parse_amount("change", match["value"], units[path] if match["sign"] == "=" else "")
        values[path] = value if match["sign"] == "=" else value * number_at(scene, path)
    change = SceneChange(tuple(values.items()), tuple(fixed))
    return _removing(removed, change, words, time_of) if removed else change


def _removing(
    removed: Mapping[str, str], change: SceneChange, words: Words, time_of: Callable[[str, SceneChange], float]
) -> SceneChange:
    """Return a change extended by removals, all at one time, by default the start."""
    if len(whens := set(removed.values())) > 1:
        raise TextError("change", "there are several moments at which something is removed", "give one moment")
    when = whens.pop()
    if not when or when in ("start", "at start"):
        after = 0.0
    elif _TIME.fullmatch(when):
        after = parse_amount("change", when.removeprefix("t = "), words.units.spell("s"))
    else:
        after = time_of(when, change)
    return replace(change, removed=tuple(removed), after=after)


def is_removal(text: str) -> bool:
    """Return whether one of the changes that a structured question names is the removal of something."""
    return any(map(REMOVAL.fullmatch, _PARTED.split(text)))


def _body(text: str, scene: Scene, words: Words) -> str:
    mentions = {name: words.mentions.get(name, name) for name in scene.builder.bodies}
    return resolve_name("change", text, mentions)


def units_of(scene: Scene) -> Mapping[str, str]:
    """Return the units of all numbers that the text of a scene states, derived ones included, by address."""
    stated_units = {p.path: p.measure.unit for p in scene.parameters if p.value is not None and not p.hidden}
    return stated_units | {path: number.unit for path, number in derived_numbers(scene).items()}


def words_in(scene: Scene, words: Words) -> Words:
    """Return the words for a changed scene, given those for the scene before the change."""
    stated_units = units_of(scene)
    symbols = {path: symbol for path, symbol in words.symbols.items() if path in stated_units}
    new_words = Words.of(scene, words.mentions, symbols, symbols)
    return replace(new_words, unknowns=[unknown for unknown in words.unknowns if unknown.path in stated_units])
