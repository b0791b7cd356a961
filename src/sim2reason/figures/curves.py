"""Curves of a plot of a motion, and trajectories in the plane of the axes."""

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
from sim2reason.simulation.quantities.subjects.lines import strings
from sim2reason.simulation.trace import Event, Trace
from sim2reason.text.prose.description import Description


@dataclass(frozen=True)
class Trajectory:
    """Where the centre of mass of a body goes: coordinates along two axes, from the origin of its entity."""

    body: str
    name: str
    x: Array
    y: Array


@dataclass(frozen=True)
class Trajectories:
    """Those of one entity, in one plane."""

    across: str
    up: str
    members: tuple[Trajectory, ...]


def trajectories(state: State, mentions: Mapping[str, str], origins: Mapping[str, Vector]) -> tuple[Trajectories, ...]:
    """By entity the paths of all bodies for whose two directions the text has axes."""
    of, found = Bodies(), dict[tuple[str, str, str], list[Trajectory]]()
    unit = show_unit(state.mechanism.units.length)
    for name, phrase in of.phrases(state.mechanism, mentions).items():
        axes = [sense for sense in of.senses(state.mechanism, name) if sense.axis]
        if len(axes) == 2:
            owner = name.split(".", maxsplit=1)[0]
            place = state.vector(state.frames.center(name).place) - np.array(origins.get(owner, (0.0, 0.0, 0.0)))
            x, y = (place @ np.array(axis.vector) for axis in axes)
            one, other = (f"{axis.axis} ({unit})" for axis in axes)
            found.setdefault((owner, one, other), []).append(Trajectory(name, of.label(phrase), x, y))
    return tuple(Trajectories(one, other, tuple(members)) for (_, one, other), members in found.items())


SAMPLES = 400
MOST = 8  # curves of a panel
STILL, STRAIGHT = 1e-9, 1e-9
FIXED = "a fixed point"
SIZES = {"velocity": "speed", "displacement": "distance from the start"}  # of vectors that turn


@dataclass(frozen=True)
class Curve:
    """One line of a panel, before the cut and after it."""

    name: str
    values: Array


@dataclass(frozen=True)
class Panel:
    """A quantity of all that have it."""

    title: str
    curves: tuple[Curve, ...]


@dataclass(frozen=True)
class Mark:
    """An event with its words, and the bodies that have part in it."""

    time: float  # s
    text: str
    bodies: tuple[str, ...] = ()


@dataclass(frozen=True)
class MotionCurves:
    """All that a plot shows."""

    times: Array  # s
    panels: tuple[Panel, ...]
    trajectories: tuple[Trajectories, ...]
    marks: tuple[Mark, ...]
    units: UnitSystem
    stable_until: float  # s
    cut: str
    duration: float  # s, as it was asked for


def motion_curves(trace: Trace, description: Description) -> MotionCurves:
    """Return the curves of a trace, by the names of a text; those that never differ from zero are left out."""
    mentions = {address: description.mention(address) for address in description.scene.bodies}
    duration = float(trace.state.times[-1])
    times = instants(trace, duration)
    state, said = trace.sample(times), frozenset(p.path for p in description.scene.parameters if not p.hidden)
    paths = trajectories(state, mentions, description.scene.builder.origins)
    traced = {member.name for group in paths for member in group.members}
    shown = tuple(panel for panel in panels(state, mentions, said) if not _superfluous(panel, traced))
    marks = [
        Mark(event.time, told(event, trace.mechanism, mentions), event.subjects) for event in _worth(trace, duration)
    ]
    marks = [m for n, m in enumerate(marks) if not any(m.text == b.text and m.time - b.time < STILL for b in marks[:n])]
    end = min(trace.stable_until, duration)
    return MotionCurves(times, shown, paths, tuple(marks), trace.mechanism.units, end, trace.cut, duration)


def instants(trace: Trace, duration: float) -> Array:
    """Equal steps up to where the trace may be used, and both sides of every event, so that jumps look like jumps."""
    end = min(trace.stable_until, duration)
    grid = np.linspace(0.0, end, max(2, round(SAMPLES * end / duration)))
    events = np.array([event.time for event in trace.events if 0.0 < event.time <= end])
    return np.unique(np.concatenate([grid, events, np.nextafter(events, 0.0)]))


def panels(state: State, mentions: dict[str, str], said: frozenset[str] | None = None) -> tuple[Panel, ...]:
    """Return a panel for every quantity that is plotted and that something of the text has; some share one.

    What is zero throughout is left out. `said` has the paths of the numbers of the text: of what needs another one
    there is no curve; None stands for all.
    """
    found: dict[str, list[tuple[str, Curve]]] = {}
    for quantity in ordered():
        if quantity.panel:
            unit = show_unit(state.mechanism.units.spell(quantity.unit))
            for title, curve in _curves(quantity, state, mentions, said):
                found.setdefault(f"{title} ({unit})".removesuffix(" ()"), []).append((quantity.name, curve))
    panels = (Panel(title, _told_apart(curves)) for title, curves in found.items())
    return tuple(panel for panel in panels if _shows(panel.curves))


