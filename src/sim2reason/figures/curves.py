"""Curves of the quantities of a motion over time, and trajectories in the plane of the axes."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from sim2reason.scenes.dsl.measures import show_unit
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.units import UnitSystem
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.simulation.quantities import QUANTITIES, Quantity, ordered
from sim2reason.simulation.quantities.subjects.bodies import AXES, Bodies
from sim2reason.simulation.quantities.subjects.interactions import strings
from sim2reason.simulation.trace import Event, Trace
from sim2reason.text.prose.description import Description


@dataclass(frozen=True)
class Trajectory:
    """The path of a body's centre of mass: coordinates along two axes, from the origin of its entity."""

    body: str
    name: str
    x: Array
    y: Array


@dataclass(frozen=True)
class Trajectories:
    """The trajectories of one entity in one plane."""

    across: str
    up: str
    members: tuple[Trajectory, ...]


def trajectories(state: State, mentions: Mapping[str, str], origins: Mapping[str, Vector]) -> tuple[Trajectories, ...]:
    """Return the trajectories, by entity, of all bodies with two directions along axes named in the text."""
    of, groups = Bodies(), dict[tuple[str, str, str], list[Trajectory]]()
    unit = show_unit(state.mechanism.units.length)
    for name, phrase in of.phrases(state.mechanism, mentions).items():
        axes = [sense for sense in of.senses(state.mechanism, name) if sense.axis]
        if len(axes) == 2:
            owner = name.split(".", maxsplit=1)[0]
            position = state.vector(state.frames.center(name).place) - np.array(origins.get(owner, (0.0, 0.0, 0.0)))
            x, y = (position @ np.array(axis.vector) for axis in axes)
            one, other = (f"{axis.axis} ({unit})" for axis in axes)
            groups.setdefault((owner, one, other), []).append(Trajectory(name, of.label(phrase), x, y))
    return tuple(Trajectories(one, other, tuple(members)) for (_, one, other), members in groups.items())


SAMPLE_COUNT = 400
MAX_CURVES = 8  # curves in a panel
ZERO_LEVEL, STRAIGHT = 1e-9, 1e-9
FIXED = "a fixed point"
SIZES = {"velocity": "speed", "displacement": "distance from the start"}  # magnitudes of vectors


@dataclass(frozen=True)
class Curve:
    """One curve of a panel: its name, and its values at all plotted times."""

    name: str
    values: Array


@dataclass(frozen=True)
class Panel:
    """The curves of one quantity for all subjects that have it."""

    title: str
    curves: tuple[Curve, ...]


@dataclass(frozen=True)
class Mark:
    """An event with its description and the bodies involved."""

    time: float  # s
    text: str
    bodies: tuple[str, ...] = ()


@dataclass(frozen=True)
class MotionCurves:
    """The data of a plot of a motion: the panels with curves, the trajectories and the marked events."""

    times: Array  # s
    panels: tuple[Panel, ...]
    trajectories: tuple[Trajectories, ...]
    marks: tuple[Mark, ...]
    units: UnitSystem
    stable_until: float  # s
    cut: str
    duration: float  # s, as it was asked for


def motion_curves(trace: Trace, description: Description) -> MotionCurves:
    """Return the curves of a trace with the names of a description; curves that are always zero are omitted."""
    mentions = {address: description.mention(address) for address in description.scene.bodies}
    duration = float(trace.state.times[-1])
    times = instants(trace, duration)
    state, stated = trace.sample(times), frozenset(p.path for p in description.scene.parameters if not p.hidden)
    paths = trajectories(state, mentions, description.scene.builder.origins)
    traced = {member.name for group in paths for member in group.members}
    shown = tuple(panel for panel in panels(state, mentions, stated) if not _superfluous(panel, traced))
    marks = [
        Mark(event.time, describe_event(event, trace.mechanism, mentions), event.subjects)
        for event in _worth(trace, duration)
    ]
    marks = [
        m for n, m in enumerate(marks) if not any(m.text == b.text and m.time - b.time < ZERO_LEVEL for b in marks[:n])
    ]
    end = min(trace.stable_until, duration)
    return MotionCurves(times, shown, paths, tuple(marks), trace.mechanism.units, end, trace.cut, duration)


