"""Random scenes of one entity class, their variants, and the comparison of their answers."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from pydantic import ValidationError

from sim2reason.base.records import cached_property
from sim2reason.errors import DrawError, SceneError, SimulationError, UnsupportedError
from sim2reason.questions import SimulatedScene, Target, Words
from sim2reason.questions.choices import is_clear_of_events
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import Targets, targets
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.choices import choices, close_ports
from sim2reason.scenes.dsl.entity import Entity, Named, Part
from sim2reason.scenes.dsl.model import Model, Parameter, draw, replace_validated
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.units import Dimension, parse_unit
from sim2reason.scenes.files import dump
from sim2reason.simulation.certify import Certificate, certify_trace
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import Event, Trace
from sim2reason.testing.report import Finding
from sim2reason.text.prose.description import Description, describe
from sim2reason.text.prose.voices import numeric


def change_numbers(scene: Scene, numbers: Mapping[str, float]) -> Scene | None:
    """Return a scene with several numbers changed at once, by address; None if it is invalid."""
    try:
        entities = tuple(replace_validated(n, entity=_with(n.entity, n.name, numbers)) for n in scene.entities)
        joined = tuple(_with(c, f"{c.key}_{i}", numbers) for i, c in enumerate(scene.connections, 1))
        return replace_validated(
            scene, entities=entities, connections=joined, world=_with(scene.world, "world", numbers)
        )
    except (SceneError, ValidationError):
        return None


def _with(value: Any, address: str, numbers: Mapping[str, float]) -> Any:  # noqa: ANN401 - a field holds anything
    if address in numbers:
        return numbers[address]
    if isinstance(value, tuple):
        members = cast("tuple[Any, ...]", value)
        return tuple(_with(member, f"{address}.{index}", numbers) for index, member in enumerate(members))
    if not isinstance(value, Model) or not any(path.startswith(f"{address}.") for path in numbers):
        return value
    fields = {name: _with(getattr(value, name), f"{address}.{name}", numbers) for name in type(value).model_fields}
    return type(value)(**fields)


def studied(scene: Scene | None, duration: float) -> SimulatedScene | None:
    """Return a simulated scene; None if it cannot be simulated."""
    if scene is None:
        return None
    try:
        return SimulatedScene.of(scene, np.array([0.0, duration]))
    except (SceneError, SimulationError, UnsupportedError):
        return None


def stated_numbers(scene: Scene, seed: int = 0) -> dict[str, Parameter]:
    """Return the numbers that a text states as numbers, by address, without those stated by words."""
    parameters: dict[str, Parameter] = {}

    def heard(parameter: Parameter, symbol: str) -> str:
        parameters[parameter.path] = parameter
        return numeric(parameter, symbol)

    describe(scene, seed, heard)
    return parameters


def stated_by_word(scene: Scene, path: str) -> bool:
    """Return whether a word states a number, as *smooth* states zero friction."""
    owner, _, name = path.rpartition(".")
    body = scene.bodies.get(owner)
    if body is not None:
        return _worded(body, name) or body.is_stated_by_word(name)
    part = scene.value(owner) if owner != "world" else None
    return isinstance(part, Part) and (_worded(part, name) or type(part).is_stated_by_word(name, getattr(part, name)))


def _worded(value: Body | Part, name: str) -> bool:
    field_value = getattr(value, name)
    return any(word.parameter == name and field_value in word.special for word in value.words.values())


ENTITY_NAME = "it"  # name of the entity in its scenes
SAMPLES = 41
TRIES = 40  # draws for one scene
NARROW_DRAWS = 8  # first draws, in which ports are closed by entities without bodies
MAX_CHOOSY_DRAWS = 24  # draws after which a scene without motion or questions is accepted
MIN_MOTION_FRACTION = 0.05  # of the horizon: shortest certified motion
REST_TOLERANCE = 1e-6  # m, m/s or rad; smaller changes are no motion


@dataclass(frozen=True)
class Specimen:
    """A scene with one entity of the tested class, named *it*, with its text and motion cached for all checks."""

    seed: int
    scene: Scene

    @cached_property
    def file(self) -> str:
        """Return the text of its scene file."""
        return dump(self.scene)

    @cached_property
    def description(self) -> Description:
        """Return the text of the scene."""
        return describe(self.scene, self.seed)

    @cached_property
    def words(self) -> Words:
        """Return the context of questions from its text."""
        return words_of(self.description)

    @cached_property
    def study(self) -> SimulatedScene:
        """Return its motion by the recorded engine; it raises the engine's errors."""
        return SimulatedScene.of(self.scene, np.linspace(0.0, self.scene.horizon, SAMPLES))

    @cached_property
    def targets(self) -> Targets:
        """Return all possible targets (quantity and subject) of questions about the specimen's motion."""
        return targets(self.words)

    @cached_property
    def certified(self) -> tuple[Trace, Certificate]:
        """Return the scene's motion up to the time until which both engines agree, with the certificate."""
        return certify_trace(self.study.trace)

    @cached_property
    def end(self) -> float:
        """Return the end of the certified motion, s; 0 if the engine refuses the scene."""
        try:
            return min(self.study.trace.stable_until, self.scene.horizon)
        except (SimulationError, UnsupportedError):
            return 0.0

    @property
    def moves(self) -> bool:
        """Return whether anything in it moves enough to be checked."""
        if self.end <= MIN_MOTION_FRACTION * self.scene.horizon:
            return False
        state = self.study.trace.state
        return bool(max(np.abs(state.q).max(initial=0.0), np.abs(state.v).max(initial=0.0)) > REST_TOLERANCE)

    def finding(self, check: str, expected: str, found: str, remedy: str) -> Finding:
        """Return a finding about this scene."""
        return Finding(check, expected, found, remedy, self.seed, self.file)


