"""What a plot of a motion shows: curves by quantity, and events in the words of the text."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.measures import show_unit
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.prose.writer import Description
from sim2reason.quantities import QUANTITIES, Quantity, ordered
from sim2reason.quantities.subjects import Subject
from sim2reason.quantities.subjects.strings import strings
from sim2reason.simulation.trace import Event, Trace

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
    shown = panels(trace.sample(times), mentions)
    marks = [Mark(event.time, told(event, trace.mechanism, mentions)) for event in _worth(trace, duration)]
    marks = [m for n, m in enumerate(marks) if not any(m.text == b.text and m.time - b.time < STILL for b in marks[:n])]
    return MotionCurves(times, shown, tuple(marks), min(trace.stable_until, duration), trace.cut, duration)


def instants(trace: Trace, duration: float) -> Array:
    """Equal steps up to where the trace may be used, and both sides of every event, so that jumps look like jumps."""
    end = min(trace.stable_until, duration)
    grid = np.linspace(0.0, end, max(2, round(SAMPLES * end / duration)))
    events = np.array([event.time for event in trace.events if 0.0 < event.time <= end])
    return np.unique(np.concatenate([grid, events, np.nextafter(events, 0.0)]))


def panels(state: State, mentions: dict[str, str]) -> tuple[Panel, ...]:
    """A panel for every quantity that is plotted and that something of the text has; some share one."""
    found: dict[str, list[Curve]] = {}
    for quantity in ordered():
        if quantity.panel:
            title = f"{quantity.panel} ({show_unit(state.mechanism.units.spell(quantity.unit))})".removesuffix(" ()")
            found.setdefault(title, []).extend(_curves(quantity, state, mentions))
    return tuple(Panel(title, tuple(curves)) for title, curves in found.items() if curves)


def _curves(quantity: Quantity, state: State, mentions: dict[str, str]) -> Iterator[Curve]:
    """The curves of a quantity, by subjects; where several share a panel, each says its own name."""
    own = "" if quantity.panel == quantity.name else f", {quantity.name}"
    for name, phrase in quantity.of.phrases(state.mechanism, mentions).items():
        if not quantity.present(state.mechanism, name):
            continue
        values = quantity.evaluate(state, name)
        unknown = "" if np.isfinite(values).any() else ": not determined"
        for how, part in _parts(values, state, quantity.of, name) if quantity.vector else [("", values)]:
            yield Curve(quantity.of.label(phrase) + own + how + unknown, part)


def _parts(values: Array, state: State, subject: Subject, name: str) -> list[tuple[str, Array]]:
    """A vector as signed components, where the text has words for their signs, else as its size."""
    ways, directions = subject.senses(state.mechanism, name), subject.directions(state.mechanism, name)
    if len(ways) == 2 or (len(ways) == 1 and not ways[0].axis):
        said = [f", {way.axis}" if way.axis else f", {way.positive}" for way in ways]
        return [(how, values @ np.array(way.vector)) for how, way in zip(said, ways, strict=True)]
    if len(directions) == 1:
        along = values @ np.array(directions[0])
        return [(", forward", along * _forward(state, name, np.array(directions[0])))]
    return [(", size", np.linalg.norm(values, axis=1))]


def _forward(state: State, body: str, direction: Array) -> float:
    """The sign that makes the first motion of a body positive: no text says which way is right."""
    moved = QUANTITIES["displacement"].evaluate(state, body) @ direction
    first = moved[np.abs(moved) > STILL]
    return -1.0 if len(first) and first[0] < 0.0 else 1.0


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
