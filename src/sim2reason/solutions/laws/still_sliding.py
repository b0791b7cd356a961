"""Whether bodies still slide on others when a stage of a motion ends, shown in numbers."""

from collections.abc import Sequence
from functools import partial
from math import isinf

from sim2reason.solutions.algebra.expressions import ZERO, Expression
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.laws.sliding import rubs_at_rest, sliding_coordinates
from sim2reason.solutions.laws.stage import Stage
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.unit_latex import SPEED


def verify_still_sliding(stages: Sequence[Stage]) -> None:
    """Write for each body whose sliding on another one slows down that it goes on until a stage ends.

    Nothing rests on it. Where numbers are not known yet, it follows in the end.
    """
    for number, stage in enumerate(stages):
        told = stages[: number + 1]
        if stage.book.in_symbols or any(held.uniform or held.written_time is None for held in told):
            return
        for face in _slowing(stage):
            parts = [_gained(held, face, first=n == 0) for n, held in enumerate(told)]
            known = [part for part in parts if part is not None]
            if len(known) < len(parts):
                continue
            velocity = _size(stage, total(known))
            if stage.book.is_hidden(velocity):
                stage.book.afterwards.append(partial(_tell, stage, face, velocity))
            else:
                _tell(stage, face, velocity)


def _slowing(stage: Stage) -> list[int]:
    """Return the faces of moving bodies on which others slide ever more slowly, without that on which they stop."""
    m, segment, found = stage.dynamics.mechanism, stage.segment, list[int]()
    for number, side in stage.dynamics.newton.rough.items():
        face = m.faces[number]
        parts = sliding_coordinates(m, number)
        ends = any(k in stage.end.slip for k, _ in parts) or (
            stage.end.distance is None and stage.end.time is None and any(k == stage.end.coordinate for k, _ in parts)
        )
        rides = m.body[face.subject].parent is not None
        if not side or ends or not rides or isinf(face.friction) or rubs_at_rest(stage.dynamics, number):
            continue
        speed, change = (sum(float(rates[k]) * part for k, part in parts) for rates in (segment.v, segment.found.a))
        found += [number] if speed * change < 0.0 else []
    return found


def _gained(stage: Stage, face: int, *, first: bool) -> Polynomial | None:
    """Return what a stage adds to the velocity of a body relative to the one on which it slides; None if unknown.

    The `first` stage adds to the velocity with which it begins.
    """
    dynamics, parts = stage.dynamics, sliding_coordinates(stage.dynamics.mechanism, face)
    moving = [(k, 1.0) for k, _ in parts]
    if len(moving) == 1 and moving[0][0] in dynamics.carried:
        j, sign = dynamics.carried[moving[0][0]]
        moving.append((j, -sign))
    found = NIL
    for n, part in moving:
        gain = NIL if n in dynamics.frozen else dynamics.names.get(f"q{n}", NIL)
        if not gain.names() <= stage.book.values.keys():
            return None
        begun = stage.speeds.get(n, NIL) if first else NIL
        found = found + (begun + gain * Polynomial.of(stage.time)).scaled(part)
    return found if len(parts) == 1 else None


def _size(stage: Stage, held: Polynomial) -> Expression:
    formula = held.collected((stage.time.name,))
    return formula if stage.book.value(formula) >= 0.0 else held.scaled(-1.0).collected((stage.time.name,))


def _tell(stage: Stage, face: int, velocity: Expression) -> None:
    book, setting = stage.book, stage.setting
    body = stage.dynamics.mechanism.faces[face].subject
    under = stage.dynamics.mechanism.body[body].parent
    assert under is not None
    step, name = book.open("verify"), book.fresh("u", f"{setting.mark(under)}{setting.mark(body)}")
    exceeds(book, step, velocity, ZERO)
    told = step.verified(name, velocity, SPEED)
    further = "further " if stage.segment.start else ""
    step.say(f"After the {further}time ${stage.time.latex()}$, {setting.called(body)} still slides on")
    step.say(f"{setting.called(under)}, as their relative speed is {told}.")
    step.close()
