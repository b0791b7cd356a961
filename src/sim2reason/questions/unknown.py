"""Numbers that a text may leave unknown, and numbers derived from components, such as speeds."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from math import ceil, exp, hypot, inf, log
from typing import NamedTuple, Self, cast

import numpy as np

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.model import FieldType, Model, Parameter, field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import Array

VELOCITY, SPEED = "velocity", "speed"
NO_DIRECTION_ERROR = "a speed of zero has no direction"


class DerivedNumber(NamedTuple):
    """A speed, in `unit`, that a scene declares by the velocity components at the addresses `parts`."""

    path: str
    unit: str
    parts: tuple[str, ...]

    def value(self, scene: Scene) -> float:
        """Return the speed in a scene."""
        return hypot(*(float(scene.value(part) or 0.0) for part in self.parts))

    def at(self, scene: Scene, value: float) -> Mapping[str, float]:
        """Return the velocity components with another speed and the same direction; SceneError if all are zero."""
        now = self.value(scene)
        if not now:
            raise SceneError(self.path, NO_DIRECTION_ERROR, "change one of the components")
        return {part: float(scene.value(part) or 0.0) * value / now for part in self.parts}


def derived_numbers(scene: Scene) -> Mapping[str, DerivedNumber]:
    """Return all derived numbers of a scene by address, such as *system.planets.0.speed*."""
    parts = defaultdict[str, list[str]](list)
    units = dict[str, str]()
    for parameter in scene.parameters:
        if parameter.measure.noun == VELOCITY and parameter.value is not None:
            owner = parameter.path.rpartition(".")[0]
            parts[owner].append(parameter.path)
            units[owner] = parameter.measure.unit
    derived = (DerivedNumber(f"{owner}.{SPEED}", units[owner], tuple(paths)) for owner, paths in parts.items())
    return {number.path: number for number in derived}


def number_at(scene: Scene, path: str) -> float:
    """Return the value of the number at an address, which may be derived; zero if it is omitted."""
    derived = derived_numbers(scene).get(path)
    return derived.value(scene) if derived is not None else float(scene.value(path) or 0.0)


def with_numbers(scene: Scene, values: Mapping[str, float]) -> Scene:
    """Return a scene with other values of some numbers, by address, derived numbers included."""
    derived: Mapping[str, DerivedNumber] = {}
    if any(path.endswith(f".{SPEED}") for path in values):
        derived = derived_numbers(scene)
    news = dict[str, float]()
    for path, value in values.items():
        news |= derived[path].at(scene, value) if path in derived else {path: value}
    return scene.having_all(news)


def with_number(scene: Scene, path: str, value: float) -> Scene:
    """Return a scene with another value of the number at an address, which may be a derived one."""
    return with_numbers(scene, {path: value})


RANGE_FACTOR = 10.0  # factor on the range of drawn values, at either end
RANGE_POINTS = 64
FAR, STEPS = 100.0, 16  # factor on a value, either way, and number of equal logarithmic steps
FAR_FACTORS = 300.0, 1000.0  # further factors on a value
MAX_SEARCH_FACTOR = 1e4  # factor on a range: bounds of the extended search
MIN_RANGE_FRACTION = 1e-2  # of the upper end of a range that begins at zero: the least value
BODY_NUMBERS = frozenset(
    {"mass", "magnitude of the charge", "radius"}
)  # what is said of a body that has a name: *the mass of A*
LENGTHS = frozenset({"m", "au"})
STRING_LENGTH_FACTOR = 100.0  # factor on the length of a string that is long enough
USUAL_RANGE_FACTOR = 2.0  # factor on the range of drawn values, either way
NUDGE_FACTOR = 1.0 + 1e-3
MAX_UNKNOWNS = 3  # numbers tried for one question


@dataclass(frozen=True, slots=True)
class Unknown:
    """A number that the text refers to by its symbol alone."""

    path: str
    name: str  # of what it is: *mass*
    unit: str
    symbol: str  # with its dollars
    phrases: tuple[str, ...]  # the symbol last
    sought: float = 1.0  # how often it is asked for, compared with others

    @classmethod
    def of(cls, scene: Scene, parameter: Parameter, mentions: Mapping[str, str], symbol: str) -> Self | None:
        """Return the unknown for a number; None for positions and for numbers without a range."""
        field_type, measure, owner = _field(scene, parameter.path), parameter.measure, parameter.path.rpartition(".")[0]
        if (
            field_type.drawn is None
            or field_type.drawn.low == field_type.drawn.high
            or (field_type.least < 0.0 and measure.unit in LENGTHS)
        ):
            return None
        shown = f"${symbol}$"
        like = [p for p in scene.parameters if p.measure.noun == measure.noun and p.path.rpartition(".")[0] == owner]
        named = (
            measure.noun in BODY_NUMBERS
            and len(like) == 1
            and owner in scene.bodies
            and bool(scene.bodies[owner].letters)
        )
        own = (f"the {measure.noun} of {mentions[owner]}",) if named else ()
        return cls(
            parameter.path, measure.noun, measure.unit, shown, (*own, *_by_symbol(measure.noun, shown)), measure.sought
        )

    def with_symbol(self, symbol: str) -> Self:
        """Return the same unknown with another symbol."""
        shown = f"${symbol}$"
        return replace(self, symbol=shown, phrases=(*self.phrases[:-2], *_by_symbol(self.name, shown)))


def _by_symbol(name: str, shown: str) -> tuple[str, str]:
    return f"the {name} {shown}", shown


def unknowns(scene: Scene, mentions: Mapping[str, str], symbols: Mapping[str, str]) -> list[Unknown]:
    """Return all numbers that the text states and could leave unknown, with their symbols."""
    stated_parameters = [p for p in scene.parameters if p.path in symbols and p.value and not p.hidden]
    candidates = (Unknown.of(scene, p, mentions, symbols[p.path]) for p in stated_parameters)
    return [unknown for unknown in candidates if unknown is not None]


def draw_unknowns(offered: Sequence[Unknown], scene: Scene, rng: np.random.Generator) -> Iterator[Unknown]:
    """Yield a few random unknowns, drawn first by quantity, so that many masses are not favoured.

    Those are left out without which the text would be another one.
    """
    left = list(offered)
    for _ in range(min(MAX_UNKNOWNS, len(left))):
        sought = {unknown.name: unknown.sought for unknown in sorted(left, key=lambda unknown: unknown.name)}
        shares = np.array([*sought.values()]) / sum(sought.values())
        name = [*sought][int(rng.choice(len(sought), p=shares))]
        same = [unknown for unknown in left if unknown.name == name]
        taken = same[int(rng.integers(len(same)))]
        left.remove(taken)
        if _keeps_routes(scene, taken.path):
            yield taken


def _keeps_routes(scene: Scene, path: str) -> bool:
    """Return whether strings keep their routes for other values of a number."""
    try:
        other = scene.having(path, float(scene.value(path)) * NUDGE_FACTOR)
    except (SceneError, ValueError):  # it has its greatest value
        return True
    try:
        return other.mechanism.routes == scene.mechanism.routes
    except SceneError:  # as where a spring joins two slopes, which must have the same angle
        return False


def range_of(scene: Scene, path: str, about: float = 0.0) -> tuple[float, ...]:
    """Return points, in ascending order, from a tenth of the low end of a number's range to ten times the high end.

    And farther to ten times a value that it has, since recipes draw some from ranges of their own. They end where its
    declaration does. They are evenly spaced for angles, else on the logarithmic scale: of either sign, and with zero,
    if both can be.
    """
    if (derived := derived_numbers(scene).get(path)) is not None:
        size = derived.value(scene)
        return tuple(np.geomspace(size / RANGE_FACTOR, size * RANGE_FACTOR, RANGE_POINTS).tolist()) if size else ()
    field_type, unit = _field(scene, path), next(p.measure.unit for p in scene.parameters if p.path == path)
    assert field_type.drawn is not None
    low, high = field_type.drawn.low, field_type.drawn.high
    smallest, most = find_limits(scene, path)
    if low < 0.0:
        return tuple(_with_both_signs(max(-low, high), most, abs(about)).tolist())
    spaced = np.linspace if unit == "deg" else np.geomspace
    begin = max((low if unit == "deg" else max(low, high * MIN_RANGE_FRACTION)) / RANGE_FACTOR, smallest)
    usual = spaced(begin, min(high * RANGE_FACTOR, most), RANGE_POINTS)
    return (*usual.tolist(), *_onwards(usual, min(about * RANGE_FACTOR, most)))


def find_limits(scene: Scene, path: str) -> tuple[float, float]:
    """Return the least and the greatest value that a number's declaration and the related numbers beside it allow."""
    owner, _, name = path.rpartition(".")
    value, field_type = scene.value(owner), _field(scene, path)
    kinds = field_types(cast("type[Model]", type(value)))
    less = getattr(value, field_type.above) if field_type.above else None
    greater = [getattr(value, other) for other, kind in kinds.items() if kind.above == name]
    smallest = field_type.least if less is None else max(field_type.least, less * NUDGE_FACTOR)
    return smallest, min([field_type.most, *(number / NUDGE_FACTOR for number in greater if number is not None)])


