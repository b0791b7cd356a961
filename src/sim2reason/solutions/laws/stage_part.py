"""Stages of a motion as terms of sums, and checks that bodies still slide at their end."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from math import isinf
from typing import Protocol

from sim2reason.scenes.dsl.frames import Frames
from sim2reason.scenes.dsl.mechanism import ConstantTension, Mechanism
from sim2reason.scenes.dsl.vectors import dot, subtract_triples
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.goals import MotionPart
from sim2reason.solutions.laws.directions import rubs_at_rest, sliding_coordinates
from sim2reason.solutions.laws.dynamics import Dynamics
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.rolling_words import rolling_direction_words
from sim2reason.solutions.laws.stage import Stage
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.writing.notation import SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError, record_inequality


class Course(Protocol):
    """A part of a motion, such as a `Stage`, as displacements along coordinates."""

    @property
    def dynamics(self) -> Dynamics:
        """Return the laws in which accelerations or displacements have their symbols."""
        ...

    @property
    def time(self) -> Symbol:
        """Return the duration of this part of the motion."""
        ...

    def gain(self, k: int) -> Polynomial:
        """Return the displacement along a coordinate in this part of the motion."""
        ...

    def gained(self, k: int) -> Polynomial:
        """Return the displacement along a coordinate relative to the carrier of the body."""
        ...

    def path(self, k: int) -> Expression:
        """Return the distance travelled along a coordinate in this part of the motion."""
        ...


def write_stage_arcs(book: SolutionBuilder, stages: Sequence[Course], k: int) -> None:
    """Write the arcs through which a hinge turns the rim of its body in several stages, and their senses."""
    gains = [gain for stage in stages if (gain := stage.gain(k))]
    if len(gains) < 2:
        return
    step, dynamics = book.begin_step("verify"), stages[0].dynamics
    senses = [1.0 if book.value(gain.expression()) > 0.0 else -1.0 for gain in gains]
    arcs = [f"${gain.scale(sense).expression().latex()}$" for gain, sense in zip(gains, senses, strict=True)]
    turns = ("further" if now == before else "back" for before, now in pairwise(senses))
    later = (f", then {direction} through {arc}" for direction, arc in zip(turns, arcs[1:], strict=True))
    who = dynamics.setting.display_name(dynamics.mechanism.coordinates[k].body)
    direction = rolling_direction_words(dynamics, k, senses[0])
    step.add_text(
        f"The rim of {who} first turns through the arc {arcs[0]} in the sense of rolling {direction}{''.join(later)}."
    )
    for name in dict.fromkeys(name for gain in gains for name in gain.names()):
        step.rest_on(name)
    step.close()


@dataclass(frozen=True, slots=True)
class StagePart(MotionPart):
    """One stage of a motion, with the laws that give its forces."""

    motion_model: StraightMotion
    stage: Course
    laws: Dynamics

    @property
    def _newton(self) -> Newton:
        """Return the laws of the stage."""
        return self.laws.newton

    @property
    def time(self) -> Symbol:
        """Return the duration of the stage."""
        return self.stage.time

    def force(self, kind: str, name: str) -> Polynomial:
        """Return a tension, or the kinetic friction on a body with the sign that makes its work positive."""
        m, names = self.motion_model.mechanism, self.laws.names
        if kind == "T":
            line = m.line[name]
            if isinstance(line.law, ConstantTension):
                return self._newton.tension(m.lines.index(line), line)
            return names.get(f"T{m.constraints.index(line)}", NIL)
        face = next(number for number, candidate in enumerate(m.faces) if candidate.subject == name)
        side = self._newton.slip_directions.get(face, 0)
        return (self._newton.coefficient(face) * names[f"N{face}"]).scale(float(side)) if side else NIL

    def displacement_along_line(self, body: str, line: str) -> Polynomial:
        """Return the displacement of a body along a line attached to it."""
        own = self.stage.dynamics.sufficient_coordinates(self.motion_model.moving([body]))
        parts: list[Polynomial] = []
        for k in own:
            along = self._newton.read(lambda m, f, k=k: _along(m, f, (body, line, k)))
            parts.append(along * self.stage.gain(k) if along else NIL)
        return total(parts)

    def slipped(self, body: str) -> Polynomial:
        """Return the displacement of a body relative to the surface under it."""
        face = next(n for n, candidate in enumerate(self.motion_model.mechanism.faces) if candidate.subject == body)
        return total(part * self.stage.gained(k) for k, part in self._newton.slip(face).items())

    def drawn_length(self, line: str) -> Polynomial:
        """Return the decrease of a line's length."""
        number = self.motion_model.mechanism.lines.index(self.motion_model.mechanism.line[line])
        moving = self.motion_model.stretching(line)
        return total(self._newton.stretch(number, k) * self.stage.gained(k) for k in moving).scale(-1.0)

    def path(self, body: str) -> Expression:
        """Return the distance that a body travels along its line."""
        dynamics = self.stage.dynamics
        own = [k for k in dynamics.sufficient_coordinates(self.motion_model.moving([body])) if k not in dynamics.frozen]
        if not own:
            return ZERO
        if len(own) != 1:
            raise UnsolvedError("its path is no line of its own")
        return self.stage.path(own[0])


