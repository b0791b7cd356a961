"""What a plot of a motion shows: curves by quantity, and events in the words of the text."""

from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.measures import show_unit
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.prose.writer import Description
from sim2reason.quantities import QUANTITIES
from sim2reason.questions.targets import axes, senses, strings
from sim2reason.simulation.trace import Event, Trace

MOTION = ("displacement", "velocity", "acceleration")
SAMPLES = 400
STILL = 1e-9
FIXED = "a fixed point"


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
    """An event with its words."""

    time: float  # s
    text: str


@dataclass(frozen=True)
class MotionCurves:
    """All that a plot shows."""

    times: Array  # s
    panels: tuple[Panel, ...]
    marks: tuple[Mark, ...]
    stable_until: float  # s
    cut: str
    duration: float  # s, as it was asked for


def motion_curves(trace: Trace, description: Description) -> MotionCurves:
    """The curves of a trace, by the names of a text; those that never differ from zero are left out."""
    mentions = {address: description.mention(address) for address in description.scene.bodies}
    duration = float(trace.state.times[-1])
    times = instants(trace, duration)
    state = trace.sample(times)
    panels = [_moved(quantity, state, mentions, description) for quantity in MOTION]
    panels.append(_tensions(state, mentions))
    kept = tuple(panel for panel in panels if panel.curves)
    marks = [Mark(event.time, told(event, trace.mechanism, mentions)) for event in _worth(trace, duration)]
    marks = [m for n, m in enumerate(marks) if not any(m.text == b.text and m.time - b.time < STILL for b in marks[:n])]
    return MotionCurves(times, kept, tuple(marks), min(trace.stable_until, duration), trace.cut, duration)


def instants(trace: Trace, duration: float) -> Array:
    """Equal steps up to where the trace may be used, and both sides of every event, so that jumps look like jumps."""
    end = min(trace.stable_until, duration)
    grid = np.linspace(0.0, end, max(2, round(SAMPLES * end / duration)))
    events = np.array([event.time for event in trace.events if 0.0 < event.time <= end])
    return np.unique(np.concatenate([grid, events, np.nextafter(events, 0.0)]))


def _moved(quantity: str, state: State, mentions: dict[str, str], description: Description) -> Panel:
    found = QUANTITIES[quantity]
    curves: list[Curve] = []
    for body in state.mechanism.bodies:
        if body.name in mentions and axes(state.mechanism, body.name) and not any(body.inertia):
            name = description.names.letters.get(body.name, "") or mentions[body.name].removeprefix("the ")
            values = found.evaluate(state, body.name)
            curves += [Curve(f"{name}{how}", part) for how, part in _parts(values, state, body.name)]
    return Panel(f"{quantity} ({show_unit(found.unit)})", tuple(curves))


def _parts(values: Array, state: State, body: str) -> list[tuple[str, Array]]:
    """A vector as signed components, where the text has words for their signs, else as its size."""
    ways = senses(state.mechanism, body)
    if len(ways) == 2 or (len(ways) == 1 and not ways[0].axis):
        said = [f", {way.axis}" if way.axis else f", {way.positive}" for way in ways]
        return [(how, values @ np.array(way.vector)) for how, way in zip(said, ways, strict=True)]
    if len(axes(state.mechanism, body)) == 1:
        along = values @ np.array(axes(state.mechanism, body)[0])
        return [(", forward", along * _forward(state, body))]
    return [(", size", np.linalg.norm(values, axis=1))]


def _forward(state: State, body: str) -> float:
    """The sign that makes the first motion of a body positive: no text says which way is right."""
    moved = QUANTITIES["displacement"].evaluate(state, body) @ np.array(axes(state.mechanism, body)[0])
    first = moved[np.abs(moved) > STILL]
    return -1.0 if len(first) and first[0] < 0.0 else 1.0


def _tensions(state: State, mentions: dict[str, str]) -> Panel:
    phrases = strings(state.mechanism, mentions)
    curves: list[Curve] = []
    for name, phrase in phrases.items():
        values = QUANTITIES["tension"].evaluate(state, name)
        unknown = "" if np.isfinite(values).any() else ": not determined"
        curves.append(Curve(_short(phrase) + unknown, values))
    return Panel("tension (N)", tuple(curves))


def _short(phrase: str) -> str:
    """A phrase for a legend: *block A – pulley P*."""
    ends = phrase.partition(" between ")[2] or phrase
    said = ends.replace("the axle of ", "axle of ").replace("the ", "").replace(" and ", " – ")
    return f"{said} (part)" if phrase.startswith("the part") else said


def _worth(trace: Trace, duration: float) -> list[Event]:
    return [event for event in trace.events if event.time <= min(trace.stable_until, duration) + STILL]


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
    "indeterminate": "nothing holds {0} any more",
}


def told(event: Event, mechanism: Mechanism, mentions: dict[str, str]) -> str:
    """An event in the words of the text."""
    said = [_subject(subject, mechanism, mentions) for subject in event.subjects] or [""]
    said.sort(key=lambda phrase: 2 if phrase == FIXED else int("pulley" in phrase))  # a block meets a pulley
    return VERBS.get(event.kind, event.kind).format(*said, *([""] * 2))


def _subject(name: str, mechanism: Mechanism, mentions: dict[str, str]) -> str:
    """A body, string, coordinate or site in words."""
    phrase = mentions.get(name) or strings(mechanism, mentions).get(name)
    if phrase:
        return phrase
    owner = name.rpartition(".")[0]
    site = mechanism.site.get(name)
    if owner in mentions:
        body = mechanism.body.get(owner)
        table = site is None and body is not None and len(body.coordinates) > 1
        return f"{mentions[owner]}, along {name[-1]}," if table else mentions[owner]
    if site is not None and site.body in mentions:
        return mentions[site.body]
    pulley = next(
        (text for address, text in mentions.items() if address.startswith(f"{owner.split('.')[0]}.pulley")), ""
    )
    return pulley or ("a string" if site is None else FIXED)
