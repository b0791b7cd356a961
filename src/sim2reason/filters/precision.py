"""Drops a question whose answer hangs on digits that the text does not give."""

from collections.abc import Mapping
from functools import cache
from hashlib import sha256
from itertools import cycle, islice
from math import sqrt

from sim2reason.dsl.model import Parameter
from sim2reason.dsl.scene import Scene
from sim2reason.errors import SceneError
from sim2reason.filters import FILTERS, Candidate
from sim2reason.questions import KINDS, Study
from sim2reason.questions.study import BEYOND
from sim2reason.simulation.trace import Trace

SHIFT = 1e-3  # relative
AT_ONCE = 6  # shifts: with more numbers than that, all of them are shifted each time
WORST = 20.0  # the condition number κ = √Σ(Δa/a)² / SHIFT


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
        total = 0.0
        for signs in patterns(len(paths)):
            moved = {path: sign for path, sign in zip(paths, signs, strict=True) if sign}
            other = shifted(study, moved, until)
            new = kind.answer(query, other) if other is not None else None
            if other is None or new is None or _story(other.trace, kind.time(query, other)) != before:
                told = next(iter(moved)) if len(moved) == 1 else "the stated numbers"
                return f"a small shift of {told} changes the order of events"
            total += ((new - answer) / answer) ** 2
        condition = sqrt(total / AT_ONCE if len(paths) > AT_ONCE else total) / SHIFT
        return f"the condition number is {condition:.1f}" if not condition <= WORST else ""


@cache
def patterns(count: int) -> tuple[tuple[int, ...], ...]:
    """The signs with which that many numbers are shifted, each time they are.

    A few are shifted one by one. Of more, all are shifted at once with signs at random: for changes Δᵢ the square of
    Σ±Δᵢ is ΣΔᵢ² on average; no two of up to 32 numbers have the same signs, or opposite ones, in all of the patterns.
    """
    if count <= AT_ONCE:
        return tuple(tuple(int(i == k) for i in range(count)) for k in range(count))
    columns = sorted(range(2 ** (AT_ONCE - 1)), key=lambda number: sha256(bytes([number])).digest())
    signs = [[1 if number >> k & 1 else -1 for k in range(AT_ONCE)] for number in islice(cycle(columns), count)]
    return tuple(zip(*signs, strict=True))


def shiftable(scene: Scene, parameter: Parameter) -> bool:
    """Whether a number is said in the text as a number; zeros and what a word tells are not."""
    if parameter.hidden or not parameter.value:
        return False
    owner, _, name = parameter.path.rpartition(".")
    body = scene.bodies.get(owner)
    return not (body is not None and body.told_by_word(name))


def shifted(study: Study, signs: Mapping[str, int], until: float | None = None) -> Study | None:
    """The motion with numbers shifted, to a time, or None if there is none; the other way if this one is not valid."""
    for way in (1, -1):
        values = {path: study.scene.value(path) * (1.0 + way * sign * SHIFT) for path, sign in signs.items()}
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