def beyond_range(scene: Scene, path: str) -> tuple[tuple[float, ...], ...]:
    """Return logarithmically spaced values below and above the `range_of` a number, within its limits, in order.

    The values begin at the ends of that range, and extend to at most a ten thousandth of the lower end and ten thousand
    times the upper end. There are none for angles, whose range is complete, nor for numbers of either sign.
    """
    if path in derived_numbers(scene):
        return ()
    unit = next(p.measure.unit for p in scene.parameters if p.path == path)
    values = range_of(scene, path)
    if unit == "deg" or values[0] <= 0.0:
        return ()
    limits = find_limits(scene, path)
    smallest, most = max(values[0] / MAX_SEARCH_FACTOR, limits[0]), min(values[-1] * MAX_SEARCH_FACTOR, limits[1])
    ends = ((smallest, values[0]), (values[-1], most))
    return tuple(tuple(np.geomspace(low, high, RANGE_POINTS // 2).tolist()) for low, high in ends if 0.0 < low < high)


def far_from(values: Sequence[float], about: float, unit: str) -> list[float]:
    """Return values of the sign of `about`, outside the range of `values`, up to a factor of a thousand from `about`.

    They are few, and fewer beyond a hundred, the nearest ones first. Of angles there are none: far ones are others that
    are near.
    """
    if not about or unit == "deg":
        return []
    low, high = (values[0], values[-1]) if about > 0.0 else (-values[-1], -values[0])
    size = abs(about)
    times = (*(FAR ** (n / STEPS) for n in range(1, STEPS + 1)), *FAR_FACTORS)
    candidates = (size * by**side for by in times for side in (1, -1))
    return [candidate if about > 0.0 else -candidate for candidate in candidates if candidate > high or candidate < low]


def _onwards(points: Array, end: float) -> list[float]:
    """Return further points up to `end`, spaced by the ratio of the last two; none if `end` is not beyond them."""
    last = float(points[-1])
    if end <= last:
        return []
    count = ceil(log(end / last) / log(last / float(points[-2])))
    step = log(end / last) / count
    return [last * exp(step * number) for number in range(1, count + 1)]


def usual_range(scene: Scene, path: str) -> tuple[float, float]:
    """Return the range of usual values of a number."""
    drawn = _field(scene, path).drawn
    return (drawn.low / USUAL_RANGE_FACTOR, drawn.high * USUAL_RANGE_FACTOR) if drawn is not None else (inf, -inf)


def is_usual(scene: Scene, path: str, value: float) -> bool:
    """Return whether a value of a number is usual."""
    low, high = usual_range(scene, path)
    return low <= value <= high


def _with_both_signs(size: float, most: float, about: float) -> Array:
    half = np.geomspace(size * MIN_RANGE_FRACTION, min(size * RANGE_FACTOR, most), RANGE_POINTS // 2)
    half = np.append(half, _onwards(half, min(about * RANGE_FACTOR, most)))
    return np.concatenate([-half[::-1], [0.0], half])


def _field(scene: Scene, path: str) -> FieldType:
    owner, _, name = path.rpartition(".")
    return field_types(cast("type[Model]", type(scene.value(owner))))[name]


def lengthen_strings(scene: Scene) -> Scene:
    """Return the scene with the lengths that no text states multiplied, so that every string is long enough."""
    for parameter in scene.parameters:
        if parameter.hidden and parameter.value and parameter.measure.unit in LENGTHS:
            with suppress(SceneError, ValueError):
                scene = scene.having(parameter.path, STRING_LENGTH_FACTOR * parameter.value)
    return scene
