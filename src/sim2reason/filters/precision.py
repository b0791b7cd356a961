"""Drops a question whose answer hangs on digits that the text does not give."""

from collections.abc import Mapping
from functools import cache
from hashlib import sha256
from math import cos, pi, sin, sqrt

from sim2reason.dsl.model import Parameter
from sim2reason.dsl.scene import Scene
from sim2reason.errors import SceneError
from sim2reason.filters import FILTERS, Candidate
from sim2reason.questions import KINDS, Study
from sim2reason.questions.study import BEYOND
from sim2reason.simulation.trace import Trace

SHIFT = 1e-3  # relative
FEW = 3  # numbers that are shifted one by one; of more, all are shifted each time
FIRST, ALL = 3, 6  # times that these are: a condition number below SURE · WORST after the first of them is believed
WORST, SURE = 20.0, 0.25  # the condition number κ = √Σ(Δa/a)² / SHIFT


class Precision:
    """A small shift of the stated numbers moves the answer too far, or changes the order of events: chaos."""

    needs_witness = False
    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Shift the stated numbers by one part in a thousand and solve again."""
        answer, query, study = candidate.question.answer, candidate.question.query, candidate.study
        if answer == 0.0:
            return "no number of digits is relative to zero"
        kind = KINDS[query.kind]
        time = kind.time(query, study)
        before = _story(study.trace, time)
        until = None if time is None else BEYOND * time
        paths = [parameter.path for parameter in study.scene.parameters if shiftable(study.scene, parameter)]
        squares = list[float]()
        for factors in patterns(len(paths)):
            moved = {path: factor for path, factor in zip(paths, factors, strict=True) if factor}
            other = shifted(study, moved, until)
            new = kind.answer(query, other) if other is not None else None
            if other is None or new is None or _story(other.trace, kind.time(query, other)) != before:
                told = next(iter(moved)) if len(moved) == 1 else "the stated numbers"
                return f"a small shift of {told} changes the order of events"
            squares.append(((new - answer) / answer) ** 2)
            if len(paths) > FEW and len(squares) == FIRST and _condition(squares, len(paths)) <= SURE * WORST:
                return ""
        condition = _condition(squares, len(paths))
        return f"the condition number is {condition:.1f}" if not condition <= WORST else ""


def _condition(squares: list[float], count: int) -> float:
    """The condition number that the squares of some changes of the answer make."""
    return sqrt(sum(squares) / (len(squares) if count > FEW else 1)) / SHIFT


@cache
def patterns(count: int) -> tuple[tuple[float, ...], ...]:
    """By how much that many numbers are shifted, in units of `SHIFT`, each time they are.

    A few are shifted one by one. Of more, all are shifted at once by factors fᵢ of either sign: for changes Δᵢ of the
    answer the mean square of ΣfᵢΔᵢ is ΣΔᵢ² where one number counts most, and about that where many do.
    """
    if count <= FEW:
        return tuple(tuple(float(i == k) for i in range(count)) for k in range(count))
    return tuple(shift for turn in range(ALL // FIRST) for shift in _three(count, turn))


def _three(count: int, turn: int) -> list[tuple[float, ...]]:
    """Three shifts of all numbers: the factors of each are a vector of length √3.

    Their lines are spread evenly, along the golden spiral of a half sphere, so that no two numbers whose changes cancel
    each other do so in all three. Another turn deals them out in another order.
    """
    keys = [sha256(bytes([number % 256, turn])).digest() for number in range(count)]
    vectors: list[tuple[float, float, float]] = []
    for place, key in zip(sorted(range(count), key=keys.__getitem__), keys, strict=True):
        height, angle = (place + 0.5) / count, place * pi * (3.0 - sqrt(5.0))
        side, width = sqrt(3.0) * (-1) ** key[0], sqrt(1.0 - height * height)
        vectors.append((side * width * cos(angle), side * width * sin(angle), side * height))
    return list(zip(*vectors, strict=True))


def shiftable(scene: Scene, parameter: Parameter) -> bool:
    """Whether a number is said in the text as a number; zeros and what a word tells are not."""
    if parameter.hidden or not parameter.value:
        return False
    owner, _, name = parameter.path.rpartition(".")
    body = scene.bodies.get(owner)
    return not (body is not None and body.told_by_word(name))


def shifted(study: Study, factors: Mapping[str, float], until: float | None = None) -> Study | None:
    """The motion with numbers shifted, to a time, or None if there is none; the other way if this one is not valid."""
    for way in (1, -1):
        values = {path: study.scene.value(path) * (1.0 + way * factor * SHIFT) for path, factor in factors.items()}
        try:
            scene = study.scene.having_all(values)
        except (SceneError, ValueError):
            continue
        return study.variant(scene, until)
    return None


def _story(trace: Trace, time: float | None) -> list[tuple[str, tuple[str, ...]]]:
    """What happens before a moment, in order; turns change nothing and are left out."""
    end = time if time is not None else trace.stable_until
    return [(e.kind, e.subjects) for e in trace.events if e.time < end * (1.0 - 1e-9) and e.kind != "turn"]


FILTERS.add("precision", Precision())