@dataclass(frozen=True)
class Specimens:
    """The scenes of one entity class; `deep` requests more thorough, slower checks."""

    cls: type[Entity]
    members: tuple[Specimen, ...]
    deep: bool = False

    @property
    def moving(self) -> tuple[Specimen, ...]:
        """Return the scenes in which something moves."""
        return tuple(member for member in self.members if member.moves)

    def some(self, number: int) -> tuple[Specimen, ...]:
        """Return the first `number` scenes; all of them if `deep`."""
        return self.members if self.deep else self.members[:number]


def specimen(cls: type[Entity], seed: int) -> Specimen:
    """Return a random scene of an entity class, if possible one that allows questions, by seed.

    Raises:
        DrawError: nothing that fits together was drawn within the budget; the message tells the last refusal.
    """
    refused, still = "", None
    for attempt in range(TRIES):
        rng = np.random.default_rng([seed, attempt])
        try:
            entity = draw(cls, rng, choices(cls, rng))
            candidate = Specimen(
                seed, close_ports(Named(name=ENTITY_NAME, entity=entity), rng, widely=attempt >= NARROW_DRAWS)
            )
            candidate.scene.check()
            _ = candidate.description  # also what can't be told is drawn again
            moves = candidate.moves  # and what an engine says can not be
        except (SceneError, ValidationError) as error:
            refused = str(error)
            continue
        if moves and candidate.targets:
            return candidate
        still = still or candidate
        if attempt >= MAX_CHOOSY_DRAWS:
            break
    if still is None:
        raise DrawError(f"{cls.__name__}: none of {TRIES} draws is a scene; the last: {refused}")
    return still


ANSWER_RTOL = 1e-6  # relative to the largest value of the quantity
MOMENT_FRACTIONS = (0.0, 0.19, 0.46, 0.73, 0.97)  # fractions of the common motion
SOON, LATE = 1e-6, 1.0 - 1e-4  # fractions of the common motion between which events are counted


@dataclass(frozen=True)
class Difference:
    """A question that two motions answer differently, with both answers."""

    asked: str
    expected: float
    found: float

    @property
    def text(self) -> str:
        """Return the query and both answers as text."""
        return f"{self.asked}: {self.found:.9g} in place of {self.expected:.9g}"


def unit_factor(dimension: Dimension) -> float:
    """Return 1, the expected ratio of two equal motions' answers, whatever the dimension."""
    del dimension
    return 1.0


def differences(
    specimen: Specimen,
    other: SimulatedScene,
    factor: Callable[[Dimension], float] = unit_factor,
    close: float = ANSWER_RTOL,
) -> Iterator[Difference]:
    """Yield the questions whose answers differ between two motions, beyond the expected `factor`.

    Only the common interval of both motions is compared.
    """
    stretch = factor(Dimension(time=1))
    end = min(specimen.end, min(other.trace.stable_until, float(other.trace.state.times[-1])) / stretch)
    times = [
        t for t in (part * end for part in MOMENT_FRACTIONS) if t == 0.0 or is_clear_of_events(t, specimen.study.trace)
    ]
    yield from _parted(_events(specimen.study.trace, end, 1.0), _events(other.trace, end, stretch), end, close)
    here = _values(list(specimen.targets), specimen.study.trace, times, 1.0)
    there = _values(list(specimen.targets), other.trace, times, stretch)
    scales: dict[str, float] = {}
    for target, values in here.items():
        scale = max((abs(value) for value in values if np.isfinite(value)), default=0.0)
        scales[target.quantity] = max(scales.get(target.quantity, QUANTITIES[target.quantity].least), scale)
    for target, values in here.items():
        times_as_large = factor(parse_unit(target.unit).dimension)
        for time, mine, its in zip(times, values, there[target], strict=True):
            its /= times_as_large  # noqa: PLW2901 - the same answer, in the units of the other motion
            if abs(mine - its) > close * scales[target.quantity] or np.isnan(mine) != np.isnan(its):
                yield Difference(f"{specimen.targets[target].phrase} at {time:.4g} s", mine, its)


def _values(targets: list[Target], trace: Trace, times: list[float], stretch: float) -> dict[Target, list[float]]:
    values: dict[Target, list[float]] = {target: [] for target in targets}
    for time in times:
        state = trace.sample(np.array([time * stretch]))
        for target in targets:
            values[target].append(target.value(state))
    return values


def _events(trace: Trace, end: float, stretch: float) -> list[Event]:
    """Return the events strictly inside the compared interval, in the first motion's time, without turning points.

    At both ends rounding errors may decide about an event, and for turning points everywhere.
    """
    events = [Event(event.time / stretch, event.kind, event.subjects) for event in trace.events]
    return [e for e in events if e.changes_motion and SOON * end < e.time < LATE * end]


def _parted(mine: list[Event], its: list[Event], end: float, close: float) -> Iterator[Difference]:
    """Yield the differences between the events of two motions: other times, or an event in only one of them."""
    order = sorted(mine, key=lambda event: (event.kind, event.subjects, event.time))
    other = sorted(its, key=lambda event: (event.kind, event.subjects, event.time))
    if [(e.kind, e.subjects) for e in order] != [(e.kind, e.subjects) for e in other]:
        yield Difference("the number of events (their kinds and subjects differ)", len(order), len(other))
        return
    for one, two in zip(order, other, strict=True):
        if abs(one.time - two.time) > close * end:
            yield Difference(f"the time of {one.kind} of {', '.join(one.subjects)}", one.time, two.time)
