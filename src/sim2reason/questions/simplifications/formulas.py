"""Misconceptions by formulas used outside their range of validity."""

from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from math import pi

import numpy as np

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, Misconception, MisinterpretedMotion, misconception
from sim2reason.questions.simplifications.events import is_steady, with_formulas
from sim2reason.questions.simplifications.orbits import Motion, PlanetOrbit, moving_as, orbits
from sim2reason.questions.simplifications.pulleys import find_hanging_loads
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.mechanism import ConstantTension, Elastic, Line, Mechanism
from sim2reason.scenes.dsl.state import Array, Dynamics, State
from sim2reason.scenes.dsl.structure import changing, is_gravity_relevant, replace_lines
from sim2reason.simulation.equilibrium import Equilibrium, equilibrium
from sim2reason.simulation.oscillation import Oscillations, oscillations
from sim2reason.simulation.trace import Trace


@misconception
class HalfForgotten(MisinterpretedMotion):
    """The distance of a body released from rest is taken as at², as if it always had its final speed."""

    name = "half forgotten"
    reason = "the distance covered from rest is taken to be a t\N{SUPERSCRIPT TWO}, without the factor 1/2"
    sound_if_same = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if it starts from rest with constant accelerations; else none."""
        return [""] if is_steady(query, study) else []

    def read(self, study: SimulatedScene) -> SimulatedScene:
        """Return the motion with doubled distances and the same speeds."""
        return SimulatedScene(study.scene, with_formulas(study.trace, _doubled))


def _doubled(t: Array, v: Array, a: Array) -> tuple[Array, Array]:
    return v * t + a * t * t, v + a * t


@misconception
class LengthAsExtension(ChangedMechanism):
    """The extension of a spring is taken to be its length."""

    name = "length as extension"
    reason = "the length of a spring is taken for its extension"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a spring can push and pull; else none."""
        del query
        return [""] if _springs(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with springs of zero natural length."""
        del subject
        return replace_lines(mechanism, _springs(mechanism), _short)


def _springs(mechanism: Mechanism) -> list[str]:
    straight = (line for line in mechanism.lines if line.circle is None)
    return [line.name for line in straight if isinstance(line.law, Elastic) and not line.law.side]


def _short(line: Line) -> Line:
    assert isinstance(line.law, Elastic)
    return replace(line, law=replace(line.law, length=0.0))


@misconception
class MeanVelocity(MisinterpretedMotion):
    """A velocity is taken to be distance over time, even under acceleration."""

    name = "mean velocity"
    reason = "the mean velocity is taken for the velocity at the end"
    sound_if_same = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if it starts from rest with constant accelerations; else none."""
        return [""] if is_steady(query, study) else []

    def read(self, study: SimulatedScene) -> SimulatedScene:
        """Return the motion with half the velocities."""
        return SimulatedScene(study.scene, with_formulas(study.trace, _averaged))


def _averaged(t: Array, v: Array, a: Array) -> tuple[Array, Array]:
    return v * t + 0.5 * a * t * t, v + 0.5 * a * t


@misconception
class SineForCosine(Misconception):
    """An acute angle is measured from the wrong line, so that its complement is used everywhere."""

    name = "sine for cosine"
    common = True
    reason = "sine and cosine of an angle are confused"
    sound_if_same = True  # then both enter alike, as in the range of a throw

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the addresses of all acute angles that the text states."""
        del query
        return [
            parameter.path
            for parameter in study.scene.parameters
            if parameter.measure.unit == "deg"
            and not parameter.hidden
            and parameter.value is not None
            and 0.0 < parameter.value < 90.0
        ]

    def simplified(self, study: SimulatedScene, subject: str, until: float) -> SimulatedScene | None:
        """Return the scene with the complement of the angle, and its motion; None if it cannot be built."""
        return study.with_values({subject: 90.0 - float(study.scene.value(subject))}, until)


MODE_RESIDUAL_RTOL = (
    1e-3  # of the greatest displacement: largest part of an initial state that the modes do not represent
)


@misconception
class SmallAngle(MisinterpretedMotion):
    """A swing is taken to be harmonic about its equilibrium, whatever its amplitude."""

    name = "small angle"
    common = True
    reason = "the angle is taken as small"
    sound_if_same = True  # then it is small

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if gravity drives a nonlinear motion; else none."""
        del query
        mechanism = study.mechanism
        return [""] if is_gravity_relevant(mechanism) and changing(mechanism) else []

    def read(self, study: SimulatedScene) -> SimulatedScene | None:
        """Return the motion in normal modes; None if there are no modes, or the motion is harmonic anyway."""
        rest = equilibrium(study.mechanism)
        if rest is None or rest.linear:
            return None
        modes = oscillations(rest)
        trace = _harmonic(study.trace, rest, modes) if modes is not None else None
        return SimulatedScene(study.scene, trace) if trace is not None else None


def _harmonic(trace: Trace, rest: Equilibrium, modes: Oscillations) -> Trace | None:
    """Return the motion q = q₀ + Σ s (a cos ωt + b sin ωt) from the initial state, without forces; else None."""
    first = trace.sample(np.zeros(1))
    gone, speeds = first.q[0] - rest.coordinates, first.v[0]
    omega, shapes = modes.frequencies, modes.shapes
    inverse = np.asarray(np.linalg.pinv(shapes), dtype=np.float64)
    a, b = inverse @ gone, inverse @ speeds
    if max(np.abs(shapes @ a - gone).max(), np.abs(shapes @ b - speeds).max()) > MODE_RESIDUAL_RTOL * max(
        np.abs(gone).max(), MODE_RESIDUAL_RTOL
    ):
        return None

    def sample(times: Array) -> State:
        c, s = np.cos(np.outer(times, omega)), np.sin(np.outer(times, omega))
        unknown = np.full(len(times), np.nan)
        q, v = rest.coordinates + (c * a + s * (b / omega)) @ shapes.T, (c * b - s * (a * omega)) @ shapes.T
        dynamics = Dynamics(
            -((c * a + s * (b / omega)) * omega**2) @ shapes.T,
            dict.fromkeys(first.constraint_tension, unknown),
            dict.fromkeys(first.normal, unknown),
            dict.fromkeys(first.friction, unknown),
        )
        return State.of(first.mechanism, times, (q, v), dynamics)

    end = float(trace.state.times[-1])
    return Trace(trace.engine, sample(trace.state.times), (), end, "", sample, lambda: np.linspace(0.0, end, 33))


@misconception
class UniformAngularSpeed(MisinterpretedMotion):
    """Equal times are taken to correspond to equal angles on an ellipse, instead of equal areas."""

    name = "uniform angular speed"
    reason = "equal angles are taken to be swept out in equal times, as on a circle"
    sound_if_same = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if planets are on closed orbits about a star; else none."""
        del query
        planet_orbits = orbits(study.mechanism)
        return [""] if planet_orbits and all(orbit.period is not None for orbit in planet_orbits) else []

    def read(self, study: SimulatedScene) -> SimulatedScene:
        """Return the motion on the ellipses about the star alone, with their periods and uniform angular speed."""
        ellipses = {orbit: partial(_turned, orbit) for orbit in orbits(study.mechanism)}
        return SimulatedScene(study.scene, moving_as(study.trace, ellipses))


def _turned(orbit: PlanetOrbit, times: Array) -> Motion:
    """Return the motion r = p/(1 + e cos ν), ṙ = r² e sin ν ω/p, r̈ = (2ṙ²/r + r² e cos ν ω²/p)."""
    assert orbit.period is not None
    rate, p, (ex, ey) = orbit.sense * 2.0 * pi / orbit.period, orbit.semi_latus_rectum, orbit.eccentricity_vector
    angle = np.arctan2(orbit.place[1], orbit.place[0]) + rate * times
    out = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    along = np.stack([-out[:, 1], out[:, 0]], axis=1)
    ahead, aside = (out @ np.array([ex, ey]))[:, None], (along @ np.array([ex, ey]))[:, None]  # e cos ν, −e sin ν
    r = p / (1.0 + ahead)
    faster = -(r**2) * aside * rate / p
    outward = 2.0 * faster**2 / r + r**2 * ahead * rate**2 / p
    velocity = faster * out + r * rate * along
    return r * out, velocity, (outward - r * rate**2) * out + 2.0 * faster * rate * along


@misconception
class WeightAsTension(ChangedMechanism):
    """The tension above a hanging body is taken to equal its weight, as in equilibrium."""

    name = "weight as tension"
    reason = "the tension in a string is taken to balance the weight that hangs from it"
    sound_if_same = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the names of hanging bodies."""
        del query
        return find_hanging_loads(study.mechanism)

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with the weight as the total tension in the strings above the body, shared equally."""
        load = find_hanging_loads(mechanism)[subject]
        law = ConstantTension(load.mass * -mechanism.gravity[2] / load.runs)
        return replace_lines(mechanism, load.strings, lambda line: replace(line, law=law))