def instants(trace: Trace, duration: float) -> Array:
    """Return equally spaced times up to the end of validity, with both sides of every event, s."""
    end = min(trace.stable_until, duration)
    grid = np.linspace(0.0, end, max(2, round(SAMPLE_COUNT * end / duration)))
    events = np.array([event.time for event in trace.events if 0.0 < event.time <= end])
    return np.unique(np.concatenate([grid, events, np.nextafter(events, 0.0)]))


def panels(state: State, mentions: dict[str, str], stated: frozenset[str] | None = None) -> tuple[Panel, ...]:
    """Return a panel for each plotted quantity that the text mentions; some quantities share a panel.

    Curves that are always zero are omitted. `stated` contains the addresses of the stated numbers: a quantity that
    needs others is omitted; None allows all.
    """
    curves_by_title: dict[str, list[tuple[str, Curve]]] = {}
    for quantity in ordered():
        if quantity.panel:
            unit = show_unit(state.mechanism.units.spell(quantity.unit))
            for title, curve in _curves(quantity, state, mentions, stated):
                curves_by_title.setdefault(f"{title} ({unit})".removesuffix(" ()"), []).append((quantity.name, curve))
    panels = (Panel(title, _disambiguated(curves)) for title, curves in curves_by_title.items())
    return tuple(panel for panel in panels if _shows(panel.curves))


def _disambiguated(curves: list[tuple[str, Curve]]) -> tuple[Curve, ...]:
    """Return the curves, with the quantity added to the name where two quantities of one subject share a panel."""
    names = [curve.name for _, curve in curves]
    return tuple(
        replace(curve, name=f"{curve.name}, {quantity}") if names.count(curve.name) > 1 else curve
        for quantity, curve in curves
    )


def _superfluous(panel: Panel, traced: set[str]) -> bool:
    """Return whether to omit a panel: trajectories show the same better, or it has too many curves to read."""
    names = {curve.name for curve in panel.curves}
    return len(names) > MAX_CURVES or (panel.title.startswith(SIZES["displacement"]) and names <= traced)


def _shows(curves: tuple[Curve, ...]) -> bool:
    """Return whether any value is nonzero or undetermined."""
    return any(not np.isfinite(curve.values).any() or np.nanmax(np.abs(curve.values)) > ZERO_LEVEL for curve in curves)


def _curves(
    quantity: Quantity, state: State, mentions: dict[str, str], stated: frozenset[str] | None
) -> Iterator[tuple[str, Curve]]:
    """Yield the panel titles and curves of a quantity, one for each subject, or one for their sum."""
    mechanism, of = state.mechanism, quantity.of
    names = {
        name: phrase
        for name, phrase in of.phrases(mechanism, mentions).items()
        if quantity.present(mechanism, name)
        and (stated is None or all(of.gives(need, mechanism, name, stated) for need in quantity.needs))
    }
    if quantity.pooled and names:
        total = np.sum([quantity.evaluate(state, name) for name in names], axis=0)
        yield quantity.panel, Curve(quantity.name.removesuffix(" energy"), total)
        return
    for name, phrase in names.items():
        values = quantity.evaluate(state, name)
        unknown = "" if np.isfinite(values).any() else ": not determined"
        label = of.label(phrase)
        if not quantity.vector:
            yield quantity.panel, Curve(label + unknown, values)
            continue
        title, how, part = _part(values, quantity, state, name)
        yield title, Curve(label + how + unknown, part)


def _part(values: Array, quantity: Quantity, state: State, name: str) -> tuple[str, str, Array]:
    """Return the panel, sign convention and values of a vector: its component on a fixed line, else its magnitude."""
    ways, directions = quantity.of.senses(state.mechanism, name), quantity.of.directions(state.mechanism, name)
    if len(ways) == 1 and not ways[0].axis:
        return quantity.panel, f", {ways[0].positive}", values @ np.array(ways[0].vector)
    if len(directions) == 1:
        along = values @ np.array(directions[0])
        return quantity.panel, "", along * _forward(state, name, np.array(directions[0]))
    axle = None if ways or directions else _common_axis(values)
    if axle is not None:
        return quantity.panel, "", values @ axle
    return SIZES.get(quantity.panel, f"size of the {quantity.panel}"), "", np.linalg.norm(values, axis=1)


