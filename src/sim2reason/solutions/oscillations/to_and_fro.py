"""Motions between turning points: the initial direction, the first rest, and taut strings."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import pi

import numpy as np

from sim2reason.simulation.trace import Trace
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.functions import PI, Call, Power, sum_formulas
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.goals import MotionPart
from sim2reason.solutions.laws.directions import later_words
from sim2reason.solutions.oscillations.harmonic import HarmonicOscillation
from sim2reason.solutions.oscillations.linear_motion import LinearMotion
from sim2reason.solutions.oscillations.linear_way import LinearMotionModel
from sim2reason.solutions.oscillations.relative_motion import RelativeMotion
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.writing.notation import ACCELERATION, METRES, NEWTONS, SECONDS
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError, record_inequality


def write_first_move(model: LinearMotionModel, motion: LinearMotion | RelativeMotion) -> None:
    """Write the initial direction of a frictionless motion from rest, from the net force at the start."""
    (i,), book = motion.free, model.book
    if isinstance(motion, RelativeMotion) or any(motion.laws.slip_directions.values()) or model.initial_rate(i):
        return
    load, who = motion.load(i), model.mover_phrase(i)
    forward = load.value(motion.givens) > 0.0
    size, towards = (load if forward else load.scale(-1.0)).factored(), model.towards(i, forward=forward)
    step = book.begin_step("verify")
    if book.is_hidden(size):
        step.add_text(f"{capitalized(who)} first moves {towards}.")
    else:
        net = book.fresh("F", "0")
        book.set_value(net.name, book.value(size))
        equation = step.verified(net, size, NEWTONS)
        step.add_text(f"The net force along the motion at the start, {equation}, sets {who} in motion {towards}.")
    step.close()


def write_first_rest(model: LinearMotionModel, oscillation: HarmonicOscillation, span: float, name: Symbol) -> Symbol:
    """Write when the velocity is first zero, `span` seconds after the start; return the `name` of that time."""
    book, rate, begun, rest = (
        model.book,
        oscillation.angular_frequency,
        oscillation.sine_coefficient,
        oscillation.equilibrium,
    )
    step, phase = book.begin_step("time"), rate * name
    velocity = rest * rate * Call("sin", phase) + oscillation.first.expression() * Call("cos", phase)
    who, law = model.mover_phrase(oscillation.motion.free[0]), step.law(velocity, ZERO)
    step.add_text(f"{capitalized(who)} first comes to rest when its velocity, the derivative of the displacement")
    step.add_text(
        f"${oscillation.displacement_at_phase(phase).latex()}$, is zero: {law}, "
        f"so {step.derived(Call('tan', phase), begun / -rest)}."
    )
    early = oscillation.numbers[0] * span < 0.5 * pi
    sign = f"{rest.latex()} {'<' if book.value(rest) < 0.0 else '>'} 0"
    between = f"${phase.latex()}$ is {'less' if early else 'greater'} than ${(Number(0.5) * PI).latex()}$"
    formula = oscillation.angle_of_turning(span) / rate
    equation = step.result(name, formula, SECONDS)
    if not book.is_hidden(rest):
        step.add_text(f"As ${sign}$, {between}, and {equation}.")
    elif book.in_symbols:
        plain = "-" not in book.formulas.get(rest.latex(), rest).latex().removeprefix("-")  # all terms of one sign
        lead = "As" if plain else "For"
        step.add_text(f"{lead} ${sign}$, {between}, and {equation}.")
    else:
        step.add_text(f"Assume that ${sign}$; then {between}, and {equation}.")
        book.afterwards.append(lambda: _tell_sign(model, rest, sign, (phase, early)))
    step.close()
    return name


def write_rest_beyond(
    model: LinearMotionModel,
    oscillation: HarmonicOscillation,
    turning: Expression,
    position: Expression,
    *,
    later: bool,
) -> None:
    """Write that a body would come to rest only beyond `position`, so that friction is constant until there.

    In symbols, this is assumed. With `later`, the body has come to rest before.
    """
    book, step, who = model.book, model.book.begin_step("verify"), model.mover_phrase(oscillation.motion.free[0])
    there = (
        oscillation.name.latex() if position == oscillation.name else f"{oscillation.name.latex()} = {position.latex()}"
    )
    when = "next" if later else "first"
    if book.in_symbols:
        step.add_text(f"Assume that {who} gets to ${there}$ before it {when} comes to rest.")
        step.close()
        return
    name = book.fresh("s", r"\text{turn}") if later else book.fresh("x", "1")
    far, near = (-part if book.value(part) < 0.0 else part for part in (turning, position))
    record_inequality(book, step, far, near)
    equation = step.verified(name, turning, METRES)
    step.add_text(f"{capitalized(who)} would {when} come to rest at {equation}, beyond ${there}$,")
    step.add_text("so friction is constant until then.")
    step.close()


def _tell_sign(model: LinearMotionModel, rest: Expression, sign: str, reached: tuple[Expression, bool]) -> None:
    """Write the verification that the net force is zero on the assumed side of the start, by the phase at rest."""
    step, (phase, early), right = model.book.begin_step("verify"), reached, Number(0.5) * PI
    greater, less = (ZERO, rest) if model.book.value(rest) < 0.0 else (rest, ZERO)
    record_inequality(model.book, step, greater, less)
    record_inequality(model.book, step, *((right, phase) if early else (phase, right)))
    wrong = f"${phase.latex()}$ would be {'greater' if early else 'less'} than ${right.latex()}$"
    step.add_text(f"Indeed ${sign}$, as was assumed; on the other side of ${rest.latex()} = 0$, {wrong}.")
    step.close()


def write_rest_later(
    book: SolutionBuilder, formula: Expression, left: Symbol, half: Symbol | None, *, again: bool
) -> None:
    """Write that a half-oscillation, of duration `formula` or symbol `half`, takes longer than the time `left`."""
    if book.in_symbols:
        return
    if book.is_hidden(formula) or book.is_hidden(left):
        book.afterwards.append(lambda: write_rest_later(book, formula, left, half, again=again))
        return
    step = book.begin_step("verify")
    record_inequality(book, step, left, ZERO)
    if half is not None:
        record_inequality(book, step, half, left)
        step.rest_on(half.name)
        step.add_text(
            f"As ${left.name} < {half.name}$, it does not come to rest{' again' if again else ''} within this time."
        )
    else:
        rest = "next" if again else "first"
        step.add_text(f"It would {rest} come to rest {later_words(book, step, formula, left)}.")
    step.close()


@dataclass(frozen=True)
class _HangingBody:
    """A body that hangs on a string: its coordinate, string, mass, and acceleration without the string."""

    k: int
    line: int
    mass: Expression
    falling: Expression  # its acceleration without the string, m/s²


def verify_taut(setting: ProblemContext, book: SolutionBuilder, oscillation: HarmonicOscillation) -> None:
    """Schedule the verification that no body hanging on a string ever falls freely, if numbers show it."""
    oscillation = max(_with_earlier(oscillation), key=lambda swing: swing.amplitude_value)
    motion = oscillation.motion
    if book.in_symbols or not isinstance(motion, LinearMotion):
        return
    for body in _hanging(motion):
        ratio = abs(motion.ratio(body.k, motion.free[0]))
        if (
            0.0
            < ratio * oscillation.numbers[0] ** 2 * oscillation.amplitude_value
            < body.falling.value(motion.givens).real
        ):
            book.afterwards.append(lambda body=body, r=ratio: _write(setting, book, oscillation, body, r))


def _with_earlier(oscillation: HarmonicOscillation) -> Iterator[HarmonicOscillation]:
    """Yield a half-oscillation and all earlier ones, whose amplitudes are larger if there is friction."""
    earlier: HarmonicOscillation | None = oscillation
    while earlier is not None:
        yield earlier
        earlier = earlier.like


def _hanging(motion: LinearMotion) -> Iterator[_HangingBody]:
    """Yield the bodies on which only one string and, against it, their weight act."""
    for k in motion.ratios:
        row = motion.laws.newton(k)
        names = [n for n in row.zero.names() if n[0] in "TNSf" and n[1:].isdigit()]
        if len(names) != 1 or names[0][0] != "T":
            continue
        pull, mass = row.forces.terms_without(names), row.inertia.coefficient(f"q{k}")
        along, weight = row.forces.coefficient(names[0]).number or 0.0, pull.value(motion.givens)
        if mass and not row.inertia.terms_without((f"q{k}",)) and along * weight < 0.0:
            falling = reduced_quotient(pull if weight > 0.0 else pull.scale(-1.0), mass)
            yield _HangingBody(k, int(names[0][1:]), mass.factored(), falling)


def _write(
    setting: ProblemContext, book: SolutionBuilder, oscillation: HarmonicOscillation, body: _HangingBody, ratio: float
) -> None:
    greatest = Power(oscillation.angular_frequency, 2) * oscillation.amplitude
    formula = greatest if ratio == 1.0 else Number(ratio) * greatest
    step, name, smallest_tension = (
        book.begin_step("verify"),
        book.fresh("a", r"\text{max}"),
        book.fresh("T", r"\text{min}"),
    )
    record_inequality(book, step, body.falling, formula)
    who = setting.display_name(setting.mechanism.coordinates[body.k].body)
    string = setting.string_phrases[oscillation.motion.laws.lines[body.line].name]
    step.add_text(f"The acceleration of {who} is at most {step.verified(name, formula, ACCELERATION)},")
    step.add_text(f"less than ${body.falling.latex()}$, so {string} stays taut. Its tension is at least")
    step.add_text(f"{step.verified(smallest_tension, body.mass * (body.falling - name), NEWTONS)}.")
    step.close()


REST_SPEED_RTOL = 1e-6  # relative to the greatest speed: below it the body counts as at rest
SCAN_SAMPLES = 2001


def turning_times(trace: Trace, coordinate: int, until: float) -> list[float]:
    """Return the times, s, up to `until` at which a coordinate turns back, by the engine."""
    times = np.linspace(0.0, until, SCAN_SAMPLES)
    speeds = trace.sample(times).v[:, coordinate]
    moving = np.flatnonzero(np.abs(speeds) > REST_SPEED_RTOL * float(np.abs(speeds).max()))
    times, speeds = times[moving], speeds[moving]
    instants: list[float] = []
    for n in np.flatnonzero(speeds[:-1] * speeds[1:] < 0.0):
        share = speeds[n] / (speeds[n] - speeds[n + 1])
        instants.append(float(times[n] + share * (times[n + 1] - times[n])))
    return instants


@dataclass(frozen=True, slots=True)
class BackAndForthTravel(MotionPart):
    """A motion back and forth between successive values of a free coordinate."""

    motion_model: LinearMotionModel
    places: Sequence[Expression]

    def path(self, body: str) -> Expression:
        """Return the total distance that a body travels, m."""
        return sum_formulas(self.paths(body))

    def paths(self, body: str) -> Sequence[Expression]:
        """Return the distances, m, that a body travels between successive positions, one for each interval."""
        own, book, distances = self.motion_model.moving([body]), self.motion_model.book, list[Expression]()
        if len(own) != 1 or len(self.motion_model.motion.ratios[own[0]]) != 1:
            raise UnsolvedError("its path is no line of its own")
        (part,) = self.motion_model.motion.ratios[own[0]].values()
        for one, other in pairwise(self.places):
            displacement = other - one
            length = displacement if book.value(displacement) >= 0.0 else -displacement
            distances.append(length * abs(part) if abs(part) != 1.0 else length)
        return distances


class FrictionTravel(BackAndForthTravel):
    """Half-oscillations with kinetic friction of constant magnitude."""

    def force(self, kind: str, name: str) -> Polynomial:
        """Return the kinetic friction µN on a body, for its work along the whole path; zero for other forces."""
        if kind != "f":
            return super().force(kind, name)
        newton = self.motion_model.newton
        number = next(n for n, face in enumerate(self.motion_model.mechanism.faces) if face.subject == name)
        row = newton.normal(number)
        normal_force = (row.inertia - row.forces.terms_without((f"N{number}",))).substitute(
            {f"q{k}": NIL for k in self.motion_model.motion.ratios}
        )
        return newton.coefficient(number) * normal_force

    def slipped(self, body: str) -> Polynomial:
        """Return the length of the whole path on the surface, m."""
        return Polynomial.from_expression(self.path(body))