def _told_apart(curves: list[tuple[str, Curve]]) -> tuple[Curve, ...]:
    """With the names of the quantities, where two of them share the panel and a subject."""
    names = [curve.name for _, curve in curves]
    return tuple(
        replace(curve, name=f"{curve.name}, {quantity}") if names.count(curve.name) > 1 else curve
        for quantity, curve in curves
    )


def _superfluous(panel: Panel, traced: set[str]) -> bool:
    """Whether paths show it better, or there are so many pairs that no one can tell the curves from each other."""
    names = {curve.name for curve in panel.curves}
    return len(names) > MOST or (panel.title.startswith(SIZES["displacement"]) and names <= traced)


def _shows(curves: tuple[Curve, ...]) -> bool:
    """Return whether anything is not zero, or not determined, which is told."""
    return any(not np.isfinite(curve.values).any() or np.nanmax(np.abs(curve.values)) > STILL for curve in curves)


def _curves(
    quantity: Quantity, state: State, mentions: dict[str, str], said: frozenset[str] | None
) -> Iterator[tuple[str, Curve]]:
    """Yield the curves of a quantity with the titles of their panels, by subjects, or their sum."""
    mechanism, of = state.mechanism, quantity.of
    names = {
        name: phrase
        for name, phrase in of.phrases(mechanism, mentions).items()
        if quantity.present(mechanism, name)
        and (said is None or all(of.gives(need, mechanism, name, said) for need in quantity.needs))
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
    """A vector along the one line that it stays on, with its sense, else its size: the panel, the sense, the values."""
    ways, directions = quantity.of.senses(state.mechanism, name), quantity.of.directions(state.mechanism, name)
    if len(ways) == 1 and not ways[0].axis:
        return quantity.panel, f", {ways[0].positive}", values @ np.array(ways[0].vector)
    if len(directions) == 1:
        along = values @ np.array(directions[0])
        return quantity.panel, "", along * _forward(state, name, np.array(directions[0]))
    axle = None if ways or directions else _axle(values)
    if axle is not None:
        return quantity.panel, "", values @ axle
    return SIZES.get(quantity.panel, f"size of the {quantity.panel}"), "", np.linalg.norm(values, axis=1)


def _axle(values: Array) -> Array | None:
    """The one line on which all of a vector's values lie, if it turns round as it changes: first they are positive."""
    sizes = np.linalg.norm(values, axis=1)
    if not np.isfinite(sizes).all() or sizes.max() <= STILL:
        return None
    way: Array = values[int(np.argmax(sizes > 1e-3 * sizes.max()))]
    way = way / np.linalg.norm(way)
    along = values @ way
    straight = np.abs(values - np.outer(along, way)).max() <= STRAIGHT * sizes.max()
    return way if straight else None


def _forward(state: State, body: str, direction: Array) -> float:
    """Return the sign that makes the first motion of a body positive: no text says which way is right."""
    moved = QUANTITIES["displacement"].evaluate(state, body) @ direction
    first = moved[np.abs(moved) > STILL]
    return -1.0 if len(first) and first[0] < 0.0 else 1.0


def _worth(trace: Trace, duration: float) -> list[Event]:
    end = min(trace.stable_until, duration) + STILL
    return [event for event in trace.events if event.time <= end and not _untold(event, trace.mechanism)]


def _untold(event: Event, mechanism: Mechanism) -> bool:
    """Return whether no text speaks of what turns back: one of two directions of a body that are no axes."""
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


def told(event: Event, mechanism: Mechanism, mentions: dict[str, str]) -> str:
    """Return an event in the words of the text."""
    said = [_subject(subject, mechanism, mentions) for subject in event.subjects if subject] or [""]
    said.sort(key=lambda phrase: 2 if phrase == FIXED else int("pulley" in phrase))  # a block meets a pulley
    if "component of" in said[0]:
        return f"{said[0]} changes its sign"
    if event.kind == "collision" and len(said) == 1:
        return f"{said[0]} hits {_obstacle(event, mechanism)}"
    return VERBS.get(event.kind, event.kind).format(*said, *([""] * 2))


def _obstacle(event: Event, mechanism: Mechanism) -> str:
    """Return what of the room a body hits."""
    normals = [m.normal for m in mechanism.meetings if m.a is None and m.b in event.subjects and m.normal is not None]
    return "the ground" if any(normal[2] > abs(normal[0]) + abs(normal[1]) for normal in normals) else "a wall"


def _subject(name: str, mechanism: Mechanism, mentions: dict[str, str]) -> str:
    """Return a body, string, coordinate or site in words."""
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