def _common_axis(values: Array) -> Array | None:
    """Return the unit vector of the line that contains all values of a vector; None if they lie on no line."""
    sizes = np.linalg.norm(values, axis=1)
    if not np.isfinite(sizes).all() or sizes.max() <= ZERO_LEVEL:
        return None
    direction: Array = values[int(np.argmax(sizes > 1e-3 * sizes.max()))]
    direction = direction / np.linalg.norm(direction)
    along = values @ direction
    straight = np.abs(values - np.outer(along, direction)).max() <= STRAIGHT * sizes.max()
    return direction if straight else None


def _forward(state: State, body: str, direction: Array) -> float:
    """Return the sign that makes the first motion of a body positive; the text defines no direction."""
    moved = QUANTITIES["displacement"].evaluate(state, body) @ direction
    first = moved[np.abs(moved) > ZERO_LEVEL]
    return -1.0 if len(first) and first[0] < 0.0 else 1.0


def _worth(trace: Trace, duration: float) -> list[Event]:
    end = min(trace.stable_until, duration) + ZERO_LEVEL
    return [event for event in trace.events if event.time <= end and not _is_unmentioned(event, trace.mechanism)]


def _is_unmentioned(event: Event, mechanism: Mechanism) -> bool:
    """Return whether an event is a reversal whose directions the text does not mention."""
    if event.kind != "turn" or not event.subjects or event.subjects[0] not in mechanism.number:
        return False
    own = mechanism.coordinates[mechanism.number[event.subjects[0]]]
    return len(mechanism.body[own.body].coordinates) > 1 and own.label not in AXES


VERBS = {
    "collision": "{0} and {1} collide",
    "taut": "{0} goes taut",
    "slack": "{0} goes slack",
    "stick": "{0} stops sliding",
    "slip": "{0} begins to slide, or slides back",
    "turn": "{0} turns back",
    "reach": "{0} meets {1}",
    "limit": "{0} reaches the end of its way",
    "lift": "{0} leaves its face",
    "crowd": "impacts too close together",
    "burn-out": "{0} has burnt all its fuel",
    "land": "{0} lands",
    "leave": "{0} leaves its support",
    "enter": "{0} enters the region",
    "exit": "{0} leaves the region",
    "indeterminate": "nothing holds {0} any more",
}


def describe_event(event: Event, mechanism: Mechanism, mentions: dict[str, str]) -> str:
    """Return the description of an event in the words of the text."""
    phrases = [_subject(subject, mechanism, mentions) for subject in event.subjects if subject] or [""]
    phrases.sort(key=lambda phrase: 2 if phrase == FIXED else int("pulley" in phrase))  # a block meets a pulley
    if "component of" in phrases[0]:
        return f"{phrases[0]} changes its sign"
    if event.kind == "collision" and len(phrases) == 1:
        return f"{phrases[0]} hits {_obstacle(event, mechanism)}"
    return VERBS.get(event.kind, event.kind).format(*phrases, *([""] * 2))


def _obstacle(event: Event, mechanism: Mechanism) -> str:
    """Return the name of the fixed surface that a body hits."""
    normals = [m.normal for m in mechanism.meetings if m.a is None and m.b in event.subjects and m.normal is not None]
    return "the ground" if any(normal[2] > abs(normal[0]) + abs(normal[1]) for normal in normals) else "a wall"


def _subject(name: str, mechanism: Mechanism, mentions: dict[str, str]) -> str:
    """Return the name of a body, string, coordinate or site in the text."""
    phrase = mentions.get(name) or strings(mechanism, mentions).get(name)
    if phrase:
        return phrase
    owner = name.rpartition(".")[0]
    site = mechanism.site.get(name)
    if owner in mentions:
        body = mechanism.body.get(owner)
        table = site is None and body is not None and len(body.coordinates) > 1
        return f"the {name[-1]} component of the velocity of {mentions[owner]}" if table else mentions[owner]
    if site is not None and site.body in mentions:
        return mentions[site.body]
    pulley = next(
        (text for address, text in mentions.items() if address.startswith(f"{owner.split('.')[0]}.pulley")), ""
    )
    return pulley or ("a string" if site is None else FIXED)