def _along(mechanism: Mechanism, frames: Frames, of: tuple[str, str, int]) -> float:
    """Return the component of a coordinate's motion along a line, away from its attachment to a body."""
    body, line, k = of
    through = mechanism.line[line].through
    ends = through if mechanism.site[through[0]].body == body else through[::-1]
    separation = subtract_triples(frames.site(ends[1]).place, frames.site(ends[0]).place)
    size = float(dot(separation, separation)) ** 0.5
    return float(dot(separation, frames.center(body).gradient[k])) / size


def verify_still_sliding(stages: Sequence[Stage]) -> None:
    """Write for each body whose sliding slows down that it still slides at the end of a stage.

    No other step depends on it. With unknown numbers it is written at the end.
    """
    for number, stage in enumerate(stages):
        stages_so_far = stages[: number + 1]
        if stage.book.in_symbols or any(each.uniform or each.written_time is None for each in stages_so_far):
            return
        for face in _slowing(stage):
            parts = [_gained(each, face, first=n == 0) for n, each in enumerate(stages_so_far)]
            known = [part for part in parts if part is not None]
            if len(known) < len(parts):
                continue
            velocity = _size(stage, total(known))
            if stage.book.is_hidden(velocity):
                stage.book.afterwards.append(partial(_write_sliding, stage, face, velocity))
            else:
                _write_sliding(stage, face, velocity)


def _slowing(stage: Stage) -> list[int]:
    """Return the contacts at which sliding slows down without coming to rest at the end of the stage."""
    m, segment, contacts = stage.dynamics.mechanism, stage.segment, list[int]()
    for number, side in stage.dynamics.newton.slip_directions.items():
        face = m.faces[number]
        parts = sliding_coordinates(m, number)
        ends = any(k in stage.end.slip for k, _ in parts) or (
            stage.end.distance is None and stage.end.time is None and any(k == stage.end.coordinate for k, _ in parts)
        )
        rides = m.body[face.subject].parent is not None
        if not side or ends or not rides or isinf(face.friction) or rubs_at_rest(stage.dynamics, number):
            continue
        speed, change = (sum(float(rates[k]) * part for k, part in parts) for rates in (segment.v, segment.found.a))
        contacts += [number] if speed * change < 0.0 else []
    return contacts


def _gained(stage: Stage, face: int, *, first: bool) -> Polynomial | None:
    """Return the change of a body's slip velocity in a stage; None if it is unknown.

    For the `first` stage, the initial slip velocity is included.
    """
    dynamics, parts = stage.dynamics, sliding_coordinates(stage.dynamics.mechanism, face)
    moving = [(k, 1.0) for k, _ in parts]
    if len(moving) == 1 and moving[0][0] in dynamics.carrier_coordinates:
        j, sign = dynamics.carrier_coordinates[moving[0][0]]
        moving.append((j, -sign))
    change = NIL
    for n, part in moving:
        gain = NIL if n in dynamics.frozen else dynamics.names.get(f"q{n}", NIL)
        if not gain.names() <= stage.book.values.keys():
            return None
        begun = stage.speeds.get(n, NIL) if first else NIL
        change = change + (begun + gain * Polynomial.from_expression(stage.time)).scale(part)
    return change if len(parts) == 1 else None


def _size(stage: Stage, polynomial: Polynomial) -> Expression:
    """Return the magnitude of a polynomial as a formula: its negative if its value is negative."""
    formula = polynomial.collected((stage.time.name,))
    return formula if stage.book.value(formula) >= 0.0 else polynomial.scale(-1.0).collected((stage.time.name,))


def _write_sliding(stage: Stage, face: int, velocity: Expression) -> None:
    """Write that a body still slides at the end of a stage."""
    book, setting = stage.book, stage.setting
    body = stage.dynamics.mechanism.faces[face].subject
    under = stage.dynamics.mechanism.body[body].parent
    assert under is not None
    step, name = (
        book.begin_step("verify"),
        book.fresh("u", f"{setting.subscript_of(under)}{setting.subscript_of(body)}"),
    )
    record_inequality(book, step, velocity, ZERO)
    equation = step.verified(name, velocity, SPEED)
    further = "further " if stage.segment.start else ""
    step.add_text(f"After the {further}time ${stage.time.latex()}$, {setting.display_name(body)} still slides on")
    step.add_text(f"{setting.display_name(under)}, as their relative speed is {equation}.")
    step.close()
